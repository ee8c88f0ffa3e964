// A memory bank of a pixel node: so many bytes, and nothing beyond them.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace pxm {

/// A bank with a capacity that is enforced and a high-water mark. Host memory is taken only as
/// used.
class Bank {
  public:
    /// An empty bank; `name` must outlive it.
    Bank(std::string_view name, std::int64_t limit_bytes)
        : name_(name), limit_bytes_(limit_bytes) {}

    [[nodiscard]] std::string_view name() const noexcept { return name_; }  // as faults call it
    /// No more can be reserved.
    [[nodiscard]] std::int64_t limit_bytes() const noexcept { return limit_bytes_; }
    /// The largest size reserved so far.
    [[nodiscard]] std::int64_t used_bytes() const noexcept { return used_bytes_; }

    /// Makes the first `bytes` bytes of the bank usable; false if the bank is smaller than that.
    [[nodiscard]] bool reserve(std::int64_t bytes) {
        if (bytes > limit_bytes_) return false;
        used_bytes_ = std::max(used_bytes_, bytes);
        bytes_.resize(static_cast<std::size_t>(used_bytes_));
        return true;
    }

    /// The reserved part as 32-bit words.
    [[nodiscard]] std::span<std::uint32_t> words() noexcept {
        return {reinterpret_cast<std::uint32_t*>(bytes_.data()),
                static_cast<std::size_t>(used_bytes_) / sizeof(std::uint32_t)};
    }

    /// Records of one trivially copyable type laid over the reserved part, from `offset_bytes` on.
    template <class Record>
    [[nodiscard]] Record* records(std::int64_t offset_bytes) noexcept {
        static_assert(std::is_trivially_copyable_v<Record> && alignof(Record) <= 8);
        assert(offset_bytes % static_cast<std::int64_t>(alignof(Record)) == 0);
        return reinterpret_cast<Record*>(bytes_.data() + offset_bytes);
    }

  private:
    std::string_view name_;
    std::int64_t limit_bytes_;
    std::int64_t used_bytes_ = 0;
    std::vector<std::byte> bytes_;  // from operator new: aligned for any record
};

}  // namespace pxm
