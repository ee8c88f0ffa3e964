#include "host/files/image_reader.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "host/error.hpp"
#include "host/files/exr_header.hpp"
#include "host/files/image_format.hpp"
#include "host/files/regular_file.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

/// Why a file is refused; the caller knows its name.
struct Refusal {
    std::string why;
};

ImageFormat format_of(const RegularFile& file) {
    const FoundFormat found = found_format(file.read(0, image_head_bytes));
    if (found.format) return *found.format;
    if (found.name.empty()) throw Refusal{"not a picture (PNG, JPEG, OpenEXR, TIFF or PNM)"};
    throw Refusal{
        fmt::format("it is {}, and pxm reads PNG, JPEG, OpenEXR, TIFF and PNM: convert it to one "
                    "of these",
                    found.name)};
}

bool is_interlaced(const RegularFile& png) {
    const std::string head = png.read(0, 29);
    return head.size() < 29 || head[28] != '\0';  // the last byte of the chunk IHDR
}

/// The limits that hold for this file: some formats are unpacked as a whole.
ImageLimits limits_of(const RegularFile& file, ImageFormat format, ImageLimits limits) {
    const bool by_rows =
        format == ImageFormat::openexr || (format == ImageFormat::png && !is_interlaced(file));
    if (!by_rows) limits.pixels = std::min(limits.pixels, unpacked_pixels);
    return limits;
}

void require_within(const ImageLimits& limits, const ExrSizes& sizes) {
    const auto [width, height, channels, tile_width, tile_height] = sizes;
    if (width < 1 || height < 1 || channels < 1) throw Refusal{"it has no pixels"};
    if (std::max(width, height) > limits.side_pixels || width > limits.pixels / height)
        throw Refusal{fmt::format("{} x {} pixels are more than {} in all or {} a side", width,
                                  height, limits.pixels, limits.side_pixels)};
    if (channels > most_channels)
        throw Refusal{fmt::format("{} channels are more than {}", channels, most_channels)};
    // Tiles come in rows, so a row of tiles is kept.
    const std::int64_t across = tile_width > 0 ? (width / tile_width + 1) * tile_width : width;
    const std::int64_t rows = std::max<std::int64_t>(tile_height, 1);
    if (tile_width > any_image.side_pixels || tile_height > any_image.side_pixels ||
        across * channels > row_values * 64 / rows || width * channels > row_values)
        throw Refusal{fmt::format(
            "{} x {} pixels of {} channels{} are more than pxm takes at a "
            "time ({} values a row, {} in a row of tiles)",
            width, height, channels,
            tile_width > 0 ? fmt::format(" in tiles of {} x {}", tile_width, tile_height) : "",
            row_values, row_values * 64)};
}

ExrSizes sizes_of(const PictureSpec& spec) {
    return {spec.width, spec.height, spec.channel_count, spec.tile_width, spec.tile_height};
}

void require_understood(const PictureSpec& spec) {
    if (spec.deep) throw Refusal{"it has several values a pixel (deep data)"};
    if (spec.depth > 1 || spec.tile_depth > 1) throw Refusal{"it is a volume, not a picture"};
    if (spec.channels.size() != static_cast<std::size_t>(std::max<long>(spec.channel_count, 0)))
        throw Refusal{"it does not name its channels"};
}

/// Of a picture within the limits.
ImageHeader header_of(const PictureSpec& spec) {
    ImageHeader header;
    header.width = static_cast<int>(spec.width);
    header.height = static_cast<int>(spec.height);
    header.channels = spec.channels;
    header.srgb = !spec.floats && spec.color_space != "Linear";
    for (const auto& [name, value] : spec.metadata) {
        if (name.starts_with("pxm:") || name.starts_with("pxm_"))
            header.metadata.emplace_back(name.substr(4), value);
    }
    return header;
}

/// OpenImageIO's words, on one line: what follows its first sentence asks the user questions.
std::string sentence_of(const std::string& why) {
    const std::string first = why.substr(0, std::min(why.find(". "), why.find('\n')));
    return first.empty() ? "its content is broken" : printable(first, 400);
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A stream of its own on a file that stays open.
std::unique_ptr<std::FILE, CloseFile> stream_of(const RegularFile& file) {
    const int descriptor = ::dup(file.descriptor());
    std::FILE* stream = descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb");
    if (stream == nullptr) {
        if (descriptor >= 0) ::close(descriptor);
        throw Refusal{"cannot be opened"};
    }
    return std::unique_ptr<std::FILE, CloseFile>(stream);
}

}  // namespace

int ImageHeader::channel(const std::string& name) const {
    const auto found = std::ranges::find(channels, name);
    return found == channels.end() ? -1 : static_cast<int>(found - channels.begin());
}

const std::string* ImageHeader::find(const std::string& name) const {
    const auto found =
        std::ranges::find(metadata, name, &std::pair<std::string, std::string>::first);
    return found == metadata.end() ? nullptr : &found->second;
}

struct ImageReader::File {
    std::string path;
    RegularFile file;
    std::unique_ptr<std::FILE, CloseFile> stream;
    std::unique_ptr<PictureInput> input;  // is gone before what it reads from
    ImageHeader header;
    int band_rows = 1;  // read at once
    int next = 0;       // row to be handed out
    int known = 0;      // rows read
    std::vector<float> band;

    File(const std::string& place, const std::string& called) : path(called), file(place, called) {}

    void open(const ImageLimits& wanted);
    void read_band();
    [[noreturn]] void refuse(const std::string& why) const {
        throw Error(ErrorKind::file, fmt::format("cannot read {}: {}", path, why));
    }
};

void ImageReader::File::open(const ImageLimits& wanted) {
    const ImageFormat format = format_of(file);
    const ImageLimits limits = limits_of(file, format, wanted);
    if (format == ImageFormat::openexr) require_within(limits, largest_exr_sizes(file));
    stream = stream_of(file);
    std::string error;
    input = picture_library().open(reader_name(format), stream.get(), path, error);
    if (!input) throw Refusal{sentence_of(error)};
    const PictureSpec& spec = input->spec();
    require_understood(spec);
    require_within(limits, sizes_of(spec));
    header = header_of(spec);
    const long values = spec.width * spec.channel_count;
    band_rows = static_cast<int>(spec.tile_height > 0 ? spec.tile_height
                                                      : std::clamp(row_values / values, 1L, 64L));
    band.resize(static_cast<std::size_t>(values) * static_cast<std::size_t>(band_rows));
}

void ImageReader::File::read_band() {
    const int end = std::min(header.height, known + band_rows);
    if (!input->read_floats(known, end, static_cast<int>(header.channels.size()), band.data()))
        refuse(sentence_of(input->error()));
    known = end;
}

ImageReader::ImageReader(const std::string& place, const std::string& path,
                         const ImageLimits& limits) {
    try {
        file_ = std::make_unique<File>(place, path);
        file_->open(limits);
    } catch (const Refusal& refusal) {
        file_->refuse(refusal.why);
    } catch (const Error& error) {  // of the file itself, which tells its name
        throw Error(error.kind(), fmt::format("cannot read {}", error.what()));
    }
}

ImageReader::~ImageReader() = default;

const ImageHeader& ImageReader::header() const { return file_->header; }

const float* ImageReader::next_row() {
    if (file_->next == file_->known) file_->read_band();
    const int row = file_->next++ % file_->band_rows;
    return file_->band.data() + static_cast<std::size_t>(row) *
                                    static_cast<std::size_t>(file_->header.width) *
                                    file_->header.channels.size();
}

LoadedImage read_image(const std::string& path, const std::vector<std::string>& wanted) {
    ImageReader reader(path, kept_image);
    LoadedImage image{reader.header(), {}};
    std::vector<std::size_t> kept;
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
        const bool named = std::ranges::count(wanted, image.channels[c]) > 0;
        if (wanted.empty() || c == 0 || named) kept.push_back(c);
    }
    const std::size_t all = image.channels.size();
    const auto width = static_cast<std::size_t>(image.width);
    image.channels.clear();
    if (long{image.width} * image.height > 4 * kept_image.pixels / static_cast<long>(kept.size()))
        throw Error(ErrorKind::file,
                    fmt::format("cannot read {}: {} x {} pixels of {} channels are "
                                "more than pxm keeps",
                                path, image.width, image.height, kept.size()));
    for (const std::size_t c : kept) image.channels.push_back(reader.header().channels[c]);
    image.values.reserve(width * static_cast<std::size_t>(image.height) * kept.size());
    for (int y = 0; y < image.height; ++y) {
        const float* row = reader.next_row();
        for (std::size_t x = 0; x < width; ++x) {
            for (const std::size_t c : kept) image.values.push_back(row[x * all + c]);
        }
    }
    return image;
}

LinearPicture read_linear_picture(ImageReader& reader) {
    const ImageHeader& header = reader.header();
    const std::size_t channels = header.channels.size();
    LinearPicture picture{header.width, header.height, {}};
    picture.pixels.reserve(static_cast<std::size_t>(header.width) *
                           static_cast<std::size_t>(header.height));
    for (int y = 0; y < header.height; ++y) {
        const float* pixel = reader.next_row();
        for (int x = 0; x < header.width; ++x, pixel += channels) {
            std::array<float, 3> color{};
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = pixel[channels < 3 ? 0 : c];
                color[c] = header.srgb ? linear_from_srgb(value) : value;
            }
            picture.pixels.push_back(color);
        }
    }
    return picture;
}

float linear_from_srgb(float srgb) {
    const float x = std::clamp(srgb, 0.0F, 1.0F);
    return x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
}

}  // namespace pxm::host
