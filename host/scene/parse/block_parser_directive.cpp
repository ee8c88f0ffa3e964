// One directive of a block that is there already.
#include "host/scene/parse/block_parser.hpp"

namespace pxm::host {

void BlockParser::directive(const AnyBlock& block) {
    std::visit([&](auto* one) { directive_of(*one); }, block);
}

void BlockParser::directive_of(IfsBlock& block) {
    map_directive(block, directive_word(*find_block("ifs")));
}

void BlockParser::directive_of(ObjectBlock& block) {
    const BlockGrammar& grammar = *find_block("object");
    const Token word = directive_word(grammar);
    if (word.text == "sphere" || word.text == "box") block.volume.reset();
    object_directive(block, word);
}

void BlockParser::directive_of(PlaneBlock& block) {
    const Token word = directive_word(*find_block("plane"));
    if (word.text == "texture") block.textures.clear();
    plane_directive(block, word);
}

void BlockParser::directive_of(TextureBlock& block) {
    const Token word = directive_word(*find_block("texture"));
    if (word.text == "file" || word.text == "ifs") block.source.reset();
    texture_directive(block, word);
}

void BlockParser::directive_of(LightBlock& block) {
    light_directive(block, directive_word(*find_block("light")));
}

void BlockParser::directive_of(CameraBlock& block) {
    camera_directive(block, directive_word(*find_block("camera")));
}

void BlockParser::directive_of(ImageBlock& block) {
    image_directive(block, directive_word(*find_block("image")));
}

void BlockParser::directive_of(RenderBlock& block) {
    render_directive(block, directive_word(*find_block("render")));
}

void BlockParser::directive_of(AnimationBlock& block) {
    animation_directive(block, directive_word(*find_block("animation")));
}

}  // namespace pxm::host
