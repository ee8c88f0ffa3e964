// The cells that one ray has opened, for scenes whose cells overlap very much (docs/overlaps.md).
// What a ray meets inside a cell follows from the ray in the cell's own coordinates. Where these
// are the same to within a step of half a pixel at most, so is what lies inside: the cell that
// comes first in the order (key, object, word) is opened, and later ones are not, unless they are
// smaller: what a cell holds must not be left to a cell around it, of which it is a part.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dsp_kernels/diameter.hpp"
#include "dsp_kernels/search.hpp"

namespace pxm::host {

/// A hash of numbers that are cut to steps. Two cells of different steps are taken for the same
/// once in 2^64 comparisons.
class CellSketch {
  public:
    void add(std::uint64_t number) {
        low_ = mix(low_ ^ number);
        high_ = mix(high_ + number);
    }
    void add(double x, double per_step) {
        // Numbers of scenes are multiples of powers of two more often than not: no step ends there.
        constexpr double aside = 0.3819660112501051;
        const double step = std::floor(x * per_step + aside);
        constexpr double most = 0x1p62;  // beyond, and for NaN, all count as one
        add(std::abs(step) < most ? static_cast<std::uint64_t>(static_cast<std::int64_t>(step))
                                  : ~std::uint64_t{0});
    }
    [[nodiscard]] std::uint64_t low() const { return low_; }
    [[nodiscard]] std::uint64_t high() const { return high_; }

  private:
    /// As the finalizer of MurmurHash3.
    [[nodiscard]] static std::uint64_t mix(std::uint64_t x) {
        x = (x ^ x >> 33U) * 0xFF51AFD7ED558CCDU;
        return x ^ x >> 29U;
    }
    std::uint64_t low_ = 0x9E3779B97F4A7C15U;
    std::uint64_t high_ = 0xC4CEB9FE1A85EC53U;
};

/// A table of at most `room` cells: what comes after that is not remembered, and opened each time.
class KnownCells {
  public:
    static constexpr std::size_t room = std::size_t{1} << 16;

    void forget() {
        ++ray_;
        count_ = 0;
    }
    /// Whether a cell of that sketch was opened that is no larger and whose interval ended there or
    /// later; if not, this one counts as opened. Cells that are alike have the same follow set, and
    /// sizes shrink from one to another inside it (but where maps contract in the long run alone):
    /// so no cell is known by one around it, nor do two wait for what each finds in the other.
    [[nodiscard]] bool contains(const CellSketch& sketch, double exit, double size) noexcept;

  private:
    struct Entry {
        std::uint64_t low = 0;
        std::uint64_t high = 0;
        double exit = 0;
        double size = 0;
        std::uint64_t ray = 0;  // that it was made for
    };

    std::vector<Entry> entries_ = std::vector<Entry>(2 * room);
    std::size_t count_ = 0;
    std::uint64_t ray_ = 1;
};

/// 1 over the largest power of two that is no more than `step`: nearly the same for cells at
/// slightly different distances, whose pixels have slightly different sizes.
[[nodiscard]] inline double steps_per_unit(double step) {
    constexpr std::uint64_t exponent = 0x7FF0000000000000U, one_over = 0x7FE0000000000000U;
    return std::bit_cast<double>(one_over - (std::bit_cast<std::uint64_t>(step) & exponent));
}

/// What a ray sees of a cell, lengths cut to at most `step` scene units.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] CellSketch sketch_of(Node& node, const kernels::Cell<Real>& cell, double step) {
    using Object = kernels::ObjectRecord<real_words<Real>>;
    using Set = kernels::FollowSetRecord<real_words<Real>>;
    constexpr int share_bits = 10;  // of a constant: sizes are the same to a thousandth
    const double constant = to_double(cell.constant);
    const double inside = step / constant;  // in the cell's coordinates
    const double diameter = to_double(node.shape_real(cell.follow_set + Set::diameter));
    const double turn = inside / (constant * diameter);  // of the direction, over the whole cell
    CellSketch sketch;
    sketch.add(std::uint64_t{cell.object} << 32U | cell.follow_set);
    const std::uint32_t levels = node.shape_word(cell.object + Object::levels);
    sketch.add(std::uint64_t{levels == kernels::unlimited_levels ? 0U : cell.level});
    const auto add = [&](const kernels::Vec3<Real>& v, double per_unit) {
        for (const Real x : {v.x, v.y, v.z}) sketch.add(to_double(x), per_unit);
    };
    add(cell.ray.origin, steps_per_unit(inside));
    add(cell.ray.direction, steps_per_unit(turn));
    sketch.add(to_double(cell.ray.base), steps_per_unit(step));
    if (kernels::is_polar(node, cell.object)) {
        for (const auto& row : cell.linear.rows) add(row, steps_per_unit(step / diameter));
    } else {
        constexpr int dropped = 52 - share_bits;
        constexpr std::uint64_t aside = std::uint64_t{0x61C88647U} << (dropped - 32);
        sketch.add((std::bit_cast<std::uint64_t>(constant) + aside) >> dropped);
    }
    return sketch;
}

/// Whether a ray has opened such a cell before, told apart by steps of half that share of a pixel
/// to the whole of it; if not, it has now. Cells of lifted maps are never known: their thickness
/// depends on the way to them.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool knows_cell(Node& node, KnownCells& known, double share,
                              const kernels::Search<Real>& search,
                              const kernels::Cell<Real>& cell) noexcept {
    using Object = kernels::ObjectRecord<real_words<Real>>;
    if ((node.shape_word(cell.object + Object::squash) & kernels::squash_flat) != 0) return false;
    const double pixel = to_double(kernels::pixel_at(node, search, cell.object, cell.key));
    const double step = share * to_double(search.detail) * pixel;
    return known.contains(sketch_of(node, cell, step), to_double(cell.exit),
                          to_double(cell.constant));
}

}  // namespace pxm::host
