#include "host/scene/check/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "host/error.hpp"
#include "host/scene/check/block_setter.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/parse/value_reader.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

[[noreturn]] void refuse(const Setting& setting, const std::string& why) {
    throw Error(ErrorKind::setting, fmt::format("--set {}={}: {}", printable(setting.key, 100),
                                                printable(setting.value, 100), why));
}

bool is_let(const Setting& setting) { return setting.key.find('.') == std::string::npos; }

/// The first message; a value's end is not a file's.
std::string first_message(const Diagnostics& diagnostics) {
    std::string text = diagnostics.text({});
    text = text.substr(0, text.find('\n'));
    if (text.starts_with("error: ")) text = text.substr(7);
    const std::string end = "the end of the file";
    const std::size_t at = text.find(end);
    if (at != std::string::npos) text.replace(at, end.size(), "nothing more");
    return text;
}

/// The settings of `let`s, while the scene is parsed.
class LetSettings {
  public:
    explicit LetSettings(const Settings& settings) : settings_(settings) {}

    /// A let's number: what is set, or `own`. Both may use the lets before it.
    double number(const std::string& name, double own) {
        double value = own;
        for (const Setting& setting : settings_)
            if (setting.key == name) value = evaluate(setting);
        numbers_.emplace(name, value);
        return value;
    }

    /// Throws if something is set that the scene has no let for.
    void require_all_found() const {
        for (const Setting& setting : settings_) {
            if (!is_let(setting) || numbers_.contains(setting.key)) continue;
            std::set<std::string> names;
            for (const auto& [name, value] : numbers_) names.insert(name);
            refuse(setting, names.empty()
                                ? "the scene has no 'let'"
                                : fmt::format("the scene has no 'let' of that name (it has {})",
                                              fmt::join(names, ", ")));
        }
    }

    [[nodiscard]] const Constants& numbers() const { return numbers_; }

  private:
    [[nodiscard]] double evaluate(const Setting& setting) const {
        Diagnostics found;
        try {
            TokenReader tokens(setting.value, 0, found);
            const double value = ValueReader(tokens, numbers_).number();
            if (tokens.peek().kind != TokenKind::end)
                tokens.fail_expected("one expression", "a 'let' is a number");
            return value;
        } catch (const SyntaxError&) {
            refuse(setting, first_message(found));
        }
    }

    const Settings& settings_;
    Constants numbers_;
};

std::optional<std::string> mistake_of(const Scene& scene) {
    Diagnostics found;
    check_scene(scene, found);
    if (!found.has_errors()) return std::nullopt;
    return first_message(found);
}

/// Sets the values of blocks. What makes a sound scene wrong is the setting's mistake, unless a
/// later one mends it (`eye` and `look` may have to move together).
void set_blocks(Scene& scene, const Settings& settings, const Constants& constants) {
    bool sound = !mistake_of(scene);
    const Setting* guilty = nullptr;
    std::string mistake;
    for (const Setting& setting : settings) {
        if (is_let(setting)) continue;
        Diagnostics found;
        try {
            BlockSetter(scene, constants, found).set(setting);
        } catch (const SyntaxError&) {
            refuse(setting, first_message(found));
        }
        const auto now = mistake_of(scene);
        if (now && sound) {
            guilty = &setting;
            mistake = *now;
        }
        sound = !now;
    }
    if (!sound && guilty != nullptr) refuse(*guilty, mistake);
}

}  // namespace

Setting parse_setting(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw Error(ErrorKind::setting,
                    fmt::format("--set: found \"{}\", expected NAME=VALUE or BLOCK.DIRECTIVE=VALUE",
                                printable(text, 100)));
    const std::size_t end = text.find_last_not_of(" \t", equals - 1);
    Setting setting{text.substr(0, end + 1), text.substr(equals + 1)};
    if (setting.value.find('\0') != std::string::npos ||
        setting.value.find_first_not_of(" \t") == std::string::npos)
        refuse(setting, "expected a value");
    return setting;
}

Settings parse_settings(const std::vector<std::string>& texts) {
    Settings settings;
    for (const std::string& text : texts) settings.push_back(parse_setting(text));
    return settings;
}

std::string text_of(const Setting& setting) {
    const std::string text = fmt::format("{}={}", setting.key, setting.value);
    const bool plain = text.find_first_of(" \t\n") == std::string::npos;
    return fmt::format("--set {0}{1}{0}", plain ? "" : "'", text);
}

std::string text_of(const Settings& settings) {
    std::vector<std::string> texts;
    for (const Setting& setting : settings) texts.push_back(text_of(setting));
    return fmt::format("{}", fmt::join(texts, " "));
}

Scene parse_scene(const std::string& path, const Settings& settings, Diagnostics& diagnostics,
                  const std::vector<std::string>& allowed, const std::optional<std::string>& text,
                  double frame) {
    if (settings.empty()) return parse_scene(path, diagnostics, allowed, nullptr, text, frame);
    LetSettings lets(settings);
    const LetNumber number = [&](const std::string& name, double own) {
        return lets.number(name, own);
    };
    Scene scene = parse_scene(path, diagnostics, allowed, number, text, frame);
    if (diagnostics.has_errors()) return scene;
    lets.require_all_found();
    set_blocks(scene, settings, lets.numbers());
    return scene;
}

}  // namespace pxm::host
