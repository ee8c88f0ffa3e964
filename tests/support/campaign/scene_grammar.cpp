#include "tests/support/campaign/scene_grammar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "host/scene/words.hpp"

namespace pxm::test {

using namespace host;

namespace {

constexpr int fractals = 2;  // beside what is included

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
    return text;
}

}  // namespace

SceneGrammar::SceneGrammar(std::uint64_t seed)
    : draw_(seed), mode_(static_cast<Mode>(draw_.below(4))), forms_(draw_, names_) {
    add_fractal_writers();
    add_object_writers();
    add_floor_writers();
    add_view_writers();
    add_render_writers();
}

std::string SceneGrammar::part_text() {
    return "# what grammar's scenes include\n"
           "ifs part {\n    newmap scale: 0.5 translate: 0.5,0,0\n    newmap scale: 0.4\n}\n"
           "texture boards { wood size: 1,0.2 }\n";
}

std::string SceneGrammar::picture_bytes() {
    std::string bytes = "P6 4 4 255\n";
    for (int i = 0; i < 48; ++i) bytes += static_cast<char>(40 + 4 * i);
    return bytes;
}

std::vector<std::string> SceneGrammar::known_directives() const {
    std::vector<std::string> known;
    for (const auto& [directive, writer] : writers_) known.push_back(directive);
    return known;
}

std::string SceneGrammar::vector(double most) {
    const auto one = [&] { return draw_.between(-most, most); };
    return forms_.list({one(), one(), one()});
}

std::string SceneGrammar::point(double most) {
    const auto one = [&] { return forms_.between(-most, most); };
    return fmt::format("({},{},{})", one(), one(), one());
}

std::string SceneGrammar::gap() {
    static constexpr const char* gaps[] = {
        " ", "  ", "\n    ", "\n\t", "\r\n    ", "  # a comment\n    ", "\n\n    "};
    return gaps[draw_.below(7)];
}

std::string SceneGrammar::directive(const std::string& block, const std::string& word) {
    const BlockGrammar& grammar = *find_block(block);
    const int index = grammar.find(word);
    const auto writer = writers_.find(block + "." + word);
    if (index < 0 || writer == writers_.end()) {
        throw std::logic_error(fmt::format(
            "the grammar of scenes has no form of '{}' in '{}' (tests/support/campaign)", word,
            block));
    }
    const Values values = grammar.directives[static_cast<std::size_t>(index)].values;
    const std::string text = writer->second();
    if (text.empty() || (values == Values::optional && draw_.one_in(3))) return word;
    if (values == Values::none) return word + " " + text;
    return word + (draw_.one_in(8) ? " : " : ": ") + text;
}

std::string SceneGrammar::block(const BlockGrammar& grammar, const std::string& name,
                                const std::vector<std::string>& lines) {
    const bool named =
        grammar.naming == Naming::needed || (grammar.naming == Naming::allowed && draw_.one_in(2));
    std::string text = std::string(grammar.kind) + (named ? " " + name : "") + " {";
    for (const std::string& line : lines) text += gap() + line;
    return text + gap() + "}\n";
}

std::vector<std::string> SceneGrammar::some(const BlockGrammar& grammar, int one_in,
                                            const std::vector<std::string>& without) {
    std::vector<std::string> lines;
    for (const Directive& one : grammar.directives) {
        const std::string word(one.word);
        if (std::ranges::find(without, word) != without.end() || !draw_.one_in(one_in)) continue;
        lines.push_back(directive(std::string(grammar.kind), word));
    }
    return lines;
}

// ---- ifs ----

std::string SceneGrammar::reference() {
    const int number = 1 + draw_.below(maps_);
    return draw_.one_in(2) ? std::to_string(number) : fmt::format("map_{}", number);
}

void SceneGrammar::add_fractal_writers() {
    write("ifs.newmap", [] { return std::string(); });  // its name is the map's
    write("ifs.scale", [this] {
        const bool uniform = mode_ == Mode::fast || draw_.one_in(2);
        const auto one = [&] { return draw_.between(0.2, 0.5); };
        return uniform ? forms_.between(0.2, 0.5) : forms_.list({one(), one(), one()});
    });
    write("ifs.rotate",
          [this] { return fmt::format("{},{}", word_of(axis_words), forms_.between(-180, 180)); });
    write("ifs.translate", [this] { return vector(1); });
    write("ifs.matrix", [this] {
        const auto row = [&](double most) {
            const auto one = [&] { return forms_.between(-most, most); };
            return fmt::format("{},{},{}", one(), one(), one());
        };
        return fmt::format("{}, {}, {}, {}", row(0.25), row(0.25), row(0.25), row(1));
    });
    write("ifs.tetrahedron", [this] {
        const std::string at = forms_.between(-1, 1), to = forms_.between(1.2, 1.5);
        return fmt::format(
            "(0,0,0)(1,0,0)(0,1,0)(0,0,1) -> (({0}),0,0)(({0})+0.4,0,0)"
            "(({0}),({1})-1,0)(({0}),0,0.3)",
            at, to);
    });
    write("ifs.color", [this] {
        const auto one = [&] { return draw_.between(0.1, 0.9); };
        return forms_.list({one(), one(), one(), one()});
    });
    write("ifs.weight", [this] { return forms_.between(0.1, 3); });
    write("ifs.follow", [this] {
        std::vector<std::string> followers;
        for (int i = draw_.below(3); i >= 0; --i) followers.push_back(reference());
        return reference() + " -> " + joined(followers, ", ");
    });
    write("ifs.start",
          [this] { return draw_.one_in(2) ? reference() : reference() + ", " + reference(); });
    write("ifs.blend", [this] {
        return fmt::format("ends closed -> {}, {}", draw_.one_in(2) ? "ends opened" : "ends 2",
                           forms_.between(0.1, 0.9));
    });
}

/// A map contracts by its first command; what follows moves it.
std::string SceneGrammar::map(int number, bool flat) {
    std::string text = directive("ifs", "newmap");
    // Its first map has a name, so that every reference by a name finds one.
    text += fmt::format(" map_{}", number);
    const auto add = [&](const char* word) { text += gap() + directive("ifs", word); };
    const bool similar = flat || mode_ == Mode::fast;
    const int kinds = similar ? 1 : mode_ == Mode::wide ? 2 : 4;
    static constexpr const char* contracting[] = {"scale", "tetrahedron", "matrix", "blend"};
    if (flat) {
        text += gap() + "scale: " + forms_.between(0.3, 0.5);
        text +=
            gap() + fmt::format("translate: {},{},0", forms_.between(-1, 1), forms_.between(-1, 1));
    } else {
        add(contracting[draw_.below(kinds)]);
        if (!similar && draw_.one_in(2)) add("rotate");
        add("translate");
    }
    if (draw_.one_in(2)) add("color");
    if (draw_.one_in(3)) add("weight");
    return text;
}

std::string SceneGrammar::ifs(const std::string& name, bool flat) {
    maps_ = 2 + draw_.below(3);
    std::vector<std::string> lines;
    for (int i = 1; i <= maps_; ++i) lines.push_back(map(i, flat));
    if (draw_.one_in(2)) {
        // Every map has a follower; the grammar's own rule adds to them.
        for (int i = 1; i <= maps_; ++i)
            lines.push_back(fmt::format("follow: {} -> {}", i, reference()));
        lines.push_back(directive("ifs", "follow"));
        if (draw_.one_in(2)) lines.push_back(directive("ifs", "start"));
    }
    std::string text = block(*find_block("ifs"), name, lines);
    return draw_.one_in(4) ? fmt::format("r{}", text) : text;  // also written rifs
}

/// The maps that blends lie between. Ch. 13 takes no scene in which one turns.
std::string SceneGrammar::ends() {
    if (mode_ == Mode::fast) return "";
    return "ifs ends {\n    newmap closed scale: 0.5\n"
           "    newmap opened scale: 0.4 rotate: y,60 translate: 0.5,0,0\n}\n";
}

// ---- objects ----

void SceneGrammar::add_object_writers() {
    write("object.ifs", [this] {
        const int which = draw_.below(fractals + 1);
        return which == fractals ? std::string("part") : fmt::format("system_{}", which);
    });
    write("object.sphere",
          [this] { return point(0.3) + (draw_.one_in(2) ? " " : ", ") + forms_.between(0.5, 2); });
    write("object.box", [this] {
        return fmt::format("({0},{0},{0})({1},1,{1})", forms_.between(-2, -1),
                           forms_.between(0.5, 2));
    });
    for (const char* word : {"cone", "cylinder", "hull", "auto"})
        write(fmt::format("object.{}", word), [] { return std::string(); });
    write("object.scale", [this] {
        const auto one = [&] { return draw_.between(0.5, 2); };
        return draw_.one_in(2) ? forms_.between(0.5, 2) : forms_.list({one(), one(), one()});
    });
    write("object.rotate", writers_["ifs.rotate"]);
    write("object.translate", [this] { return vector(1.5); });
    write("object.matrix", [this] {
        const auto one = [&] { return forms_.between(0.6, 1.5); };
        return fmt::format("{},0,0.2, 0,{},0, 0.1,0,{}, {},{},0", one(), one(), one(), one(),
                           one());
    });
    write("object.color", writers_["ifs.color"]);
    write("object.opacity", [this] { return forms_.between(0.2, 0.9); });
    write("object.diffuse", [this] { return forms_.between(0.1, 0.9); });
    write("object.reflect", [this] { return forms_.between(0.1, 0.6); });
    write("object.levels", [this] { return forms_.whole(draw_.below(6)); });
}

std::string SceneGrammar::object(int number) {
    std::vector<std::string> volumes{"sphere"};
    if (mode_ != Mode::fast) volumes = {"sphere", "box", "cone", "cylinder"};
    std::vector<std::string> lines;
    const bool primitive = number > 0 && draw_.one_in(3);
    if (!primitive) {
        lines.push_back(directive("object", "ifs"));
        if (mode_ != Mode::fast) volumes.insert(volumes.end(), {"hull", "auto"});
    }
    if (primitive || draw_.one_in(2)) {
        const auto which = draw_.below(static_cast<int>(volumes.size()));
        lines.push_back(directive("object", volumes[static_cast<std::size_t>(which)]));
    }
    std::vector<std::string> without{"ifs", "sphere", "box", "cone", "cylinder", "hull", "auto"};
    if (mode_ != Mode::plain) without.emplace_back("opacity");
    const std::vector<std::string> more = some(*find_block("object"), 3, without);
    lines.insert(lines.end(), more.begin(), more.end());
    return block(*find_block("object"), fmt::format("object_{}", number), lines);
}

// ---- planes, textures, lights ----

void SceneGrammar::add_floor_writers() {
    write("plane.point", [this] { return vector(0.2); });
    write("plane.normal", [this] {
        return fmt::format("{},1,{}", forms_.between(-0.3, 0.3), forms_.between(-0.3, 0.3));
    });
    write("plane.color", [this] { return rgb(); });
    write("plane.texture", [this] {
        std::vector<std::string> used;
        for (int i = draw_.below(2); i >= 0; --i)
            used.push_back(textures_[static_cast<std::size_t>(
                draw_.below(static_cast<int>(textures_.size())))]);
        return joined(used, ", ");
    });
    write("plane.reflect", writers_["object.reflect"]);
    write("texture.file", [] { return fmt::format("\"{}\"", picture_file); });
    write("texture.ifs", [] { return std::string("flat"); });
    write("texture.wood", [] { return std::string(); });
    write("texture.size", [this] { return forms_.between(0.3, 2) + "," + forms_.between(0.3, 2); });
    write("texture.color", [this] { return rgb(); });
    write("texture.color2", [this] { return rgb(); });
    const auto away = [this] {
        return fmt::format("{},{},{}", forms_.between(-1, 1), forms_.between(2, 5),
                           forms_.between(-4, -1));
    };
    write("light.direction", away);
    write("light.position", away);
    write("light.color", [this] { return rgb(); });
    write("light.shadow", [this] { return word_of(switch_words); });
}

std::string SceneGrammar::texture(const std::string& name) {
    static constexpr const char* sources[] = {"file", "ifs", "wood"};
    std::vector<std::string> lines{directive("texture", sources[draw_.below(3)])};
    for (const std::string& line : some(*find_block("texture"), 2, {"file", "ifs", "wood"}))
        lines.push_back(line);
    textures_.push_back(name);
    return block(*find_block("texture"), name, lines);
}

// ---- camera, image, render, animation ----

void SceneGrammar::add_view_writers() {
    write("camera.eye", [this] {
        return forms_.list({draw_.between(-2, 2), draw_.between(0.5, 2), draw_.between(-6, -3)});
    });
    write("camera.look", [this] { return vector(0.4); });
    write("camera.up", [this] { return fmt::format("{},1,0", forms_.between(-0.5, 0.5)); });
    write("camera.fov", [this] { return forms_.between(20, 80); });
    write("camera.orthographic", [this] { return forms_.between(1, 5); });
    write("camera.zoom", [this] { return forms_.between(0.5, 4); });
    write("image.size", [this] {
        return forms_.whole(8 + draw_.below(5)) + "," + forms_.whole(8 + draw_.below(5));
    });
    write("image.crop", [this] {
        return fmt::format("{},{},{},{}", forms_.whole(draw_.below(3)), draw_.below(3),
                           forms_.whole(5 + draw_.below(3)), 5 + draw_.below(3));
    });
    write("animation.frames", [this] { return forms_.whole(1 + draw_.below(4)); });
    write("animation.rate", [this] { return forms_.between(1, 60); });
    write("animation.shutter", [this] { return forms_.between(0.1, 0.9); });
}

void SceneGrammar::add_render_writers() {
    write("render.ambient", [this] { return rgb(); });
    write("render.background", [this] { return rgb(); });
    write("render.shading", [this] { return word_of(shading_words); });
    write("render.covers", [this]() -> std::string {
        if (mode_ == Mode::area) return "area";
        if (mode_ != Mode::plain || draw_.one_in(3)) return "off";
        return draw_.one_in(2) ? "on" : forms_.between(0.05, 0.2) + "," + forms_.between(1, 2);
    });
    write("render.samples", [this] { return forms_.whole(1 + draw_.below(4)); });
    write("render.intersect", [this]() -> std::string {
        if (mode_ == Mode::fast) return "fast";
        if (mode_ == Mode::wide) return "wide";
        return draw_.one_in(2) ? "auto" : "heap";
    });
    write("render.numeric", [this]() -> std::string {
        return mode_ == Mode::wide ? "float" : word_of(numeric_words);
    });
    write("render.detail", [this] { return forms_.between(0.5, 3); });
    write("render.lipschitz", [this] { return word_of(lipschitz_words); });
    write("render.volume", [this]() -> std::string {
        if (mode_ == Mode::fast || mode_ == Mode::wide) return "sphere";
        return word_of(volume_words);
    });
    write("render.heap", [this] { return forms_.whole(1 + draw_.below(300)); });
    write("render.bounces", [this] { return forms_.whole(draw_.below(6)); });
}

std::string SceneGrammar::scene() {
    std::string text = draw_.one_in(2) ? "# a random scene\n" : "";
    for (int i = draw_.below(4); i > 0; --i) {
        const double value = draw_.between(-2, 2);
        const std::string name = fmt::format("let_{}", names_.lets.size());
        text += fmt::format("let {} = {}\n", name, forms_.number(value));
        names_.lets.emplace_back(name, value);
    }
    if (draw_.one_in(3)) {
        text += block(*find_block("animation"), "", some(*find_block("animation"), 2));
        names_.animated = true;
    }
    text += fmt::format("include: \"{}\"\n", part_file) + ends() + ifs("flat", true);
    for (int i = 0; i < fractals; ++i) text += ifs(fmt::format("system_{}", i), false);
    for (int i = draw_.below(3); i >= 0; --i) text += object(i);
    textures_ = {"boards"};
    for (int i = draw_.below(3); i > 0; --i) text += texture(fmt::format("texture_{}", i));
    for (int i = draw_.below(2); i > 0; --i) {
        std::vector<std::string> lines = some(*find_block("plane"), 2, {"normal"});
        lines.push_back(directive("plane", "normal"));
        text += block(*find_block("plane"), fmt::format("plane_{}", i), lines);
    }
    for (int i = draw_.below(3); i > 0; --i) {
        std::vector<std::string> lines = some(*find_block("light"), 2, {"direction", "position"});
        lines.push_back(directive("light", draw_.one_in(2) ? "direction" : "position"));
        text += block(*find_block("light"), fmt::format("light_{}", i), lines);
    }
    std::vector<std::string> render{"shading", "covers", "intersect", "volume", "numeric"};
    std::vector<std::string> lines = some(*find_block("render"), 4, render);
    for (const std::string& word : render)
        if (mode_ != Mode::plain || draw_.one_in(3)) lines.push_back(directive("render", word));
    text += block(*find_block("render"), "", lines);
    text += block(*find_block("camera"), "view", some(*find_block("camera"), 2));
    lines = some(*find_block("image"), 2, {"size"});
    lines.push_back(directive("image", "size"));
    return text + block(*find_block("image"), "", lines);
}

}  // namespace pxm::test
