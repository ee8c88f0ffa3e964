#include "host/import/fractint_ifs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "host/fractal/lipschitz.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t flat_numbers = 7;      // a b c d e f p
constexpr std::size_t spatial_numbers = 13;  // 3x3, translation, p
constexpr double point_thickness = 0.5;      // z scale of a map that squashes the plane to a point

std::size_t numbers_a_map(const FractintIfs& ifs) {
    return ifs.flat ? flat_numbers : spatial_numbers;
}

void read_option(FractintIfs& ifs) {
    FractintEntry& entry = ifs.entry;
    if (entry.option.empty()) return;
    ifs.flat = !same_word(entry.option, "3D");
    if (ifs.flat)
        entry.diagnostics.error(entry.position, fmt::format("unknown kind ({}): expected (3D)",
                                                            printable(entry.option)));
}

/// Numbers up to the closing brace.
void read_body(FractintReader& reader, FractintIfs& ifs) {
    Diagnostics& diagnostics = ifs.entry.diagnostics;
    const auto unclosed = [&] {
        diagnostics.error(ifs.entry.position, fmt::format("entry \"{}\" has no closing '}}'",
                                                          printable(ifs.entry.name)));
    };
    for (;;) {
        reader.skip_blanks();
        while (reader.peek() == ',') {
            reader.take();
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
        word = word.substr(0, word.find(','));
        double value = 0;
        if (!read_number(word, value)) {
            diagnostics.error(
                place, word.empty()
                           ? "expected a number or '}', found '{'"
                           : fmt::format("expected a number or '}}', found '{}'", printable(word)));
            return reader.skip_entry();
        }
        for (std::size_t i = 0; i < word.size(); ++i) reader.take();
        if (ifs.numbers.size() == maps_an_ifs * numbers_a_map(ifs)) {
            diagnostics.error(place, fmt::format("more than {} maps", maps_an_ifs));
            return reader.skip_entry();
        }
        ifs.numbers.push_back(value);
        ifs.places.push_back(place);
    }
}

void check(FractintIfs& ifs) {
    FractintEntry& entry = ifs.entry;
    if (entry.diagnostics.has_errors()) return;
    const std::size_t row = numbers_a_map(ifs);
    const std::size_t rest = ifs.numbers.size() % row;
    if (ifs.numbers.empty()) {
        entry.diagnostics.error(entry.position,
                                fmt::format("entry \"{}\" has no maps", printable(entry.name)));
    } else if (rest != 0) {
        entry.diagnostics.error(
            ifs.places[ifs.numbers.size() - rest],
            fmt::format("map {} of \"{}\" has {} of its {} numbers ({})",
                        ifs.numbers.size() / row + 1, printable(entry.name), rest, row,
                        ifs.flat ? "a b c d e f p" : "3x3 by rows, translation, p"));
    }
    for (std::size_t i = row - 1; i < ifs.numbers.size(); i += row) {
        if (ifs.numbers[i] >= 0) continue;
        entry.diagnostics.error(ifs.places[i],
                                fmt::format("the probability of map {} is {}: it must not be "
                                            "negative",
                                            i / row + 1, ifs.numbers[i]));
    }
}

/// The numbers are a column-vector map; row i of the thesis' matrix is its column i.
Affine flat_map(std::span<const double> n) {
    Affine map;
    map.linear[0] = {n[0], n[2], 0};
    map.linear[1] = {n[1], n[3], 0};
    map.linear[2] = {0, 0, 0};
    map.translation = {n[4], n[5], 0};
    const double thickness = std::sqrt(std::abs(n[0] * n[3] - n[1] * n[2]));
    const double stretch = lipschitz_constant(map);
    map.linear[2][2] = thickness > 0 ? thickness : stretch > 0 ? stretch : point_thickness;
    return map;
}

/// FRACTINT's z points to the viewer, ours away: both are mirrored, so that the picture is not.
Affine spatial_map(std::span<const double> n) {
    Affine map;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double sign = (row == 2) != (column == 2) ? -1 : 1;
            map.linear[column][row] = sign * n[static_cast<std::size_t>(3 * row + column)] + 0.0;
        }
    }
    map.translation = {n[9], n[10], -n[11] + 0.0};
    return map;
}

}  // namespace

std::vector<FractintIfs> parse_fractint_ifs(std::string_view text, Diagnostics& diagnostics) {
    std::vector<FractintIfs> list;
    FractintReader reader(text);
    for (reader.skip_blanks(); !reader.at_end() && !diagnostics.full(); reader.skip_blanks()) {
        FractintIfs ifs;
        if (!reader.head(ifs.entry, diagnostics)) {
            if (reader.peek() == '}') reader.take();
            continue;
        }
        if (is_comment_entry(ifs.entry)) {
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
        map.weight = numbers.back();
        block.maps.push_back(std::move(map));
    }
    return block;
}

}  // namespace pxm::host
