// Pieces to lines. Every decision looks at what was written (does the author break the line here?)
// and at the line so far; what it leads to is what would be decided again, so that formatting twice
// is formatting once.
#include "host/scene/print/format.hpp"

#include <algorithm>
#include <cstddef>

#include "host/scene/parse/grammar.hpp"
#include "host/scene/parse/source_pieces.hpp"
#include "host/scene/print/formatted_lines.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t width = 120;  // columns
constexpr std::size_t step = 4;     // of indentation

enum class Role { top, open, close, map, of_ifs, directive, value, end };

/// What each piece is: the beginning of something, or a part of what began before it.
std::vector<Role> roles_of(const std::vector<Piece>& pieces) {
    std::vector<Role> roles;
    const BlockGrammar* announced = nullptr;  // by the kind, until its brace
    const BlockGrammar* block = nullptr;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& piece = pieces[i];
        const bool word = piece.kind == TokenKind::word;
        Role role = piece.kind == TokenKind::end ? Role::end : Role::value;
        if (piece.kind == TokenKind::symbol && piece.is("{")) {
            role = Role::open;
            block = announced;
        } else if (piece.kind == TokenKind::symbol && piece.is("}")) {
            role = Role::close;
            block = announced = nullptr;
        } else if (word && block == nullptr) {
            const BlockGrammar* kind = find_block(piece.text);
            if (kind != nullptr) announced = kind;
            if (kind != nullptr || piece.is("let") || piece.is("include")) role = Role::top;
        } else if (word && block->find(piece.text) >= 0) {
            const Directive& found =
                block->directives[static_cast<std::size_t>(block->find(piece.text))];
            // `heap` in `intersect: heap` is no directive: those that need values have a colon.
            if (found.values != Values::needed || pieces[i + 1].is(":")) role = Role::directive;
            if (piece.is("newmap")) role = Role::map;
            if (role == Role::directive && (piece.is("follow") || piece.is("start")))
                role = Role::of_ifs;
        }
        roles.push_back(role);
    }
    return roles;
}

class Formatter {
  public:
    explicit Formatter(std::string_view text)
        : pieces_(pieces_of(text)), roles_(roles_of(pieces_)) {}

    std::string format() {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            comments(i);
            if (roles_[i] != Role::end) piece(i);
            follow(i);
        }
        return lines_.text();
    }

  private:
    void comments(std::size_t i) {
        for (const Comment& comment : pieces_[i].before.comments) {
            if (comment.newlines_before == 0 && lines_.in_line()) {
                lines_.end_with(comment.text);
                continue;
            }
            if (comment.newlines_before > 1) lines_.blank();
            const std::size_t indent = roles_[i] == Role::close ? step : indent_of(i);
            lines_.begin(indent);
            lines_.add(comment.text);
            lines_.end();
        }
    }

    void piece(std::size_t i) {
        if (!lines_.in_line() || begins_line(i)) {
            const bool starts =
                roles_[i] != Role::value && roles_[i] != Role::open && roles_[i] != Role::close;
            if (starts && pieces_[i].before.newlines > 1) lines_.blank();
            lines_.begin(indent_of(i));
        } else {
            lines_.add(separator(i));
        }
        lines_.add(pieces_[i].text);
    }

    /// What the piece changes for those that follow.
    void follow(std::size_t i) {
        if (roles_[i] == Role::open) {
            in_map_ = false;
            many_lines_ = !fits_on_line(i);
            if (many_lines_) lines_.opened();
        }
        if (roles_[i] == Role::close) many_lines_ = false;
        if (roles_[i] == Role::map) in_map_ = true;
        if (roles_[i] == Role::map || roles_[i] == Role::of_ifs || roles_[i] == Role::directive)
            level_ = indent_of(i);
        if (roles_[i] == Role::top) level_ = 0;
    }

    [[nodiscard]] std::size_t indent_of(std::size_t i) const {
        switch (roles_[i]) {
            case Role::map:
            case Role::of_ifs:
                return step;
            case Role::directive:
                return in_map_ ? 2 * step : step;
            case Role::value:
                return level_ + step;
            default:
                return 0;
        }
    }

    [[nodiscard]] bool begins_line(std::size_t i) const {
        switch (roles_[i]) {
            case Role::top:
                return true;
            case Role::close:
            case Role::map:
            case Role::of_ifs:
                return many_lines_;
            case Role::directive:
                return many_lines_ && (roles_[i - 1] == Role::open || pieces_[i].before.breaks() ||
                                       !fits_behind(i));
            case Role::value:
                return pieces_[i].before.breaks() && may_break(i);
            default:
                return false;
        }
    }

    /// Whether a line may end before a part of a value: not beside what clings to its neighbour.
    [[nodiscard]] bool may_break(std::size_t i) const {
        const Piece& before = pieces_[i - 1];
        const Piece& piece = pieces_[i];
        if (roles_[i - 1] == Role::top || roles_[i - 1] == Role::map) return false;
        if (before.is("(") || piece.is("=")) return false;
        return !(piece.is(",") || piece.is(")") || piece.is(":"));
    }

    [[nodiscard]] std::string separator(std::size_t i) const {
        const Piece& before = pieces_[i - 1];
        const Piece& piece = pieces_[i];
        if (roles_[i - 1] == Role::open && roles_[i] == Role::close) return "";
        if (roles_[i] != Role::value) {
            const bool apart = (roles_[i - 1] == Role::value || roles_[i - 1] == Role::directive) &&
                               piece.before.blanks > 1;
            return apart && roles_[i] == Role::directive ? "  " : " ";
        }
        if (before.is("(") || piece.is(",") || piece.is(")") || piece.is(":")) return "";
        const bool spaced = before.is(":") || before.is("=") || piece.is("=") ||
                            before.kind == TokenKind::arrow || piece.kind == TokenKind::arrow;
        return spaced || piece.before.blanks > 0 || piece.before.breaks() ? " " : "";
    }

    /// The columns of the pieces from i on, up to the next that begins something or a line.
    [[nodiscard]] std::size_t columns_of(std::size_t i) const {
        std::size_t columns = separator(i).size() + columns_in(pieces_[i].text);
        for (std::size_t k = i + 1; roles_[k] == Role::value && !begins_line(k); ++k)
            columns += separator(k).size() + columns_in(pieces_[k].text);
        return columns;
    }

    [[nodiscard]] bool fits_behind(std::size_t i) const {
        return lines_.columns() + columns_of(i) <= width;
    }

    /// Whether the block that opens with piece i is on one line and may stay there.
    [[nodiscard]] bool fits_on_line(std::size_t i) const {
        std::size_t columns = lines_.columns();
        for (std::size_t k = i + 1; roles_[k] != Role::end; ++k) {
            if (pieces_[k].before.breaks()) return false;
            columns += separator(k).size() + columns_in(pieces_[k].text);
            if (roles_[k] == Role::close) break;
        }
        return columns <= width;
    }

    std::vector<Piece> pieces_;
    std::vector<Role> roles_;
    FormattedLines lines_;
    bool many_lines_ = false;  // the block's directives have lines of their own
    bool in_map_ = false;
    std::size_t level_ = 0;  // indentation of the directive that values belong to
};

}  // namespace

std::string format_scene(std::string_view text) { return Formatter(text).format(); }

}  // namespace pxm::host
