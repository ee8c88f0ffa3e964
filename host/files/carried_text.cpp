#include "host/files/carried_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "host/error.hpp"
#include "host/files/deflated.hpp"
#include "host/files/exr_header.hpp"
#include "host/files/image_format.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

using namespace std::string_view_literals;

// Compressed, by zlib, in no language, without a translation of the keyword.
constexpr std::string_view png_head = "pxm_source\0\1\0\0\0"sv;
constexpr std::size_t chunk_head_bytes = 8, chunk_end_bytes = 4, png_signature_bytes = 8;
constexpr long most_chunks = 4'000'000;  // of 64 bytes and more: a picture of many gigabytes
// zlib makes no stream longer than this of what is allowed, and base64 four letters of three bytes.
constexpr std::size_t stream_bytes = carried_bytes + carried_bytes / 256 + 64;
constexpr std::size_t letters = (stream_bytes + 2) / 3 * 4;

constexpr std::size_t piece_letters = 252;  // of a string attribute: at most 255

constexpr std::string_view alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

[[noreturn]] void refuse(const RegularFile& picture, const std::string& why) {
    throw Error(ErrorKind::scene, fmt::format("{}: the scene that it carries {}",
                                              printable_path(picture.path()), why));
}

std::string base64(std::string_view bytes) {
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t three = 0;
        const std::size_t there = std::min<std::size_t>(3, bytes.size() - at);
        for (std::size_t i = 0; i < 3; ++i)
            three = three << 8U | (i < there ? static_cast<unsigned char>(bytes[at + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            text += i <= there ? alphabet[three >> (18 - 6 * i) & 63U] : '=';
    }
    return text;
}

std::optional<std::string> bytes_of_base64(std::string_view text) {
    if (text.size() % 4 != 0) return std::nullopt;
    std::string bytes;
    for (std::size_t at = 0; at < text.size(); at += 4) {
        std::uint32_t three = 0;
        std::size_t there = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const char letter = text[at + i];
            const std::size_t value = alphabet.find(letter);
            const bool is_filler = letter == '=' && at + 4 == text.size() && i >= 2;
            if (value == std::string_view::npos && !is_filler) return std::nullopt;
            if (!is_filler && there != i) return std::nullopt;  // a letter after a filler
            if (!is_filler) ++there;
            three = three << 6U | static_cast<std::uint32_t>(is_filler ? 0 : value);
        }
        for (std::size_t i = 0; i + 1 < there; ++i)
            bytes += static_cast<char>(three >> (16 - 8 * i) & 255U);
    }
    return bytes;
}

std::string text_of_stream(const RegularFile& picture, std::string_view stream) {
    auto text = inflated(stream, carried_bytes);
    if (!text) refuse(picture, fmt::format("is broken or larger than {} bytes", carried_bytes));
    return *std::move(text);
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char c : bytes.substr(0, 4)) value = value << 8U | static_cast<unsigned char>(c);
    return value;
}

/// The text's chunk stands before the pixels in what pxm writes; a program that went through the
/// file may have put it behind them.
std::optional<std::string> in_png(const RegularFile& png) {
    std::uint64_t at = png_signature_bytes;
    for (long chunks = 0; chunks < most_chunks; ++chunks) {
        const std::string head = png.read(at, chunk_head_bytes + png_head.size());
        if (head.size() < chunk_head_bytes) return std::nullopt;
        const std::uint32_t bytes = big_endian(head);
        const std::string_view type = std::string_view(head).substr(4, 4);
        if (type == "IEND") return std::nullopt;
        const std::string_view data = std::string_view(head).substr(chunk_head_bytes);
        if (type == "iTXt" && data.starts_with(png_head.substr(0, sizeof carried_name))) {
            if (bytes < png_head.size() || data != png_head)
                refuse(png, "is not compressed as pxm does it");
            const std::size_t size = bytes - png_head.size();
            if (size > stream_bytes)
                refuse(png, fmt::format("is larger than {} bytes", carried_bytes));
            const std::string stream = png.read(at + chunk_head_bytes + png_head.size(), size);
            return text_of_stream(png, stream);
        }
        at += chunk_head_bytes + std::uint64_t{bytes} + chunk_end_bytes;
    }
    return std::nullopt;
}

std::optional<std::string> in_exr(const RegularFile& exr) {
    const ExrText found = exr_text(exr, carried_name, letters);
    if (!found.there) return std::nullopt;
    if (!found.text) refuse(exr, fmt::format("is no text, or larger than {} bytes", carried_bytes));
    const auto stream = bytes_of_base64(*found.text);
    if (!stream) refuse(exr, "is not written as pxm does it");
    return text_of_stream(exr, *stream);
}

}  // namespace

std::string png_carried(std::string_view text) { return std::string(png_head) + deflated(text); }

std::vector<std::pair<std::string, std::string>> exr_carried(std::string_view text) {
    const std::string all = base64(deflated(text));
    std::vector<std::pair<std::string, std::string>> pieces;
    for (std::size_t at = 0; at < all.size(); at += piece_letters)
        pieces.emplace_back(fmt::format("{}_{:04}", carried_name, pieces.size() + 1),
                            all.substr(at, piece_letters));
    return pieces;
}

std::optional<std::string> carried_text(const RegularFile& picture) {
    const auto format = found_format(picture.read(0, image_head_bytes)).format;
    if (format == ImageFormat::png) return in_png(picture);
    if (format == ImageFormat::openexr) return in_exr(picture);
    return std::nullopt;
}

}  // namespace pxm::host
