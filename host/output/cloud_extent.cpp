#include "host/output/cloud_extent.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace pxm::host {

namespace {

constexpr double steps = 0x1p18;      // across an object
constexpr double spacing = 0x1p-23;   // of floats, relative: what lies one step further
constexpr double rounding = 0x1p-45;  // relative: smaller objects are points

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

bool floats_keep(const CloudExtent& extent) {
    using Float = std::numeric_limits<float>;
    const double far = extent.farthest();
    if (far == 0) return true;
    if (!(far <= Float::max()) || far < Float::min() * steps) return false;
    return extent.size() < rounding * far || extent.size() >= steps * spacing * far;
}

}  // namespace

void CloudExtent::add(const glm::dvec3& point) {
    low_ = empty_ ? point : glm::min(low_, point);
    high_ = empty_ ? point : glm::max(high_, point);
    empty_ = false;
}

void CloudExtent::add(const CloudExtent& other) {
    if (other.empty_) return;
    add(other.low_);
    add(other.high_);
}

double CloudExtent::size() const { return largest(high_ - low_); }

double CloudExtent::farthest() const { return largest(glm::max(glm::abs(low_), glm::abs(high_))); }

glm::dvec3 CloudExtent::offset() const {
    const glm::dvec3 middle = low_ + (high_ - low_) / 2.0;
    if (!(size() > 0)) return middle;
    const double step = std::exp2(std::floor(std::log2(size())));
    return glm::round(middle / step) * step;
}

CloudExtent CloudExtent::without(const glm::dvec3& offset) const {
    CloudExtent moved = *this;
    moved.low_ -= offset;
    moved.high_ -= offset;
    return moved;
}

CoordinateNumber number_for(const std::vector<CloudExtent>& objects) {
    CloudExtent all;
    for (const CloudExtent& object : objects) all.add(object);
    const bool keep = floats_keep(all) && std::ranges::all_of(objects, floats_keep);
    return keep ? CoordinateNumber::single : CoordinateNumber::double_;
}

}  // namespace pxm::host
