#include "host/output/png.hpp"

#include <zlib.h>

#include <new>
#include <stdexcept>

namespace pxm::host {

namespace {

using Bytes = std::vector<unsigned char>;

constexpr int deflate_level = 1;
constexpr int raw_deflate = -15, most_memory = 9;  // of zlib: no header, a window of 32 kB
constexpr std::uint32_t gamma_of_srgb = 45'455;    // 1/2.2 in units of 10^-5, as PNG wants it
// Of sRGB's white, red, green and blue: x and y in units of 10^-5.
constexpr std::uint32_t chromaticities[] = {31'270, 32'900, 64'000, 33'000,
                                            30'000, 60'000, 15'000, 6'000};

void put(Bytes& to, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        to.push_back(static_cast<unsigned char>(value >> shift));
}

/// The rows with the filter Sub: each byte less that of the pixel to the left.
Bytes filtered(std::span<const unsigned char> rows, std::size_t row_bytes) {
    constexpr unsigned char sub = 1;
    constexpr std::size_t pixel = 3;
    Bytes all(rows.size() + rows.size() / row_bytes);
    unsigned char* to = all.data();
    for (std::size_t at = 0; at < rows.size(); at += row_bytes, to += row_bytes + 1) {
        const unsigned char* row = rows.data() + at;
        to[0] = sub;
        for (std::size_t i = 0; i < pixel; ++i) to[1 + i] = row[i];
        for (std::size_t i = pixel; i < row_bytes; ++i)
            to[1 + i] = static_cast<unsigned char>(row[i] - row[i - pixel]);
    }
    return all;
}

/// zlib's state of one deflation.
class Deflater {
  public:
    Deflater() {
        if (deflateInit2(&stream_, deflate_level, Z_DEFLATED, raw_deflate, most_memory,
                         Z_DEFAULT_STRATEGY) != Z_OK)
            throw std::bad_alloc();  // the settings are right
    }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;
    ~Deflater() { deflateEnd(&stream_); }

    /// Ends at a whole byte and not as a stream does, so that others can follow.
    Bytes deflate_whole(Bytes& data) {
        constexpr uLong room_of_flush = 16;
        Bytes out(deflateBound(&stream_, data.size()) + room_of_flush);
        stream_.next_in = data.data();
        stream_.avail_in = static_cast<uInt>(data.size());
        stream_.next_out = out.data();
        stream_.avail_out = static_cast<uInt>(out.size());
        const bool done = deflate(&stream_, Z_SYNC_FLUSH) == Z_OK && stream_.avail_in == 0 &&
                          stream_.avail_out > 0;
        if (!done) throw std::logic_error("zlib took more room than it had said");
        out.resize(stream_.total_out);
        return out;
    }

  private:
    z_stream stream_{};
};

}  // namespace

PngSegment deflate_rows(std::span<const unsigned char> rows, std::size_t row_bytes) {
    Bytes data = filtered(rows, row_bytes);
    PngSegment segment;
    segment.bytes = data.size();
    segment.checksum = static_cast<std::uint32_t>(
        adler32(adler32(0, nullptr, 0), data.data(), static_cast<uInt>(data.size())));
    segment.deflated = Deflater().deflate_whole(data);
    return segment;
}

PngFile::PngFile(CheckedFile& file, std::uint32_t columns, std::uint32_t rows,
                 const std::string& software, const std::tm& time)
    : file_(file), checksum_(static_cast<std::uint32_t>(adler32(0, nullptr, 0))) {
    constexpr unsigned char signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    file_.append(signature, sizeof signature);
    Bytes head;
    put(head, columns);
    put(head, rows);
    head.insert(head.end(), {8, 2, 0, 0, 0});  // bits, colour, deflate, filters, not interlaced
    chunk("IHDR", head);
    Bytes gamma;
    put(gamma, gamma_of_srgb);
    chunk("gAMA", gamma);
    Bytes colors;
    for (const std::uint32_t value : chromaticities) put(colors, value);
    chunk("cHRM", colors);
    chunk("sRGB", Bytes{0});
    const auto byte = [](int value) { return static_cast<unsigned char>(value); };
    const int year = time.tm_year + 1900;
    chunk("tIME", Bytes{byte(year >> 8), byte(year), byte(time.tm_mon + 1), byte(time.tm_mday),
                        byte(time.tm_hour), byte(time.tm_min), byte(time.tm_sec)});
    Bytes text;
    for (const char c : std::string("Software")) text.push_back(byte(c));
    text.push_back(0);
    for (const char c : software) text.push_back(byte(c));
    chunk("tEXt", text);
}

void PngFile::chunk(const char (&type)[5], std::span<const unsigned char> data) {
    Bytes head;
    put(head, static_cast<std::uint32_t>(data.size()));
    for (int i = 0; i < 4; ++i) head.push_back(static_cast<unsigned char>(type[i]));
    uLong crc = crc32(crc32(0, nullptr, 0), head.data() + 4, 4);
    if (!data.empty()) crc = crc32(crc, data.data(), static_cast<uInt>(data.size()));
    Bytes end;
    put(end, static_cast<std::uint32_t>(crc));
    file_.append(head.data(), head.size());
    if (!data.empty()) file_.append(data.data(), data.size());
    file_.append(end.data(), end.size());
}

void PngFile::text(std::string_view content) {
    chunk("iTXt", {reinterpret_cast<const unsigned char*>(content.data()), content.size()});
}

void PngFile::append(const PngSegment& segment) {
    // A stream of zlib begins with two bytes: a window of 32 kB, the fastest of its levels.
    if (!begun_) chunk("IDAT", Bytes{0x78, 0x01});
    begun_ = true;
    chunk("IDAT", segment.deflated);
    checksum_ = static_cast<std::uint32_t>(
        adler32_combine(checksum_, segment.checksum, static_cast<z_off_t>(segment.bytes)));
}

void PngFile::finish() {
    Bytes end{0x03, 0x00};  // an empty last block
    put(end, checksum_);
    chunk("IDAT", end);
    chunk("IEND", {});
}

}  // namespace pxm::host
