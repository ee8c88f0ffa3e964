// The blocks around the fractals: plane, texture, light, camera, image, render, animation.
#include <fmt/format.h>

#include "host/scene/parse/block_parser.hpp"

namespace pxm::host {

void BlockParser::plane() {
    const BlockGrammar& grammar = *find_block("plane");
    const Head named = head(grammar);
    PlaneBlock block;
    block.name = named.name;
    block.position = named.position;
    body(grammar, [&](const Token& word) { plane_directive(block, word); });
    scene_.planes.push_back(std::move(block));
}

void BlockParser::plane_directive(PlaneBlock& plane, const Token& word) {
    if (word.text == "point") plane.point = values_.vec3("'point' takes x,y,z");
    if (word.text == "normal") plane.normal = values_.vec3("'normal' takes x,y,z");
    if (word.text == "color") plane.color = values_.rgb();
    if (word.text == "reflect") plane.reflect = values_.number();
    if (word.text == "texture") {
        do {
            const Position position = tokens_.peek().position;
            plane.textures.push_back({values_.name("a texture"), position});
        } while (tokens_.accept(','));
    }
}

void BlockParser::texture() {
    const BlockGrammar& grammar = *find_block("texture");
    const Head named = head(grammar);
    TextureBlock block;
    block.name = named.name;
    block.position = named.position;
    body(grammar, [&](const Token& word) { texture_directive(block, word); });
    scene_.textures.push_back(std::move(block));
}

void BlockParser::texture_directive(TextureBlock& texture, const Token& word) {
    if (word.text == "size") {
        texture.size = values_.vec2("'size' takes u,v");
    } else if (word.text == "color") {
        texture.color = values_.rgb();
    } else if (word.text == "color2") {
        texture.color2 = values_.rgb();
    } else {
        if (texture.source)
            tokens_.report(word.position,
                           fmt::format("'{}' is a second source: a texture has one", word.text));
        texture.source_position = tokens_.peek().position;
        if (word.text == "file") texture.source = FileTexture{values_.file_name()};
        if (word.text == "ifs") texture.source = IfsTexture{values_.name("an ifs")};
        if (word.text == "wood") texture.source = WoodTexture{};
    }
}

void BlockParser::light() {
    const BlockGrammar& grammar = *find_block("light");
    const Head named = head(grammar);
    LightBlock block;
    block.name = named.name;
    block.position = named.position;
    body(grammar, [&](const Token& word) { light_directive(block, word); });
    scene_.lights.push_back(std::move(block));
}

void BlockParser::light_directive(LightBlock& light, const Token& word) {
    if (word.text == "direction") light.direction = values_.vec3("'direction' takes x,y,z");
    if (word.text == "position") light.location = values_.vec3("'position' takes x,y,z");
    if (word.text == "color") light.color = values_.rgb();
    if (word.text == "shadow") {
        light.shadow_position = word.position;
        light.shadow = values_.word(switch_words);
    }
}

template <class Block>
void BlockParser::keep_first(std::optional<Block>& kept, const Block& block,
                             std::string_view kind) {
    if (kept)
        tokens_.report(block.position,
                       fmt::format("a second '{}': a scene has one (the first is in line {})", kind,
                                   kept->position.line));
    else
        kept = block;
}

void BlockParser::camera() {
    const BlockGrammar& grammar = *find_block("camera");
    const Head named = head(grammar);
    CameraBlock block;
    block.name = named.name;
    block.position = named.position;
    body(grammar, [&](const Token& word) { camera_directive(block, word); });
    keep_first(scene_.camera, block, grammar.kind);
}

void BlockParser::camera_directive(CameraBlock& camera, const Token& word) {
    if (word.text == "eye") camera.eye = values_.decimals("'eye' takes x,y,z");
    if (word.text == "look") camera.look = values_.decimals("'look' takes x,y,z");
    if (word.text == "up") camera.up = values_.vec3("'up' takes x,y,z");
    if (word.text == "fov") camera.fov = values_.number();
    if (word.text == "orthographic") camera.orthographic = values_.number();
    if (word.text == "zoom") camera.zoom = values_.magnification();
}

void BlockParser::image() {
    const BlockGrammar& grammar = *find_block("image");
    ImageBlock block;
    block.position = head(grammar).position;
    body(grammar, [&](const Token& word) { image_directive(block, word); });
    keep_first(scene_.image, block, grammar.kind);
}

void BlockParser::image_directive(ImageBlock& image, const Token& word) {
    if (word.text == "size") {
        const auto size = values_.whole_numbers<2>("'size' takes columns,rows");
        image.size = PixelSize{size[0], size[1]};
    }
    if (word.text == "crop") {
        const auto crop = values_.whole_numbers<4>("'crop' takes x0,y0,x1,y1");
        image.crop = CropWindow{crop[0], crop[1], crop[2], crop[3]};
    }
}

void BlockParser::render() {
    const BlockGrammar& grammar = *find_block("render");
    RenderBlock block;
    block.position = head(grammar).position;
    body(grammar, [&](const Token& word) { render_directive(block, word); });
    keep_first(scene_.render, block, grammar.kind);
}

void BlockParser::render_directive(RenderBlock& render, const Token& word) {
    if (word.text == "ambient") render.ambient = values_.rgb();
    if (word.text == "background") render.background = values_.rgb();
    if (word.text == "shading") render.shading = values_.word(shading_words);
    if (word.text == "detail") render.detail = values_.number();
    if (word.text == "lipschitz") render.lipschitz = values_.word(lipschitz_words);
    if (word.text == "heap") render.heap = values_.whole_number();
    if (word.text == "bounces") render.bounces = values_.whole_number();
    if (word.text == "covers") {
        render.covers_position = word.position;
        render.covers = covers();
    }
    if (word.text == "samples") {
        render.samples_position = word.position;
        render.samples = values_.whole_number();
    }
    if (word.text == "intersect") {
        render.intersect_position = word.position;
        render.intersect = values_.word(intersect_words);
    }
    if (word.text == "numeric") {
        render.numeric_position = word.position;
        render.numeric = values_.word(numeric_words);
    }
    if (word.text == "volume") {
        render.volume_position = word.position;
        render.volume = values_.word(volume_words);
    }
}

void BlockParser::animation() {
    const BlockGrammar& grammar = *find_block("animation");
    AnimationBlock block;
    block.position = head(grammar).position;
    body(grammar, [&](const Token& word) { animation_directive(block, word); });
    keep_first(scene_.animation, block, grammar.kind);
}

void BlockParser::animation_directive(AnimationBlock& animation, const Token& word) {
    if (word.text == "frames") animation.frames = values_.whole_number();
    if (word.text == "rate") animation.rate = values_.number();
    if (word.text == "shutter") animation.shutter = values_.number();
}

CoversChoice BlockParser::covers() {
    const Token& next = tokens_.peek();
    if (next.is_word("on") || next.is_word("off")) {
        if (values_.word(switch_words)) return Covers{};
        return CoversOff{};
    }
    if (next.is_word("area")) {
        (void)tokens_.take();
        return AreaCovers{};
    }
    constexpr const char* choices = "off, on, area or tmin,tmax";
    if (next.kind == TokenKind::end || next.is('}')) tokens_.fail_expected(choices);
    const auto taus = values_.numbers<2>("'covers' takes off, on, area or tmin,tmax");
    return Covers{taus[0], taus[1]};
}

}  // namespace pxm::host
