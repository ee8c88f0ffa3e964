#include "host/text/number_runs.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace pxm::host {

std::string number_runs(const std::set<long>& numbers) {
    constexpr std::size_t most_named = 20;
    std::string text;
    std::size_t named = 0;
    for (auto at = numbers.begin(); at != numbers.end(); ++named) {
        if (named == most_named) return text + ", ...";
        const long first = *at;
        long last = first;
        while (++at != numbers.end() && *at == last + 1) ++last;
        text += (text.empty() ? "" : ", ") +
                (last == first ? fmt::format("{}", first) : fmt::format("{}-{}", first, last));
    }
    return text;
}

}  // namespace pxm::host
