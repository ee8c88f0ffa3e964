#include "host/wide/packet/registers.hpp"

#include <hwy/targets.h>

namespace pxm::host {

std::vector<std::string> register_sets() {
    std::vector<std::string> names;
    for (const auto target : hwy::SupportedAndGeneratedTargets())
        names.emplace_back(hwy::TargetName(target));
    return names;
}

}  // namespace pxm::host
