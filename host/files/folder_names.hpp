// What lies in a folder, read in a way that can run out of memory: the iterators of the standard
// library's folders end the process then (g++ 12: a noexcept function of theirs allocates).
#pragma once

#include <string>
#include <system_error>
#include <vector>

namespace pxm::host {

/// The names, in no order, without `.` and `..`; as far as they could be read, if there was an
/// error.
[[nodiscard]] std::vector<std::string> names_in(const std::string& folder, std::error_code& error);

}  // namespace pxm::host
