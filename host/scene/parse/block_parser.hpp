// One block of a scene: kind, name and directives into its struct. After a mistake it goes on with
// the next plausible directive.
#pragma once

#include <functional>
#include <variant>

#include "host/scene/parse/grammar.hpp"
#include "host/scene/parse/value_reader.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// True where a block, `let` or `include` begins: their words are directives when a colon follows.
[[nodiscard]] bool at_top_level_start(const TokenReader& tokens);

/// Skips the rest of what went wrong: to `stop`, to the start of something at the top level, or to
/// the end of the file. Braces inside are skipped in pairs.
void skip_until(TokenReader& tokens, const std::function<bool()>& stop);

/// A block that is there already.
using AnyBlock = std::variant<IfsBlock*, ObjectBlock*, PlaneBlock*, TextureBlock*, LightBlock*,
                              CameraBlock*, ImageBlock*, RenderBlock*, AnimationBlock*>;

class BlockParser {
  public:
    BlockParser(TokenReader& tokens, const Constants& constants, Scene& scene)
        : tokens_(tokens), values_(tokens, constants), scene_(scene) {}

    /// Reads the block that is next into the scene; the next token is its kind.
    void block();

    /// Reads one directive into a block, in place of what the block says of it; the next token is
    /// its word. One of a map goes to the block's last.
    void directive(const AnyBlock& block);

  private:
    struct Head {
        std::string name;
        Position position;
    };
    Head head(const BlockGrammar& grammar);
    void ifs();
    void object();
    void plane();
    void texture();
    void light();
    void camera();
    void image();
    void render();
    void animation();

    void directive_of(IfsBlock& block);
    void directive_of(ObjectBlock& block);
    void directive_of(PlaneBlock& block);
    void directive_of(TextureBlock& block);
    void directive_of(LightBlock& block);
    void directive_of(CameraBlock& block);
    void directive_of(ImageBlock& block);
    void directive_of(RenderBlock& block);
    void directive_of(AnimationBlock& block);

    using Handler = std::function<void(const Token& word)>;
    void body(const BlockGrammar& grammar, const Handler& handler);
    Token directive_word(const BlockGrammar& grammar);
    void note_repetition(const BlockGrammar& grammar, const Token& word);
    void recover(const BlockGrammar& grammar);

    void start_map(IfsBlock& ifs, const Token& newmap);
    void map_directive(IfsBlock& ifs, const Token& word);
    bool command(std::vector<Command>& commands, const Token& word);
    TetrahedronCommand tetrahedron();
    MatrixCommand matrix();
    void object_directive(ObjectBlock& object, const Token& word);
    void volume(ObjectBlock& object, const Token& word);
    void plane_directive(PlaneBlock& plane, const Token& word);
    void texture_directive(TextureBlock& texture, const Token& word);
    void light_directive(LightBlock& light, const Token& word);
    void camera_directive(CameraBlock& camera, const Token& word);
    void image_directive(ImageBlock& image, const Token& word);
    void render_directive(RenderBlock& render, const Token& word);
    void animation_directive(AnimationBlock& animation, const Token& word);
    void blend(MapBlock& map, const Token& word);
    BlendEnd blend_end();
    CoversChoice covers();
    /// Keeps the first of the blocks that a scene may have only once.
    template <class Block>
    void keep_first(std::optional<Block>& kept, const Block& block, std::string_view kind);

    TokenReader& tokens_;
    ValueReader values_;
    Scene& scene_;
    unsigned seen_ = 0;           // directives of the current block, a bit each
    std::size_t scene_maps_ = 0;  // in all blocks of this file
};

}  // namespace pxm::host
