#include "host/output/cryptomatte.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "host/text/json_text.hpp"

namespace pxm::host {

namespace {

// The constants of MurmurHash3_x86_32.
constexpr std::uint32_t factor_1 = 0xcc9e2d51, factor_2 = 0x1b873593;
constexpr std::uint32_t mix_1 = 0x85ebca6b, mix_2 = 0xc2b2ae35;

constexpr unsigned exponent_shift = 23;  // of a float's bits

std::uint32_t scrambled(std::uint32_t block) { return std::rotl(block * factor_1, 15) * factor_2; }

}  // namespace

std::uint32_t murmur3(std::string_view bytes) {
    std::uint32_t hash = 0;
    const auto block = [&](std::size_t at, std::size_t count) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < count; ++i)
            value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << 8 * i;
        return value;
    };
    const std::size_t whole = bytes.size() / 4 * 4;
    for (std::size_t at = 0; at < whole; at += 4)
        hash = std::rotl(hash ^ scrambled(block(at, 4)), 13) * 5 + 0xe6546b64;
    if (whole < bytes.size()) hash ^= scrambled(block(whole, bytes.size() - whole));
    hash ^= static_cast<std::uint32_t>(bytes.size());
    hash = (hash ^ hash >> 16U) * mix_1;
    hash = (hash ^ hash >> 13U) * mix_2;
    return hash ^ hash >> 16U;
}

// An exponent of all zeros or all ones would be a denormal, an infinity or no number: programs on
// the way may change these.
std::uint32_t matte_hash(std::string_view name) {
    const std::uint32_t hash = murmur3(name);
    const std::uint32_t exponent = hash >> exponent_shift & 255U;
    return exponent == 0 || exponent == 255 ? hash ^ std::uint32_t{1} << exponent_shift : hash;
}

MatteShares::MatteShares(const CropWindow& window)
    : window_(window),
      shares_(static_cast<std::size_t>((window.x1 - window.x0) * (window.y1 - window.y0)) *
              matte_ranks) {}

std::size_t MatteShares::place(long x, long y) const {
    const long pixel = (y - window_.y0) * (window_.x1 - window_.x0) + x - window_.x0;
    return static_cast<std::size_t>(pixel) * matte_ranks;
}

void MatteShares::add(long x, long y, std::size_t name, float share) {
    if (!(share > 0)) return;
    const std::size_t begin = place(x, y);
    for (std::size_t i = begin; i < begin + matte_ranks; ++i) {
        Share& one = shares_[i];
        if (one.share > 0 && one.name != name) continue;
        one.name = static_cast<std::uint16_t>(name);
        one.share += share;
        return;
    }
}

std::vector<MatteShares::Share> MatteShares::of(long x, long y) const {
    const auto begin = shares_.begin() + static_cast<std::ptrdiff_t>(place(x, y));
    std::vector<Share> shares(begin, begin + matte_ranks);
    std::ranges::sort(shares, [](const Share& a, const Share& b) {
        return a.share != b.share ? a.share > b.share : a.name < b.name;
    });
    return shares;
}

std::vector<std::string> MatteLayer::channels() const {
    std::vector<std::string> list;
    for (int i = 0; i < matte_ranks / 2; ++i)
        for (const char channel : std::string_view("RGBA"))
            list.push_back(fmt::format("{}{:02}.{}", name, i, channel));
    return list;
}

Metadata MatteLayer::metadata() const {
    const std::string start =
        fmt::format("cryptomatte/{}/", fmt::format("{:08x}", murmur3(name)).substr(0, 7));
    nlohmann::ordered_json manifest = nlohmann::ordered_json::object();
    for (const std::string& one : names) manifest[one] = fmt::format("{:08x}", matte_hash(one));
    return {{start + "name", name},
            {start + "hash", "MurmurHash3_32"},
            {start + "conversion", "uint32_to_float32"},
            {start + "manifest", json_text(manifest)}};
}

void MatteLayer::put(long x, long y, float* to) const {
    for (const MatteShares::Share& share : shares.of(x, y)) {
        *to++ = share.share > 0 ? std::bit_cast<float>(matte_hash(names[share.name])) : 0;
        *to++ = share.share;
    }
}

}  // namespace pxm::host
