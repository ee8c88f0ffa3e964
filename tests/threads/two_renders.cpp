// Four renders of one process at a time, by the native engine, the wide one and the machine, with
// what hears of their progress; then the same of which every second is stopped on its way. Those
// that come to their end give the pixels that they give alone.
#include <atomic>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "host/error.hpp"
#include "host/render/render.hpp"
#include "pxm/model.hpp"

using namespace pxm::host;

namespace {

constexpr const char* scene = R"(
ifs tetra {
    newmap scale: 1/2
    newmap scale: 1/2 translate: 1/2,0,0
    newmap scale: 1/2 translate: 1/4,sqrt(3)/4,0
    newmap scale: 1/2 translate: 1/4,sqrt(3)/12,sqrt(6)/6
}
object tetra { ifs: tetra }
)";

RenderRequest request_of(IntersectMethod method, const pxm::Model* machine) {
    RenderRequest request;
    request.scene_path = "tetra";
    request.scene_text = scene;
    request.machine = machine;
    request.threads = 3;
    request.overrides.size = machine ? PixelSize{24, 16} : PixelSize{160, 120};
    request.overrides.intersect = method;
    return request;
}

bool same(const Frame& a, const Frame& b) {
    if (a.pixels.size() != b.pixels.size()) return false;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        if (a.pixels[i].z != b.pixels[i].z) return false;
    return true;
}

/// How many renders ended otherwise than alone.
int render_at_once(const std::vector<RenderRequest>& requests, bool stop_some) {
    std::vector<RenderResult> alone;
    for (const RenderRequest& request : requests) alone.push_back(render(request, {}));
    std::vector<std::atomic<bool>> stops(requests.size());
    std::atomic<int> wrong = 0;
    std::atomic<int> heard = 0;
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < requests.size(); ++i) {
            threads.emplace_back([&, i] {
                const RunControl control{&stops[i], [&](double) { ++heard; }};
                const RenderResult result = render(requests[i], control);
                if (!result.stopped && !same(result.frame, alone[i].frame)) ++wrong;
            });
        }
        for (std::size_t i = 0; stop_some && i < stops.size(); i += 2) stops[i] = true;
    }
    std::printf("%zu renders at once, %d wrong, %d times heard\n", requests.size(), wrong.load(),
                heard.load());
    return wrong;
}

}  // namespace

int main() {
    const std::vector<RenderRequest> requests{
        request_of(IntersectMethod::heap, nullptr), request_of(IntersectMethod::wide, nullptr),
        request_of(IntersectMethod::heap, pxm::find_model("916")),
        request_of(IntersectMethod::wide, nullptr)};
    try {
        return render_at_once(requests, false) + render_at_once(requests, true) == 0 ? 0 : 1;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
