// Texts in plots and pages.
#pragma once

#include <string>

namespace pxm::host {

/// A number for people: 12,345, 0.9731, 1.2e-07.
[[nodiscard]] std::string number_text(double value);
/// Text for HTML, attributes included.
[[nodiscard]] std::string escaped(const std::string& text);

}  // namespace pxm::host
