#include "host/commands/exr_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "host/error.hpp"
#include "host/text/nearest.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream list(text);
    for (std::string word; std::getline(list, word, ',');) words.push_back(word);
    return words;
}

/// Whole numbers beyond 2,048 are not all halves.
void require_half(const std::string& text, const std::vector<Aov>& aovs) {
    const std::vector<std::string_view> known{half_color, "Z", "N", "alpha"};
    const std::vector<std::string> names = words_of(text);
    for (const std::string& name : names) {
        if (std::ranges::count(known, name) == 0)
            throw Error(ErrorKind::setting,
                        fmt::format("--half: found \"{}\", expected color, Z, N or alpha{}; other "
                                    "channels are whole numbers, which 16 bits do not hold",
                                    printable(name), suggestion(name, known)));
        if (name != half_color &&
            std::ranges::none_of(aovs, [&](Aov aov) { return name == aov_name(aov); }))
            throw Error(
                ErrorKind::setting,
                fmt::format("--half {0}: there is no such channel without --aov {0}", name));
        if (std::ranges::count(names, name) > 1)
            throw Error(ErrorKind::setting, fmt::format("--half: {} is named twice", name));
    }
}

}  // namespace

void require_exr_options(const RenderArguments& arguments, const std::vector<Aov>& aovs,
                         const std::string& out) {
    const bool in_parts =
        !arguments.part.empty() || !arguments.claim.empty() || !arguments.keep.empty();
    const bool is_exr = out.ends_with(".exr") || out.ends_with(".EXR");
    const auto require_exr = [&](const char* option, bool given) {
        if (given && !is_exr && (arguments.part.empty() && arguments.claim.empty()))
            throw Error(ErrorKind::setting,
                        fmt::format("{} needs an .exr output, not {}", option,
                                    out.empty() ? "a film" : printable_path(out)));
    };
    require_exr("--half", !arguments.half.empty());
    require_exr("--data-window", arguments.data_window);
    require_exr("--cryptomatte", !arguments.cryptomatte.empty());
    if (!arguments.half.empty()) require_half(arguments.half, aovs);
    if (arguments.cryptomatte.empty()) return;
    (void)parse_mattes(arguments.cryptomatte);
    if (in_parts)
        throw Error(ErrorKind::setting,
                    "--cryptomatte: a picture that is made in parts has none (--part, --claim, "
                    "--keep)");
}

Metadata exr_metadata(const RenderArguments& arguments, const PixelSize& image) {
    Metadata metadata;
    if (!arguments.half.empty()) metadata.emplace_back(half_metadata, arguments.half);
    if (arguments.data_window)
        metadata.emplace_back(whole_metadata, fmt::format("{}x{}", image.columns, image.rows));
    return metadata;
}

std::vector<MatteKind> parse_mattes(const std::string& text) {
    std::vector<MatteKind> kinds;
    for (const std::string& word : words_of(text)) {
        const bool is_map = word == "map";
        if (!is_map && word != "object")
            throw Error(
                ErrorKind::setting,
                fmt::format("--cryptomatte: found \"{}\", expected object, map, or both "
                            "with a comma between them{}",
                            printable(word),
                            suggestion(word, std::vector<std::string_view>{"object", "map"})));
        const MatteKind kind = is_map ? MatteKind::map : MatteKind::object;
        if (std::ranges::count(kinds, kind) > 0)
            throw Error(ErrorKind::setting, fmt::format("--cryptomatte: {} is named twice", word));
        kinds.push_back(kind);
    }
    return kinds;
}

ExtraChannels matte_channels(const std::vector<MatteLayer>& layers) {
    ExtraChannels extra;
    for (const MatteLayer& layer : layers) {
        for (const std::string& name : layer.channels()) extra.names.push_back(name);
        for (const auto& entry : layer.metadata()) extra.metadata.push_back(entry);
    }
    extra.put = [&layers](long x, long y, float* to) {
        for (const MatteLayer& layer : layers) {
            layer.put(x, y, to);
            to += 2 * matte_ranks;
        }
    };
    return extra;
}

}  // namespace pxm::host
