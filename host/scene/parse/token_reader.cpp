#include "host/scene/parse/token_reader.hpp"

#include <fmt/format.h>

namespace pxm::host {

TokenReader::TokenReader(std::string_view text, int file, Diagnostics& diagnostics)
    : lexer_(text, file), diagnostics_(diagnostics), next_(lexer_.next()), second_(lexer_.next()) {}

Token TokenReader::take() {
    const Token taken = next_;
    if (taken.kind == TokenKind::end) return taken;
    ++taken_;
    next_ = second_;
    second_ = lexer_.next();
    return taken;
}

bool TokenReader::accept(char symbol) {
    if (!next_.is(symbol)) return false;
    take();
    return true;
}

Token TokenReader::expect(char symbol, std::string_view note) {
    if (!next_.is(symbol)) fail_expected(fmt::format("'{}'", symbol), note);
    return take();
}

void TokenReader::report(const Position& position, const std::string& message) {
    if (given_up_) return;
    diagnostics_.error(position, message);
    if (diagnostics_.overflowed()) give_up();
}

void TokenReader::fail(const Position& position, const std::string& message) {
    report(position, message);
    throw SyntaxError{};
}

void TokenReader::fail_expected(std::string_view what, std::string_view note) {
    std::string message = fmt::format("expected {}, found {}", what, describe(next_));
    if (!note.empty()) message += fmt::format(" ({})", note);
    fail(next_.position, message);
}

void TokenReader::give_up() {
    given_up_ = true;
    lexer_ = Lexer({}, next_.position.file);
    next_ = second_ = Token{TokenKind::end, {}, next_.position};
}

}  // namespace pxm::host
