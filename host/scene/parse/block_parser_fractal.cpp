// The blocks that say what is there: ifs and object.
#include <fmt/format.h>

#include "host/scene/check/limits.hpp"
#include "host/scene/parse/block_parser.hpp"

namespace pxm::host {

void BlockParser::ifs() {
    const BlockGrammar& grammar = *find_block("ifs");
    const Head named = head(grammar);
    scene_.ifs.emplace_back();
    IfsBlock& block = scene_.ifs.back();
    block.name = named.name;
    block.position = named.position;
    body(grammar, [&](const Token& word) { map_directive(block, word); });
}

void BlockParser::map_directive(IfsBlock& ifs, const Token& word) {
    if (word.text == "newmap") return start_map(ifs, word);
    if (word.text == "follow") {
        FollowRule rule{values_.map_reference(), {}};
        if (tokens_.peek().kind != TokenKind::arrow)
            tokens_.fail_expected("'->'", "follow: MAP -> MAP, ...");
        tokens_.take();
        rule.followers = values_.map_references();
        ifs.follow.push_back(std::move(rule));
        return;
    }
    if (word.text == "start") {
        ifs.start = values_.map_references();
        return;
    }
    if (ifs.maps.empty())
        tokens_.fail(word.position,
                     fmt::format("'{}' belongs to a map: expected 'newmap' before it", word.text));
    MapBlock& map = ifs.maps.back();
    if (word.text == "blend") return blend(map, word);
    if (command(map.commands, word)) return;
    if (word.text == "color") map.color = values_.rgba();
    if (word.text == "weight") map.weight = values_.number();
}

void BlockParser::start_map(IfsBlock& ifs, const Token& newmap) {
    if (ifs.maps.size() == maps_an_ifs || scene_maps_ == maps_a_scene) {
        tokens_.report(newmap.position,
                       ifs.maps.size() == maps_an_ifs
                           ? fmt::format("more than {} maps in an ifs", maps_an_ifs)
                           : fmt::format("more than {} maps", maps_a_scene));
        tokens_.give_up();  // the rest would only cost memory
        return;
    }
    ++scene_maps_;
    MapBlock map;
    map.position = newmap.position;
    const Token& next = tokens_.peek();
    if (next.kind == TokenKind::word && !tokens_.peek_second().is(':') && !is_keyword(next.text))
        map.name = tokens_.take().text;
    ifs.maps.push_back(std::move(map));
}

/// Reads the values of scale, rotate, translate, matrix or tetrahedron; false for another word.
bool BlockParser::command(std::vector<Command>& commands, const Token& word) {
    const auto add = [&](const CommandKind& kind) { commands.push_back({kind, word.position}); };
    if (word.text == "scale") {
        add(ScaleCommand{values_.scale_factors()});
    } else if (word.text == "rotate") {
        const Axis axis = values_.word(axis_words);
        tokens_.expect(',', "'rotate' takes an axis and degrees");
        add(RotateCommand{axis, values_.number()});
    } else if (word.text == "translate") {
        add(TranslateCommand{values_.vec3("'translate' takes x,y,z")});
    } else if (word.text == "matrix") {
        add(matrix());
    } else if (word.text == "tetrahedron") {
        add(tetrahedron());
    } else {
        return false;
    }
    return true;
}

/// It is looked up when the whole text is read (host/scene/parse/resolve_blends.hpp).
void BlockParser::blend(MapBlock& map, const Token& word) {
    BlendCommand command;
    command.from = blend_end();
    if (tokens_.peek().kind != TokenKind::arrow)
        tokens_.fail_expected("'->'", "blend: MAP -> MAP, share");
    tokens_.take();
    command.to = blend_end();
    tokens_.expect(',', "blend: MAP -> MAP, share");
    command.share = values_.number();
    map.commands.push_back({command, word.position});
}

/// A map of this ifs, or of the one that is named before it.
BlendEnd BlockParser::blend_end() {
    BlendEnd end;
    const TokenKind second = tokens_.peek_second().kind;
    const bool two = second == TokenKind::word || second == TokenKind::number;
    if (tokens_.peek().kind == TokenKind::word && two) end.ifs = values_.name("an ifs");
    end.map = values_.map_reference();
    return end;
}

MatrixCommand BlockParser::matrix() {
    const auto m = values_.numbers<12>("'matrix' takes 12 numbers, four rows of three");
    MatrixCommand command;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            command.map.linear[row][column] = m[static_cast<std::size_t>(3 * row + column)];
    command.map.translation = {m[9], m[10], m[11]};
    return command;
}

TetrahedronCommand BlockParser::tetrahedron() {
    TetrahedronCommand command;
    const auto corners = [&](std::array<glm::dvec3, 4>& points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) values_.optional_comma();
            points[i] = values_.point();
        }
    };
    corners(command.from);
    if (tokens_.peek().kind != TokenKind::arrow)
        tokens_.fail_expected("'->'", "tetrahedron: four points -> four points");
    tokens_.take();
    corners(command.to);
    return command;
}

void BlockParser::object() {
    const BlockGrammar& grammar = *find_block("object");
    const Head named = head(grammar);
    ObjectBlock block;
    block.name = named.name;
    block.position = named.position;
    body(grammar, [&](const Token& word) { object_directive(block, word); });
    scene_.objects.push_back(std::move(block));
}

void BlockParser::object_directive(ObjectBlock& object, const Token& word) {
    if (command(object.commands, word)) return;
    if (word.text == "ifs") {
        object.ifs_position = tokens_.peek().position;
        object.ifs = values_.name("an ifs");
    } else if (word.text == "color") {
        object.color = values_.rgba();
    } else if (word.text == "opacity") {
        object.opacity_position = word.position;
        object.opacity = values_.number();
    } else if (word.text == "diffuse") {
        object.diffuse = values_.number();
    } else if (word.text == "reflect") {
        object.reflect_position = word.position;
        object.reflect = values_.number();
    } else if (word.text == "levels") {
        object.levels = values_.whole_number();
    } else {
        volume(object, word);
    }
}

void BlockParser::volume(ObjectBlock& object, const Token& word) {
    if (object.volume)
        tokens_.report(word.position,
                       fmt::format("'{}' is a second volume: an object has one", word.text));
    object.volume_position = word.position;
    if (word.text == "sphere") {
        SphereVolume sphere;
        if (tokens_.accept(':')) {
            sphere.center = values_.point();
            values_.optional_comma();
            sphere.radius = values_.number();
        }
        object.volume = sphere;
    }
    if (word.text == "box") {
        BoxVolume box;
        if (tokens_.accept(':')) {
            box.low = values_.point();
            values_.optional_comma();
            box.high = values_.point();
        }
        object.volume = box;
    }
    if (word.text == "cone") object.volume = ConeVolume{};
    if (word.text == "cylinder") object.volume = CylinderVolume{};
    if (word.text == "hull") object.volume = HullVolume{};
    if (word.text == "auto") object.volume = AutoVolume{};
}

}  // namespace pxm::host
