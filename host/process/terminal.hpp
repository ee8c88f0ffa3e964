// What the program says: results on the standard output, messages on the standard error. Nothing
// else writes to either. Results are checked to the last byte; messages are shown as far as they
// can be written. Text from files and their names may hold anything: no control character gets out.
#pragma once

#include <string_view>

namespace pxm::host {

/// Gives each of the descriptors 0 to 2 that is closed a place that takes and gives nothing, so
/// that no file of ours gets its number and the messages with it. To be called first.
void fill_standard_descriptors();

/// A part of the result, in UTF-8. Throws Error(ErrorKind::file) if it cannot be written; what is
/// still in a buffer is checked by finish_results().
void put_result(std::string_view text);
/// Writes what is still in the buffer. Throws Error(ErrorKind::file) unless all of the results were
/// taken.
void finish_results();

/// A message for the user. One that cannot be written is dropped silently: there is nobody to
/// tell.
void tell(std::string_view text) noexcept;

}  // namespace pxm::host
