// What is checked of an option's text while CLI11 reads the command line. Every option that is a
// number has one of the first five: CLI11's own reading of whole numbers takes 010 for 8 and 0x10
// for 16 (tests/host/commands/number_options_test.cpp walks all options).
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace pxm::host {

/// For `transform`: a whole number of low..high, 0 <= low, in decimal digits. CLI11 is given its
/// canonical text, which it cannot misread.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);
/// The same for every number that 64 bits hold.
[[nodiscard]] CLI::Validator any_whole_number();
/// For `transform`: a finite number greater than 0.
[[nodiscard]] CLI::Validator positive_number();
/// For `transform`: a number in 0..1.
[[nodiscard]] CLI::Validator share();
/// For `transform`: a number in low..high.
[[nodiscard]] CLI::Validator number_within(double low, double high);
/// For `check`: a text that is not empty, as "$FORGOTTEN" would be.
[[nodiscard]] CLI::Validator some_text();

}  // namespace pxm::host
