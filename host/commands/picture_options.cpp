#include "host/commands/picture_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "host/commands/exr_options.hpp"
#include "host/error.hpp"
#include "host/process/terminal.hpp"
#include "host/render/render_options.hpp"
#include "host/scene/carried/carried_json.hpp"
#include "host/scene/check/settings.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

using Options = std::vector<std::pair<std::string, std::string>>;

// Nothing here names a file: a picture from somebody else says how it looks, and no more.
struct HeldText {
    const char* name;
    std::string RenderArguments::*value;
};
constexpr HeldText held_texts[] = {
    {"--machine", &RenderArguments::machine},     {"--numeric", &RenderArguments::numeric},
    {"--size", &RenderArguments::size},           {"--crop", &RenderArguments::crop},
    {"--covers", &RenderArguments::covers},       {"--shading", &RenderArguments::shading},
    {"--intersect", &RenderArguments::intersect}, {"--lipschitz", &RenderArguments::lipschitz},
    {"--volume", &RenderArguments::volume},       {"--aov", &RenderArguments::aov},
    {"--half", &RenderArguments::half},           {"--cryptomatte", &RenderArguments::cryptomatte},
};

struct HeldWhole {
    const char* name;
    std::optional<long> RenderArguments::*value;
    OptionCheck (*check)();
};
constexpr HeldWhole held_wholes[] = {
    {"--levels", &RenderArguments::levels, &check_of_levels},
    {"--samples", &RenderArguments::samples, &check_of_samples},
    {"--heap", &RenderArguments::heap, &check_of_heap},
};

struct HeldNumber {
    const char* name;
    std::optional<double> RenderArguments::*value;
};
constexpr HeldNumber held_numbers[] = {
    {"--zoom", &RenderArguments::zoom},
    {"--detail", &RenderArguments::detail},
};

Options options_of(const RenderArguments& arguments) {
    Options options;
    for (const HeldText& held : held_texts)
        if (const std::string& value = arguments.*held.value; !value.empty())
            options.emplace_back(held.name, value);
    for (const HeldWhole& held : held_wholes)
        if (const auto value = arguments.*held.value)
            options.emplace_back(held.name, fmt::format("{}", *value));
    for (const HeldNumber& held : held_numbers)
        if (const auto value = arguments.*held.value)
            options.emplace_back(held.name, fmt::format("{}", *value));
    if (arguments.data_window) options.emplace_back("--data-window", "");
    for (const std::string& setting : arguments.set) options.emplace_back("--set", setting);
    return options;
}

/// The number's canonical text. Throws Error(ErrorKind::setting).
std::string checked(const char* name, const OptionCheck& check, std::string text) {
    const std::string why = check.look(text);
    if (!why.empty())
        throw Error(ErrorKind::setting, fmt::format("{}: {}", name, printable(why, 200)));
    return text;
}

/// Puts an option into the arguments; false if there is none of that name.
bool take(const std::string& name, const std::string& value, RenderArguments& arguments) {
    for (const HeldText& held : held_texts) {
        if (name != held.name) continue;
        arguments.*held.value = value;
        return true;
    }
    for (const HeldWhole& held : held_wholes) {
        if (name != held.name) continue;
        arguments.*held.value = std::atol(checked(held.name, held.check(), value).c_str());
        return true;
    }
    for (const HeldNumber& held : held_numbers) {
        if (name != held.name) continue;
        arguments.*held.value =
            std::strtod(checked(held.name, positive_number(), value).c_str(), nullptr);
        return true;
    }
    if (name == "--set") arguments.set.push_back(value);
    if (name == "--frames") arguments.frames = value;
    if (name == "--data-window") arguments.data_window = true;
    return name == "--set" || name == "--frames" || name == "--data-window";
}

/// Throws Error(ErrorKind::setting) for what the command line would not take.
void require_sound(const RenderArguments& a) {
    if (!a.machine.empty()) (void)parse_model("--machine", a.machine);
    if (!a.numeric.empty()) (void)parse_numeric(a.numeric);
    if (!a.size.empty()) (void)parse_size(a.size);
    if (!a.crop.empty()) (void)parse_crop(a.crop);
    if (!a.covers.empty()) (void)parse_covers(a.covers);
    if (!a.shading.empty()) (void)parse_shading(a.shading);
    if (!a.intersect.empty()) (void)parse_intersect(a.intersect);
    if (!a.lipschitz.empty()) (void)parse_lipschitz(a.lipschitz);
    if (!a.volume.empty()) (void)parse_volume(a.volume);
    const std::vector<Aov> aovs = a.aov.empty() ? std::vector<Aov>{} : parse_aovs(a.aov);
    require_exr_options(a, aovs, ".exr");
    (void)parse_settings(a.set);
}

/// What the picture was rendered with.
RenderArguments arguments_of(const CarriedScene& carried, const std::string& path) {
    RenderArguments arguments;
    try {
        for (const auto& [name, value] : carried.options)
            if (!take(name, value, arguments))
                throw Error(ErrorKind::setting,
                            fmt::format("there is no option \"{}\" here", printable(name)));
        require_sound(arguments);
    } catch (const Error& error) {
        throw Error(ErrorKind::scene, fmt::format("{}: the scene that it carries: {}",
                                                  printable_path(path), error.what()));
    }
    return arguments;
}

template <class Value>
void hold(Value& value, const Value& old) {
    if (value == Value{}) value = old;
}

}  // namespace

void hold_options_of_picture(RenderArguments& arguments) {
    const auto carried = carried_scene_at(arguments.scene);
    if (!carried) return;
    RenderArguments old = arguments_of(*carried, arguments.scene);
    if (arguments.native) old.machine.clear();
    if (!arguments.size.empty()) old.crop.clear();  // it was a window of another size
    const bool in_parts = !arguments.part.empty() || !arguments.claim.empty();
    const auto dot = arguments.out.rfind('.');
    const bool is_exr = dot != std::string::npos && arguments.out.substr(dot) == ".exr";
    if (!in_parts && !is_exr) {  // others have no room for them
        old.aov.clear();
        old.half.clear();
        old.data_window = false;
    }
    if (in_parts || !arguments.keep.empty() || !is_exr) old.cryptomatte.clear();
    for (const HeldText& held : held_texts) hold(arguments.*held.value, old.*held.value);
    for (const HeldWhole& held : held_wholes) hold(arguments.*held.value, old.*held.value);
    for (const HeldNumber& held : held_numbers) hold(arguments.*held.value, old.*held.value);
    hold(arguments.frames, old.frames);
    hold(arguments.data_window, old.data_window);
    arguments.set.insert(arguments.set.begin(), old.set.begin(), old.set.end());
}

void hold_settings_of_picture(const std::string& scene, std::vector<std::string>& set) {
    const auto carried = carried_scene_at(scene);
    if (!carried) return;
    const RenderArguments old = arguments_of(*carried, scene);
    set.insert(set.begin(), old.set.begin(), old.set.end());
}

std::string SceneCarrier::text(double frame) {
    if (arguments_.no_scene) return "";
    if (!scene_) {
        from_picture_ = carried_scene_at(arguments_.scene).has_value();
        scene_ = carry(arguments_.scene, arguments_.allowed);
    }
    CarriedScene carried = *scene_;
    carried.version = PXM_VERSION;
    carried.options = options_of(arguments_);
    if (carried.has_frames) carried.options.emplace_back("--frames", fmt::format("{}", frame));
    std::string text = carried_json(carried);
    if (!carried.left_out.empty() && !told_ && !arguments_.quiet)
        tell(fmt::format("the picture carries no scene: {}\n", carried.left_out));
    told_ = true;
    return text;
}

std::string SceneCarrier::name() const {
    if (from_picture_) return scene_->files.front().name;
    return std::filesystem::path(arguments_.scene).filename().string();
}

}  // namespace pxm::host
