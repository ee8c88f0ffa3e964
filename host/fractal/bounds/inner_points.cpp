#include "host/fractal/bounds/inner_points.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>

#include "host/math/lipschitz.hpp"
#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

constexpr int directions = 26;           // the faces, edges and corners of a cube
constexpr long work_limit = 20'000'000;  // points mapped
constexpr long most_rounds = 24;

std::array<glm::dvec3, directions> cube_directions() {
    std::array<glm::dvec3, directions> result;
    int n = 0;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (x != 0 || y != 0 || z != 0) result[n++] = {x, y, z};
            }
        }
    }
    return result;
}

/// Keeps, of all points offered, the farthest in each direction.
class Extremes {
  public:
    Extremes() { reach_.fill(-std::numeric_limits<double>::infinity()); }

    void offer(const glm::dvec3& point) {
        static const auto axes = cube_directions();
        for (int i = 0; i < directions; ++i) {
            const double reach = glm::dot(axes[i], point);
            if (!(reach > reach_[i])) continue;
            reach_[i] = reach;
            point_[i] = point;
        }
    }

    /// As if all that was offered to `others` were offered here.
    void offer(const Extremes& others) {
        for (int i = 0; i < directions; ++i) {
            if (!(others.reach_[i] > reach_[i])) continue;
            reach_[i] = others.reach_[i];
            point_[i] = others.point_[i];
        }
    }

    [[nodiscard]] Points points() const {
        Points result;
        for (const glm::dvec3& point : point_) {
            if (std::find(result.begin(), result.end(), point) == result.end()) {
                result.push_back(point);
            }
        }
        return result;
    }

  private:
    std::array<double, directions> reach_;
    std::array<glm::dvec3, directions> point_;
};

void offer_fixed_points(const Rifs& rifs, std::vector<Extremes>& extremes) {
    for (std::size_t s = 0; s < extremes.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) {
            if (rifs.follow_of[m] != static_cast<int>(s)) continue;
            extremes[s].offer(fixed_point(rifs.maps[m]));
        }
    }
}

long rounds_for(const Rifs& rifs) {
    long edges = 1;
    for (const FollowSet& set : rifs.follow_sets) edges += static_cast<long>(set.maps.size());
    return std::clamp<long>(work_limit / (edges * directions), 1, most_rounds);
}

}  // namespace

std::vector<Points> inner_points(const Rifs& rifs) {
    std::vector<Extremes> extremes(rifs.follow_sets.size());
    std::vector<Points> points;
    for (const glm::dvec3& point : inner_point_of_each(rifs)) points.push_back({point});
    for (std::size_t s = 0; s < points.size(); ++s) extremes[s].offer(points[s][0]);
    offer_fixed_points(rifs, extremes);
    for (long round = rounds_for(rifs); round > 0; --round) {
        for (std::size_t s = 0; s < points.size(); ++s) points[s] = extremes[s].points();
        // A map of many sets takes the same points to the same places: they are looked at once.
        std::vector<Extremes> images(rifs.maps.size());
        for (std::size_t m = 0; m < images.size(); ++m) {
            give_up_if_asked();
            for (const glm::dvec3& point : points[rifs.follow_of[m]]) {
                images[m].offer(rifs.maps[m].point(point));
            }
        }
        for (std::size_t s = 0; s < points.size(); ++s) {
            give_up_if_asked();
            for (const int m : rifs.follow_sets[s].maps) extremes[s].offer(images[m]);
        }
    }
    for (std::size_t s = 0; s < points.size(); ++s) points[s] = extremes[s].points();
    return points;
}

// Always choosing the map that contracts most ends in a cycle of maps, whose fixed point is exact
// and whose images are points of the sets that lead to it.
std::vector<glm::dvec3> inner_point_of_each(const Rifs& rifs) {
    std::vector<double> lip;
    for (const Affine& map : rifs.maps) lip.push_back(lipschitz_constant(map));
    const auto choice = [&](int s) {
        const std::vector<int>& maps = rifs.follow_sets[s].maps;
        return *std::min_element(maps.begin(), maps.end(),
                                 [&](int a, int b) { return lip[a] < lip[b]; });
    };
    const int sets = static_cast<int>(rifs.follow_sets.size());
    enum class State : char { unseen, on_path, known };
    std::vector<State> state(sets, State::unseen);
    std::vector<glm::dvec3> point(sets);
    for (int root = 0; root < sets; ++root) {
        std::vector<int> path;
        int s = root;
        for (; state[s] == State::unseen; s = rifs.follow_of[choice(s)]) {
            state[s] = State::on_path;
            path.push_back(s);
        }
        if (state[s] == State::on_path) {  // a new cycle, from s to the end of the path
            Affine round;
            for (auto on_path = path.rbegin();; ++on_path) {
                round = then(round, rifs.maps[choice(*on_path)]);
                if (*on_path == s) break;
            }
            point[s] = fixed_point(round);
            state[s] = State::known;
        }
        for (auto on_path = path.rbegin(); on_path != path.rend(); ++on_path) {
            if (state[*on_path] == State::known) continue;
            const int m = choice(*on_path);
            point[*on_path] = rifs.maps[m].point(point[rifs.follow_of[m]]);
            state[*on_path] = State::known;
        }
    }
    return point;
}

Points extremes_of(const Points& points) {
    Extremes extremes;
    for (const glm::dvec3& point : points) extremes.offer(point);
    return extremes.points();
}

glm::dvec3 fixed_point(const Affine& map) {
    // x = x T + a. Eigen's column i is the thesis' row i.
    Eigen::Matrix3d left = Eigen::Matrix3d::Identity();
    Eigen::Vector3d right;
    for (int i = 0; i < 3; ++i) {
        right(i) = map.translation[i];
        for (int j = 0; j < 3; ++j) left(j, i) -= map.linear[i][j];
    }
    const Eigen::Vector3d x = left.fullPivLu().solve(right);
    return {x(0), x(1), x(2)};
}

const glm::dvec3& extreme(const Points& points, const glm::dvec3& u) {
    const glm::dvec3* best = &points.front();
    double reach = glm::dot(*best, u);
    for (const glm::dvec3& point : points) {
        const double r = glm::dot(point, u);
        if (r <= reach) continue;
        reach = r;
        best = &point;
    }
    return *best;
}

}  // namespace pxm::host
