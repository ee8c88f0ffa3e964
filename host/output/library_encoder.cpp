// Pictures of all other formats, through OpenImageIO, and EXR through OpenEXR. Most writers ignore
// the result of a write: on a full disk the picture would lack its end. Those that take a place to
// write to get one that remembers the first write that failed; what the others wrote is read back
// and compared.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <optional>
#include <sstream>
#include <string_view>

#include "host/files/carried_text.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/encoder.hpp"
#include "host/output/pixel_values.hpp"
#include "host/output/row_bands.hpp"
#include "host/process/in_order.hpp"
#include "host/text/digest.hpp"

namespace pxm::host {

namespace {

bool holds_floats(const std::string& extension) { return extension == "exr" || extension == "hdr"; }

/// The library's message about `beside`, told of `path`.
std::string told_of(const std::string& path, const std::string& beside, std::string why) {
    const auto at = why.find(beside);
    return at == std::string::npos ? why : why.replace(at, beside.size(), path);
}

std::string time_text() {
    const std::tm time = file_time();
    char text[32];
    std::strftime(text, sizeof text, "%Y:%m:%d %H:%M:%S", &time);
    return text;
}

/// Gives the writer a place to write to, if it can be trusted with one. TIFF cannot: it reads what
/// it wrote, which its writer never does from such a place, and leaves out the picture's size.
bool takes_bytes(PictureOutput& output, FileBytes& bytes) {
    return output.format() != "tiff" && output.takes(bytes);
}

/// Why the picture in that file, of three channels of 8 bits, is not the one whose bytes were
/// written row by row; empty if it is.
std::string why_not_as_written(const std::string& path, const PixelSize& size, const Digest& rows) {
    const std::string damaged = "what was written cannot be read back: the disk may be full";
    const auto input = picture_library().open_own(path);
    if (!input) return damaged;
    const PictureSpec& spec = input->spec();
    if (spec.width != size.columns || spec.height != size.rows || spec.channel_count < 3)
        return damaged;
    std::vector<unsigned char> row(3 * static_cast<std::size_t>(size.columns));
    Digest found;
    for (int y = 0; y < size.rows; ++y) {
        if (!input->read_bytes(y, y + 1, 3, row.data())) return damaged;
        found.add_all(std::span<const unsigned char>(row));
    }
    // HEIF keeps pictures only nearly: there it is enough that all of it can be decoded.
    const bool exact = input->format() != "heif";
    return exact && found.value() != rows.value() ? damaged : "";
}

const std::string* find_metadata(const Metadata& metadata, const char* name) {
    const auto found = std::ranges::find(metadata, name, &Metadata::value_type::first);
    return found == metadata.end() ? nullptr : &found->second;
}

/// The file's channels of a list of their names.
std::vector<std::string> half_channels(const std::string& text, const std::vector<Aov>& aovs) {
    std::vector<std::string> channels;
    std::istringstream names(text);
    for (std::string name; std::getline(names, name, ',');) {
        if (name == half_color) channels.insert(channels.end(), {"R", "G", "B", "A"});
        for (const Aov aov : aovs) {
            if (name != aov_name(aov)) continue;
            for (const AovChannel& channel : channels_of(aov)) channels.push_back(channel.name);
        }
    }
    return channels;
}

class LibraryEncoder : public ImageWriter::Encoder {
  public:
    LibraryEncoder(const std::string& path, const CropWindow& window, const std::vector<Aov>& aovs,
                   const Metadata& metadata, const ExtraChannels* extra);

    void append(const Frame& part) override;
    void finish() override;

  private:
    [[nodiscard]] PictureSpec spec(const Metadata& metadata) const;
    [[nodiscard]] std::vector<std::string> names() const;
    void set_exr(const Metadata& metadata, PictureSpec& spec) const;
    void put(const Frame& part, std::span<const PixelRecord> pixels, unsigned char* to) const;
    void write(const RowBand& band);
    void require(bool done);

    std::string path_;
    CropWindow window_;
    PixelSize size_;
    bool is_exr_;
    bool floats_;
    FloatChannels channels_;
    const ExtraChannels* extra_;  // of an EXR, or null
    PartFile part_;
    std::unique_ptr<PictureOutput> output_;  // is gone before what it writes to
    std::optional<Digest> digest_;           // of a writer that opens the file itself
    RowBands bands_;
    InOrder<RowBand> rows_;
};

LibraryEncoder::LibraryEncoder(const std::string& path, const CropWindow& window,
                               const std::vector<Aov>& aovs, const Metadata& metadata,
                               const ExtraChannels* extra)
    : path_(path),
      window_(window),
      size_{window.x1 - window.x0, window.y1 - window.y0},
      is_exr_(extension_of(path) == "exr"),
      floats_(holds_floats(extension_of(path))),
      channels_{is_exr_, aovs},
      extra_(is_exr_ ? extra : nullptr),
      part_(path, Places::any),
      bands_(window, floats_ ? names().size() * sizeof(float) : 3) {
    std::string error;
    PictureLibrary& library = is_exr_ ? exr_library() : picture_library();
    output_ = library.create(part_.beside(), error);
    if (!output_) cannot_write(path, error);
    if (!takes_bytes(*output_, part_.file())) digest_.emplace();
    // Some formats hold the name: with a place to write to it need not be the part's.
    require(output_->open(digest_ ? part_.beside() : path, spec(metadata)));
}

PictureSpec LibraryEncoder::spec(const Metadata& metadata) const {
    PictureSpec spec;
    spec.width = size_.columns;
    spec.height = size_.rows;
    spec.channels = names();
    spec.floats = floats_;
    spec.color_space = floats_ ? "Linear" : "sRGB";
    spec.metadata = {{"DateTime", time_text()}, {"Software", software}};
    if (is_exr_) {
        set_exr(metadata, spec);
        spec.metadata.emplace_back("compression", "zip");
        // No colon in the names: to some readers what stands before it is a channel's.
        for (const auto& [name, value] : metadata) {
            if (name != carried_metadata) {
                spec.metadata.emplace_back("pxm_" + name, value);
                continue;
            }
            for (const auto& piece : exr_carried(value)) spec.metadata.push_back(piece);
        }
    }
    return spec;
}

std::vector<std::string> LibraryEncoder::names() const {
    std::vector<std::string> names = channels_.names();
    if (extra_ != nullptr) names.insert(names.end(), extra_->names.begin(), extra_->names.end());
    return names;
}

void LibraryEncoder::set_exr(const Metadata& metadata, PictureSpec& spec) const {
    if (const std::string* half = find_metadata(metadata, half_metadata))
        spec.half = half_channels(*half, channels_.aovs);
    if (const std::string* whole = find_metadata(metadata, whole_metadata)) {
        spec.x = window_.x0;
        spec.y = window_.y0;
        spec.whole_width = std::atol(whole->c_str());
        spec.whole_height = std::atol(whole->c_str() + whole->find('x') + 1);
    }
    if (extra_ == nullptr) return;
    for (const auto& entry : extra_->metadata) spec.metadata.push_back(entry);
}

/// The system's reason first: the library knows none, or nothing of it.
void LibraryEncoder::require(bool done) {
    part_.file().require();
    if (done) return;
    const std::string why = output_->error();
    if (why.find("std::bad_alloc") != std::string::npos) throw std::bad_alloc();
    cannot_write(path_, told_of(path_, part_.beside(), why));
}

void LibraryEncoder::append(const Frame& part) {
    const auto put_row = [&](std::span<const PixelRecord> pixels, unsigned char* to) {
        put(part, pixels, to);
    };
    bands_.add(part, put_row, [&](RowBand band) {
        const long index = band.index;
        rows_.add(index, std::move(band), [&](const RowBand& next) { write(next); });
    });
}

void LibraryEncoder::put(const Frame& part, std::span<const PixelRecord> pixels,
                         unsigned char* to) const {
    if (!floats_) return put_srgb_bytes(pixels, to);
    auto* values = reinterpret_cast<float*>(to);
    if (extra_ == nullptr) return put_floats(pixels, channels_, values);
    const std::size_t own = channels_.names().size(), all = own + extra_->names.size();
    for (const PixelRecord& pixel : pixels) {
        const long at = &pixel - part.pixels.data();
        put_floats(std::span(&pixel, 1), channels_, values);
        extra_->put(part.crop.x0 + at % part.columns(), part.crop.y0 + at / part.columns(),
                    values + own);
        values += all;
    }
}

void LibraryEncoder::write(const RowBand& band) {
    const auto first = static_cast<int>(band.first_row);
    const auto end = static_cast<int>(band.first_row + band.rows);
    if (floats_) {
        require(
            output_->write_floats(first, end, reinterpret_cast<const float*>(band.bytes.data())));
        return;
    }
    if (digest_) digest_->add_all(std::span<const unsigned char>(band.bytes));
    require(output_->write_bytes(first, end, band.bytes.data()));
}

void LibraryEncoder::finish() {
    require(output_->close());
    if (digest_) {
        const std::string why = why_not_as_written(part_.beside(), size_, *digest_);
        if (!why.empty()) cannot_write(path_, why);
    }
    part_.commit();
}

}  // namespace

std::unique_ptr<ImageWriter::Encoder> make_library_encoder(const std::string& path,
                                                           const CropWindow& window,
                                                           const std::vector<Aov>& aovs,
                                                           const Metadata& metadata,
                                                           const ExtraChannels* extra) {
    return std::make_unique<LibraryEncoder>(path, window, aovs, metadata, extra);
}

}  // namespace pxm::host
