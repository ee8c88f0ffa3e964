// Numbers drawn from a seed: the same with every standard library, so that a seed names a scene.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

namespace pxm::test {

class Draw {
  public:
    explicit Draw(std::uint64_t seed) : random_(seed * 0x9E3779B97F4A7C15U + 1) {}

    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
    }
    /// 10^low to 10^high.
    double power(double low, double high) { return std::pow(10, between(low, high)); }
    /// 0 to n - 1.
    int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
    /// True once in n times.
    bool one_in(int n) { return below(n) == 0; }
    /// A point of the cube from -1 to 1.
    glm::dvec3 point() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
    glm::dvec3 direction() {
        glm::dvec3 d = point();
        while (glm::length(d) < 0.1 || glm::length(d) > 1) d = point();
        return glm::normalize(d);
    }
    /// A color.
    glm::dvec3 rgb() { return {between(0, 1), between(0, 1), between(0, 1)}; }

  private:
    std::mt19937_64 random_;
};

}  // namespace pxm::test
