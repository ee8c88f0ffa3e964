#include "host/import/fractint/fractint_ifs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "host/import/plane_map.hpp"
#include "host/scene/check/limits.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t flat_numbers = 7;      // a b c d e f p
constexpr std::size_t spatial_numbers = 13;  // 3x3, translation, p

std::size_t numbers_with_weight(const FractintIfs& ifs) {
    return ifs.flat ? flat_numbers : spatial_numbers;
}

std::size_t numbers_a_map(const FractintIfs& ifs) {
    return numbers_with_weight(ifs) - (ifs.weighted ? 0 : 1);
}

const char* what_a_map_holds(const FractintIfs& ifs) {
    if (!ifs.weighted) return ifs.flat ? "a b c d e f" : "3x3 by rows, translation";
    return ifs.flat ? "a b c d e f p" : "3x3 by rows, translation, p";
}

void read_option(FractintIfs& ifs) {
    FractintEntry& entry = ifs.entry;
    if (entry.option.empty()) return;
    ifs.flat = !same_word(entry.option, "3D");
    if (ifs.flat)
        entry.diagnostics.error(entry.position, fmt::format("unknown kind ({}): expected (3D)",
                                                            printable(entry.option)));
}

/// Numbers up to the closing brace, or up to the end of what has neither a name nor braces.
void read_body(FractintReader& reader, FractintIfs& ifs) {
    Diagnostics& diagnostics = ifs.entry.diagnostics;
    const bool bare = ifs.entry.name.empty();
    const auto unclosed = [&] {
        if (bare) return;
        diagnostics.error(ifs.entry.position, fmt::format("entry \"{}\" has no closing '}}'",
                                                          printable(ifs.entry.name)));
    };
    for (;;) {
        reader.skip_blanks();
        while (reader.peek() == ',' || reader.peek() == '"') {
            if (reader.take() == '"') ifs.entry.has_quotes = true;
            reader.skip_blanks();
        }
        if (reader.at_end()) return unclosed();
        if (reader.peek() == '}') {
            reader.take();
            return;
        }
        const Position place = reader.position();
        if (reader.at_head()) return unclosed();
        std::string_view word = reader.word();
        word = word.substr(0, word.find_first_of(",\""));
        double value = 0;
        if (!read_number(word, value)) {
            diagnostics.error(
                place, word.empty()
                           ? "expected a number or '}', found '{'"
                           : fmt::format("expected a number or '}}', found '{}'", printable(word)));
            return reader.skip_entry();
        }
        for (std::size_t i = 0; i < word.size(); ++i) reader.take();
        if (ifs.numbers.size() == maps_an_ifs * numbers_with_weight(ifs)) {
            diagnostics.error(place, fmt::format("more than {} maps", maps_an_ifs));
            return reader.skip_entry();
        }
        ifs.numbers.push_back(value);
        ifs.places.push_back(place);
    }
}

/// How many numbers stand in each line that has any.
struct LineOfNumbers {
    std::size_t first = 0;  // its index
    std::size_t count = 0;
};
std::vector<LineOfNumbers> lines_of(const FractintIfs& ifs) {
    std::vector<LineOfNumbers> lines;
    for (std::size_t i = 0; i < ifs.places.size(); ++i) {
        if (i == 0 || ifs.places[i].line != ifs.places[i - 1].line) lines.push_back({i, 0});
        ++lines.back().count;
    }
    return lines;
}

/// The first map that has too few numbers or too many. Where lines are maps, its line is the one
/// that is unlike them; else it is the last.
void tell_of_odd_map(FractintIfs& ifs) {
    const std::size_t row = numbers_a_map(ifs);
    const std::vector<LineOfNumbers> lines = lines_of(ifs);
    const bool lines_are_maps =
        std::ranges::any_of(lines, [&](const LineOfNumbers& line) { return line.count == row; });
    const std::size_t odd = static_cast<std::size_t>(
        std::ranges::find_if(lines, [&](const auto& line) { return line.count != row; }) -
        lines.begin());
    const std::size_t rest = ifs.numbers.size() % row;
    const LineOfNumbers map =
        lines_are_maps ? lines[odd] : LineOfNumbers{ifs.numbers.size() - rest, rest};
    const std::size_t number = lines_are_maps ? odd + 1 : ifs.numbers.size() / row + 1;
    ifs.entry.diagnostics.error(
        ifs.places[map.first],
        fmt::format(
            "map {} {}has {} of its {} numbers ({})", number,
            ifs.entry.name.empty() ? "" : fmt::format("of \"{}\" ", printable(ifs.entry.name)),
            map.count, row, what_a_map_holds(ifs)));
}

void check(FractintIfs& ifs) {
    FractintEntry& entry = ifs.entry;
    if (entry.diagnostics.has_errors()) return;
    ifs.weighted =
        ifs.numbers.empty() || !std::ranges::all_of(lines_of(ifs), [&](const LineOfNumbers& line) {
            return line.count == numbers_with_weight(ifs) - 1;
        });
    const std::size_t row = numbers_a_map(ifs);
    if (ifs.numbers.empty()) {
        entry.diagnostics.error(entry.position,
                                fmt::format("entry \"{}\" has no maps", printable(entry.name)));
    } else if (ifs.numbers.size() % row != 0) {
        tell_of_odd_map(ifs);
    }
    for (std::size_t i = row - 1; ifs.weighted && i < ifs.numbers.size(); i += row) {
        if (ifs.numbers[i] >= 0) continue;
        entry.diagnostics.error(ifs.places[i],
                                fmt::format("the probability of map {} is {}: it must not be "
                                            "negative",
                                            i / row + 1, ifs.numbers[i]));
    }
}

Affine flat_map(std::span<const double> n) {
    return plane_map({n[0], n[1], n[2], n[3], n[4], n[5]});
}

/// FRACTINT's axes are ours: x to the right, y up, z away from the viewer, whose eye is at the
/// smaller z and sees a point the smaller the larger its z is [IterDyn].
Affine spatial_map(std::span<const double> n) {
    Affine map;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            map.linear[column][row] = n[static_cast<std::size_t>(3 * row + column)];
    map.translation = {n[9], n[10], n[11]};
    return map;
}

/// True if numbers stand here that no name and no brace precede.
bool at_bare_numbers(const FractintReader& reader) {
    const std::string_view word = reader.word();
    double value = 0;
    return read_number(word.substr(0, word.find_first_of(",\"")), value) && !reader.at_head();
}

}  // namespace

std::vector<FractintIfs> parse_fractint_ifs(std::string_view text, Diagnostics& diagnostics) {
    std::vector<FractintIfs> list;
    FractintReader reader(text);
    for (reader.skip_blanks(); !reader.at_end() && !diagnostics.full(); reader.skip_blanks()) {
        FractintIfs ifs;
        if (list.empty() && at_bare_numbers(reader)) {
            ifs.entry.position = reader.position();
        } else if (reader.peek() == '{') {  // a block without a name
            reader.skip_comment_entry();
            continue;
        } else if (!reader.head(ifs.entry, diagnostics)) {
            if (reader.peek() == '}') reader.take();
            continue;
        } else if (is_comment_entry(ifs.entry)) {
            reader.skip_comment_entry();
            continue;
        }
        read_option(ifs);
        read_body(reader, ifs);
        check(ifs);
        list.push_back(std::move(ifs));
    }
    return list;
}

IfsBlock fractint_maps(const FractintIfs& ifs) {
    IfsBlock block;
    block.position = ifs.entry.position;
    const std::size_t row = numbers_a_map(ifs);
    for (std::size_t i = 0; i + row <= ifs.numbers.size(); i += row) {
        const std::span<const double> numbers(ifs.numbers.data() + i, row);
        MapBlock map;
        map.position = ifs.places[i];
        map.commands = {
            {MatrixCommand{ifs.flat ? flat_map(numbers) : spatial_map(numbers)}, map.position}};
        if (ifs.weighted) map.weight = numbers.back();
        block.maps.push_back(std::move(map));
    }
    return block;
}

}  // namespace pxm::host
