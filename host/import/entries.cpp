#include "host/import/entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <utility>

#include "host/compile/compile.hpp"
#include "host/error.hpp"
#include "host/import/fractint/fractint_reader.hpp"
#include "host/import/imported_scene.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/text/nearest.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t longest_name = 200;

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 500;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), shown); ++i)
        list += "\n  " + printable(names[i], longest_name);
    if (names.size() > shown) list += fmt::format("\n  ... and {} more", names.size() - shown);
    return list;
}

/// The place that `#3` says, from 0; nothing if the text is none of that form.
std::optional<std::size_t> place_of(std::string_view text) {
    std::size_t place = 0;
    if (!text.starts_with('#')) return std::nullopt;
    const auto result = std::from_chars(text.data() + 1, text.data() + text.size(), place);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || place == 0)
        return std::nullopt;
    return place - 1;
}

void require_valid(const Imported& imported) {
    Diagnostics diagnostics;
    const std::string name = imported.name + ".pxm";
    const Scene scene = parse_text(name, imported.text, diagnostics);
    if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
    if (!diagnostics.has_errors()) (void)compile(scene, 1, diagnostics);
    if (!diagnostics.has_errors()) return;
    throw Error(ErrorKind::scene,
                fmt::format("\"{}\" has no scene that pxm takes:\n{}", printable(imported.name),
                            diagnostics.text(scene.files)));
}

}  // namespace

std::size_t choose_entry(const std::vector<std::string>& names, const std::string& file,
                         const std::optional<std::string>& wanted) {
    if (names.empty())
        throw Error(ErrorKind::scene, fmt::format("{}: no entries", printable(file, longest_name)));
    if (!wanted) {
        if (names.size() == 1) return 0;
        throw Error(ErrorKind::setting,
                    fmt::format("{} has {} entries; choose one with --entry NAME:{}",
                                printable(file, longest_name), names.size(), listed(names)));
    }
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == *wanted) return i;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (same_word(names[i], *wanted)) return i;
    if (const auto place = place_of(*wanted); place && *place < names.size()) return *place;
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    throw Error(
        ErrorKind::setting,
        fmt::format("{} has no entry \"{}\"{}; it has:{}", printable(file, longest_name),
                    printable(*wanted), printable(suggestion(*wanted, candidates), longest_name),
                    listed(names)));
}

std::string file_name(const std::string& path) {
    return printable(std::filesystem::path(path).filename().string(), longest_name);
}

std::string bare_name(const std::string& path) {
    return std::filesystem::path(path).stem().string();
}

Imported finished(Scene scene, const std::string& heading) {
    Imported imported;
    imported.name = scene.ifs.empty() ? scene.objects.front().name : scene.ifs.front().name;
    imported.text = imported_text(scene, heading + "\nimported by pxm " PXM_VERSION);
    require_valid(imported);
    imported.scene = std::move(scene);
    return imported;
}

}  // namespace pxm::host
