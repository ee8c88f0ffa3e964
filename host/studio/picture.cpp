#include "host/studio/picture.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "host/error.hpp"
#include "host/files/checked_file.hpp"
#include "host/output/encoder.hpp"
#include "host/output/pixel_values.hpp"
#include "host/output/png.hpp"
#include "host/output/row_bands.hpp"

namespace pxm::host {

namespace {

/// Takes blocks of pixels as they are rendered; each lies at a place of its own.
class ToRgb : public PictureTaker {
  public:
    explicit ToRgb(Picture& picture) : picture_(picture) {}

    void begin(const RenderResult& known) override {
        window_ = known.window;
        picture_.rgb.resize(
            3 * static_cast<std::size_t>((window_.x1 - window_.x0) * (window_.y1 - window_.y0)));
    }

    void take(const Frame& part) override {
        for (long y = part.crop.y0; y < part.crop.y1; ++y) {
            const std::span row(&part.at(part.crop.x0, y),
                                static_cast<std::size_t>(part.columns()));
            const auto at = static_cast<std::size_t>((y - window_.y0) * (window_.x1 - window_.x0) +
                                                     part.crop.x0 - window_.x0);
            put_srgb_bytes(row, picture_.rgb.data() + 3 * at);
        }
    }

  private:
    Picture& picture_;
    CropWindow window_;
};

}  // namespace

RenderResult render_asked(const AskedPicture& asked, int threads, std::atomic<bool>& stop,
                          const std::function<void(double)>& progress, PictureTaker& taker) {
    if (stop) {
        RenderResult nothing;
        nothing.stopped = true;
        return nothing;
    }
    RunControl control;
    control.stop = &stop;
    control.progress = progress;
    return render(request_of(asked, threads), control, &taker);
}

Picture picture_asked(const AskedPicture& asked, int threads, std::atomic<bool>& stop,
                      const std::function<void(double)>& progress) {
    Picture picture;
    ToRgb taker(picture);
    picture.result = render_asked(asked, threads, stop, progress, taker);
    return picture;
}

std::string png_bytes(const Picture& picture) {
    const int descriptor = memfd_create("picture", MFD_CLOEXEC);
    if (descriptor < 0) throw Error(ErrorKind::failed, "no memory for the picture");
    CheckedFile file(descriptor, "picture", Places::any);
    const CropWindow& window = picture.result.window;
    const auto columns = static_cast<std::size_t>(window.x1 - window.x0);
    PngFile png(file, static_cast<std::uint32_t>(columns),
                static_cast<std::uint32_t>(window.y1 - window.y0), software, file_time());
    const std::size_t segment = static_cast<std::size_t>(band_rows) * columns * 3;
    for (std::size_t at = 0; at < picture.rgb.size(); at += segment)
        png.append(deflate_rows(
            std::span(picture.rgb).subspan(at, std::min(segment, picture.rgb.size() - at)),
            columns * 3));
    png.finish();
    std::string bytes(static_cast<std::size_t>(file.size()), '\0');
    if (file.read_at(0, bytes.data(), bytes.size()) != bytes.size())
        throw Error(ErrorKind::failed, "the picture cannot be read back");
    return bytes;
}

}  // namespace pxm::host
