// The top of a scene: files, `include`, `let`, and the blocks one after another.
#include "host/scene/parse/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include "host/error.hpp"
#include "host/files/allowed_folders.hpp"
#include "host/scene/carried/carried_scene.hpp"
#include "host/scene/check/limits.hpp"
#include "host/scene/check/range_check.hpp"
#include "host/scene/parse/block_parser.hpp"
#include "host/scene/parse/resolve_blends.hpp"
#include "host/scene/picture_path.hpp"
#include "host/scene/scene_path.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

namespace fs = std::filesystem;

bool is_empty(const Scene& scene) {
    return scene.ifs.empty() && scene.objects.empty() && scene.planes.empty() &&
           scene.textures.empty() && scene.lights.empty() && !scene.camera && !scene.image &&
           !scene.render;
}

/// The place of the first NUL byte: text has none.
Position nul_position(const std::string& text, std::size_t nul, int file) {
    const std::string_view before = std::string_view(text).substr(0, nul);
    const std::size_t line_end = before.rfind('\n');
    const std::size_t start = line_end == std::string_view::npos ? 0 : line_end + 1;
    return {file, static_cast<int>(std::ranges::count(before, '\n')) + 1,
            static_cast<int>(nul - start) + 1};
}

/// Whether an included text looks like a scene. Of one that does not, no word is shown: whoever
/// wrote the scene may have named a file that is not his to read. A text without a word may be a
/// scene's, and what has NUL bytes is reported without being shown.
bool begins_as_scene(const std::string& text) {
    const Token first = Lexer(text, 0).next();
    return first.kind == TokenKind::end || text.find('\0') != std::string::npos ||
           first.is_word("let") || first.is_word("include") ||
           (first.kind == TokenKind::word && find_block(first.text) != nullptr);
}

class SceneParser {
  public:
    SceneParser(Diagnostics& diagnostics, const FileReader& reader, const LetNumber& let_number,
                double frame, const IncludeFinder& find_included)
        : diagnostics_(diagnostics),
          reader_(reader),
          let_number_(let_number),
          frame_(frame),
          find_included_(find_included) {}

    Scene parse(const std::string& name, const std::string& text) {
        file(fs::path(name).lexically_normal().string(), name, text);
        if (!diagnostics_.has_errors()) resolve_blends(scene_, diagnostics_);
        if (!diagnostics_.has_errors() && is_empty(scene_))
            diagnostics_.error({}, "the scene is empty");
        return std::move(scene_);
    }

  private:
    /// `path` tells one file from another, `name` is what messages call it.
    void file(const std::string& path, const std::string& name, const std::string& text);
    void top_level(TokenReader& tokens, BlockParser& blocks);
    void let(TokenReader& tokens);
    void name_time();
    void include(TokenReader& tokens);
    void include_file(TokenReader& tokens, const Token& file_token);

    Diagnostics& diagnostics_;
    const FileReader& reader_;
    const LetNumber& let_number_;
    double frame_;
    const IncludeFinder& find_included_;
    Scene scene_;
    Constants constants_;
    std::vector<std::string> open_files_;  // the file being read and those that include it
    std::set<std::string> read_files_;
    std::size_t text_bytes_ = 0;  // of all that was included
};

void SceneParser::file(const std::string& path, const std::string& name, const std::string& text) {
    const int index = static_cast<int>(scene_.files.size());
    scene_.files.push_back({name, text});
    const std::size_t nul = text.find('\0');
    if (nul != std::string::npos) {
        diagnostics_.error(nul_position(text, nul, index), "byte 0x00: this is not a text file");
        return;
    }
    read_files_.insert(path);
    open_files_.push_back(path);
    TokenReader tokens(text, index, diagnostics_);
    BlockParser blocks(tokens, constants_, scene_);
    while (tokens.peek().kind != TokenKind::end) {
        try {
            top_level(tokens, blocks);
        } catch (const SyntaxError&) {
            skip_until(tokens, [] { return false; });
        }
    }
    open_files_.pop_back();
}

void SceneParser::top_level(TokenReader& tokens, BlockParser& blocks) {
    const Token& word = tokens.peek();
    if (word.is_word("let")) return let(tokens);
    if (word.is_word("include")) return include(tokens);
    if (word.kind == TokenKind::word && find_block(word.text) != nullptr) {
        blocks.block();
        return name_time();
    }
    const Token found = tokens.take();  // so that something is read whatever it is
    std::string message = fmt::format("expected a block, found {}", describe(found));
    if (found.kind == TokenKind::word) message += suggest_block(found.text);
    if (message.back() != ')')
        message +=
            " (ifs, object, plane, texture, light, camera, image, render, animation, let or "
            "include)";
    tokens.fail(found.position, message);
}

/// After an `animation`, unless a `let` before it has these names.
void SceneParser::name_time() {
    if (!scene_.animation) return;
    constants_.emplace("frame", frame_);
    constants_.emplace("t", time_of(*scene_.animation, frame_));
}

void SceneParser::let(TokenReader& tokens) {
    tokens.take();
    const Token name = tokens.peek();
    ValueReader values(tokens, constants_);
    const std::string constant = values.name("a number");
    tokens.expect('=', "let NAME = expression");
    double value = values.number();
    if (let_number_) value = let_number_(constant, value);
    if (!constants_.emplace(constant, value).second)
        tokens.report(name.position,
                      fmt::format("'{}' is named twice by 'let'", printable(constant)));
}

void SceneParser::include(TokenReader& tokens) {
    tokens.take();
    tokens.expect(':', "include: \"FILE\"");
    if (tokens.peek().kind != TokenKind::string) tokens.fail_expected("a file name in quotes");
    include_file(tokens, tokens.take());
}

/// Paths are relative to the including file, or to what finds them elsewhere. A file that was read
/// before is not read again.
void SceneParser::include_file(TokenReader& tokens, const Token& file_token) {
    const fs::path target(file_token.text);
    std::string path =
        (fs::path(open_files_.back()).parent_path() / target).lexically_normal().string();
    if (find_included_) path = find_included_(path, std::string(file_token.text));
    if (std::ranges::find(open_files_, path) != open_files_.end()) {
        tokens.report(file_token.position,
                      fmt::format("\"{}\" includes itself", printable(file_token.text, 400)));
        return;
    }
    if (read_files_.contains(path)) return;
    if (open_files_.size() > static_cast<std::size_t>(include_depth)) {
        tokens.report(file_token.position,
                      fmt::format("includes nested deeper than {}", include_depth));
        return;
    }
    if (scene_.files.size() >= files_a_scene) {
        tokens.report(file_token.position,
                      fmt::format("the scene has more than {} files", files_a_scene));
        return;
    }
    std::string text;
    try {
        text = reader_(path);
    } catch (const Error& error) {
        tokens.report(file_token.position,
                      fmt::format("cannot include \"{}\": {}", printable(file_token.text, 400),
                                  error.what()));
        return;
    }
    text_bytes_ += text.size();
    if (text_bytes_ > text_bytes_a_scene) {
        tokens.report(file_token.position,
                      fmt::format("the scene's files have more than {} MB in all",
                                  text_bytes_a_scene >> 20U));
        return;
    }
    if (!begins_as_scene(text)) {
        tokens.report(file_token.position,
                      fmt::format("\"{}\" is no scene: it begins with no block, let or include",
                                  printable(file_token.text, 400)));
        return;
    }
    file(path, path, text);
}

/// Also those that no plane shows: a scene is refused for what it says, not for what it does.
void refuse_pictures_outside(const Scene& scene, const AllowedFolders& folders,
                             Diagnostics& diagnostics) {
    for (const TextureBlock& texture : scene.textures) {
        const auto* source = texture.source ? std::get_if<FileTexture>(&*texture.source) : nullptr;
        if (source == nullptr) continue;
        try {
            (void)folders.resolved(picture_path(scene, texture, *source));
        } catch (const Error& error) {
            diagnostics.error(
                texture.source_position,
                fmt::format("{}: {}", block_name("texture", texture.name), error.what()));
        }
    }
}

/// A scene's own file. Of one that is not there, the message says which may have been meant.
std::string read_scene(const std::string& path) {
    try {
        return read_file(path);
    } catch (const Error& error) {
        std::error_code failed;
        if (fs::exists(path, failed)) throw;
        throw Error(error.kind(), error.what() + suggest_scene(path));
    }
}

}  // namespace

Scene parse_scene(const std::string& path, Diagnostics& diagnostics,
                  const std::vector<std::string>& allowed, const LetNumber& let_number,
                  const std::optional<std::string>& text, double frame) {
    AllowedFolders folders(path, allowed);
    if (const auto carried = text ? std::nullopt : carried_scene_at(path)) {
        Scene scene = parse_carried(*carried, path, diagnostics, let_number, frame);
        refuse_pictures_outside(scene, folders, diagnostics);
        if (!diagnostics.has_errors()) refuse_other_pictures(*carried, path, scene, diagnostics);
        return scene;
    }
    const IncludeFinder find = [&](const std::string& beside, const std::string& written) {
        std::error_code failed;
        const auto found = fs::exists(beside, failed) ? std::nullopt : find_included(written);
        if (!found) return beside;
        folders.allow(found->folder);
        return found->path;
    };
    const FileReader reader = [&](const std::string& included) {
        return read_file(folders.resolved(included), included);
    };
    Scene scene = parse_text(path, text ? *text : read_scene(path), diagnostics, reader, let_number,
                             frame, find);
    refuse_pictures_outside(scene, folders, diagnostics);
    return scene;
}

Scene parse_text(const std::string& name, const std::string& text, Diagnostics& diagnostics,
                 const FileReader& reader, const LetNumber& let_number, double frame,
                 const IncludeFinder& find_included) {
    return SceneParser(diagnostics, reader, let_number, frame, find_included).parse(name, text);
}

double time_of(const AnimationBlock& animation, double frame) {
    return animation.frames > 1 ? frame / static_cast<double>(animation.frames - 1) : 0;
}

}  // namespace pxm::host
