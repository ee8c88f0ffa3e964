// What is known of a scene that is being written, without a picture of it.
#pragma once

#include <string>

#include "host/studio/asks.hpp"
#include "host/studio/asks_json.hpp"

namespace pxm::host {

/// JSON, all three. They throw Error for a scene that is wrong.
[[nodiscard]] std::string check_answer(const AskedCheck& asked);
[[nodiscard]] std::string inspect_answer(const AskedScene& asked);
/// The cell that a pixel shows.
[[nodiscard]] std::string pick_answer(const AskedPixel& asked, int threads);

}  // namespace pxm::host
