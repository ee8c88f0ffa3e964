// Writes words of the scene block in a node's format.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "host/math/affine.hpp"
#include "pxm/real.hpp"

namespace pxm::host {

/// Grows a block record by record and fills fields in by address.
template <class Real>
class BlockWriter {
  public:
    /// Room for so many words; returns their address.
    std::uint32_t grow(std::size_t words) {
        const auto address = static_cast<std::uint32_t>(words_.size());
        words_.insert(words_.end(), words, 0U);
        return address;
    }
    void integer(std::uint32_t address, std::uint32_t value) { words_[address] = value; }
    void number(std::uint32_t address, Real value) {
        for (const std::uint32_t word : encode(value)) words_[address++] = word;
    }
    void real(std::uint32_t address, double value) { number(address, from_double<Real>(value)); }
    void vector(std::uint32_t address, const glm::dvec3& v) {
        for (int i = 0; i < 3; ++i) real(address + static_cast<std::uint32_t>(i) * step, v[i]);
    }
    void vector(std::uint32_t address, const glm::dvec2& v) {
        real(address, v.x);
        real(address + step, v.y);
    }
    void linear(std::uint32_t address, const glm::dmat3& m) {
        for (int i = 0; i < 3; ++i)
            vector(address + static_cast<std::uint32_t>(3 * i) * step, m[i]);
    }
    void affine(std::uint32_t address, const Affine& map) {
        linear(address, map.linear);
        vector(address + 9 * step, map.translation);
    }
    std::vector<std::uint32_t> take() { return std::move(words_); }

  private:
    static constexpr std::uint32_t step = real_words<Real>;
    std::vector<std::uint32_t> words_;
};

}  // namespace pxm::host
