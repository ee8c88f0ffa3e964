// What is wrong in the source of a program, and where: plain data, for the host to print.
#pragma once

#include <string>
#include <vector>

namespace pxm::dsp32::assembler {

struct Place {       // a place in a source
    int line = 1;    // from 1
    int column = 1;  // in bytes, from 1
};

struct Mistake {          // what is wrong with a source
    Place place;          // where
    std::string message;  // what, without the place
};

/// Mistakes beyond this many are not collected.
inline constexpr std::size_t mistake_limit = 20;

/// The mistakes of a source, in the order in which they were found.
class Mistakes {
  public:
    /// Another one, unless there are enough.
    void add(Place place, std::string message) {
        if (!full()) list_.push_back({place, std::move(message)});
    }
    [[nodiscard]] bool full() const { return list_.size() >= mistake_limit; }  // there are enough
    [[nodiscard]] std::size_t count() const { return list_.size(); }           // how many there are
    [[nodiscard]] const std::vector<Mistake>& list() const { return list_; }   // all of them

  private:
    std::vector<Mistake> list_;
};

}  // namespace pxm::dsp32::assembler
