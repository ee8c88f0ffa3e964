// Laws of --part: what is told, and what a launcher says in the environment (docs/cluster.md).
#include "host/parts/part_choice.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/error.hpp"
#include "host/parts/part_run.hpp"

namespace pxm::host {
namespace {

using Variables = std::map<std::string, std::string>;

PartChoice chosen(const std::string& text, const Variables& variables = {}) {
    return choose_part(text, [&](const char* name) -> const char* {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    });
}

std::string refusal(const std::string& text, const Variables& variables = {}) {
    try {
        (void)chosen(text, variables);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::setting);
        return error.what();
    }
    return "(nothing was thrown)";
}

struct Case {
    Variables variables;
    long part;
    long parts;
};

void expect_parts(const std::vector<Case>& cases) {
    for (const Case& one : cases) {
        const PartChoice choice = chosen("auto", one.variables);
        const std::string& name = one.variables.begin()->first;
        EXPECT_EQ(choice.part, one.part) << name << " " << one.variables.begin()->second;
        EXPECT_EQ(choice.parts, one.parts) << name;
    }
}

Variables slurm_array(const std::string& id, const std::string& first, const std::string& last,
                      const std::string& count) {
    return {{"SLURM_ARRAY_TASK_ID", id},
            {"SLURM_ARRAY_TASK_MIN", first},
            {"SLURM_ARRAY_TASK_MAX", last},
            {"SLURM_ARRAY_TASK_COUNT", count}};
}

TEST(PartChoice, is_one_of_so_many) {
    EXPECT_EQ(chosen("3/7").part, 3);
    EXPECT_EQ(chosen("3/7").parts, 7);
    EXPECT_EQ(chosen("1/1").parts, 1);
    EXPECT_EQ(chosen("003/0007").part, 3) << "as all numbers of options";
}

TEST(PartChoice, is_refused_where_it_is_no_part) {
    for (const char* text : {"0/4", "5/4", "1/0", "x", "", "/", "1/", "/4", "1/4/4", "-1/4",
                             "1.5/4", "1 / 4", "automatic", "1/1000001"}) {
        EXPECT_EQ(refusal(text), "--part: found \"" + std::string(text) +
                                     "\", expected I/N with 1 <= I <= N <= 1000000, or auto");
    }
}

TEST(PartChoice, follows_the_launchers) {
    expect_parts({
        {{{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "8"}}, 1, 8},
        {{{"OMPI_COMM_WORLD_RANK", "7"}, {"OMPI_COMM_WORLD_SIZE", "8"}}, 8, 8},
        {{{"PMI_RANK", "2"}, {"PMI_SIZE", "4"}}, 3, 4},
        {{{"SLURM_PROCID", "5"}, {"SLURM_STEP_NUM_TASKS", "6"}}, 6, 6},
    });
}

TEST(PartChoice, follows_the_arrays_of_slurm_wherever_they_begin_and_step) {
    expect_parts({
        {slurm_array("1", "1", "16", "16"), 1, 16},
        {slurm_array("16", "1", "16", "16"), 16, 16},
        {slurm_array("0", "0", "7", "8"), 1, 8},
        {slurm_array("25", "5", "45", "5"), 3, 5},
        {slurm_array("9", "9", "9", "1"), 1, 1},
    });
}

TEST(PartChoice, is_of_all_tasks_of_all_steps_of_an_array) {
    std::set<long> parts;
    for (int id = 1; id <= 3; ++id) {
        for (int rank = 0; rank < 4; ++rank) {
            Variables variables = slurm_array(std::to_string(id), "1", "3", "3");
            variables["SLURM_PROCID"] = std::to_string(rank);
            variables["SLURM_STEP_NUM_TASKS"] = "4";
            const PartChoice choice = chosen("auto", variables);
            EXPECT_EQ(choice.parts, 12);
            parts.insert(choice.part);
        }
    }
    EXPECT_EQ(parts.size(), 12U) << "each another one";
    EXPECT_EQ(*parts.rbegin(), 12);
}

TEST(PartChoice, is_the_nearest_launchers) {
    // mpirun in a job of Slurm: srun has started one process of mpirun's on each of 2 computers.
    expect_parts({{{{"OMPI_COMM_WORLD_RANK", "5"},
                    {"OMPI_COMM_WORLD_SIZE", "8"},
                    {"SLURM_PROCID", "1"},
                    {"SLURM_STEP_NUM_TASKS", "2"}},
                   6,
                   8}});
}

TEST(PartChoice, is_not_guessed) {
    const std::string nobody =
        "--part auto: no launcher says which: neither SLURM_ARRAY_TASK_ID nor "
        "OMPI_COMM_WORLD_RANK, PMI_RANK or SLURM_PROCID with its size is there";
    EXPECT_EQ(refusal("auto"), nobody);
    EXPECT_EQ(refusal("auto", {{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "8"}}), nobody)
        << "the script of a job, which runs once";
    EXPECT_EQ(refusal("auto", {{"PMI_RANK", "x"}, {"PMI_SIZE", "4"}}),
              "--part auto: PMI_RANK is \"x\", no number");
    EXPECT_EQ(refusal("auto", {{"PMI_RANK", "4"}, {"PMI_SIZE", "4"}}),
              "--part auto: PMI_RANK is 4, and PMI_SIZE is 4");
    EXPECT_EQ(refusal("auto", slurm_array("4", "1", "9", "3")),
              "--part auto: the numbers of the array, 3 of them from 1 to 9, do not go by steps: "
              "say --part $SLURM_ARRAY_TASK_ID/N");
    EXPECT_EQ(refusal("auto", {{"SLURM_ARRAY_TASK_ID", "4"}}),
              "--part auto: SLURM_ARRAY_TASK_ID is there, but not _COUNT, _MIN and _MAX");
}

TEST(Parts, are_all_units_each_once_and_of_about_the_same_number) {
    for (const std::size_t units : {1U, 64U, 1000U, 4800U}) {
        for (const long parts : {1L, 2L, 7L, 64L, 1000L}) {
            std::vector<int> times(units);
            std::size_t least = units, most = 0;
            for (long part = 1; part <= parts; ++part) {
                const auto own = units_of_part(units, part, parts);
                for (const std::size_t unit : own) ++times[unit];
                least = std::min(least, own.size());
                most = std::max(most, own.size());
            }
            EXPECT_EQ(times, std::vector<int>(units, 1)) << units << " " << parts;
            const double mean = static_cast<double>(units) / static_cast<double>(parts);
            EXPECT_LE(static_cast<double>(most - least), std::max(1.0, mean / 16))
                << units << " " << parts;
        }
    }
}

TEST(Parts, have_names_that_sort_as_they_count) {
    EXPECT_EQ(part_name(3, 7), "part-3-of-7.pxmpart");
    EXPECT_EQ(part_name(3, 128), "part-003-of-128.pxmpart");
}

}  // namespace
}  // namespace pxm::host
