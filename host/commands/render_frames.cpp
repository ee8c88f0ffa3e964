#include "host/commands/render_frames.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <span>

#include "host/error.hpp"
#include "host/files/checked_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/film.hpp"
#include "host/output/frame_list.hpp"
#include "host/output/pixel_values.hpp"
#include "host/output/statistics_json.hpp"
#include "host/process/interrupt.hpp"
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

/// A frame as bytes of sRGB.
class ByteFrame : public PictureTaker {
  public:
    void begin(const RenderResult& known) override {
        window_ = known.window;
        bytes_.resize(static_cast<std::size_t>(3 * columns() * (window_.y1 - window_.y0)));
    }
    void take(const Frame& part) override {
        for (long y = part.crop.y0; y < part.crop.y1; ++y) {
            const long at = (y - window_.y0) * columns() + part.crop.x0 - window_.x0;
            put_srgb_bytes(
                std::span(&part.at(part.crop.x0, y), static_cast<std::size_t>(part.columns())),
                bytes_.data() + 3 * at);
        }
    }
    [[nodiscard]] std::span<const unsigned char> bytes() const { return bytes_; }

  private:
    [[nodiscard]] long columns() const { return window_.x1 - window_.x0; }

    CropWindow window_;
    std::vector<unsigned char> bytes_;
};

/// One stream of all.
class OneStream : public FrameTarget {
  public:
    explicit OneStream(std::unique_ptr<FrameStream> stream) : stream_(std::move(stream)) {}
    RenderResult render_frame(const RenderRequest& request, const RunControl& control) override {
        RenderResult result = render(request, control, &frame_);
        if (!result.stopped) stream_->frame(frame_.bytes());
        return result;
    }
    void finish() override { stream_->finish(); }

  private:
    ByteFrame frame_;
    std::unique_ptr<FrameStream> stream_;
};

/// The standard output, over a descriptor of its own.
class StandardOutput : public FrameTarget {
  public:
    StandardOutput(RawFormat format, const FilmShape& shape)
        : file_(descriptor(), "the standard output", Places::in_order),
          stream_(make_raw_stream(file_, format, shape)) {}
    RenderResult render_frame(const RenderRequest& request, const RunControl& control) override {
        return stream_.render_frame(request, control);
    }
    void finish() override { stream_.finish(); }

  private:
    static int descriptor() {
        const int copy = dup(STDOUT_FILENO);
        if (copy < 0) cannot_write("the standard output", strerror(errno));
        return copy;
    }

    CheckedFile file_;
    OneStream stream_;
};

FilmShape shape_of(const Scene& scene) {
    const ImageBlock image = scene.image.value_or(ImageBlock{});
    const PixelSize size = image.size.value_or(PixelSize{});
    const CropWindow window = image.crop.value_or(CropWindow{0, 0, size.columns, size.rows});
    return {window.x1 - window.x0, window.y1 - window.y0,
            scene.animation ? scene.animation->rate : AnimationBlock{}.rate};
}

RawFormat raw_format_of(const FilmJob& job) {
    if (job.format == "y4m") return RawFormat::y4m;
    if (job.format == "ppm") return RawFormat::ppm;
    throw Error(ErrorKind::setting,
                job.format.empty()
                    ? "-o -: say what goes to the standard output, --format y4m or --format ppm"
                    : fmt::format("--format: found \"{}\", expected y4m or ppm",
                                  printable(job.format, 100)));
}

std::unique_ptr<FrameTarget> target_of(const FilmJob& job, const Scene& scene,
                                       const std::vector<long>& frames) {
    if (job.out == "-")
        return std::make_unique<StandardOutput>(raw_format_of(job), shape_of(scene));
    if (!job.format.empty())
        throw Error(ErrorKind::setting, "--format: it is of frames on the standard output (-o -)");
    if (is_film(job.out)) {
        job.require_picture("film.png");
        require_writable(job.out);
        return std::make_unique<OneStream>(make_film(job.out, shape_of(scene)));
    }
    if (frames.size() > 1 && !has_frame_number(job.out))
        throw Error(ErrorKind::setting,
                    job.out.empty()
                        ? "--frames: say where the frames go, as -o frames/%04d.png or -o film.mp4"
                        : fmt::format("--frames: {} frames cannot be one picture, {}: put the "
                                      "frame's number into its name, as %04d",
                                      frames.size(), printable_path(job.out)));
    for (const long frame : {frames.front(), frames.back()})
        job.require_picture(path_of_frame(job.out, frame));
    return std::make_unique<PictureFiles>(job);
}

/// A frame that fails says which it was.
RenderResult render_named(FrameTarget& target, const RenderRequest& request,
                          const RunControl& control) {
    try {
        return target.render_frame(request, control);
    } catch (const Error& error) {
        throw Error(error.kind(), fmt::format("frame {}: {}", request.frame, error.what()),
                    error.mistakes());
    }
}

RunControl control_of_frame(const RunControl& control, std::size_t frame, std::size_t frames) {
    RunControl own = control;
    if (!control.progress) return own;
    own.progress = [&control, frame, frames](double share) {
        control.progress((static_cast<double>(frame) + share) / static_cast<double>(frames));
    };
    return own;
}

}  // namespace

ExitCode render_frames(const FilmJob& job) {
    PhaseClock clock;
    const Scene scene = scene_of(job.request);
    if (!job.frames.empty() && !scene.animation)
        throw Error(ErrorKind::setting, "--frames: the scene has no 'animation'");
    const long count = scene.animation ? scene.animation->frames : 1;
    const std::vector<long> frames = job.frames.empty()
                                         ? frames_of(fmt::format("0-{}", count - 1), count)
                                         : frames_of(job.frames, count);
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
                render_named(*target, request, control_of_frame(control, i, frames.size()));
            if (result.stopped) return exit_code_of_signal(received_signal());
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
