#include "host/fractal/neighbours/convex_tile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

namespace pxm::host {

namespace {

using exact::ExactMap;
using exact::Polynomial;

constexpr std::size_t most_corners = 24;
constexpr int most_rounds = 12;    // of maps applied to corners
constexpr double doubtful = 1e-7;  // a determinant that double does not tell from 0

/// A point: the map that takes everything to it, and its coordinates rounded.
struct Corner {
    ExactMap map;
    glm::dvec3 at{0.0};
};
using Corners = std::vector<Corner>;

class Hull {
  public:
    explicit Hull(const exact::ExactSystem& system)
        : system_(system), n_(static_cast<std::size_t>(system.field.dimensions)) {}

    std::optional<double> volume() {
        if (!find_corners() || !are_apart()) return std::nullopt;
        return volume_;
    }

  private:
    /// A plane through as many corners as there are dimensions, and which side the rest is on.
    struct Face {
        std::array<std::size_t, 3> through{};
        int side = 0;
    };

    [[nodiscard]] Corner corner(ExactMap map) const {
        Corner result{std::move(map), {}};
        const auto rounded = result.map.rounded(system_.field);
        for (std::size_t i = 0; i < n_; ++i)
            result.at[static_cast<int>(i)] = rounded.entry[i * (n_ + 1) + n_];
        return result;
    }

    [[nodiscard]] Corner image(const ExactMap& map, const Corner& c) const {
        return corner(ExactMap::composed(system_.field, map, c.map));
    }

    /// A fixed point: that of a map of which 1 is no eigenvalue of the linear part.
    [[nodiscard]] std::optional<Corner> fixed_point(const ExactMap& map) const {
        std::vector<std::vector<Polynomial>> rows(n_);
        std::vector<Polynomial> moved;
        for (std::size_t r = 0; r < n_; ++r) {
            for (std::size_t c = 0; c < n_; ++c) {
                const Polynomial entry =
                    map.entry(system_.field, static_cast<int>(r), static_cast<int>(c));
                rows[r].push_back(r == c ? Polynomial(1) - entry : Polynomial(0) - entry);
            }
            moved.push_back(map.entry(system_.field, static_cast<int>(r), static_cast<int>(n_)));
        }
        const Polynomial det = exact::determinant(system_, rows);
        if (det.is_zero()) return std::nullopt;
        std::vector<Polynomial> entries(n_ * (n_ + 1));
        for (std::size_t c = 0; c < n_; ++c) {
            auto replaced = rows;
            for (std::size_t r = 0; r < n_; ++r) replaced[r][c] = moved[r];
            entries[c * (n_ + 1) + n_] =
                system_.numbers.divide(lifted(exact::determinant(system_, replaced)), lifted(det))
                    .value;
        }
        return corner(ExactMap(system_.field, entries));
    }

    [[nodiscard]] exact::Algebraic lifted(const Polynomial& p) const {
        exact::Algebraic a = system_.numbers.lifted(exact::whole(0));
        a.value = p;
        return a;
    }

    /// On which side of the plane through the corners the point is: -1, 0 or 1.
    [[nodiscard]] int side(const std::array<const Corner*, 3>& through, const Corner& point) const {
        std::array<glm::dvec3, 3> rows{};
        for (std::size_t i = 0; i < n_; ++i)
            rows[i] = (i + 1 < n_ ? through[i + 1]->at : point.at) - through[0]->at;
        const double rounded = n_ == 1   ? rows[0].x
                               : n_ == 2 ? rows[0].x * rows[1].y - rows[0].y * rows[1].x
                                         : glm::dot(rows[0], glm::cross(rows[1], rows[2]));
        if (std::abs(rounded) > doubtful * scale_) return rounded > 0 ? 1 : -1;
        std::vector<std::vector<Polynomial>> exact_rows(n_);
        for (std::size_t i = 0; i < n_; ++i)
            for (std::size_t c = 0; c < n_; ++c)
                exact_rows[i].push_back(coordinate(i + 1 < n_ ? *through[i + 1] : point, c) -
                                        coordinate(*through[0], c));
        return system_.numbers.sign(lifted(exact::determinant(system_, exact_rows)));
    }

    [[nodiscard]] Polynomial coordinate(const Corner& c, std::size_t i) const {
        return c.map.entry(system_.field, static_cast<int>(i), static_cast<int>(n_));
    }

    /// Calls see(indices) for all choices of as many corners as there are dimensions.
    void each_choice(std::size_t count,
                     const std::function<void(const std::array<std::size_t, 3>&)>& see) const {
        std::array<std::size_t, 3> at{};
        for (at[0] = 0; at[0] < count; ++at[0]) {
            if (n_ == 1) see(at);
            for (at[1] = at[0] + 1; n_ > 1 && at[1] < count; ++at[1]) {
                if (n_ == 2) see(at);
                for (at[2] = at[1] + 1; n_ > 2 && at[2] < count; ++at[2]) see(at);
            }
        }
    }

    [[nodiscard]] std::vector<Face> faces_of(const Corners& corners) const {
        std::vector<Face> faces;
        each_choice(corners.size(), [&](const std::array<std::size_t, 3>& at) {
            std::array<const Corner*, 3> through{};
            for (std::size_t i = 0; i < n_; ++i) through[i] = &corners[at[i]];
            bool low = false, high = false;
            for (const Corner& c : corners) {
                const int s = side(through, c);
                low = low || s < 0;
                high = high || s > 0;
                if (low && high) return;
            }
            if (low != high) faces.push_back({at, low ? -1 : 1});
        });
        return faces;
    }

    /// Leaves out what no face needs: a corner of a polytope lies on faces that have no other point
    /// in common; others are between corners of one face, or inside.
    void keep_extreme(Corners& corners) const {
        const std::vector<Face> faces = faces_of(corners);
        if (faces.empty()) return;
        std::vector<char> kept(corners.size(), 0);
        for (std::size_t k = 0; k < corners.size(); ++k) kept[k] = is_extreme(corners, faces, k);
        Corners left;
        for (std::size_t k = 0; k < corners.size(); ++k)
            if (kept[k]) left.push_back(corners[k]);
        corners = std::move(left);
    }

    /// No other corner lies on all faces that this one lies on.
    [[nodiscard]] bool is_extreme(const Corners& corners, const std::vector<Face>& faces,
                                  std::size_t k) const {
        std::vector<char> on_all(corners.size(), 1);
        bool any = false;
        for (const Face& face : faces) {
            std::array<const Corner*, 3> through{};
            for (std::size_t i = 0; i < n_; ++i) through[i] = &corners[face.through[i]];
            if (side(through, corners[k]) != 0) continue;
            any = true;
            for (std::size_t j = 0; j < corners.size(); ++j)
                if (on_all[j] && side(through, corners[j]) != 0) on_all[j] = 0;
        }
        return any && std::ranges::count(on_all, 1) == 1;
    }

    bool find_corners() {
        for (const ExactMap& map : system_.maps) {
            const auto fixed = fixed_point(map);
            if (!fixed) return false;
            add(*fixed, corners_);
        }
        for (int round = 0; round < most_rounds; ++round) {
            Corners all = corners_;
            for (const ExactMap& map : system_.maps)
                for (const Corner& c : corners_) add(image(map, c), all);
            set_scale(all);
            keep_extreme_in_parts(all);
            if (all.size() > most_corners) return false;
            if (same(all, corners_)) return measure();
            corners_ = std::move(all);
        }
        return false;
    }

    /// The hull of many points, a few at a time.
    void keep_extreme_in_parts(Corners& all) const {
        Corners kept;
        for (const Corner& c : all) {
            kept.push_back(c);
            if (kept.size() > most_corners / 2 + n_) keep_extreme(kept);
            if (kept.size() > most_corners) break;
        }
        if (kept.size() <= most_corners) keep_extreme(kept);
        all = std::move(kept);
    }

    static void add(const Corner& c, Corners& to) {
        if (std::ranges::none_of(to, [&](const Corner& other) { return other.map == c.map; }))
            to.push_back(c);
    }

    static bool same(const Corners& a, const Corners& b) {
        return a.size() == b.size() && std::ranges::all_of(a, [&](const Corner& c) {
                   return std::ranges::any_of(
                       b, [&](const Corner& other) { return other.map == c.map; });
               });
    }

    void set_scale(const Corners& corners) {
        double size = 0;
        for (const Corner& c : corners) size = std::max(size, glm::distance(c.at, corners[0].at));
        scale_ = std::pow(size, static_cast<double>(n_));
    }

    /// Of the hull, from a point in its middle.
    bool measure() {
        faces_ = faces_of(corners_);
        glm::dvec3 middle{0.0};
        for (const Corner& c : corners_) middle += c.at / static_cast<double>(corners_.size());
        std::vector<std::vector<std::size_t>> seen;
        for (const Face& face : faces_) {
            const std::vector<std::size_t> on = corners_on(face);
            if (std::ranges::find(seen, on) != seen.end()) continue;
            seen.push_back(on);
            volume_ += cone(on, middle);
        }
        return volume_ > doubtful * scale_;
    }

    [[nodiscard]] std::vector<std::size_t> corners_on(const Face& face) const {
        std::array<const Corner*, 3> through{};
        for (std::size_t i = 0; i < n_; ++i) through[i] = &corners_[face.through[i]];
        std::vector<std::size_t> on;
        for (std::size_t k = 0; k < corners_.size(); ++k)
            if (side(through, corners_[k]) == 0) on.push_back(k);
        return on;
    }

    /// The volume between a point and a face.
    [[nodiscard]] double cone(const std::vector<std::size_t>& on, const glm::dvec3& tip) const {
        const glm::dvec3 first = corners_[on[0]].at - tip;
        if (n_ == 1) return std::abs(first.x);
        if (n_ == 2) {
            const glm::dvec3 second = corners_[on[1]].at - tip;
            return std::abs(first.x * second.y - first.y * second.x) / 2;
        }
        glm::dvec3 middle{0.0};
        for (const std::size_t k : on)
            middle += (corners_[k].at - tip) / static_cast<double>(on.size());
        const glm::dvec3 across = first - middle;
        const glm::dvec3 up = glm::normalize(glm::cross(across, corners_[on[1]].at - tip - middle));
        std::vector<std::pair<double, glm::dvec3>> around;
        for (const std::size_t k : on) {
            const glm::dvec3 p = corners_[k].at - tip;
            around.emplace_back(std::atan2(glm::dot(glm::cross(across, p - middle), up),
                                           glm::dot(across, p - middle)),
                                p);
        }
        std::ranges::sort(around, {}, &std::pair<double, glm::dvec3>::first);
        double sum = 0;
        constexpr double tetrahedron = 6;
        for (std::size_t i = 0; i < around.size(); ++i)
            sum += std::abs(glm::dot(
                middle, glm::cross(around[i].second, around[(i + 1) % around.size()].second)));
        return sum / tetrahedron;
    }

    /// Whether the hull's images by any two maps have no inside in common.
    [[nodiscard]] bool are_apart() const {
        std::vector<Corners> images;
        for (const ExactMap& map : system_.maps) {
            Corners& one = images.emplace_back();
            for (const Corner& c : corners_) one.push_back(image(map, c));
        }
        for (std::size_t i = 0; i < images.size(); ++i)
            for (std::size_t j = i + 1; j < images.size(); ++j)
                if (!separated(images[i], images[j]) && !separated(images[j], images[i]) &&
                    !(n_ == 3 && separated_by_edges(images[i], images[j])))
                    return false;
        return true;
    }

    /// By a face of the first: no corner of the second is on the side where the rest of it is.
    [[nodiscard]] bool separated(const Corners& first, const Corners& second) const {
        return std::ranges::any_of(faces_, [&](const Face& face) {
            std::array<const Corner*, 3> through{};
            for (std::size_t i = 0; i < n_; ++i) through[i] = &first[face.through[i]];
            int own = 0;  // maps may reflect
            for (const Corner& c : first)
                if (own == 0) own = side(through, c);
            return std::ranges::all_of(second,
                                       [&](const Corner& c) { return side(through, c) != own; });
        });
    }

    /// By a plane through two corners of one and one of the other, which edges of both lie along.
    [[nodiscard]] bool separated_by_edges(const Corners& a, const Corners& b) const {
        const auto split = [&](const std::array<const Corner*, 3>& through) {
            const auto sides = [&](const Corners& corners, bool& low, bool& high) {
                for (const Corner& c : corners) {
                    const int s = side(through, c);
                    low = low || s < 0;
                    high = high || s > 0;
                }
            };
            bool low_a = false, high_a = false, low_b = false, high_b = false;
            sides(a, low_a, high_a);
            if (low_a == high_a) return false;
            sides(b, low_b, high_b);
            return low_b != high_b && low_a != low_b;
        };
        for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}})
            for (std::size_t i = 0; i < one->size(); ++i)
                for (std::size_t j = i + 1; j < one->size(); ++j)
                    for (const Corner& c : *other)
                        if (split({&(*one)[i], &(*one)[j], &c})) return true;
        return false;
    }

    const exact::ExactSystem& system_;
    std::size_t n_;
    Corners corners_;
    std::vector<Face> faces_;
    double scale_ = 1;
    double volume_ = 0;
};

}  // namespace

std::optional<double> convex_volume(const exact::ExactSystem& system) {
    constexpr std::size_t most_maps = 64;
    if (system.maps.size() > most_maps) return std::nullopt;
    return Hull(system).volume();
}

}  // namespace pxm::host
