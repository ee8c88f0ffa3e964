// JSON as text that anything can read and nothing stumbles over: plain ASCII, with all else as \u
// escapes. A file's name may be no UTF-8: what is none of it becomes U+FFFD.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace pxm::host {

/// `indent` as nlohmann has it: -1 is all on one line.
[[nodiscard]] inline std::string json_text(const nlohmann::ordered_json& json, int indent = -1) {
    return json.dump(indent, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace pxm::host
