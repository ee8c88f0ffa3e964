#include "host/commands/scene_options.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "host/commands/option_checks.hpp"

namespace pxm::host {

namespace {

/// The options that say over the scene how it is rendered: their names, what they do, where they
/// are written and where they go, and how their text is read or what their number may be.
template <class Arguments, class See>
void each_scene_option(Arguments& a, const See& see) {
    using To = SceneOverrides;
    see("--size", "WxH in pixels", a.size, &To::size, parse_size);
    see("--crop", "x0,y0,x1,y1: only this window, half open", a.crop, &To::crop, parse_crop);
    see("--levels", "Stop after so many maps", a.levels, &To::levels, check_of_levels());
    see("--zoom", "Move the eye to look + (eye - look) / F", a.zoom, &To::zoom, positive_number());
    see("--numeric", "dsp32, float or double", a.numeric, &To::numeric, parse_numeric);
    see("--samples", "Samples a pixel", a.samples, &To::samples, check_of_samples());
    see("--covers", "on, off, area, or tmin,tmax in pixels", a.covers, &To::covers, parse_covers);
    see("--shading", "constant, low-pass, high-pass or facet", a.shading, &To::shading,
        parse_shading);
    see("--intersect", "auto, heap, fast or wide", a.intersect, &To::intersect, parse_intersect);
    see("--lipschitz", "auto, product, determinant or polar", a.lipschitz, &To::lipschitz,
        parse_lipschitz);
    see("--volume", "auto, sphere, box, oriented or hull", a.volume, &To::volume, parse_volume);
    see("--detail", "Cells are terminal at so many pixels", a.detail, &To::detail,
        positive_number());
    see("--heap", "Entries of the heap", a.heap, &To::heap, check_of_heap());
}

template <class Written>
constexpr bool is_text = std::is_same_v<Written, std::string>;

}  // namespace

void add_scene_options(CommandOptions& command, RenderArguments& arguments) {
    each_scene_option(arguments, [&]<class Written>(const char* name, const char* what,
                                                    Written& written, auto, const auto& check) {
        Option option = command.add_option(name, written, what);
        if constexpr (!is_text<Written>) option.transform(check);
    });
}

SceneOverrides overrides_of(const RenderArguments& arguments) {
    SceneOverrides overrides;
    each_scene_option(arguments,
                      [&]<class Written>(const char*, const char*, const Written& written, auto to,
                                         const auto& parse) {
                          if constexpr (is_text<Written>) {
                              if (!written.empty()) overrides.*to = parse(written);
                          } else {
                              if (written) overrides.*to = *written;
                          }
                      });
    return overrides;
}

std::string noted_options(const RenderArguments& arguments) {
    std::string options = arguments.program == "asm" ? "--program asm" : "";
    each_scene_option(arguments, [&]<class Written>(const std::string& name, const char*,
                                                    const Written& written, auto, const auto&) {
        std::string text;
        if constexpr (is_text<Written>) {
            text = written;
        } else if (written) {
            text = fmt::format("{}", *written);
        }
        const bool changes_nothing = name == "--zoom" && text == "1";
        if (text.empty() || changes_nothing || name == "--numeric") return;
        options += fmt::format("{}{} {}", options.empty() ? "" : " ", name, text);
    });
    return options;
}

}  // namespace pxm::host
