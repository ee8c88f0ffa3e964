// Two numbers that a volume lies between.
#pragma once

namespace pxm::host {

struct VolumeBracket {  // the volume is between
    double low = 0;     // this
    double high = 0;    // and this
};

}  // namespace pxm::host
