#include "host/commands/render_frames.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "host/commands/film_stream.hpp"
#include "host/error.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/film.hpp"
#include "host/output/frame_list.hpp"
#include "host/output/statistics_json.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/limits.hpp"
#include "host/process/phase_clock.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

/// Where frames go.
class FrameTarget {
  public:
    virtual ~FrameTarget() = default;
    virtual RenderResult render_frame(const RenderRequest& request, const RunControl& control) = 0;
    virtual void finish() = 0;
};

/// A file each.
class PictureFiles : public FrameTarget {
  public:
    explicit PictureFiles(const FilmJob& job) : job_(job) {}
    RenderResult render_frame(const RenderRequest& request, const RunControl& control) override {
        return job_.write_picture(request, path_of_frame(job_.out, std::lround(request.frame)),
                                  control);
    }
    void finish() override {}

  private:
    const FilmJob& job_;
};

/// One stream of all.
class OneStream : public FrameTarget {
  public:
    explicit OneStream(std::unique_ptr<FrameStream> stream) : stream_(std::move(stream)) {}
    RenderResult render_frame(const RenderRequest& request, const RunControl& control) override {
        RenderResult result = render(request, control, &taker_);
        if (!result.stopped) stream_->frame(taker_.frame.bytes());
        return result;
    }
    void finish() override { stream_->finish(); }

  private:
    struct Taker : PictureTaker {
        void begin(const RenderResult& known) override { frame.begin(known.window); }
        void take(const Frame& part) override { frame.take(part); }
        ByteFrame frame;
    };
    Taker taker_;
    std::unique_ptr<FrameStream> stream_;
};

std::unique_ptr<FrameTarget> target_of(const FilmJob& job, const Scene& scene,
                                       const std::vector<long>& frames) {
    if (is_film(job.out)) job.require_picture("film.png");
    if (auto stream = open_film_stream({job.out, job.format}, shape_of(scene)))
        return std::make_unique<OneStream>(std::move(stream));
    require_frame_number(job.out, frames.size());
    for (const long frame : {frames.front(), frames.back()})
        job.require_picture(path_of_frame(job.out, frame));
    return std::make_unique<PictureFiles>(job);
}

/// A frame that fails says which it was.
RenderResult render_named(FrameTarget& target, const RenderRequest& request,
                          const RunControl& control) {
    return naming_frame(request.frame, [&] { return target.render_frame(request, control); });
}

}  // namespace

ExitCode render_frames(const FilmJob& job) {
    PhaseClock clock;
    const Scene scene = scene_of(job.request);
    const std::vector<long> frames = frames_of_scene(job.frames, scene);
    if (!job.stats.empty() && frames.size() > 1 && !has_frame_number(job.stats))
        throw Error(ErrorKind::setting, "--stats: put the frame's number into the name, as %04d");
    const std::unique_ptr<FrameTarget> target = target_of(job, scene, frames);
    std::string warnings;  // the same of all frames are told once
    {
        Progress progress(job.quiet);
        RunControl control;
        control.stop = &stop_requested();
        if (progress.enabled()) control.progress = [&](double share) { progress.update(share); };
        for (std::size_t i = 0; i < frames.size(); ++i) {
            RenderRequest request = job.request;
            request.frame = static_cast<double>(frames[i]);
            const RenderResult result =
                render_named(*target, request, share_of(control, i, frames.size()));
            if (result.stopped) return exit_code_of_stop("the frames before this one are made");
            if (warnings.empty() && !result.warnings.empty())
                warnings = fmt::format("frame {}: {}", frames[i], result.warnings);
            if (!job.stats.empty())
                write_text_safely(path_of_frame(job.stats, frames[i]),
                                  statistics_json(result.statistics));
        }
    }
    target->finish();
    tell(warnings);
    if (!job.quiet)
        tell(fmt::format("{}: {} frames in {:.2f} s\n",
                         job.out == "-" ? "the standard output" : printable_path(job.out),
                         frames.size(), clock.lap()));
    return ExitCode::done;
}

}  // namespace pxm::host
