#include "host/export/export_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "host/error.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

std::string lower_extension(const std::string& path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string::npos || path[dot] == '/') return "";
    std::string extension = path.substr(dot + 1);
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

}  // namespace

std::string export_format_words() {
    std::string words;
    for (const ExportFormatName& one : export_formats) {
        if (!words.empty()) words += '|';
        words += one.text;
    }
    return words;
}

const ExportFormatName& choose_export_format(const std::string& name, const std::string& path) {
    const std::string wanted = name.empty() ? lower_extension(path) : name;
    const auto* const found = std::ranges::find(export_formats, wanted, &ExportFormatName::text);
    if (found != export_formats.end()) return *found;
    throw Error(
        ErrorKind::setting,
        name.empty()
            ? fmt::format("{}: its extension names no format; it can be {}, or --format says "
                          "it",
                          printable_path(path), export_format_words())
            : fmt::format("--format {}: expected {}", printable(name), export_format_words()));
}

}  // namespace pxm::host
