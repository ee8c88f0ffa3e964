// Two numbers that a volume lies between.
#pragma once

namespace pxm::host {

struct VolumeBracket {
    double low = 0;
    double high = 0;
};

}  // namespace pxm::host
