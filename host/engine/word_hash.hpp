// A 24-bit hash of a cell's word: what images tell cells apart by.
#pragma once

#include <cstdint>
#include <vector>

namespace pxm::host {

/// FNV-1a over the bytes of a symbol and one that ends it.
[[nodiscard]] inline std::uint32_t hash_symbol(std::uint32_t hash, std::uint32_t symbol) {
    for (++symbol; symbol != 0; symbol >>= 8) hash = (hash ^ (symbol & 0xFF)) * 0x0100'0193;
    return (hash ^ 0xFF) * 0x0100'0193;
}

/// The unfinished hash of a word.
[[nodiscard]] inline std::uint32_t hash_symbols(const std::vector<int>& word) {
    std::uint32_t hash = 0x811C'9DC5;
    for (const int symbol : word) hash = hash_symbol(hash, static_cast<std::uint32_t>(symbol));
    return hash;
}

/// A finished hash: 24 bits, exact in a float channel, and never 0.
[[nodiscard]] inline std::uint32_t finished_hash(std::uint32_t hash) {
    const std::uint32_t folded = (hash >> 24 ^ hash) & 0x00FF'FFFF;
    return folded == 0 ? 1 : folded;
}

}  // namespace pxm::host
