// The laws of host/process/give_up.hpp: who asks may leave, and nobody else notices.
#include "host/process/give_up.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "host/render/render.hpp"

namespace pxm::host {
namespace {

TEST(GiveUp, nothing_is_given_up_that_nobody_may_give_up) {
    EXPECT_NO_THROW(give_up_if_asked());
    std::atomic<bool> stop = false;
    {
        const MayGiveUp may(stop);
        EXPECT_NO_THROW(give_up_if_asked());
        stop = true;
        EXPECT_THROW(give_up_if_asked(), GivenUp);
        std::thread([] { EXPECT_NO_THROW(give_up_if_asked()); }).join();
        std::atomic<bool> other = false;
        {
            const MayGiveUp inner(other);
            EXPECT_NO_THROW(give_up_if_asked());
        }
        EXPECT_THROW(give_up_if_asked(), GivenUp);
    }
    EXPECT_NO_THROW(give_up_if_asked());
}

/// Maps that turn and squash, each followed by five others: seconds to bound. Sevenths of a number
/// that 7 does not divide are all different.
std::string scene_of(int maps) {
    std::string text = "ifs many {\n";
    for (int i = 0; i < maps; ++i) {
        const int turn = i * 137 % 360;
        text +=
            fmt::format("newmap scale: 0.0{},0.02,0.03 rotate: y,{} translate: 0.{},-0.{},0.{}\n",
                        1 + i % 4, turn, i * 17 % 1000, i * 29 % 1000, i * 43 % 1000);
    }
    for (int i = 0; i < maps; ++i) {
        text += fmt::format("follow: {} -> {}", i + 1, 1 + (i * 7) % maps);
        for (int j = 1; j < 5; ++j) text += fmt::format(", {}", 1 + (i * 7 + j * 13) % maps);
        text += "\n";
    }
    return text + "}\n";
}

TEST(GiveUp, the_preparation_of_a_scene_ends_soon_after_it_is_given_up) {
    using Clock = std::chrono::steady_clock;
    RenderRequest request;
    request.scene_path = "many.pxm";
    request.scene_text = scene_of(1501);
    const Clock::time_point begun = Clock::now();
    (void)compiled_scene_of(request);
    const auto whole = std::chrono::duration<double>(Clock::now() - begun);
    int times_given_up = 0;
    for (const double share : {0.0, 0.01, 0.1, 0.3, 0.6}) {  // of what all of it takes
        std::atomic<bool> stop = false;
        Clock::time_point asked;
        std::thread watch([&] {
            std::this_thread::sleep_for(share * whole);
            asked = Clock::now();
            stop = true;
        });
        try {
            const MayGiveUp may(stop);
            (void)compiled_scene_of(request);
        } catch (const GivenUp&) {
            ++times_given_up;
        }
        const Clock::time_point ended = Clock::now();
        watch.join();
        // A second is far more than it takes, on a loaded machine too.
        EXPECT_LT(std::chrono::duration<double>(ended - asked).count(), 1.0) << share;
    }
    EXPECT_GT(times_given_up, 0);  // not all, where the machine is quicker than it was before
}

}  // namespace
}  // namespace pxm::host
