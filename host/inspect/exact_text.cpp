#include "host/inspect/exact_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/inspect/dimension_order.hpp"

namespace pxm::host {

namespace {

void line(std::string& text, const char* what, const std::string& value) {
    text += fmt::format("  {:<20} {}\n", what, value);
}

/// Six digits, and 0 for what is 0 against `size`.
std::string number(double x, double size) {
    constexpr double nothing = 1e-9;
    return fmt::format("{:.6g}", std::abs(x) < nothing * size ? 0.0 : x);
}

std::string point(const glm::dvec3& p, double size) {
    return fmt::format("({}, {}, {})", number(p.x, size), number(p.y, size), number(p.z, size));
}

std::string answer(const Decided<bool>& decided) {
    const char* word = !decided.value ? "unknown" : *decided.value ? "yes" : "no";
    return fmt::format("{}: {}", word, decided.why);
}

std::string answer(const Decided<double>& decided) {
    if (!decided.value) return "unknown: " + decided.why;
    return fmt::format("{:.6g}: {}", *decided.value, decided.why);
}

std::string word(const IfsFacts& ifs, const std::vector<int>& maps) {
    std::string text;
    for (const int m : maps)
        text += (text.empty() ? "" : " ") + ifs.exact_names[static_cast<std::size_t>(m)];
    return text;
}

void add_order(const IfsFacts& ifs, std::string& text) {
    const DimensionOrder order = dimension_order(ifs);
    std::string value;
    for (std::size_t i = 0; i < order.dimensions.size(); ++i) {
        const OrderedDimension& one = order.dimensions[i];
        if (i > 0) value += fmt::format(" {} ", order.links[i - 1].relation);
        value += one.value
                     ? fmt::format("{} {:.6g} ({})", one.name, *one.value, known_name(one.known))
                     : fmt::format("{} unknown", one.name);
    }
    line(text, "in order", value);
}

/// How many parts the cells of each level make.
void add_parts(const ExactFindings& exact, std::string& text) {
    constexpr std::size_t most = 12;  // levels in a line
    if (exact.parts_of_levels.empty()) return;
    std::string parts;
    for (std::size_t i = 0; i < std::min(most, exact.parts_of_levels.size()); ++i)
        parts += fmt::format("{}{}", i > 0 ? ", " : "", exact.parts_of_levels[i]);
    line(text, "", parts + " parts of the first levels' cells");
    if (exact.components.value || exact.infinite_components.value_or(false))
        line(text, "connected pieces",
             fmt::format("{}: {}",
                         exact.components.value ? std::to_string(*exact.components.value)
                                                : "infinitely many",
                         exact.components.why));
}

std::string threes(const ExactFindings& exact) {
    if (*exact.triples.value == 0) return "no three cells have a common point";
    std::string where =
        fmt::format("{} pairs of neighbours at a point of their cell", *exact.triples.value);
    if (exact.triple_dimension.value)
        where += fmt::format("; such points have dimension {:.6g}", *exact.triple_dimension.value);
    return where;
}

void add_exact(const IfsFacts& ifs, std::string& text) {
    const ExactFindings& exact = ifs.exact;
    line(text, "numbers", exact.degree > 0 ? exact.numbers : "not exact: " + exact.numbers);
    if (exact.degree == 0 && exact.interval_digits == 0) return;
    line(text, "neighbours",
         exact.finite.value.value_or(false) ? "finite, " + exact.finite.why : exact.finite.why);
    line(text, "exact overlaps", answer(exact.overlaps));
    if (exact.overlaps.value.value_or(false))
        line(text, "",
             fmt::format("{} and {}", word(ifs, exact.overlapping_words[0]),
                         word(ifs, exact.overlapping_words[1])));
    line(text, "Hausdorff", answer(exact.hausdorff));
    line(text, "connected", answer(exact.connected));
    add_parts(exact, text);
    if (exact.triples.value) line(text, "meeting in threes", threes(exact));
    line(text, "inside", answer(exact.interior));
    if (exact.interior.value.value_or(false)) line(text, "volume", answer(exact.volume));
    line(text, "boundary", answer(exact.boundary));
}

void add_measure(const IfsFacts& ifs, std::string& text) {
    const double size = ifs.diameter.value;
    if (ifs.moments) {
        line(text, "centroid", point(ifs.moments->centroid, size));
        std::string axes;
        for (std::size_t i = 0; i < ifs.moments->axes.size(); ++i)
            axes += fmt::format("{}{} along {}", i > 0 ? "; " : "variance ",
                                number(ifs.moments->variances[i], size * size),
                                point(ifs.moments->axes[i], 1));
        line(text, "principal axes", axes);
    }
    const bool near = ifs.diameter.upper <= ifs.diameter.value * (1 + 1e-5);
    line(text, "diameter",
         fmt::format("{}{} between {} and {}", number(size, 1),
                     near ? "" : fmt::format(", at most {:.6g},", ifs.diameter.upper),
                     point(ifs.diameter.between[0], size), point(ifs.diameter.between[1], size)));
}

}  // namespace

std::string exact_text(const IfsFacts& ifs) {
    std::string text;
    add_order(ifs, text);
    add_exact(ifs, text);
    add_measure(ifs, text);
    return text;
}

}  // namespace pxm::host
