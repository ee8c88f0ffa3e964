#include "host/scene/parse/source_pieces.hpp"

#include <algorithm>

namespace pxm::host {

namespace {

/// `text` has nothing but blanks, newlines and comments.
Gap gap_of(std::string_view text) {
    Gap gap;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '\n') {
            ++gap.newlines;
            gap.blanks = 0;
        } else if (text[at] == '#') {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            const std::string_view line = text.substr(at, end - at);
            const std::size_t last = line.find_last_not_of(" \t\r");
            gap.comments.push_back({std::string(line.substr(0, last + 1)), gap.newlines});
            gap.newlines = gap.blanks = 0;
            at = end - 1;
        } else {
            ++gap.blanks;
        }
    }
    return gap;
}

}  // namespace

std::vector<Piece> pieces_of(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    Lexer lexer(text, 0);
    std::vector<Piece> pieces;
    std::size_t place = 0;
    while (true) {
        const Token token = lexer.next();
        std::string_view written = token.text;
        std::size_t begin = text.size();
        if (token.kind != TokenKind::end) {
            begin = static_cast<std::size_t>(written.data() - text.data());
            if (token.kind == TokenKind::string)
                written = text.substr(--begin, written.size() + 2);  // the quotes
        }
        pieces.push_back(
            {token.kind, std::string(written), gap_of(text.substr(place, begin - place))});
        if (token.kind == TokenKind::end) return pieces;
        place = begin + written.size();
    }
}

}  // namespace pxm::host
