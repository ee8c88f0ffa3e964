// The user's browser, where there is a screen to show it on.
#pragma once

#include <string>

namespace pxm::host {

/// Asks the desktop to open the address. False if there is none, or nothing that opens addresses.
[[nodiscard]] bool open_in_browser(const std::string& address);

}  // namespace pxm::host
