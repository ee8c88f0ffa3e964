#include "host/commands/film_stream.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "host/files/checked_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/film.hpp"
#include "host/output/frame_list.hpp"
#include "host/output/pixel_values.hpp"
#include "host/text/nearest.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

/// The standard output, over a descriptor of its own.
class StandardOutput : public FrameStream {
  public:
    StandardOutput(RawFormat format, const FilmShape& shape)
        : file_(descriptor(), "the standard output", Places::in_order),
          stream_(make_raw_stream(file_, format, shape)) {}
    void frame(std::span<const unsigned char> rgb) override { stream_->frame(rgb); }
    void finish() override { stream_->finish(); }

  private:
    static int descriptor() {
        const int copy = dup(STDOUT_FILENO);
        if (copy < 0) cannot_write("the standard output", strerror(errno));
        return copy;
    }

    CheckedFile file_;
    std::unique_ptr<FrameStream> stream_;
};

RawFormat raw_format_of(const std::string& format) {
    if (format == "y4m") return RawFormat::y4m;
    if (format == "ppm") return RawFormat::ppm;
    throw Error(ErrorKind::setting,
                format.empty()
                    ? "-o -: say what goes to the standard output, --format y4m or --format ppm"
                    : fmt::format("--format: found \"{}\", expected y4m or ppm{}",
                                  printable(format, 100), suggestion(format, {"y4m", "ppm"})));
}

}  // namespace

void ByteFrame::begin(const CropWindow& window) {
    window_ = window;
    bytes_.assign(static_cast<std::size_t>(3 * columns() * (window_.y1 - window_.y0)), 0);
}

void ByteFrame::take(const Frame& part) {
    for (long y = part.crop.y0; y < part.crop.y1; ++y) {
        const long at = (y - window_.y0) * columns() + part.crop.x0 - window_.x0;
        put_srgb_bytes(
            std::span(&part.at(part.crop.x0, y), static_cast<std::size_t>(part.columns())),
            bytes_.data() + 3 * at);
    }
}

FilmShape shape_of(const Scene& scene) {
    const ImageBlock image = scene.image.value_or(ImageBlock{});
    const PixelSize size = image.size.value_or(PixelSize{});
    const CropWindow window = image.crop.value_or(CropWindow{0, 0, size.columns, size.rows});
    return {window.x1 - window.x0, window.y1 - window.y0,
            scene.animation ? scene.animation->rate : AnimationBlock{}.rate};
}

std::unique_ptr<FrameStream> open_film_stream(const FilmPath& path, const FilmShape& shape) {
    if (path.out == "-") return std::make_unique<StandardOutput>(raw_format_of(path.format), shape);
    if (!path.format.empty())
        throw Error(ErrorKind::setting, "--format: it is of frames on the standard output (-o -)");
    if (!is_film(path.out)) return nullptr;
    require_writable(path.out);
    return make_film(path.out, shape);
}

void require_frame_number(const std::string& out, std::size_t frames) {
    if (frames <= 1 || has_frame_number(out)) return;
    throw Error(ErrorKind::setting,
                out.empty() ? "--frames: say where the frames go, as -o frames/%04d.png or "
                              "-o film.mp4"
                            : fmt::format("--frames: {} frames cannot be one picture, {}: put the "
                                          "frame's number into its name, as %04d",
                                          frames, printable_path(out)));
}

std::vector<long> frames_of_scene(const std::string& text, const Scene& scene) {
    if (!text.empty() && !scene.animation)
        throw Error(ErrorKind::setting, "--frames: the scene has no 'animation'");
    const long count = scene.animation ? scene.animation->frames : 1;
    return frames_of(text.empty() ? fmt::format("0-{}", count - 1) : text, count);
}

}  // namespace pxm::host
