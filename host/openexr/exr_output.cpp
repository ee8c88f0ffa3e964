// The module that is linked to OpenEXR, for the pictures of that format which pxm writes: it brings
// four libraries with it, where OpenImageIO would bring 260. The file is the one that OpenImageIO
// makes of the same PictureSpec, to the last byte.
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

Imf::Header header_of(const PictureSpec& spec) {
    Imf::Header header(static_cast<int>(spec.width), static_cast<int>(spec.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const std::string& name : spec.channels)
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
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
        channels_ = spec.channels;
        width_ = static_cast<std::size_t>(spec.width);
        return tried([&] { file_.emplace(*stream_, header_of(spec)); });
    }
    bool write_floats(int first, int end, const float* values) override {
        return tried([&] {
            const std::size_t pixel = channels_.size() * sizeof(float), row = pixel * width_;
            // The library counts rows from the picture's first, wherever these are.
            char* origin = reinterpret_cast<char*>(const_cast<float*>(values)) -
                           static_cast<std::ptrdiff_t>(row) * first;
            Imf::FrameBuffer buffer;
            for (std::size_t i = 0; i < channels_.size(); ++i)
                buffer.insert(channels_[i],
                              Imf::Slice(Imf::FLOAT, origin + i * sizeof(float), pixel, row));
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

    std::vector<std::string> channels_;
    std::size_t width_ = 0;
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
