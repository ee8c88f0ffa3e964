#define FMT_EXCEPTIONS 1  // OpenImageIO's headers would switch them off
#include "host/output/image.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <new>
#include <optional>

#include "host/error.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/image_sink.hpp"

namespace pxm::host {

namespace {

std::string extension_of(const std::string& path) {
    const auto dot = path.rfind('.');
    const auto slash = path.rfind('/');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
    std::string extension = path.substr(dot + 1);
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

bool holds_floats(const std::string& path) {
    const std::string extension = extension_of(path);
    return extension == "exr" || extension == "hdr";
}

/// The time in the file's metadata: SOURCE_DATE_EPOCH or a constant, so that equal renders are
/// equal files.
std::string date_time() {
    const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
    const std::time_t seconds = epoch ? static_cast<std::time_t>(std::atoll(epoch)) : 0;
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y:%m:%d %H:%M:%S", &parts);
    return text;
}

bool is_exr(const std::string& path) { return extension_of(path) == "exr"; }

/// Red, green, blue and, in an EXR, what is opaque: programs that find no A take another channel
/// for it, or the picture for transparent.
std::vector<std::string> channel_names(const std::string& path, const std::vector<Aov>& aovs) {
    std::vector<std::string> names{"R", "G", "B"};
    if (is_exr(path)) names.emplace_back("A");
    for (const Aov aov : aovs) {
        for (const AovChannel& channel : channels_of(aov)) names.push_back(channel.name);
    }
    return names;
}

void append(std::vector<float>& values, const PixelRecord& pixel, Aov aov) {
    switch (aov) {
        case Aov::z:
            values.push_back(pixel.z);
            return;
        case Aov::node:
            values.push_back(static_cast<float>(pixel.node));
            return;
        case Aov::cycles:
            values.push_back(static_cast<float>(pixel.cycles));
            return;
        case Aov::volumes:
            values.push_back(static_cast<float>(pixel.volumes));
            return;
        case Aov::level:
            values.push_back(static_cast<float>(pixel.level));
            return;
        case Aov::heap:
            values.push_back(static_cast<float>(pixel.heap));
            return;
        case Aov::alpha:
            values.push_back(pixel.alpha);
            return;
        case Aov::object:
            values.push_back(static_cast<float>(pixel.object));
            return;
        case Aov::word:
            values.push_back(static_cast<float>(pixel.word));
            return;
        case Aov::normal:
            values.insert(values.end(), pixel.normal, pixel.normal + 3);
            return;
    }
}

/// OpenImageIO's message about `beside`, told of `path`.
std::string told_of(const std::string& path, const std::string& beside, std::string why) {
    const auto at = why.find(beside);
    return at == std::string::npos ? why : why.replace(at, beside.size(), path);
}

OIIO::ImageSpec spec_of(const std::string& path, const PixelSize& size,
                        const std::vector<std::string>& names, const Metadata& metadata) {
    const bool floats = holds_floats(path);
    OIIO::ImageSpec spec(static_cast<int>(size.columns), static_cast<int>(size.rows),
                         static_cast<int>(names.size()),
                         floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    spec.channelnames = names;
    spec.attribute("DateTime", date_time());
    spec.attribute("Software", "pxm " PXM_VERSION);
    spec.attribute("oiio:ColorSpace", floats ? "Linear" : "sRGB");
    if (is_exr(path)) {
        spec.attribute("compression", "zip");
        // No colon in the names: to some readers what stands before it is a channel's.
        for (const auto& [name, value] : metadata) spec.attribute("pxm_" + name, value);
    }
    return spec;
}

std::vector<float> floats_of(const Frame& rows, const std::vector<std::string>& names,
                             const std::vector<Aov>& aovs) {
    const bool opaque = std::ranges::count(names, "A") > 0;
    std::vector<float> values;
    values.reserve(rows.pixels.size() * names.size());
    for (const PixelRecord& pixel : rows.pixels) {
        values.insert(values.end(), pixel.color, pixel.color + 3);
        if (opaque) values.push_back(1);
        for (const Aov aov : aovs) append(values, pixel, aov);
    }
    return values;
}

std::array<unsigned char, 3> bytes_of(const float (&color)[3]) {
    std::array<unsigned char, 3> bytes;
    for (std::size_t k = 0; k < 3; ++k) {
        bytes[k] = static_cast<unsigned char>(std::lround(srgb_from_linear(color[k]) * 255.0F));
    }
    return bytes;
}

std::vector<unsigned char> bytes_of(const Frame& rows) {
    std::vector<unsigned char> all(3 * rows.pixels.size());
    const float* last = nullptr;  // neighbours are often of one colour: the background's
    std::array<unsigned char, 3> bytes{};
    for (std::size_t i = 0; i < rows.pixels.size(); ++i) {
        const auto& color = rows.pixels[i].color;
        if (last == nullptr || !std::equal(color, color + 3, last)) bytes = bytes_of(color);
        last = color;
        std::ranges::copy(bytes, all.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
    return all;
}

/// Whether OpenImageIO has a writer of colour pictures for this extension. Its `null` and `term`
/// write no file, a zfile holds depths, and its IFF takes tiles alone.
bool is_picture_format(const std::string& path) {
    prepare_image_library();
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) return (void)OIIO::geterror(), false;
    const std::string format = output->format_name();
    return format != "null" && format != "term" && format != "zfile" && format != "iff";
}

}  // namespace

float srgb_from_linear(float linear) {
    const float x = std::clamp(linear, 0.0F, 1.0F);
    return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

void require_image_format(const std::string& path, const std::vector<Aov>& aovs) {
    const std::string extension = extension_of(path);
    if (extension.empty() || !is_picture_format(path)) {
        throw Error(ErrorKind::setting, "cannot write " + path + ": unknown image extension \"" +
                                            extension + "\" (png, exr, tif, jpg, ...)");
    }
    if (!aovs.empty() && !is_exr(path)) {
        throw Error(ErrorKind::setting, "--aov needs an .exr output, not " + path);
    }
}

/// Gives the writer a place to write to, if it can be trusted with one. TIFF cannot: it reads what
/// it wrote, which its writer never does from such a place, and leaves out the picture's size.
static bool takes_a_sink(OIIO::ImageOutput& output, ImageSink& sink) {
    return std::string_view(output.format_name()) != "tiff" && output.set_ioproxy(&sink);
}

struct ImageWriter::File {
    File(const std::string& p, const PixelSize& s, const std::vector<Aov>& a)
        : path(p), size(s), aovs(a), part(p, Places::any), sink(part.file(), part.beside()) {}

    std::string path;
    PixelSize size;
    std::vector<Aov> aovs;
    PartFile part;
    ImageSink sink;
    std::unique_ptr<OIIO::ImageOutput> output;
    std::optional<Digest> digest;  // of a writer that opens the file itself
    int next_row = 0;

    /// The system's reason first: the library knows none, or nothing of it.
    void require(bool done) {
        part.file().require();
        if (done) return;
        const std::string why = output->geterror();
        if (why.find("std::bad_alloc") != std::string::npos) throw std::bad_alloc();
        cannot_write(path, told_of(path, part.beside(), why));
    }
};

ImageWriter::ImageWriter(const std::string& path, const PixelSize& size,
                         const std::vector<Aov>& aovs, const Metadata& metadata)
    : file_(new File(path, size, aovs)) {
    prepare_image_library();
    file_->output = OIIO::ImageOutput::create(file_->part.beside());
    if (!file_->output) cannot_write(path, OIIO::geterror());
    if (!takes_a_sink(*file_->output, file_->sink)) file_->digest.emplace();
    const OIIO::ImageSpec spec = spec_of(path, size, channel_names(path, aovs), metadata);
    // Some formats hold the name: with a place to write to it need not be the part's.
    file_->require(file_->output->open(file_->digest ? file_->part.beside() : path, spec));
}

ImageWriter::~ImageWriter() = default;

void ImageWriter::append(const Frame& rows) {
    const int first = file_->next_row;
    file_->next_row += static_cast<int>(rows.rows());
    const auto put = [&](const OIIO::TypeDesc& type, const void* pixels) {
        file_->require(file_->output->write_scanlines(first, file_->next_row, 0, type, pixels));
    };
    if (holds_floats(file_->path)) {
        put(OIIO::TypeDesc::FLOAT,
            floats_of(rows, channel_names(file_->path, file_->aovs), file_->aovs).data());
    } else {
        const std::vector<unsigned char> bytes = bytes_of(rows);
        if (file_->digest) file_->digest->add_all(std::span<const unsigned char>(bytes));
        put(OIIO::TypeDesc::UINT8, bytes.data());
    }
}

void ImageWriter::finish() {
    File& file = *file_;
    file.require(file.output->close());
    if (file.digest) {
        const std::string why =
            why_not_as_written(file.part.beside(), static_cast<int>(file.size.columns),
                               static_cast<int>(file.size.rows), *file.digest);
        if (!why.empty()) cannot_write(file.path, why);
    }
    file.part.commit();
}

void write_image(const std::string& path, const Frame& frame, const std::vector<Aov>& aovs,
                 const Metadata& metadata) {
    ImageWriter writer(path, {frame.columns(), frame.rows()}, aovs, metadata);
    writer.append(frame);
    writer.finish();
}

}  // namespace pxm::host
