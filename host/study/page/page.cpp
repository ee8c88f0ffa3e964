#include "host/study/page/page.hpp"

#include <fmt/format.h>

#include "host/error.hpp"
#include "host/files/regular_file.hpp"
#include "host/study/page/plot.hpp"

namespace pxm::host {

namespace {

constexpr const char* style = R"(
body { font: 15px/1.45 Georgia, "Times New Roman", serif; color: #14213d; background: #fff;
  max-width: 1000px; margin: 2em auto; padding: 0 1em; overflow-wrap: anywhere; }
h1, h2, h3 { font-weight: 600; line-height: 1.2; }
h2 { border-top: 2px solid #14213d; padding-top: .5em; margin-top: 2em; }
table { border-collapse: collapse; margin: 1em 0; font-size: 14px; overflow-wrap: normal; }
th, td { padding: .2em .7em; text-align: right; border-bottom: 1px solid #ccd; }
th:first-child, td:first-child { text-align: left; white-space: nowrap; }
.wide { overflow-x: auto; } .wide svg { min-width: 600px; }
svg { max-width: 760px; width: 100%; height: auto; font: 12px Georgia, serif; display: block; }
.row { display: flex; flex-wrap: wrap; gap: 1.5em; align-items: flex-start; }
.row > figure { flex: 1 1 205px; max-width: 460px; margin: 0; }
figure { margin: 1em 0; }
figure img { width: 100%; image-rendering: pixelated; border: 1px solid #ccd; display: block; }
figcaption { font-size: 13px; }
.title { font-size: 14px; font-weight: 600; } .label { font-size: 10.5px; fill: #3a4660; }
.axis { stroke: #14213d; } .grid { stroke: #e3e6ee; } .mean { stroke: #d1495b; stroke-dasharray: 5 3; }
.bar { fill: #3d5a80; } .bar:hover, .cell:hover { stroke: #d1495b; stroke-width: 2; }
.cell { stroke: #fff; stroke-width: .5; } .hit { fill: transparent; stroke: none; }
.hit:hover { stroke: #d1495b; stroke-width: 1.5; }
#tip { position: fixed; display: none; background: #14213d; color: #fff; padding: .4em .7em;
  border-radius: 4px; font: 13px/1.35 sans-serif; white-space: pre-line; pointer-events: none;
  z-index: 9; max-width: 24em; }
@media print { body { max-width: none; margin: 0; font-size: 11pt; } #tip { display: none !important; }
  figure, svg, table { break-inside: avoid; } h2, h3 { break-after: avoid; }
  * { -webkit-print-color-adjust: exact; print-color-adjust: exact; } }
)";

// Shows data-tip, or the value of the grid's cell under the pointer.
constexpr const char* script = R"(
(() => {
  const tip = document.createElement('div');
  tip.id = 'tip';
  document.body.append(tip);
  const number = v => Math.abs(v) >= 1000 ? Math.round(v).toLocaleString('en') : +v.toPrecision(4);
  const gridText = (e, image) => {
    const box = image.getBoundingClientRect(), d = image.dataset;
    const x = Math.min(d.columns - 1, Math.max(0, Math.floor((e.clientX - box.left) / box.width * d.columns)));
    const y = Math.min(d.rows - 1, Math.max(0, Math.floor((e.clientY - box.top) / box.height * d.rows)));
    image.grid ??= d.values.split(' ').map(Number);
    return `${x},${y} of ${d.columns}x${d.rows}\n${number(image.grid[y * d.columns + x])} ${d.unit}`;
  };
  document.addEventListener('pointermove', e => {
    const mark = e.target.closest('[data-tip], [data-values]');
    if (!mark) { tip.style.display = 'none'; return; }
    tip.textContent = mark.dataset.tip ?? gridText(e, mark);
    tip.style.display = 'block';
    tip.style.left = Math.min(e.clientX + 14, innerWidth - tip.offsetWidth - 4) + 'px';
    tip.style.top = Math.min(e.clientY + 14, innerHeight - tip.offsetHeight - 4) + 'px';
  });
  document.addEventListener('pointerleave', () => { tip.style.display = 'none'; });
})();
)";

std::string base64(const std::string& bytes) {
    constexpr const char* digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const unsigned byte =
                i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
            group = group << 8 | byte;
        }
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
    }
    return text;
}

/// Nothing of a picture that is no longer there.
std::string bytes_of(const std::string& path) {
    try {
        const RegularFile file(path);
        return file.read(0, static_cast<std::size_t>(file.bytes()));
    } catch (const Error&) {
        return "";
    }
}

std::string quoted(const std::string& field) {
    if (field.find_first_of(",\"\n") == std::string::npos) return field;
    std::string text(1, '"');
    for (const char c : field) text.append(c == '"' ? 2 : 1, c);
    text += '"';
    return text;
}

/// No line ends before a per cent sign.
std::string joined(std::string text) {
    for (auto at = text.find(" %"); at != text.npos; at = text.find(" %"))
        text.replace(at, 1, "&nbsp;");
    return text;
}

}  // namespace

Page::Page(const std::string& title) : title_(title) {}

void Page::heading(const std::string& text) {
    body_ += fmt::format("<h2>{}</h2>\n", escaped(text));
}

void Page::subheading(const std::string& text) {
    body_ += fmt::format("<h3>{}</h3>\n", escaped(text));
}

void Page::paragraph(const std::string& text) {
    body_ += fmt::format("<p>{}</p>\n", escaped(text));
}

void Page::table(const PageTable& table) {
    body_ += "<div class=\"wide\"><table>\n<tr>";
    for (const std::string& name : table.columns)
        body_ += fmt::format("<th>{}</th>", escaped(name));
    body_ += "</tr>\n";
    for (const auto& cells : table.rows) {
        body_ += "<tr>";
        for (const std::string& cell : cells)
            body_ += fmt::format("<td>{}</td>", joined(escaped(cell)));
        body_ += "</tr>\n";
    }
    body_ += "</table></div>\n";
}

void Page::plot(const std::string& svg) {
    body_ += fmt::format("<figure class=\"wide\">{}</figure>\n", svg);
}

void Page::row(const std::vector<std::string>& figures) {
    body_ += "<div class=\"row\">\n";
    for (const std::string& figure : figures) body_ += fmt::format("<figure>{}</figure>\n", figure);
    body_ += "</div>\n";
}

std::string Page::figure(const PageMap& map) {
    std::string values;
    for (const double value : map.values) values += fmt::format("{:.4g} ", value);
    if (!values.empty()) values.pop_back();
    const std::string hover = map.values.empty()
                                  ? ""
                                  : fmt::format(
                                        " data-columns=\"{}\" data-rows=\"{}\" data-unit=\"{}\" "
                                        "data-values=\"{}\"",
                                        map.columns, map.rows, escaped(map.unit), values);
    return fmt::format(
        "<img alt=\"{0}\" src=\"data:image/png;base64,{1}\"{2}>"
        "<figcaption>{0}</figcaption>",
        escaped(map.title), base64(bytes_of(map.picture)), hover);
}

std::string Page::html() const {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n"
        "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}"
        "<script>{3}</script>\n</body>\n</html>\n",
        escaped(title_), style, body_, script);
}

std::string csv_of(const PageTable& table) {
    std::string text;
    const auto add = [&](const std::vector<std::string>& fields) {
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (i > 0) text += ',';
            text += quoted(fields[i]);
        }
        text += '\n';
    };
    add(table.columns);
    for (const auto& row : table.rows) add(row);
    return text;
}

}  // namespace pxm::host
