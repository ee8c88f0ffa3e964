#include "host/studio/picture.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
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

void put_number(std::string& bytes, std::uint32_t number) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(static_cast<unsigned char>(number >> shift));
}

/// Takes blocks of pixels as they are rendered; each lies at a place of its own.
class ToCanvas : public PictureTaker {
  public:
    ToCanvas(Picture& picture, bool of_machine) : picture_(picture), of_machine_(of_machine) {}

    void begin(const RenderResult& known) override {
        window_ = known.window;
        const auto columns = static_cast<std::size_t>(window_.x1 - window_.x0);
        const std::size_t pixels = columns * static_cast<std::size_t>(window_.y1 - window_.y0);
        picture_.rgba.resize(4 * pixels);
        if (of_machine_) picture_.cycles.resize(pixels);
    }

    void take(const Frame& part) override {
        const auto columns = static_cast<std::size_t>(part.columns());
        std::vector<unsigned char> rgb(3 * columns);
        for (long y = part.crop.y0; y < part.crop.y1; ++y) {
            const std::span row(&part.at(part.crop.x0, y), columns);
            put_srgb_bytes(row, rgb.data());
            const auto at = static_cast<std::size_t>((y - window_.y0) * (window_.x1 - window_.x0) +
                                                     part.crop.x0 - window_.x0);
            unsigned char* to = picture_.rgba.data() + 4 * at;
            for (std::size_t i = 0; i < columns; ++i, to += 4) {
                std::copy_n(rgb.data() + 3 * i, 3, to);
                to[3] = 0xFF;
            }
            for (std::size_t i = 0; of_machine_ && i < columns; ++i)
                picture_.cycles[at + i] = static_cast<std::uint32_t>(std::min<std::uint64_t>(
                    row[i].cycles, std::numeric_limits<std::uint32_t>::max()));
        }
    }

  private:
    Picture& picture_;
    bool of_machine_;
    CropWindow window_;
};

}  // namespace

Picture render_asked(const AskedPicture& asked, int threads, std::atomic<bool>& stop,
                     const std::function<void(double)>& progress) {
    Picture picture;
    if (stop) {
        picture.result.stopped = true;
        return picture;
    }
    std::atomic<bool> late = false;
    const auto begin = std::chrono::steady_clock::now();
    RunControl control;
    control.stop = &stop;
    control.progress = [&](double share) {
        if (progress) progress(share);
        const auto passed = std::chrono::steady_clock::now() - begin;
        if (std::chrono::duration<double>(passed).count() <= asked_seconds) return;
        late = true;
        stop = true;
    };
    ToCanvas canvas(picture, asked.machine != nullptr);
    picture.result = render(request_of(asked, threads), control, &canvas);
    if (late)
        throw Error(ErrorKind::failed,
                    "the picture takes longer than the studio waits; pxm render has no limit");
    return picture;
}

std::string picture_bytes(const std::string& head, const Picture& picture) {
    std::string bytes;
    bytes.reserve(4 + head.size() + picture.rgba.size() + 4 * picture.cycles.size());
    put_number(bytes, static_cast<std::uint32_t>(head.size()));
    bytes += head;
    bytes.append(picture.rgba.begin(), picture.rgba.end());
    for (const std::uint32_t cycles : picture.cycles) put_number(bytes, cycles);
    return bytes;
}

std::string png_bytes(const Picture& picture) {
    const int descriptor = memfd_create("picture", MFD_CLOEXEC);
    if (descriptor < 0) throw Error(ErrorKind::failed, "no memory for the picture");
    CheckedFile file(descriptor, "picture", Places::any);
    const CropWindow& window = picture.result.window;
    const auto columns = static_cast<std::size_t>(window.x1 - window.x0);
    PngFile png(file, static_cast<std::uint32_t>(columns),
                static_cast<std::uint32_t>(window.y1 - window.y0), software, file_time());
    std::vector<unsigned char> rgb(picture.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgb.size() / 3; ++i)
        std::copy_n(picture.rgba.data() + 4 * i, 3, rgb.data() + 3 * i);
    const std::size_t segment = static_cast<std::size_t>(band_rows) * columns * 3;
    for (std::size_t at = 0; at < rgb.size(); at += segment)
        png.append(deflate_rows(std::span(rgb).subspan(at, std::min(segment, rgb.size() - at)),
                                columns * 3));
    png.finish();
    std::string bytes(static_cast<std::size_t>(file.size()), '\0');
    if (file.read_at(0, bytes.data(), bytes.size()) != bytes.size())
        throw Error(ErrorKind::failed, "the picture cannot be read back");
    return bytes;
}

}  // namespace pxm::host
