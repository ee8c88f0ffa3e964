// Cryptomatte, ids of what a pixel shows for compositing programs: per pixel the hashes of names
// and how much of it each covers, the largest share first, in channels of floats; and the names in
// the metadata ([Cryptomatte], docs/pictures.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/files/picture_library.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// MurmurHash3_x86_32 of the bytes, with the seed 0.
[[nodiscard]] std::uint32_t murmur3(std::string_view bytes);

/// The hash of a name as it stands in a channel: bits that are a finite float, and no denormal.
[[nodiscard]] std::uint32_t matte_hash(std::string_view name);

inline constexpr int matte_ranks = 6;  // names of a pixel that are kept
inline constexpr std::size_t matte_names = 65'535;

/// Shares of the pixels of a window. Different pixels may be changed by different threads.
class MatteShares {
  public:
    explicit MatteShares(const CropWindow& window);

    /// Adds to the share of a name, by its number, in a pixel; a seventh name of it is left out.
    void add(long x, long y, std::size_t name, float share);
    struct Share {
        std::uint16_t name = 0;
        float share = 0;
    };
    /// The largest first; those without a share last. Equal ones in the order of their names.
    [[nodiscard]] std::vector<Share> of(long x, long y) const;

  private:
    [[nodiscard]] std::size_t place(long x, long y) const;

    CropWindow window_;
    std::vector<Share> shares_;
};

/// A set of names, and where they are.
struct MatteLayer {
    std::string name;                // CryptoObject
    std::vector<std::string> names;  // all different
    MatteShares shares;

    /// CryptoObject00.R and so on: two ranks of four channels.
    [[nodiscard]] std::vector<std::string> channels() const;
    /// Name, hash, conversion and manifest.
    [[nodiscard]] Metadata metadata() const;
    /// The values of the channels in a pixel.
    void put(long x, long y, float* to) const;
};

}  // namespace pxm::host
