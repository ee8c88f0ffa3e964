#include <nlohmann/json.hpp>

#include "host/inspect/render_needs.hpp"
#include "host/text/json_text.hpp"

namespace pxm::host {

std::string render_needs_json(const RenderNeeds& needs) {
    const nlohmann::ordered_json json = {{"scene", needs.scene},
                                         {"size", {needs.size.columns, needs.size.rows}},
                                         {"cpu_seconds", needs.cpu_seconds},
                                         {"seconds", needs.seconds},
                                         {"threads", needs.threads},
                                         {"bytes", needs.bytes},
                                         {"trial_pixels", needs.trial_pixels}};
    return json_text(json) + "\n";
}

}  // namespace pxm::host
