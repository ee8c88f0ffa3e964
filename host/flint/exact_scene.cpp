#include "host/flint/exact_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <variant>

#include "host/flint/exact_expression.hpp"

namespace pxm::host {

namespace {

using exact::Entries;
using exact::NotExact;

Entries doubles_of(const Affine& map) {
    Entries entries;
    for (int r = 0; r < 3; ++r) {
        auto& row = entries[static_cast<std::size_t>(r)];
        for (int c = 0; c < 3; ++c)
            row[static_cast<std::size_t>(c)] = {0, exact::Polynomial::of_double(map.linear[c][r])};
        row[3] = {0, exact::Polynomial::of_double(map.translation[r])};
    }
    return entries;
}

/// Whether two texts are one number, up to its sign.
bool same_magnitude(std::string_view a, std::string_view b) {
    const auto bare = [](std::string_view text) {
        text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
        return text.starts_with('-') && text.find_first_of("+-", 1) == text.npos ? text.substr(1)
                                                                                 : text;
    };
    return bare(a) == bare(b);
}

/// Reads what stands behind the words of a map's commands.
template <class Numbers>
class CommandReader {
  public:
    using Value = typename Numbers::Value;
    using Entries = std::array<std::array<Value, 4>, 3>;
    using Point = std::array<Value, 3>;

    CommandReader(const Scene& scene, ExactExpressions<Numbers>& expressions)
        : scene_(scene), expressions_(expressions), field_(expressions.numbers()) {}

    Entries map(const MapBlock& block) {
        Entries entries = unit();
        ratio_ = whole(1);
        for (const Command& command : block.commands) entries = then(entries, read(command));
        return entries;
    }
    /// The factor of the last map, up to its sign, if its commands make it a similitude by
    /// themselves.
    [[nodiscard]] const std::optional<Value>& ratio() const { return ratio_; }

  private:
    [[nodiscard]] Value whole(long value) const { return field_.whole(value); }
    [[nodiscard]] Entries unit() const {
        Entries entries;
        for (std::size_t i = 0; i < 3; ++i) entries[i][i] = whole(1);
        return entries;
    }

    /// First `first`, then `second`.
    Entries then(const Entries& first, const Entries& second) const {
        Entries result;
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 4; ++c) {
                Value sum = c == 3 ? second[r][3] : whole(0);
                for (std::size_t k = 0; k < 3; ++k)
                    sum = field_.add(sum, field_.multiply(second[r][k], first[k][c]));
                result[r][c] = sum;
            }
        return result;
    }

    Entries read(const Command& command) {
        const Position& at = command.position;
        if (at.file < 0 || at.file >= static_cast<int>(scene_.files.size()))
            throw NotExact{"a command without a place in the text"};
        Diagnostics unused;
        TokenReader tokens(text_from(at), at.file, unused);
        const Token word = tokens.take();
        if (!tokens.accept(':')) throw NotExact{"a command that was set from outside"};
        if (word.text == "scale") return scale(tokens);
        if (word.text == "rotate") return rotate(tokens);
        if (word.text == "translate") return translate(tokens);
        if (word.text == "matrix") return matrix(tokens);
        if (word.text == "tetrahedron") return tetrahedron(tokens);
        throw NotExact{"a blend of maps is in no number field"};
    }

    [[nodiscard]] std::string_view text_from(const Position& at) const {
        std::string_view text = scene_.files[static_cast<std::size_t>(at.file)].text;
        if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
        std::size_t start = 0;
        for (int line = 1; line < at.line; ++line) {
            const std::size_t end = text.find('\n', start);
            if (end == std::string_view::npos) return {};
            start = end + 1;
        }
        return text.substr(std::min(text.size(), start + static_cast<std::size_t>(at.column) - 1));
    }

    Entries scale(TokenReader& tokens) {
        Point factors;
        const char* from = tokens.peek().text.data();
        factors.fill(expressions_.read(tokens));
        const std::string_view first(from, tokens.peek().text.data());
        bool same = true;
        for (std::size_t i = 1; i < 3 && tokens.accept(','); ++i) {
            from = tokens.peek().text.data();
            factors[i] = expressions_.read(tokens);
            same = same && same_magnitude(first, {from, tokens.peek().text.data()});
        }
        if (!same) ratio_.reset();
        if (ratio_) ratio_ = field_.multiply(*ratio_, factors[0]);
        Entries entries;
        for (std::size_t i = 0; i < 3; ++i) entries[i][i] = factors[i];
        return entries;
    }

    /// `axis` turns the next axis toward the one after it.
    Entries rotate(TokenReader& tokens) {
        const Token axis = tokens.take();
        tokens.expect(',');
        const Value degrees = expressions_.read(tokens);
        const std::size_t first = axis.text == "x" ? 1 : axis.text == "y" ? 2 : 0;
        const std::size_t second = (first + 1) % 3;
        Entries entries = unit();
        const Value cosine = field_.cosine(degrees);
        const Value sine = field_.sine(degrees);
        entries[first][first] = entries[second][second] = cosine;
        entries[second][first] = sine;
        entries[first][second] = field_.subtract(whole(0), sine);
        return entries;
    }

    Entries translate(TokenReader& tokens) {
        Entries entries = unit();
        for (std::size_t i = 0; i < 3; ++i) {
            if (i > 0) tokens.expect(',');
            entries[i][3] = expressions_.read(tokens);
        }
        return entries;
    }

    Entries matrix(TokenReader& tokens) {
        ratio_.reset();
        Entries entries;
        for (std::size_t i = 0; i < 12; ++i) {
            if (i > 0) tokens.expect(',');
            entries[i % 3][i / 3] = expressions_.read(tokens);
        }
        return entries;
    }

    Point point(TokenReader& tokens) {
        Point p;
        tokens.accept(',');
        for (std::size_t i = 0; i < 3; ++i) {
            tokens.expect(i == 0 ? '(' : ',');
            p[i] = expressions_.read(tokens);
        }
        tokens.expect(')');
        return p;
    }

    [[nodiscard]] Point difference(const Point& a, const Point& b) const {
        return {field_.subtract(a[0], b[0]), field_.subtract(a[1], b[1]),
                field_.subtract(a[2], b[2])};
    }

    [[nodiscard]] Point cross(const Point& a, const Point& b) const {
        Point p;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            p[i] = field_.subtract(field_.multiply(a[j], b[k]), field_.multiply(a[k], b[j]));
        }
        return p;
    }

    /// As in host/scene/parse/compose.cpp: T is the sum over i of f_i (e_j x e_k) / det.
    Entries tetrahedron(TokenReader& tokens) {
        ratio_.reset();
        std::array<Point, 4> from, to;
        for (Point& p : from) p = point(tokens);
        tokens.take();  // the arrow
        for (Point& p : to) p = point(tokens);
        std::array<Point, 3> e, f;
        for (std::size_t i = 0; i < 3; ++i) {
            e[i] = difference(from[i + 1], from[0]);
            f[i] = difference(to[i + 1], to[0]);
        }
        const std::array<Point, 3> c{cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])};
        Value volume = whole(0);
        for (std::size_t i = 0; i < 3; ++i)
            volume = field_.add(volume, field_.multiply(e[0][i], c[0][i]));
        Entries entries;
        for (std::size_t r = 0; r < 3; ++r) {
            Value moved = to[0][r];
            for (std::size_t k = 0; k < 3; ++k) {
                Value sum = whole(0);
                for (std::size_t i = 0; i < 3; ++i)
                    sum = field_.add(sum, field_.multiply(c[i][k], f[i][r]));
                entries[r][k] = field_.divide(sum, volume);
                moved = field_.subtract(moved, field_.multiply(entries[r][k], from[0][k]));
            }
            entries[r][3] = moved;
        }
        return entries;
    }

    const Scene& scene_;
    ExactExpressions<Numbers>& expressions_;
    Numbers& field_;
    std::optional<Value> ratio_;
};

/// All rotations by whole degrees share one field.
void expect_turns(const IfsBlock& block, exact::NumberField& field) {
    constexpr long full_turn = 360, quarters = 4;
    long order = 1;
    for (const MapBlock& map : block.maps)
        for (const Command& command : map.commands) {
            const auto* rotate = std::get_if<RotateCommand>(&command.kind);
            if (rotate == nullptr || std::abs(rotate->degrees) > full_turn) continue;
            const long degrees = std::lround(rotate->degrees);
            if (static_cast<double>(degrees) != rotate->degrees) continue;
            const long turns = full_turn / std::gcd(full_turn, degrees);
            order = std::lcm(order, std::lcm(turns, quarters));
        }
    field.expect_turns(order);
}

}  // namespace

exact::WrittenMaps written_maps(const Scene& scene, const IfsBlock& block) {
    constexpr std::size_t most_maps = 500;  // pairs of them are looked at
    if (block.maps.size() > most_maps) throw NotExact{"the system has more than 500 maps"};
    exact::WrittenMaps written;
    if (scene.files.empty()) {
        for (const MapBlock& map : block.maps)
            written.maps.push_back(doubles_of(compose(map.commands)));
        return written;
    }
    ExactExpressions<FieldNumbers> expressions(scene);
    expect_turns(block, expressions.numbers().field());
    CommandReader reader(scene, expressions);
    try {
        for (const MapBlock& map : block.maps) written.maps.push_back(reader.map(map));
    } catch (const SyntaxError&) {
        throw NotExact{"a number that was set from outside"};
    }
    written.field = std::move(expressions.numbers().field());
    return written;
}

exact::BallMaps balls_as_written(const Scene& scene, const IfsBlock& block) {
    if (scene.files.empty()) throw NotExact{"there is no text"};
    ExactExpressions<BallNumbers> expressions(scene);
    CommandReader reader(scene, expressions);
    exact::BallMaps written;
    try {
        for (const MapBlock& map : block.maps) {
            written.maps.push_back(reader.map(map));
            written.ratio.push_back(reader.ratio());
        }
    } catch (const SyntaxError&) {
        throw NotExact{"a number that was set from outside"};
    }
    return written;
}

}  // namespace pxm::host
