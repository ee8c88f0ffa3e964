#include "host/process/granted_threads.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "host/text/number_text.hpp"

namespace pxm::host {

namespace {

/// The cores of the affinity mask; 0 if the system does not say. The mask of a large computer does
/// not fit in a cpu_set_t: the call fails until there is room.
int cores_of_mask() {
    constexpr int most_cores = 1 << 20;
    for (int room = 1024; room <= most_cores; room *= 2) {
        const std::unique_ptr<cpu_set_t, void (*)(cpu_set_t*)> mask(
            CPU_ALLOC(static_cast<std::size_t>(room)), [](cpu_set_t* set) { CPU_FREE(set); });
        const std::size_t bytes = CPU_ALLOC_SIZE(static_cast<std::size_t>(room));
        if (sched_getaffinity(0, bytes, mask.get()) == 0) return CPU_COUNT_S(bytes, mask.get());
        if (errno != EINVAL) return 0;
    }
    return 0;
}

ThreadChoice granted_cores() {
    const auto cores = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
    const int granted = cores_of_mask();
    if (granted <= 0 || granted == cores)
        return {std::max(1, cores),
                fmt::format("the computer has {} core{}", cores, cores == 1 ? "" : "s")};
    return {granted,
            fmt::format("the process may run on {} of the computer's {} cores", granted, cores)};
}

/// The first number of a variable that OpenMP reads: "4", or "4,2" for nested regions.
std::optional<int> openmp_number(const char* variable) {
    const char* text = std::getenv(variable);
    if (text == nullptr) return std::nullopt;
    std::string_view number(text);
    number = number.substr(0, number.find(','));
    while (number.starts_with(' ')) number.remove_prefix(1);
    while (number.ends_with(' ')) number.remove_suffix(1);
    const auto value = number_of_text<int>(number);
    return value && *value >= 1 ? value : std::nullopt;
}

}  // namespace

ThreadChoice granted_threads(const std::filesystem::path& root) {
    ThreadChoice choice = granted_cores();
    const auto limit = [&](int threads, const std::string& because) {
        if (threads < choice.threads) choice = {threads, because};
    };
    if (const auto quota = cpu_quota(root)) {
        const double whole = std::min(std::ceil(*quota), static_cast<double>(most_threads));
        limit(static_cast<int>(whole),
              fmt::format("the control group's CPU quota is {:.4g} cores", *quota));
    }
    for (const char* variable : {"OMP_NUM_THREADS", "OMP_THREAD_LIMIT"}) {
        if (const auto number = openmp_number(variable))
            limit(*number, fmt::format("{} is {}", variable, *number));
    }
    limit(most_threads, fmt::format("pxm starts no more than {}", most_threads));
    return choice;
}

ThreadChoice choose_threads(int asked) {
    if (asked > 0) return {asked, "it was asked for"};
    return granted_threads();
}

}  // namespace pxm::host
