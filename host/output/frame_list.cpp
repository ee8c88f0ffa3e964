#include "host/output/frame_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "host/error.hpp"
#include "host/text/number_text.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
    throw Error(ErrorKind::setting, fmt::format("--frames {}: {}", printable(text, 100), why));
}

constexpr const char* form = "expected frames as 0-599, 0-599:10 or 3,7,20-30";

long frame_of(const std::string& all, const std::string& text) {
    const std::optional<long> frame = number_of_text<long>(text);
    if (!frame || *frame < 0) refuse(all, form);
    return *frame;
}

struct Range {
    long first;
    long last;
    long step;
};

Range range_of(const std::string& all, const std::string& text) {
    const std::size_t dash = text.find('-'), colon = text.find(':');
    if (dash == std::string::npos) {
        const long one = frame_of(all, text);
        return {one, one, 1};
    }
    const std::size_t end = std::min(colon, text.size());
    if (end < dash) refuse(all, form);
    const Range range{frame_of(all, text.substr(0, dash)),
                      frame_of(all, text.substr(dash + 1, end - dash - 1)),
                      colon == std::string::npos ? 1 : frame_of(all, text.substr(colon + 1))};
    if (range.step < 1) refuse(all, "a step is 1 or more");
    if (range.last < range.first)
        refuse(all, fmt::format("{}-{} runs backwards", range.first, range.last));
    return range;
}

/// Where a number's place begins and ends, and how many digits it has at least.
struct NumberPlace {
    std::size_t begin;
    std::size_t end;
    int digits;
};

std::vector<NumberPlace> number_places(const std::string& path) {
    std::vector<NumberPlace> places;
    for (std::size_t at = path.find('%'); at != std::string::npos; at = path.find('%', at)) {
        std::size_t end = at + 1;
        if (end < path.size() && path[end] == '%') {
            at += 2;
            continue;
        }
        while (end < path.size() && path[end] >= '0' && path[end] <= '9') ++end;
        const std::string digits = path.substr(at + 1, end - at - 1);
        const bool number = end < path.size() && path[end] == 'd' && digits.size() <= 2 &&
                            (digits.empty() || digits[0] == '0');
        if (!number)
            throw Error(
                ErrorKind::setting,
                fmt::format("{}: after a % comes the frame's number, %d or %04d, or another %",
                            printable_path(path)));
        places.push_back({at, end + 1, number_of_text<int>("0" + digits).value_or(0)});
        at = end + 1;
    }
    return places;
}

}  // namespace

std::vector<long> frames_of(const std::string& text, long frames) {
    std::vector<long> list;
    std::set<long> seen;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const Range range = range_of(text, text.substr(at, comma - at));
        if (range.last >= frames)
            refuse(text, fmt::format("the animation has the frames 0 to {}", frames - 1));
        for (long frame = range.first;; frame += range.step) {
            if (!seen.insert(frame).second) refuse(text, fmt::format("{} is said twice", frame));
            list.push_back(frame);
            if (range.step > range.last - frame) break;  // the next may be beyond all numbers
        }
        at = comma + 1;
    }
    return list;
}

bool has_frame_number(const std::string& path) {
    const std::vector<NumberPlace> places = number_places(path);
    if (places.size() > 1)
        throw Error(ErrorKind::setting,
                    fmt::format("{}: the frame's number has several places", printable_path(path)));
    return !places.empty();
}

std::string path_of_frame(const std::string& path, long frame) {
    std::string result;
    std::size_t from = 0;
    const auto plain = [&](std::size_t end) {
        for (; from < end; ++from) {
            result += path[from];
            if (path[from] == '%') ++from;  // of two one is left
        }
    };
    for (const NumberPlace& place : number_places(path)) {
        plain(place.begin);
        result += fmt::format("{:0{}}", frame, place.digits);
        from = place.end;
    }
    plain(path.size());
    return result;
}

}  // namespace pxm::host
