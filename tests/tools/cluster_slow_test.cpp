// Real launchers on this computer: each makes the five solids in parts, by the scripts of
// tools/cluster/ and --part auto, and the picture is that of one run. What is not installed is
// skipped, with its name.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace pxm::test {
namespace {

const std::string scene = source_dir + "/scenes/five_solids.pxm";
const std::string tools = source_dir + "/tools/cluster/";
const std::string size = " --size 64x48 ";
const std::string film = source_dir + "/scenes/animation/jitterbug.pxm";
const std::string frames = " --frames 0-92:4 --size 32x24 --quiet ";

class Launcher : public testing::Test {
  protected:
    Launcher() {
        const Outcome one =
            run_program(folder, {"render", scene, "-o", "one.exr", "--size", "64x48"});
        EXPECT_EQ(one.exit_code, 0) << one.err;
    }
    [[nodiscard]] bool has(const std::string& program) const {
        return run_shell(folder, "command -v " + program).exit_code == 0;
    }
    void expect_picture(const std::string& script) const {
        const Outcome outcome = run_shell(folder, "export PXM; " + script);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
        EXPECT_TRUE(folder.read("all.exr") == folder.read("one.exr")) << outcome.out << outcome.err;
    }
    /// The same of a film of 24 frames: `script` makes them as out/%02d.png.
    void expect_film(const std::string& script) const {
        const Outcome outcome =
            run_shell(folder, "export PXM; mkdir one out && $PXM render " + film + frames +
                                  "-o one/%02d.png && " + script + " && diff -r one out");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
        EXPECT_EQ(run_shell(folder, "ls out | grep -c png").out, "24\n");
    }
    Folder folder;
};

TEST_F(Launcher, a_shell_makes_the_picture) {
    expect_picture("for i in 1 2 3; do $PXM render " + scene + size +
                   "--part $i/3 -o parts & done; wait; $PXM join parts -o all.exr");
}

TEST_F(Launcher, workers_that_claim_make_the_picture) {
    expect_picture(tools + "claim_workers 3 " + scene + " parts" + size +
                   " && $PXM join parts -o all.exr");
    for (const std::string& name : folder.names())
        EXPECT_EQ(name.find("claim-"), std::string::npos) << name;
}

TEST_F(Launcher, workers_that_claim_make_the_film) {
    expect_film(tools + "claim_workers 3 " + film + " parts" + frames +
                "&& $PXM join parts -o out/%02d.png --quiet");
}

TEST_F(Launcher, gnu_parallel_makes_the_film) {
    if (!has("parallel")) GTEST_SKIP() << "no parallel (Debian: parallel)";
    expect_film(tools + "parallel_hosts 5 " + film + " out/%02d.png" + frames);
}

TEST_F(Launcher, mpi_makes_the_film) {
    if (!has("mpirun.openmpi")) GTEST_SKIP() << "no mpirun.openmpi (Debian: openmpi-bin)";
    expect_film("MPIRUN='mpirun.openmpi --allow-run-as-root --oversubscribe -n 4' " + tools +
                "mpi " + film + " out/%02d.png" + frames);
}

TEST_F(Launcher, gnu_parallel_makes_the_picture) {
    if (!has("parallel")) GTEST_SKIP() << "no parallel (Debian: parallel)";
    expect_picture(tools + "parallel_hosts 5 " + scene + " all.exr" + size);
}

TEST_F(Launcher, open_mpi_makes_the_picture) {
    if (!has("mpirun.openmpi")) GTEST_SKIP() << "no mpirun.openmpi (Debian: openmpi-bin)";
    expect_picture("MPIRUN='mpirun.openmpi --allow-run-as-root --oversubscribe -n 4' " + tools +
                   "mpi " + scene + " all.exr" + size);
}

TEST_F(Launcher, mpich_makes_the_picture) {
    if (!has("mpiexec.mpich")) GTEST_SKIP() << "no mpiexec.mpich (Debian: mpich)";
    expect_picture("MPIRUN='mpiexec.mpich -n 4' " + tools + "mpi " + scene + " all.exr" + size);
}

/// Slurm's own answer if it does not start here.
#define PXM_SKIP_WITHOUT_SLURM(outcome) \
    if ((outcome).exit_code == 77) GTEST_SKIP() << (outcome).out << (outcome).err

TEST_F(Launcher, slurm_makes_the_picture_by_steps_and_by_an_array) {
    const std::string here = source_dir + "/tests/tools/slurm_here ";
    folder.write("job",
                 "set -e\n"
                 "sbatch -W -n 3 -o steps.log " +
                     tools + "slurm_steps.sbatch " + scene + " all.exr" + size +
                     "\ncmp all.exr one.exr\n"
                     "sbatch -W --array=1-4 -o array.log " +
                     tools + "slurm_array.sbatch " + scene + " parts" + size +
                     "\n$PXM join parts -o array.exr\ncmp array.exr one.exr\n"
                     "rm parts/part-2-of-4.pxmpart\n"
                     "sbatch -W --array=1-4 -o array.log " +
                     tools + "slurm_array.sbatch " + scene + " parts" + size +
                     "\n$PXM join parts -o array.exr\ncmp array.exr one.exr\n"
                     "mkdir one out; $PXM render " +
                     film + frames + "-o one/%02d.png\nsbatch -W --array=1-4 -o film.log " + tools +
                     "slurm_array.sbatch " + film + " frames" + frames +
                     "\n$PXM join frames -o out/%02d.png\ndiff -r one out\n");
    const Outcome outcome = run_shell(
        folder, "export PXM; " + here + folder.path("slurm") + " sh job; e=$?; cat *.log; exit $e");
    PXM_SKIP_WITHOUT_SLURM(outcome);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace pxm::test
