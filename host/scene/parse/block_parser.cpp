// What all blocks have in common: head, directives, repetition, recovery.
#include "host/scene/parse/block_parser.hpp"

#include <fmt/format.h>

#include "host/text/printable.hpp"

namespace pxm::host {

bool at_top_level_start(const TokenReader& tokens) {
    const Token& word = tokens.peek();
    const Token& second = tokens.peek_second();
    if (word.kind != TokenKind::word) return false;
    if (word.text == "include") return second.is(':') || second.kind == TokenKind::string;
    if (word.text == "let") return second.kind == TokenKind::word;
    if (find_block(word.text) == nullptr) return false;
    // A kind and a name alone may be a directive that lacks its colon, as in `ifs grass`.
    return second.is('{') || (second.kind == TokenKind::word && tokens.peek_third().is('{'));
}

void skip_until(TokenReader& tokens, const std::function<bool()>& stop) {
    long depth = 0;
    while (tokens.peek().kind != TokenKind::end) {
        if (at_top_level_start(tokens) || (depth == 0 && stop())) return;
        const Token skipped = tokens.take();
        if (skipped.is('{')) ++depth;
        if (skipped.is('}') && depth > 0) --depth;
    }
}

void BlockParser::block() {
    const std::string_view kind = find_block(tokens_.peek().text)->kind;
    if (kind == "ifs") ifs();
    if (kind == "object") object();
    if (kind == "plane") plane();
    if (kind == "texture") texture();
    if (kind == "light") light();
    if (kind == "camera") camera();
    if (kind == "image") image();
    if (kind == "render") render();
    if (kind == "animation") animation();
}

BlockParser::Head BlockParser::head(const BlockGrammar& grammar) {
    const Token kind = tokens_.take();
    Head head{{}, kind.position};
    const Token& next = tokens_.peek();
    // `camera eye: ...` lacks its brace, `object cone { ... }` has a keyword for a name.
    const bool named =
        next.kind == TokenKind::word && (!is_keyword(next.text) || tokens_.peek_second().is('{'));
    if (grammar.naming == Naming::needed || (grammar.naming == Naming::allowed && named))
        head.name = values_.name(fmt::format("the {}", kind.text));
    return head;
}

void BlockParser::body(const BlockGrammar& grammar, const Handler& handler) {
    const Token open = tokens_.expect('{', fmt::format("the directives of '{}'", grammar.kind));
    const std::string unclosed =
        fmt::format("the '{}' of line {} is not closed", grammar.kind, open.position.line);
    seen_ = 0;
    while (!tokens_.accept('}')) {
        const long taken = tokens_.taken();
        try {
            if (tokens_.peek().kind == TokenKind::end) tokens_.fail_expected("'}'", unclosed);
            if (at_top_level_start(tokens_)) tokens_.fail_expected("'}'", unclosed);
            const Token word = directive_word(grammar);
            note_repetition(grammar, word);
            handler(word);
        } catch (const SyntaxError&) {
            if (tokens_.peek().kind == TokenKind::end || at_top_level_start(tokens_)) return;
            if (tokens_.taken() == taken && !tokens_.peek().is('{')) tokens_.take();
            recover(grammar);
        }
    }
}

/// The next directive with the colon behind it, if it takes values.
Token BlockParser::directive_word(const BlockGrammar& grammar) {
    if (tokens_.peek().kind != TokenKind::word)
        tokens_.fail_expected(fmt::format("a directive of '{}' or '}}'", grammar.kind));
    const Token word = tokens_.take();
    const int index = grammar.find(word.text);
    if (index < 0) {
        std::string help = suggest_directive(word.text, grammar);
        if (help.empty()) help = fmt::format(" (it takes {})", directive_list(grammar));
        tokens_.fail(word.position, fmt::format("unknown directive '{}' in '{}'{}",
                                                printable(word.text), grammar.kind, help));
    }
    const Values values = grammar.directives[static_cast<std::size_t>(index)].values;
    if (values == Values::needed || (values == Values::optional && tokens_.peek().is('(')))
        tokens_.expect(':', fmt::format("before the values of '{}'", word.text));
    if (values == Values::none && tokens_.peek().is(':'))
        tokens_.fail(tokens_.peek().position, fmt::format("'{}' takes no values", word.text));
    return word;
}

void BlockParser::note_repetition(const BlockGrammar& grammar, const Token& word) {
    const auto index = static_cast<std::size_t>(grammar.find(word.text));
    const Times times = grammar.directives[index].times;
    const unsigned bit = 1U << index;
    if (times != Times::many && (seen_ & bit) != 0)
        tokens_.report(word.position,
                       fmt::format("'{}' is given twice in this {}", word.text,
                                   times == Times::once ? std::string(grammar.kind) : "map"));
    seen_ |= bit;
    if (word.text != "newmap") return;
    for (std::size_t i = 0; i < grammar.directives.size(); ++i)
        if (grammar.directives[i].times == Times::once_a_map) seen_ &= ~(1U << i);
}

/// Goes on at '}', at a word with a colon behind it, or at a directive that takes no values.
void BlockParser::recover(const BlockGrammar& grammar) {
    skip_until(tokens_, [&] {
        const Token& next = tokens_.peek();
        if (next.is('}')) return true;
        if (next.kind != TokenKind::word) return false;
        if (tokens_.peek_second().is(':')) return true;
        const int index = grammar.find(next.text);
        return index >= 0 &&
               grammar.directives[static_cast<std::size_t>(index)].values != Values::needed;
    });
}

}  // namespace pxm::host
