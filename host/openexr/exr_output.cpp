// The module that is linked to OpenEXR, for the pictures of that format which pxm writes: it brings
// four libraries with it, where OpenImageIO would bring 260. The file is the one that OpenImageIO
// makes of the same PictureSpec, to the last byte.
#include <Imath/ImathBox.h>
#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <sched.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <stdexcept>

#include "host/files/picture_library.hpp"
#include "host/files/picture_module.hpp"

namespace pxm::host {

namespace {

/// A place to write to, over bytes that check every write.
class Stream : public Imf::OStream {
  public:
    explicit Stream(FileBytes& bytes) : OStream("pxm"), bytes_(bytes) {}

    void write(const char data[], int count) override {
        if (!bytes_.write_at(static_cast<std::int64_t>(place_), data,
                             static_cast<std::size_t>(count)))
            throw std::runtime_error("a write failed");
        place_ += static_cast<std::uint64_t>(count);
    }
    std::uint64_t tellp() override { return place_; }
    void seekp(std::uint64_t place) override { place_ = place; }

  private:
    FileBytes& bytes_;
    std::uint64_t place_ = 0;
};

/// OpenImageIO's names of what OpenEXR calls otherwise.
void add_metadata(const Metadata& metadata, Imf::Header& header) {
    for (const auto& [name, value] : metadata) {
        if (name == "compression") continue;
        header.insert(name == "DateTime" ? "capDate" : name, Imf::StringAttribute(value));
    }
}

/// Pixels in a larger picture: what is around them is not in the file.
Imf::Header windows_of(const PictureSpec& spec) {
    const auto number = [](std::int64_t value) { return static_cast<int>(value); };
    if (spec.whole_width == 0) return {number(spec.width), number(spec.height)};
    using Imath::V2i;
    const V2i first(number(spec.x), number(spec.y));
    const V2i last = first + V2i(number(spec.width) - 1, number(spec.height) - 1);
    return {
        Imath::Box2i(V2i(0, 0), V2i(number(spec.whole_width) - 1, number(spec.whole_height) - 1)),
        Imath::Box2i(first, last)};
}

bool is_half(const PictureSpec& spec, const std::string& channel) {
    return std::find(spec.half.begin(), spec.half.end(), channel) != spec.half.end();
}

Imf::Header header_of(const PictureSpec& spec) {
    Imf::Header header = windows_of(spec);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const std::string& name : spec.channels)
        header.channels().insert(name, Imf::Channel(is_half(spec, name) ? Imf::HALF : Imf::FLOAT));
    add_metadata(spec.metadata, header);
    return header;
}

class ExrOutput : public PictureOutput {
  public:
    bool takes(FileBytes& bytes) override {
        stream_.emplace(bytes);
        return true;
    }
    bool open(const std::string& /*path*/, const PictureSpec& spec) override {
        spec_ = spec;
        return tried([&] { file_.emplace(*stream_, header_of(spec)); });
    }
    bool write_floats(int first, int end, const float* values) override {
        return tried([&] {
            const std::size_t channels = spec_.channels.size();
            const auto width = static_cast<std::size_t>(spec_.width);
            const std::size_t pixels = width * static_cast<std::size_t>(end - first);
            Imf::FrameBuffer buffer;
            halves_.resize(spec_.half.size() * pixels);
            std::size_t next_half = 0;
            for (std::size_t i = 0; i < channels; ++i) {
                const std::string& name = spec_.channels[i];
                if (is_half(spec_, name)) {
                    half* to = halves_.data() + next_half++ * pixels;
                    for (std::size_t n = 0; n < pixels; ++n) to[n] = half(values[n * channels + i]);
                    buffer.insert(name, slice(Imf::HALF, to, first, sizeof(half)));
                } else {
                    auto* from = const_cast<float*>(values) + i;
                    buffer.insert(name, slice(Imf::FLOAT, from, first, channels * sizeof(float)));
                }
            }
            file_->setFrameBuffer(buffer);
            file_->writePixels(end - first);
        });
    }
    bool write_bytes(int, int, const unsigned char*) override { return false; }
    bool close() override {
        return tried([&] { file_.reset(); });
    }
    std::string error() override { return error_; }
    [[nodiscard]] std::string format() const override { return "openexr"; }

  private:
    /// Of values whose first is that of the first pixel in that row; the library counts both from
    /// the whole picture's first, wherever the values are.
    [[nodiscard]] Imf::Slice slice(Imf::PixelType type, void* values, int first,
                                   std::size_t pixel) const {
        const std::size_t row = pixel * static_cast<std::size_t>(spec_.width);
        char* origin = static_cast<char*>(values) -
                       static_cast<std::ptrdiff_t>(row) * (first + spec_.y) -
                       static_cast<std::ptrdiff_t>(pixel) * spec_.x;
        return {type, origin, pixel, row};
    }

    /// After a failure the file is not touched again: it waits for ever for rows that were lost.
    template <class Work>
    bool tried(const Work& work) {
        if (failed_) return false;
        try {
            work();
        } catch (const std::exception& error) {
            error_ = error.what();
            failed_ = true;
        }
        return !failed_;
    }

    PictureSpec spec_;
    std::vector<half> halves_;  // rows of the channels that are kept in 16 bits, one by one
    std::optional<Stream> stream_;
    std::optional<Imf::OutputFile> file_;  // is gone before what it writes to
    std::string error_;
    bool failed_ = false;
};

/// Writes, and reads nothing.
class ExrLibrary : public PictureLibrary {
  public:
    /// Threads deflate blocks of 16 rows, as many as the process may use.
    ExrLibrary() {
        cpu_set_t granted;
        const bool known = sched_getaffinity(0, sizeof granted, &granted) == 0;
        Imf::setGlobalThreadCount(known ? std::max(1, CPU_COUNT(&granted)) : 1);
    }

    std::unique_ptr<PictureInput> open(const char*, std::FILE*, const std::string&,
                                       std::string&) override {
        return nullptr;
    }
    std::unique_ptr<PictureInput> open_own(const std::string&) override { return nullptr; }
    std::unique_ptr<PictureOutput> create(const std::string&, std::string&) override {
        return std::make_unique<ExrOutput>();
    }
};

}  // namespace

}  // namespace pxm::host

extern "C" __attribute__((visibility("default"))) pxm::host::PictureLibrary* pxm_exr_library() {
    // Never taken down: its threads may not outlive what they use.
    static auto* library = new pxm::host::ExrLibrary;
    return library;
}
