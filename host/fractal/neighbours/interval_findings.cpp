#include "host/fractal/neighbours/interval_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>

#include "host/fractal/exact/number_field.hpp"
#include "host/fractal/neighbours/apart.hpp"
#include "host/fractal/neighbours/graph_growth.hpp"
#include "host/fractal/neighbours/groups.hpp"

namespace pxm::host {

namespace {

using exact::BallEntries;
using exact::RealBall;

/// Coordinates that are 0 on the attractor whatever the balls' numbers are: the map leaves them to
/// themselves and does not move them.
std::vector<std::size_t> axes_of(const exact::BallMaps& balls) {
    std::vector<std::size_t> axes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool stays_0 = std::ranges::all_of(balls.maps, [&](const BallEntries& map) {
            for (std::size_t c = 0; c < 4; ++c)
                if (c != axis && !map[axis][c].is_zero()) return false;
            return true;
        });
        if (!stays_0) axes.push_back(axis);
    }
    return axes;
}

RealBall determinant(const BallEntries& m, const std::vector<std::size_t>& axes) {
    const auto at = [&](std::size_t r, std::size_t c) -> const RealBall& {
        return m[axes[r]][axes[c]];
    };
    if (axes.empty()) return RealBall(1);
    if (axes.size() == 1) return at(0, 0);
    if (axes.size() == 2) return at(0, 0) * at(1, 1) - at(0, 1) * at(1, 0);
    RealBall sum;
    for (std::size_t c = 0; c < 3; ++c)
        sum = sum + at(0, c) * (at(1, (c + 1) % 3) * at(2, (c + 2) % 3) -
                                at(1, (c + 2) % 3) * at(2, (c + 1) % 3));
    return sum;
}

class IntervalAnswers {
  public:
    IntervalAnswers(const exact::BallMaps& balls, const Rifs& rifs,
                    const std::vector<Bounds>& bounds, const std::string& numbers)
        : balls_(balls), rifs_(rifs), bounds_(bounds), axes_(axes_of(balls)) {
        found_.interval_digits = exact::digits_of(balls);
        by_ = fmt::format(", in intervals of {} digits", found_.interval_digits);
        found_.numbers = fmt::format("{}: intervals of {} digits", numbers, found_.interval_digits);
    }

    ExactFindings run() {
        constexpr double allowed = 5e-7;  // of a ball's radius
        const double offset = exact::offset_of(balls_, rifs_);
        for (const Bounds& b : bounds_) {
            const double far = std::max(1.0, glm::length(b.ball.center) + b.ball.radius);
            if (!(offset * far <= allowed * b.ball.radius))
                throw exact::NotExact{"the bounds are not proven: the maps contract too late"};
        }
        const double smallest = std::pow(10, -0.5 * found_.interval_digits);
        together_ = not_told_apart(balls_, rifs_, bounds_, smallest);
        // What two images of a map that is not injective have in common is not seen in what they
        // are images of (Erratum 16).
        const bool injective = std::ranges::all_of(balls_.maps, [&](const BallEntries& map) {
            const RealBall det = determinant(map, axes_);
            return det.is_positive() || det.is_negative();
        });
        apart_ = injective &&
                 std::ranges::all_of(together_, [](const auto& pairs) { return pairs.empty(); });
        found_.dimensions = static_cast<int>(axes_.size());
        add_images();
        add_open_set();
        add_hausdorff();
        add_interior();
        return std::move(found_);
    }

  private:
    [[nodiscard]] std::string open_pairs() const {
        const auto set =
            std::ranges::find_if(together_, [](const auto& pairs) { return !pairs.empty(); });
        if (set == together_.end()) return "a map was not proven to be injective" + by_;
        const auto& [a, b] = set->front();
        return fmt::format("the images of {} and {} were not told apart{}", spoken_name(rifs_, a),
                           spoken_name(rifs_, b), by_);
    }

    void add_images() {
        if (apart_) {
            found_.finite = {true, "no two images have a common point" + by_};
            found_.own.resize(rifs_.follow_sets.size());
            found_.overlaps = {false, "no two images have a common point" + by_};
            found_.totally_disconnected = {true, "no two images have a common point" + by_};
        } else {
            const std::string why = open_pairs() + ", which do not decide equality";
            found_.finite = {std::nullopt, why};
            found_.overlaps = {std::nullopt, why};
            found_.totally_disconnected = {std::nullopt, why};
        }
        add_components();
        if (start_falls_apart()) {
            found_.connected = {false,
                                "the maps' images fall into groups without a common point" + by_};
        } else {
            found_.connected = {std::nullopt, apart_ ? "there is one image" : open_pairs()};
        }
    }

    void add_components() {
        if (!apart_ || !is_ifs() || rifs_.maps.size() < 2) {
            found_.components.why = "intervals do not tell it";
            return;
        }
        found_.components = {std::nullopt, "every piece is a point" + by_};
        found_.infinite_components = true;
    }

    [[nodiscard]] bool start_falls_apart() const {
        const auto start = static_cast<std::size_t>(rifs_.start);
        Groups groups(rifs_.maps.size());
        for (const auto& [a, b] : together_[start])
            groups.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
        return !groups.hold_together(rifs_.follow_sets[start].maps);
    }

    [[nodiscard]] bool is_ifs() const { return rifs_.follow_sets.size() == 1; }

    /// The sum of what the maps do to volumes, areas or lengths of the axes' subspace.
    [[nodiscard]] RealBall volumes() const {
        RealBall sum;
        for (const BallEntries& map : balls_.maps)
            sum = sum + exact::magnitude(determinant(map, axes_));
        return sum;
    }

    void add_open_set() {
        if (apart_) {
            found_.open_set = {true, "the images are disjoint" + by_};
        } else if (is_ifs() && (volumes() - RealBall(1)).is_positive()) {
            found_.open_set = {false, "the maps' volumes add up to more than the whole's" + by_};
        } else {
            found_.open_set = {std::nullopt, open_pairs()};
        }
    }

    void add_hausdorff() {
        const bool similar = std::ranges::all_of(
            balls_.ratio, [](const auto& ratio) { return ratio && !ratio->is_zero(); });
        if (!similar) {
            found_.hausdorff = {std::nullopt, "not every map is a similitude by its commands"};
        } else if (!apart_) {
            found_.hausdorff = {std::nullopt, open_pairs()};
        } else {
            GrowthGraph graph(rifs_.follow_sets.size());
            for (std::size_t s = 0; s < graph.size(); ++s)
                for (const int m : rifs_.follow_sets[s].maps) {
                    const auto map = static_cast<std::size_t>(m);
                    graph[s].push_back(
                        {rifs_.follow_of[map], std::log(std::abs(balls_.ratio[map]->middle()))});
                }
            const auto exponent = growth_exponent(graph);
            if (exponent)
                found_.hausdorff = {exponent->middle(),
                                    "the similarity dimension: similitudes whose images are "
                                    "disjoint" +
                                        by_ + " (Theorem 5.4)"};
        }
    }

    void add_interior() {
        if (is_ifs() && (RealBall(1) - volumes()).is_positive() && spans()) {
            const std::string why = "the maps' volumes add up to less than the whole's" + by_;
            found_.interior = {false, why};
            found_.volume = {0.0, why};
            found_.boundary = {found_.hausdorff.value,
                               found_.hausdorff.value
                                   ? "without inside, it is its own boundary"
                                   : "it is its own boundary, whose dimension is not known: " +
                                         found_.hausdorff.why};
            return;
        }
        const std::string why = "intervals do not tell it" + (is_ifs() ? by_ : " of a graph");
        found_.interior.why = found_.volume.why = found_.boundary.why = why;
    }

    /// Whether some points of the attractor are proven to span the axes' subspace: those
    /// where maps stand still, and their images.
    [[nodiscard]] bool spans() const {
        if (axes_.empty()) return false;
        std::vector<std::array<RealBall, 3>> points;
        for (const BallEntries& map : balls_.maps) {
            if (points.size() == most_points) break;
            if (const auto point = fixed_point(map)) points.push_back(*point);
        }
        for (std::size_t i = 0, known = points.size(); i < known && points.size() < most_points;
             ++i)
            for (std::size_t m = 0; m < balls_.maps.size() && points.size() < most_points; ++m)
                points.push_back(image(balls_.maps[m], points[i]));
        std::vector<std::size_t> chosen;
        return !points.empty() && spans_further(points, chosen);
    }

    static constexpr std::size_t most_points = 24;

    [[nodiscard]] static std::array<RealBall, 3> image(const BallEntries& map,
                                                       const std::array<RealBall, 3>& point) {
        std::array<RealBall, 3> place;
        for (std::size_t r = 0; r < 3; ++r) {
            place[r] = map[r][3];
            for (std::size_t c = 0; c < 3; ++c) place[r] = place[r] + map[r][c] * point[c];
        }
        return place;
    }

    /// By Cramer's rule; nothing if 1 - A may be singular.
    [[nodiscard]] std::optional<std::array<RealBall, 3>> fixed_point(const BallEntries& map) const {
        BallEntries rest;
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c) rest[r][c] = RealBall(r == c ? 1 : 0) - map[r][c];
        const RealBall det = determinant(rest, axes_);
        if (!det.is_positive() && !det.is_negative()) return std::nullopt;
        std::array<RealBall, 3> point;
        for (const std::size_t axis : axes_) {
            BallEntries replaced = rest;
            for (const std::size_t r : axes_) replaced[r][axis] = map[r][3];
            point[axis] = determinant(replaced, axes_) / det;
        }
        return point;
    }

    /// From the first point: the ones that, one after the other, span most.
    [[nodiscard]] bool spans_further(const std::vector<std::array<RealBall, 3>>& points,
                                     std::vector<std::size_t>& chosen) const {
        if (chosen.size() == axes_.size()) {
            BallEntries edges;
            for (std::size_t i = 0; i < chosen.size(); ++i)
                for (const std::size_t c : axes_)
                    edges[axes_[i]][c] = points[chosen[i]][c] - points[0][c];
            const RealBall det = determinant(edges, axes_);
            return det.is_positive() || det.is_negative();
        }
        const std::size_t from = chosen.empty() ? 1 : chosen.back() + 1;
        for (std::size_t i = from; i < points.size(); ++i) {
            chosen.push_back(i);
            if (spans_further(points, chosen)) return true;
            chosen.pop_back();
        }
        return false;
    }

    const exact::BallMaps& balls_;
    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    std::vector<std::size_t> axes_;  // that the attractor is not proven to be 0 along
    PairsOfMaps together_;
    bool apart_ = false;
    std::string by_;
    ExactFindings found_;
};

}  // namespace

ExactFindings find_by_intervals(const exact::BallMaps& balls, const Rifs& rifs,
                                const std::vector<Bounds>& bounds, const std::string& numbers) {
    return IntervalAnswers(balls, rifs, bounds, numbers).run();
}

}  // namespace pxm::host
