// What is wrong in the source of a program, and where: plain data, for the host to print.
#pragma once

#include <string>
#include <vector>

namespace pxm::dsp32::assembler {

struct Place {
    int line = 1;    // from 1
    int column = 1;  // in bytes, from 1
};

struct Mistake {
    Place place;
    std::string message;
};

/// Mistakes beyond this many are not collected.
inline constexpr std::size_t mistake_limit = 20;

/// The mistakes of a source, in the order in which they were found.
class Mistakes {
  public:
    void add(Place place, std::string message) {
        if (!full()) list_.push_back({place, std::move(message)});
    }
    [[nodiscard]] bool full() const { return list_.size() >= mistake_limit; }
    [[nodiscard]] std::size_t count() const { return list_.size(); }
    [[nodiscard]] const std::vector<Mistake>& list() const { return list_; }

  private:
    std::vector<Mistake> list_;
};

}  // namespace pxm::dsp32::assembler
