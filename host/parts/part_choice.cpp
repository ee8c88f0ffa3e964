#include "host/parts/part_choice.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "host/error.hpp"
#include "host/text/number_text.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

/// How a launcher numbers the tasks that it starts, from 0.
struct Ranks {
    const char* rank;
    const char* size;
};
// The nearest launcher first: mpirun in a Slurm job leaves Slurm's variables of its own start in
// the environment, and these number the computers. SLURM_NTASKS would not do, as the script of a
// job has it too, once for all of its tasks.
constexpr Ranks all_ranks[] = {
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},  // Open MPI
    {"PMI_RANK", "PMI_SIZE"},                          // MPICH and others with Hydra; PMI
    {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"},          // srun
};

[[noreturn]] void refuse(const std::string& why) {
    throw Error(ErrorKind::setting, "--part " + why);
}

std::optional<long> number_in(const Environment& environment, const char* name) {
    const char* text = environment(name);
    if (text == nullptr || *text == '\0') return std::nullopt;
    const auto number = number_of_text<long>(text);
    if (!number || *number < 0 || *number > most_parts)
        refuse(fmt::format("auto: {} is \"{}\", no number", name, printable(text)));
    return number;
}

/// The place of a task among those of an array, whose numbers may begin and step as one likes.
std::optional<PartChoice> part_of_array(const Environment& environment) {
    const auto id = number_in(environment, "SLURM_ARRAY_TASK_ID");
    if (!id) return std::nullopt;
    const auto count = number_in(environment, "SLURM_ARRAY_TASK_COUNT");
    const auto first = number_in(environment, "SLURM_ARRAY_TASK_MIN");
    const auto last = number_in(environment, "SLURM_ARRAY_TASK_MAX");
    if (!count || !first || !last)
        refuse("auto: SLURM_ARRAY_TASK_ID is there, but not _COUNT, _MIN and _MAX");
    const long step = *count > 1 ? (*last - *first) / (*count - 1) : 1;
    const bool regular = step > 0 && *first + step * (*count - 1) == *last && *id >= *first &&
                         *id <= *last && (*id - *first) % step == 0;
    if (!regular) {
        refuse(
            fmt::format("auto: the numbers of the array, {} of them from {} to {}, do not go "
                        "by steps: say --part $SLURM_ARRAY_TASK_ID/N",
                        *count, *first, *last));
    }
    return PartChoice{(*id - *first) / step + 1, *count};
}

std::optional<PartChoice> part_of_rank(const Environment& environment) {
    for (const Ranks& ranks : all_ranks) {
        const auto rank = number_in(environment, ranks.rank);
        const auto size = number_in(environment, ranks.size);
        if (!rank || !size) continue;
        if (*rank >= *size)
            refuse(
                fmt::format("auto: {} is {}, and {} is {}", ranks.rank, *rank, ranks.size, *size));
        return PartChoice{*rank + 1, *size};
    }
    return std::nullopt;
}

PartChoice part_of_launcher(const Environment& environment) {
    const auto array = part_of_array(environment);
    const auto rank = part_of_rank(environment);
    if (!array && !rank) {
        refuse(
            "auto: no launcher says which: neither SLURM_ARRAY_TASK_ID nor "
            "OMPI_COMM_WORLD_RANK, PMI_RANK or SLURM_PROCID with its size is there");
    }
    // Each task of an array may start several.
    const PartChoice outer = array.value_or(PartChoice{}), inner = rank.value_or(PartChoice{});
    const PartChoice both{(outer.part - 1) * inner.parts + inner.part, outer.parts * inner.parts};
    if (both.parts > most_parts) refuse(fmt::format("auto: {} are too many", both.parts));
    return both;
}

}  // namespace

long choose_count(const std::string& text) {
    constexpr std::string_view any = "any/";
    const auto parts = text.starts_with(any)
                           ? number_of_text<long>(std::string_view(text).substr(any.size()))
                           : std::nullopt;
    if (!parts || *parts < 1 || *parts > most_parts) {
        throw Error(ErrorKind::setting,
                    fmt::format("--part: found \"{}\", expected any/N with 1 <= N <= {} (--claim)",
                                printable(text), most_parts));
    }
    return *parts;
}

PartChoice choose_part(const std::string& text, const Environment& environment) {
    if (text == "auto") return part_of_launcher(environment);
    const auto slash = text.find('/');
    const std::string_view all = text;
    const auto part = number_of_text<long>(all.substr(0, slash));
    const auto parts =
        slash == std::string::npos ? std::nullopt : number_of_text<long>(all.substr(slash + 1));
    if (!part || !parts || *part < 1 || *part > *parts || *parts > most_parts) {
        throw Error(
            ErrorKind::setting,
            fmt::format("--part: found \"{}\", expected I/N with 1 <= I <= N <= {}, or auto",
                        printable(text), most_parts));
    }
    return {*part, *parts};
}

}  // namespace pxm::host
