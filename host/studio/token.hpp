// Secrets that only one studio and its page know.
#pragma once

#include <string>
#include <string_view>

namespace pxm::host {

/// 128 random bits of the system as 32 hexadecimal digits. Throws Error(ErrorKind::failed).
[[nodiscard]] std::string random_token();

/// Whether they are equal, in a time that does not depend on where they differ.
[[nodiscard]] bool same_token(std::string_view a, std::string_view b) noexcept;

}  // namespace pxm::host
