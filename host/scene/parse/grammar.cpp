#include "host/scene/parse/grammar.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "host/text/nearest.hpp"

namespace pxm::host {
namespace {

constexpr Directive ifs_directives[] = {
    {"newmap", Values::none, Times::many},        {"scale", Values::needed, Times::many},
    {"rotate", Values::needed, Times::many},      {"translate", Values::needed, Times::many},
    {"matrix", Values::needed, Times::many},      {"tetrahedron", Values::needed, Times::many},
    {"color", Values::needed, Times::once_a_map}, {"weight", Values::needed, Times::once_a_map},
    {"follow", Values::needed, Times::many},      {"start"},
    {"blend", Values::needed, Times::many},
};
constexpr Directive object_directives[] = {
    {"ifs"},
    {"sphere", Values::optional, Times::many},
    {"box", Values::optional, Times::many},
    {"cone", Values::none, Times::many},
    {"cylinder", Values::none, Times::many},
    {"hull", Values::none, Times::many},
    {"auto", Values::none, Times::many},
    {"scale", Values::needed, Times::many},
    {"rotate", Values::needed, Times::many},
    {"translate", Values::needed, Times::many},
    {"matrix", Values::needed, Times::many},
    {"color"},
    {"opacity"},
    {"diffuse"},
    {"reflect"},
    {"levels"},
};
constexpr Directive plane_directives[] = {
    {"point"}, {"normal"}, {"color"}, {"texture"}, {"reflect"},
};
constexpr Directive texture_directives[] = {
    {"file", Values::needed, Times::many},
    {"ifs", Values::needed, Times::many},
    {"wood", Values::none, Times::many},
    {"size"},
    {"color"},
    {"color2"},
};
constexpr Directive light_directives[] = {
    {"direction"},
    {"position"},
    {"color"},
    {"shadow"},
};
constexpr Directive camera_directives[] = {
    {"eye"}, {"look"}, {"up"}, {"fov"}, {"orthographic"}, {"zoom"},
};
constexpr Directive image_directives[] = {{"size"}, {"crop"}};
constexpr Directive render_directives[] = {
    {"ambient"}, {"background"}, {"shading"}, {"covers"},    {"samples"}, {"intersect"},
    {"numeric"}, {"detail"},     {"volume"},  {"lipschitz"}, {"heap"},    {"bounces"},
};

constexpr Directive animation_directives[] = {{"frames"}, {"rate"}, {"shutter"}};

constexpr BlockGrammar blocks[] = {
    {"ifs", Naming::needed, ifs_directives},
    {"object", Naming::allowed, object_directives},
    {"plane", Naming::allowed, plane_directives},
    {"texture", Naming::needed, texture_directives},
    {"light", Naming::allowed, light_directives},
    {"camera", Naming::allowed, camera_directives},
    {"image", Naming::none, image_directives},
    {"render", Naming::none, render_directives},
    {"animation", Naming::none, animation_directives},
};

constexpr std::array<std::string_view, 6> number_words{"pi", "phi", "sqrt", "sin", "cos", "tan"};

constexpr std::array<std::string_view, 6> free_words{"animation", "frames", "rate",
                                                     "shutter",   "zoom",   "blend"};

}  // namespace

std::span<const BlockGrammar> all_blocks() { return blocks; }

const BlockGrammar* find_block(std::string_view kind) {
    if (kind == "rifs") kind = "ifs";
    const auto* found = std::ranges::find(blocks, kind, &BlockGrammar::kind);
    return found == std::end(blocks) ? nullptr : found;
}

int BlockGrammar::find(std::string_view word) const {
    const auto found = std::ranges::find(directives, word, &Directive::word);
    return found == directives.end() ? -1 : static_cast<int>(found - directives.begin());
}

bool is_number_word(std::string_view word) {
    return std::ranges::find(number_words, word) != number_words.end();
}

bool is_keyword(std::string_view word) {
    if (std::ranges::find(free_words, word) != free_words.end()) return false;
    if (find_block(word) != nullptr || word == "let" || word == "include") return true;
    return is_number_word(word) || std::ranges::any_of(blocks, [&](const BlockGrammar& block) {
               return block.find(word) >= 0;
           });
}

std::string suggest_directive(std::string_view word, const BlockGrammar& block) {
    std::vector<std::string_view> candidates;
    for (const Directive& directive : block.directives) candidates.push_back(directive.word);
    return suggestion(word, candidates);
}

std::string suggest_block(std::string_view word) {
    std::vector<std::string_view> candidates{"let", "include"};
    for (const BlockGrammar& block : blocks) candidates.push_back(block.kind);
    return suggestion(word, candidates);
}

std::string directive_list(const BlockGrammar& block) {
    std::string list;
    for (const Directive& directive : block.directives)
        list += (list.empty() ? "" : ", ") + std::string(directive.word);
    return list;
}

}  // namespace pxm::host
