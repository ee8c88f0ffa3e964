#include "host/study/grade.hpp"

#include <algorithm>

namespace pxm::host {

std::vector<char> wrong_pixels(const Deviation& deviation, const RenderResult& reference) {
    std::vector<char> wrong = deviation.wrong;
    for (std::size_t i = 0; i < wrong.size(); ++i)
        if (reference.frame.pixels[i].alarms & alarm_capped) wrong[i] = 1;
    return wrong;
}

double share_of(const std::vector<char>& marks) {
    return static_cast<double>(std::ranges::count(marks, 1)) /
           static_cast<double>(std::max<std::size_t>(1, marks.size()));
}

double missed_share(const RenderResult& picture, std::vector<char> wrong) {
    for (std::size_t i = 0; i < wrong.size(); ++i)
        if (picture.frame.pixels[i].alarms != 0) wrong[i] = 0;
    return share_of(wrong);
}

AlarmedPixels alarmed_pixels(const RenderResult& picture, const std::vector<char>& wrong,
                             PixelAlarm alarm) {
    AlarmedPixels alarmed;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        if ((picture.frame.pixels[i].alarms & alarm) == 0) continue;
        ++alarmed.pixels;
        if (wrong[i] != 0) ++alarmed.wrong;
    }
    return alarmed;
}

const char* grade_of(double wrong_share, bool alarmed) {
    if (wrong_share <= right_share) return "right";
    if (wrong_share <= degraded_share) return "degraded";
    return alarmed ? "reported" : "silent";
}

}  // namespace pxm::host
