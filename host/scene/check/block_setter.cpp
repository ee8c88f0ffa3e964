#include "host/scene/check/block_setter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/scene/check/range_check.hpp"
#include "host/scene/default_objects.hpp"
#include "host/text/number_text.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == '.') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

/// Where `name` is among the blocks: by its name, or by its number from 1 in the order written.
template <class Block>
std::size_t place_of(const std::vector<Block>& blocks, const std::string& name) {
    const auto found = std::ranges::find(blocks, name, &Block::name);
    if (found != blocks.end() && !name.empty())
        return static_cast<std::size_t>(found - blocks.begin());
    const auto number = number_of_text<std::size_t>(name);
    return number && *number >= 1 && *number <= blocks.size() ? *number - 1 : blocks.size();
}

/// "a, b, 3": how the blocks can be called.
template <class Block>
std::string names_of(const std::vector<Block>& blocks) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        names.push_back(blocks[i].name.empty() ? fmt::format("{}", i + 1) : blocks[i].name);
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Words that would add to what is there, or begin something new.
bool can_be_set(std::string_view word) {
    constexpr std::array<std::string_view, 7> many{"newmap",    "follow", "scale",      "rotate",
                                                   "translate", "matrix", "tetrahedron"};
    return std::ranges::find(many, word) == many.end();
}

}  // namespace

void BlockSetter::fail(const std::string& message) {
    diagnostics_.error({}, message);
    throw SyntaxError{};
}

/// The block that the key names, or the only one.
template <class Block>
Block& BlockSetter::chosen(std::vector<Block>& blocks) {
    const std::string& kind = key_.front();
    if (blocks.empty()) fail(fmt::format("the scene has no {}", kind));
    if (key_.size() == 2) {
        if (blocks.size() == 1) return blocks.front();
        fail(fmt::format("the scene has {} of kind '{}': say {}.NAME.{} (of {})", blocks.size(),
                         kind, kind, key_.back(), names_of(blocks)));
    }
    const std::size_t place = place_of(blocks, key_[1]);
    if (place == blocks.size())
        fail(fmt::format("the scene has no {} (it has {})", block_name(kind, key_[1]),
                         names_of(blocks)));
    return blocks[place];
}

/// The block that a scene has once; it is made if it is not there.
template <class Block>
Block& BlockSetter::only(std::optional<Block>& block) {
    if (!block) block.emplace();
    bool named = false;
    if constexpr (requires { block->name; }) named = key_.size() == 3 && key_[1] == block->name;
    if (key_.size() != 2 && !named)
        fail(fmt::format("a scene has one {}: say {}.{}", key_.front(), key_.front(), key_.back()));
    return *block;
}

void BlockSetter::set(const Setting& setting) {
    key_ = split(setting.key);
    const std::string& kind = key_.front();
    const BlockGrammar* grammar = find_block(kind);
    if (grammar == nullptr) {
        const std::string help = suggest_block(kind);
        fail(fmt::format(
            "there is no kind of block '{}'{}", printable(kind),
            help.empty() ? " (ifs, object, plane, texture, light, camera, image, render, animation)"
                         : help));
    }
    if (kind == "animation" && key_.back() == "frames")
        fail("t depends on it: name the number of frames by a 'let' and set that");
    const std::size_t most = grammar->kind == "ifs" ? 4 : 3;
    if (key_.size() > most || std::ranges::find(key_, "") != key_.end())
        fail(fmt::format("expected {}.DIRECTIVE or {}.NAME.DIRECTIVE", kind, kind));
    if (grammar->find(key_.back()) >= 0 && !can_be_set(key_.back()))
        fail(fmt::format("'{}' can stand several times: name its number by a 'let' and set that",
                         key_.back()));
    const int index = grammar->find(key_.back());
    const bool of_map = index >= 0 && grammar->directives[static_cast<std::size_t>(index)].times ==
                                          Times::once_a_map;
    if (of_map && key_.size() != 4)
        fail(fmt::format("'{}' belongs to a map: say {}.NAME.MAP.{}", key_.back(), kind,
                         key_.back()));
    if (!of_map && key_.size() == 4)
        fail(fmt::format("a map's values that can be set are its color and its weight"));
    text_ = fmt::format("{}: {}", key_.back(), setting.value);
    if (grammar->kind == "ifs") {
        IfsBlock& ifs = chosen(scene_.ifs);
        return key_.size() == 4 ? set_in_map(ifs) : read(&ifs);
    }
    if (kind == "object") {
        scene_.objects = objects_of(scene_);
        read(&chosen(scene_.objects));
    }
    if (kind == "plane") read(&chosen(scene_.planes));
    if (kind == "texture") read(&chosen(scene_.textures));
    if (kind == "light") read(&chosen(scene_.lights));
    if (kind == "camera") read(&only(scene_.camera));
    if (kind == "image") read(&only(scene_.image));
    if (kind == "render") read(&only(scene_.render));
    if (kind == "animation") read(&only(scene_.animation));
}

/// As if the map were the last one that was read.
void BlockSetter::set_in_map(IfsBlock& ifs) {
    const std::size_t place = place_of(ifs.maps, key_[2]);
    if (place == ifs.maps.size())
        fail(fmt::format("{} has no map \"{}\" (it has {})", block_name("ifs", ifs.name),
                         printable(key_[2]), names_of(ifs.maps)));
    IfsBlock alone;
    alone.maps.push_back(ifs.maps[place]);
    read(&alone);
    ifs.maps[place] = alone.maps.front();
}

void BlockSetter::read(const AnyBlock& block) {
    const auto file = static_cast<int>(scene_.files.size());
    // Later messages about the value show it; paths in it start at the folder one is in.
    scene_.files.push_back({fmt::format("--set {}", fmt::join(key_, ".")), text_});
    const std::string text = text_;
    TokenReader tokens(text, file, diagnostics_);
    BlockParser(tokens, constants_, scene_).directive(block);
    if (tokens.peek().kind != TokenKind::end)
        tokens.fail_expected("nothing more", fmt::format("'{}' is one value", key_.back()));
    // A report that does not end the directive is a mistake as well.
    if (diagnostics_.has_errors()) throw SyntaxError{};
}

}  // namespace pxm::host
