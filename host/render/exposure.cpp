#include "host/render/exposure.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "host/error.hpp"
#include "host/render/alarms.hpp"

namespace pxm::host {

namespace {

long samples_of(const Scene& scene) { return scene.render ? scene.render->samples.value_or(1) : 1; }

/// The frame at which sample `i` of `count` is taken: the middle of its part of the open time. A
/// film neither begins before its first frame nor goes on after its last.
double moment_of(const RenderRequest& request, const AnimationBlock& animation, long i,
                 long count) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    return std::clamp(request.frame + animation.shutter * (share - 0.5), 0.0,
                      static_cast<double>(animation.frames - 1));
}

/// Sums of a picture's colours, in the order of the moments.
class Exposure {
  public:
    void add(const Frame& frame) {
        sums_.resize(frame.pixels.size());
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            const PixelRecord& pixel = frame.pixels[i];
            for (std::size_t k = 0; k < 3; ++k) sums_[i][k] += double{pixel.color[k]};
            sums_[i][3] += double{pixel.alpha};
        }
    }
    void put_means(Frame& frame, long count) const {
        const auto mean = [&](double sum) {
            return static_cast<float>(sum / static_cast<double>(count));
        };
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) frame.pixels[i].color[k] = mean(sums_[i][k]);
            frame.pixels[i].alpha = mean(sums_[i][3]);
        }
    }

  private:
    std::vector<std::array<double, 4>> sums_;
};

void add_counts(RenderResult& sum, const RenderResult& one) {
    Statistics& all = sum.statistics;
    const Statistics& more = one.statistics;
    // A pixel is one, however many moments it has.
    const std::uint64_t pixels = all.rays.pixels, hits = all.rays.hits;
    all.rays.add(more.rays);
    all.rays.pixels = pixels;
    all.rays.hits = hits;
    all.seconds.parse += more.seconds.parse;
    all.seconds.compile += more.seconds.compile;
    all.seconds.load += more.seconds.load;
    all.seconds.render += more.seconds.render;
    for (std::size_t i = 0; i < sum.frame.pixels.size(); ++i) {
        PixelRecord& pixel = sum.frame.pixels[i];
        pixel.alarms |= one.frame.pixels[i].alarms;
        pixel.volumes += one.frame.pixels[i].volumes;
    }
    for (std::size_t i = 0; i < all.alarms.size(); ++i) {
        if (!all.alarms[i].of_pixels)
            all.alarms[i].count = std::max(all.alarms[i].count, more.alarms[i].count);
    }
}

}  // namespace

bool has_exposure(const RenderRequest& request, const Scene& scene) {
    return !request.only_sample && scene.animation && scene.animation->shutter > 0 &&
           samples_of(scene) > 1;
}

RenderResult render_exposure(const RenderRequest& request, const Scene& scene,
                             const RunControl& control, PictureTaker* taker) {
    if (request.machine)
        throw Error(ErrorKind::setting,
                    "--machine: a node of the machine knows no shutter (animation.shutter=0)");
    if (scene.render->covers && std::holds_alternative<AreaCovers>(*scene.render->covers))
        throw Error(ErrorKind::setting,
                    "covers: area looks at all places of a pixel at one moment, a shutter needs "
                    "samples (covers: off)");
    const long count = samples_of(scene);
    Exposure exposure;
    RenderResult result;
    for (long i = 0; i < count; ++i) {
        RenderRequest moment = request;
        moment.frame = moment_of(request, *scene.animation, i, count);
        moment.only_sample = i;
        RenderResult one = render(moment, share_of(control, static_cast<std::size_t>(i),
                                                   static_cast<std::size_t>(count)));
        if (one.stopped) return one;
        exposure.add(one.frame);
        if (i == 0) {
            result = std::move(one);
        } else {
            add_counts(result, one);
        }
    }
    exposure.put_means(result.frame, count);
    recount(result.statistics.alarms, result.frame);
    if (taker) {
        taker->begin(result);
        taker->take(std::exchange(result.frame, {}));
    }
    return result;
}

}  // namespace pxm::host
