// Laws of host/compile/trial: however far a trial goes, it says the same.
#include "host/compile/trial.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "host/compile/computed_volume.hpp"
#include "host/compile/shape.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::test {
namespace {

using namespace host;
using kernels::Volume;

/// Trials of balls, boxes and hulls of systems that rays go through with few tests and with many.
std::vector<Trial> some_trials() {
    std::vector<Trial> trials;
    for (const Rifs& rifs : {systems::tetra(), systems::elm(), systems::grass()}) {
        const std::vector<Bounds> bounds = bound(rifs, prove_contraction(rifs));
        const Ball& ball = bounds[static_cast<std::size_t>(rifs.start)].ball;
        const auto method = choose_lipschitz(LipschitzMethod::automatic, rifs);
        for (const Volume kind : {Volume::sphere, Volume::box, Volume::hull}) {
            VolumeComputer computer(rifs, bounds);
            std::vector<CompiledVolume> volumes;
            for (std::size_t set = 0; set < bounds.size(); ++set)
                volumes.push_back(computer.make(kind, set));
            const ShapeFrame frame{ball.center, ball.radius};
            trials.emplace_back(make_shape(rifs, volumes, frame, method), std::uint32_t{6});
        }
    }
    return trials;
}

TEST(Trial, is_exact_below_what_is_enough_and_never_says_too_much) {
    for (const Trial& fresh : some_trials()) {
        Trial whole = fresh;
        const double cost = whole.cost();
        EXPECT_GT(cost, 0);
        EXPECT_EQ(whole.cost(), cost);
        Trial trial = fresh;
        for (const double enough : {1.0, cost / 3, cost, cost * 1.01}) {
            const double known = trial.cost(enough);
            EXPECT_LE(known, cost);
            if (known < enough)
                EXPECT_EQ(known, cost);
            else
                EXPECT_GE(known, enough);
        }
    }
}

TEST(Trial, decides_as_the_whole_costs_do) {
    const std::vector<Trial> trials = some_trials();
    for (const Trial& one : trials) {
        for (const Trial& other : trials) {
            Trial all_of_one = one, all_of_other = other;
            for (const double factor : {0.5, 1.0, 2.0}) {
                Trial a = one, b = other;
                EXPECT_EQ(is_cheaper(a, factor, b),
                          all_of_one.cost() < factor * all_of_other.cost());
            }
        }
    }
}

}  // namespace
}  // namespace pxm::test
