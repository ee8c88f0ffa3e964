#include "host/fractal/neighbours/exact_inside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host/fractal/neighbours/tile_volume.hpp"

namespace pxm::host {

namespace {

class InsideSearch {
  public:
    InsideSearch(const SearchedSystem& searched, const ExactFindings& found)
        : searched_(searched), found_(found) {}

    ExactInside run() {
        decide();
        return std::move(result_);
    }

  private:
    /// The sign of (the sum of the volume ratios) - 1. Of one follow set.
    [[nodiscard]] int volume_excess() const {
        exact::Polynomial sum(-1);
        for (const exact::Polynomial& det : searched_.exact.volume_ratio)
            sum = searched_.sign(det) < 0 ? sum - det : sum + det;
        return searched_.sign(sum);
    }

    void empty_inside(const std::string& why) {
        result_.inside = {false, why};
        result_.volume = {0.0, why};
    }

    void decide() {
        if (is_interval(searched_, found_)) {
            result_.inside = {true, "a connected set in a line is an interval"};
            result_.volume = {std::nullopt, "not computed"};
            if (exact::is_coordinate_plane(searched_.exact))
                result_.volume = {interval_length(), "the length of an interval"};
            return;
        }
        if (searched_.whole) {
            const int excess = volume_excess();
            if (excess < 0)
                return empty_inside("the maps' volumes add up to less than the whole's");
            if (excess == 0 && found_.overlaps.value.value_or(false))
                return empty_inside(
                    "the maps' volumes add up to the whole's, and two words are the same map");
        }
        if (found_.open_set.value.value_or(false) && volumes_balance()) {
            result_.inside = {true, searched_.similar()
                                        ? "the open-set condition holds and the maps' volumes add "
                                          "up to the whole's [Schief94]"
                                        : found_.open_set.why};
            add_tile_volume();
            return;
        }
        add_interior_of_graph();
    }

    void add_tile_volume() {
        try {
            auto [volume, between] =
                tile_volume(searched_.exact, searched_.rifs, searched_.graph, searched_.bounds,
                            found_.connected.value.value_or(false));
            result_.volume = std::move(volume);
            result_.between = between;
        } catch (const exact::NotExact& reason) {
            result_.volume = {std::nullopt, "not computed: " + reason.why};
        }
    }

    /// From the equation that the ends of all pieces have, in double.
    [[nodiscard]] double interval_length() const {
        constexpr int most_rounds = 10'000;
        const int axis = searched_.exact.axes[0];
        std::vector<std::array<double, 2>> ends;
        for (const Bounds& b : searched_.bounds)
            ends.push_back({b.ball.center[axis], b.ball.center[axis]});
        for (int round = 0; round < most_rounds; ++round) {
            auto next = ends;
            for (std::size_t s = 0; s < ends.size(); ++s) {
                next[s] = {INFINITY, -INFINITY};
                for (const int m : searched_.rifs.follow_sets[s].maps) {
                    const auto map = static_cast<std::size_t>(m);
                    for (const double end :
                         ends[static_cast<std::size_t>(searched_.rifs.follow_of[map])]) {
                        glm::dvec3 p = searched_.bounds[s].ball.center;
                        p[axis] = end;
                        const double image = searched_.rifs.maps[map].point(p)[axis];
                        next[s] = {std::min(next[s][0], image), std::max(next[s][1], image)};
                    }
                }
            }
            if (next == ends) break;
            ends = std::move(next);
        }
        const auto start = static_cast<std::size_t>(searched_.rifs.start);
        return ends[start][1] - ends[start][0];
    }

    /// Whether the follow sets can have positive volumes of which each is the sum of its maps'
    /// images: a positive vector v with v_s = sum of |det m| v_t over the maps m of s.
    [[nodiscard]] bool volumes_balance() const {
        constexpr std::size_t most = 60;  // follow sets: elimination takes their third power
        const std::size_t n = searched_.rifs.follow_sets.size();
        if (n > most || !(searched_.whole || searched_.strong)) return false;
        std::vector<std::vector<exact::Polynomial>> rows(n, std::vector<exact::Polynomial>(n));
        for (std::size_t s = 0; s < n; ++s) {
            rows[s][s] = exact::Polynomial(-1);
            for (const int m : searched_.rifs.follow_sets[s].maps) {
                const auto map = static_cast<std::size_t>(m);
                const exact::Polynomial& det = searched_.exact.volume_ratio[map];
                exact::Polynomial& at =
                    rows[s][static_cast<std::size_t>(searched_.rifs.follow_of[map])];
                at = searched_.sign(det) < 0 ? at - det : at + det;
            }
        }
        const auto kernel = exact::kernel_vector(searched_.exact, rows);
        return kernel && std::ranges::all_of(*kernel, [&](const exact::Polynomial& p) {
                   return searched_.sign(p) == searched_.sign(kernel->front()) &&
                          searched_.sign(p) != 0;
               });
    }

    void add_interior_of_graph() {
        constexpr double clearly = 1e-9;
        if (found_.hausdorff.value && *found_.hausdorff.value < found_.dimensions - clearly)
            return empty_inside("its dimension is less than the space's");
        const std::string why = found_.hausdorff.value
                                    ? "the dimension alone does not tell"
                                    : "the dimension is not known: " + found_.hausdorff.why;
        result_.inside = {std::nullopt, why};
        result_.volume = {std::nullopt, why};
    }

    const SearchedSystem& searched_;
    const ExactFindings& found_;
    ExactInside result_;
};

}  // namespace

ExactInside exact_inside(const SearchedSystem& searched, const ExactFindings& found) {
    return InsideSearch(searched, found).run();
}

}  // namespace pxm::host
