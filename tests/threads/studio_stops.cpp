// What the studio does with a page that asks faster than it is answered: each request takes the
// turn of the one before, which is stopped, while another thread looks at how far it is; pages
// leave, and the studio closes, in the middle.
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "host/error.hpp"
#include "host/studio/jobs.hpp"
#include "host/studio/picture.hpp"
#include "host/studio/turns.hpp"
#include "pxm/model.hpp"

using namespace pxm::host;

namespace {

constexpr const char* scene = R"(
ifs a {
    newmap scale: 1/2
    newmap scale: 1/2 translate: 1/2,0,0
    newmap scale: 1/2 translate: 0,1/2,0
}
object a { ifs: a }
)";

struct Counts {
    std::atomic<int> finished = 0, stopped = 0, refused = 0, wrong = 0;
};

AskedPicture asked_of(std::uint64_t serial) {
    AskedPicture asked;
    asked.scene.name = "a.pxm";
    asked.scene.text = scene;
    asked.size = serial % 3 == 0 ? PixelSize{16, 12} : PixelSize{120, 90};
    asked.machine = serial % 3 == 0 ? pxm::find_model("916") : nullptr;
    return asked;
}

void answer(Turns& turns, Jobs& jobs, const std::string& view, std::uint64_t serial,
            Counts& counts) {
    std::optional<Turns::Turn> turn = turns.take(view, serial);
    if (!turn) {
        ++counts.refused;
        return;
    }
    const AskedPicture asked = asked_of(serial);
    const std::shared_ptr<Job> job = jobs.begin(view, asked.machine ? 64 : 0);
    const NodeWatch::Laid laid(&job->watch);
    try {
        const Picture picture =
            render_asked(asked, 2, turn->stop(), [&](double share) { job->share = share; });
        ++(picture.result.stopped ? counts.stopped : counts.finished);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        ++counts.wrong;
    }
    (void)turn->stopping_milliseconds();
}

void look_on(Jobs& jobs, const std::atomic<bool>& over) {
    double sum = 0;
    while (!over) {
        for (const char* view : {"one", "two"}) {
            const std::shared_ptr<Job> job = jobs.find(view);
            if (!job) continue;
            sum += job->share;
            for (const NodeWatch::Seen& seen : job->watch.nodes())
                sum += static_cast<double>(seen.cycles);
        }
        std::this_thread::yield();
    }
    std::printf("%s\n", sum > 0 ? "something was seen" : "nothing was seen");
}

}  // namespace

int main() {
    constexpr std::uint64_t requests = 24;
    Turns turns(1);
    Jobs jobs;
    Counts counts;
    std::atomic<bool> over = false;
    std::jthread looking([&] { look_on(jobs, over); });
    {
        std::vector<std::jthread> threads;
        for (std::uint64_t serial = 1; serial <= requests; ++serial) {
            threads.emplace_back([&, serial] {
                answer(turns, jobs, serial % 2 == 0 ? "one" : "two", serial, counts);
            });
            std::this_thread::sleep_for(std::chrono::milliseconds(serial % 4 * 20));
            if (serial == requests / 2) turns.leave("two");
        }
        turns.close();
    }
    over = true;
    std::printf("%d finished, %d stopped, %d refused, %d wrong\n", counts.finished.load(),
                counts.stopped.load(), counts.refused.load(), counts.wrong.load());
    return counts.wrong == 0 &&
                   counts.finished + counts.stopped + counts.refused == static_cast<int>(requests)
               ? 0
               : 1;
}
