// The module that is linked to OpenImageIO: the interface of host/files/picture_library.hpp, and
// nothing else. It knows no rule of pxm's; what may be read is decided before it is asked.
#define FMT_EXCEPTIONS 1  // OpenImageIO's headers would switch them off
#include "host/files/picture_library.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <optional>

#include "host/files/picture_module.hpp"

namespace pxm::host {

namespace {

/// A place to write to, over bytes that check every write.
class Proxy : public OIIO::Filesystem::IOProxy {
  public:
    explicit Proxy(FileBytes& bytes) : IOProxy("", IOProxy::Write), bytes_(bytes) {}

    [[nodiscard]] const char* proxytype() const override { return "pxm"; }
    std::size_t read(void* data, std::size_t bytes) override {
        const std::size_t got = pread(data, bytes, m_pos);
        m_pos += static_cast<std::int64_t>(got);
        return got;
    }
    std::size_t write(const void* data, std::size_t bytes) override {
        const std::size_t written = pwrite(data, bytes, m_pos);
        m_pos += static_cast<std::int64_t>(written);
        return written;
    }
    std::size_t pread(void* data, std::size_t bytes, std::int64_t place) override {
        return bytes_.read_at(place, data, bytes);
    }
    std::size_t pwrite(const void* data, std::size_t bytes, std::int64_t place) override {
        return bytes_.write_at(place, data, bytes) ? bytes : 0;
    }
    [[nodiscard]] std::size_t size() const override {
        return static_cast<std::size_t>(bytes_.size());
    }

  private:
    FileBytes& bytes_;
};

PictureSpec spec_of(const OIIO::ImageSpec& from) {
    PictureSpec spec;
    spec.width = from.width;
    spec.height = from.height;
    spec.depth = from.depth;
    spec.tile_width = from.tile_width;
    spec.tile_height = from.tile_height;
    spec.tile_depth = from.tile_depth;
    spec.channel_count = from.nchannels;
    spec.channels = from.channelnames;
    spec.deep = from.deep;
    spec.floats = from.format.is_floating_point();
    spec.color_space = from.get_string_attribute("oiio:ColorSpace", "sRGB");
    for (const auto& attribute : from.extra_attribs)
        spec.metadata.emplace_back(attribute.name().string(), attribute.get_string());
    return spec;
}

class Input : public PictureInput {
  public:
    Input(std::unique_ptr<OIIO::Filesystem::IOFile> proxy, std::unique_ptr<OIIO::ImageInput> input)
        : proxy_(std::move(proxy)), input_(std::move(input)), spec_(spec_of(input_->spec())) {}

    [[nodiscard]] const PictureSpec& spec() const override { return spec_; }
    bool read_floats(int first, int end, int channels, float* values) override {
        return read(first, end, channels, OIIO::TypeDesc::FLOAT, values);
    }
    bool read_bytes(int first, int end, int channels, unsigned char* values) override {
        return read(first, end, channels, OIIO::TypeDesc::UINT8, values);
    }
    std::string error() override { return input_->geterror(); }
    [[nodiscard]] std::string format() const override { return input_->format_name(); }

  private:
    bool read(int first, int end, int channels, const OIIO::TypeDesc& type, void* values) {
        const OIIO::ImageSpec& s = input_->spec();
        if (s.tile_width > 0)
            return input_->read_tiles(0, 0, s.x, s.x + s.width, s.y + first, s.y + end, s.z,
                                      s.z + 1, 0, channels, type, values);
        return input_->read_scanlines(0, 0, s.y + first, s.y + end, s.z, 0, channels, type, values);
    }

    std::unique_ptr<OIIO::Filesystem::IOFile> proxy_;
    std::unique_ptr<OIIO::ImageInput> input_;  // is gone before what it reads from
    PictureSpec spec_;
};

class Output : public PictureOutput {
  public:
    explicit Output(std::unique_ptr<OIIO::ImageOutput> output) : output_(std::move(output)) {}

    bool takes(FileBytes& bytes) override {
        proxy_.emplace(bytes);
        return output_->set_ioproxy(&*proxy_);
    }
    bool open(const std::string& path, const PictureSpec& from) override {
        OIIO::ImageSpec spec(static_cast<int>(from.width), static_cast<int>(from.height),
                             static_cast<int>(from.channels.size()),
                             from.floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
        spec.channelnames = from.channels;
        spec.attribute("oiio:ColorSpace", from.color_space);
        for (const auto& [name, value] : from.metadata) spec.attribute(name, value);
        return output_->open(path, spec);
    }
    bool write_floats(int first, int end, const float* values) override {
        return output_->write_scanlines(first, end, 0, OIIO::TypeDesc::FLOAT, values);
    }
    bool write_bytes(int first, int end, const unsigned char* values) override {
        return output_->write_scanlines(first, end, 0, OIIO::TypeDesc::UINT8, values);
    }
    bool close() override { return output_->close(); }
    std::string error() override { return output_->geterror(); }
    [[nodiscard]] std::string format() const override { return output_->format_name(); }

  private:
    std::optional<Proxy> proxy_;
    std::unique_ptr<OIIO::ImageOutput> output_;
};

/// OpenImageIO without plug-ins and without threads of its own.
class Library : public PictureLibrary {
  public:
    Library() {
        OIIO::attribute("plugin_searchpath", "");
        OIIO::attribute("threads", 1);
    }

    std::unique_ptr<PictureInput> open(const char* reader, std::FILE* stream,
                                       const std::string& path, std::string& error) override {
        auto proxy =
            std::make_unique<OIIO::Filesystem::IOFile>(stream, OIIO::Filesystem::IOProxy::Read);
        auto input = OIIO::ImageInput::create(reader);
        if (!input) return error = OIIO::geterror(), nullptr;
        OIIO::ImageSpec spec;
        OIIO::attribute("exr_threads", -1);  // none: each would have buffers of its own
        const bool opened = input->set_ioproxy(proxy.get()) && input->open(path, spec);
        OIIO::attribute("exr_threads", 0);  // the default again, for pictures that are written
        if (!opened) return error = input->geterror(), nullptr;
        return std::make_unique<Input>(std::move(proxy), std::move(input));
    }
    std::unique_ptr<PictureInput> open_own(const std::string& path) override {
        auto input = OIIO::ImageInput::open(path);
        if (!input) return (void)OIIO::geterror(), nullptr;
        return std::make_unique<Input>(nullptr, std::move(input));
    }
    std::unique_ptr<PictureOutput> create(const std::string& path, std::string& error) override {
        auto output = OIIO::ImageOutput::create(path);
        if (!output) return error = OIIO::geterror(), nullptr;
        return std::make_unique<Output>(std::move(output));
    }
};

}  // namespace

}  // namespace pxm::host

extern "C" __attribute__((visibility("default"))) pxm::host::PictureLibrary* pxm_picture_library() {
    static pxm::host::Library library;
    return &library;
}
