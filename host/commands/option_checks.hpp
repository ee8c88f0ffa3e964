// What is checked of an option's text while the command line is read. Every option that is a
// number has one of the first five: CLI11's own reading of whole numbers takes 010 for 8 and 0x10
// for 16 (tests/host/commands/number_options_test.cpp walks all options).
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace pxm::host {

struct OptionCheck {
    /// Says what is wrong with the text, or puts its canonical form in its place and says nothing.
    std::function<std::string(std::string& text)> look;
    std::string range;  // stands in the help
};

/// For `transform`: a whole number of low..high, 0 <= low, in decimal digits. CLI11 is given its
/// canonical text, which it cannot misread.
[[nodiscard]] OptionCheck whole_number(std::uint64_t low, std::uint64_t high);
/// The same for every number that 64 bits hold.
[[nodiscard]] OptionCheck any_whole_number();
/// For `transform`: a finite number greater than 0.
[[nodiscard]] OptionCheck positive_number();
/// For `transform`: a number in 0..1.
[[nodiscard]] OptionCheck share();
/// For `transform`: a number in low..high.
[[nodiscard]] OptionCheck number_within(double low, double high);
/// For `check`: a text that is not empty, as "$FORGOTTEN" would be.
[[nodiscard]] OptionCheck some_text();

}  // namespace pxm::host
