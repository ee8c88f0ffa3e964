// Laws of the program among full disks, closed descriptors, devices and small limits: what is told
// as done is there, what is not there is told.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>

#include "host/output/image.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

/// Warns: the second object hides in the first.
const char* const warning_scene =
    "ifs a { newmap scale: 0.5 translate: 3,0,0 newmap scale: 0.5 }\n"
    "object o { sphere: (0,0,0) 0.1 ifs: a }\n";

class ProgramFiles : public testing::Test {
  protected:
    ProgramFiles() {
        folder.write("tetra.pxm", tetra_scene);
        folder.write("warn.pxm", warning_scene);
        folder.write("f.ifs", "b { .5 0 0 .5 0 0 .5 .5 0 0 .5 1 0 .5 }");
    }
    [[nodiscard]] Outcome shell(const std::string& script) const {
        return run_shell(folder, script);
    }
    /// The exit code alone, of one run of the program with what the shell makes of it.
    void expect(const std::string& script, int exit_code, const std::string& message) const {
        const Outcome outcome = shell("$PXM " + script);
        EXPECT_EQ(outcome.exit_code, exit_code) << script << "\n" << outcome.err;
        EXPECT_EQ(outcome.err, message) << script;
    }
    Folder folder;
};

constexpr const char* full = "pxm: cannot write to the standard output: No space left on device\n";
constexpr const char* closed = "pxm: cannot write to the standard output: Bad file descriptor\n";

TEST_F(ProgramFiles, results_that_nobody_takes_are_code_4) {
    ASSERT_EQ(shell("$PXM render tetra.pxm --size 8x8 -o a.exr --quiet").exit_code, 0);
    for (const char* command :
         {"models", "models --json", "models --token 964", "inspect tetra.pxm",
          "inspect tetra.pxm --json", "compare a.exr a.exr", "import f.ifs -o -",
          "render tetra.pxm --size 8x8 --pixel 4,4", "--help", "--version"}) {
        expect(std::string(command) + " > /dev/full", 4, full);
        expect(std::string(command) + " >&-", 4, closed);
    }
}

TEST_F(ProgramFiles, a_pipe_without_a_reader_is_told_too) {
    const Outcome outcome = shell("{ sleep 0.2; $PXM models; echo $? > code; } | exec true");
    EXPECT_EQ(folder.read("code"), "4\n");
    EXPECT_EQ(outcome.err, "pxm: cannot write to the standard output: Broken pipe\n");
}

TEST_F(ProgramFiles, no_descriptor_that_is_closed_becomes_a_file_of_ours) {
    const std::string render = "$PXM render warn.pxm --size 64x64 --stats s.json -o ";
    ASSERT_EQ(shell(render + "a.png").exit_code, 0);
    for (const char* closing : {"2>&-", ">&-", "<&-", "<&- >&- 2>&-"}) {
        EXPECT_EQ(shell(render + "b.png " + closing).exit_code, 0) << closing;
        EXPECT_TRUE(folder.read("b.png") == folder.read("a.png")) << closing;
        std::filesystem::remove(folder.path("b.png"));
    }
}

TEST_F(ProgramFiles, messages_that_nobody_takes_end_nothing) {
    const std::string render = "$PXM render warn.pxm --size 64x64 --stats s.json -o a.png ";
    for (const char* lost : {"2>/dev/full", "2>&1 | exec true"}) {
        std::filesystem::remove(folder.path("s.json"));
        (void)shell(render + lost);
        EXPECT_TRUE(folder.has("s.json")) << lost << ": it is written last";
    }
    EXPECT_EQ(shell(render + "2>/dev/full").exit_code, 0);
    EXPECT_EQ(shell("$PXM render none.pxm 2>/dev/full").exit_code, 4);
}

TEST_F(ProgramFiles, devices_and_links_stay_what_they_are) {
    const Outcome outcome = shell(
        "ln -s real.json link.json; mkfifo pipe; cat pipe > got & "
        "$PXM render tetra.pxm --size 8x8 -o a.png --quiet --stats /dev/null && "
        "$PXM render tetra.pxm --size 8x8 -o a.png --quiet --stats link.json && "
        "$PXM points tetra.pxm -n 1000 -o pipe --quiet && wait && "
        "$PXM inspect tetra.pxm -o /dev/stdout | head -1; stat -c %F /dev/null link.json pipe");
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "tetra.pxm\ncharacter special file\nsymbolic link\nfifo\n");
    EXPECT_TRUE(folder.has("real.json"));
    EXPECT_GT(folder.read("got").size(), 15'000U);
}

TEST_F(ProgramFiles, what_a_killed_run_left_is_removed_by_the_next) {
    folder.write("grass.pxm",
                 "ifs grass { newmap scale: 0.707,0.96,0.707 rotate: y,45 translate: -1,0,0\n"
                 "newmap scale: 0.707,0.96,0.707 rotate: y,45 translate: 1,0,0 }\n");
    folder.write("left", "");
    // A pipe without a reader keeps a run waiting, its picture whole beside: of formats other than
    // PNG, which goes into the pipe as it is made.
    const Outcome killed = shell(
        "mkfifo pipe.exr; TMPDIR=. $PXM render tetra.pxm --size 8x8 -o pipe.exr --quiet & "
        "while ! ls .pxm-part-* > /dev/null 2>&1; do sleep 0.05; done; kill -9 $!; wait $!; "
        "ls .pxm-part-* | wc -l; $PXM render tetra.pxm --size 8x8 -o a.exr --quiet; "
        "ls .pxm-part-* | wc -l");
    EXPECT_EQ(killed.out, "1\n0\n");
    EXPECT_TRUE(folder.has("a.exr"));
}

TEST_F(ProgramFiles, a_run_that_lives_keeps_its_part_while_others_come_and_go) {
    const Outcome both = shell(
        "mkfifo pipe.exr; TMPDIR=. $PXM render tetra.pxm --size 8x8 -o pipe.exr --quiet & "
        "while ! ls .pxm-part-* > /dev/null 2>&1; do sleep 0.05; done; "
        "$PXM render tetra.pxm --size 8x8 -o a.exr --quiet; cat pipe.exr > b.exr; wait $!; "
        "echo $?; ls -A | grep -c part");
    EXPECT_EQ(both.out, "0\n0\n") << both.err;
    EXPECT_TRUE(folder.read("b.exr") == folder.read("a.exr"));
}

/// Whether the system lets a test have namespaces of its own, in which it mounts and is process 1.
class OwnNamespaces : public ProgramFiles {
  protected:
    void SetUp() override {
        const std::string test = " -m -p -f sh -c 'mkdir -p m && mount -t tmpfs none m'";
        for (const char* start : {"unshare", "unshare -U -r"}) {
            if (shell(start + test).exit_code != 0) continue;
            unshare = std::string(start) + " -m -p -f ";
            return;
        }
        GTEST_SKIP() << "no namespaces: " << shell("unshare -U -r" + test).err;
    }
    std::string unshare;
};

TEST_F(OwnNamespaces, a_full_disk_keeps_the_picture_of_before_and_no_part) {
    for (const char* format : {"png", "exr", "tif", "jpg", "bmp", "gif", "tga", "sgi", "fits",
                               "jp2", "hdr", "ppm", "webp"}) {
        folder.write("script", "mount -t tmpfs -o size=12k none m && echo old > m/o." +
                                   std::string(format) +
                                   " && $PXM render tetra.pxm --size 320x240 --quiet -o m/o." +
                                   format + "; echo $?; cat m/o.* && ls -A m");
        const Outcome outcome = shell(unshare + "sh script");
        EXPECT_EQ(outcome.out, "4\nold\no." + std::string(format) + "\n");
        EXPECT_EQ(outcome.err.rfind("pxm: cannot write m/o." + std::string(format) + ": ", 0), 0U)
            << outcome.err;
    }
}

TEST_F(OwnNamespaces, a_full_disk_leaves_no_damaged_part_and_the_next_run_goes_on) {
    const std::string render = "$PXM render tetra.pxm --size 320x240 --quiet ";
    ASSERT_EQ(shell(render + "-o one.png").exit_code, 0);
    for (const std::string where :
         {"--part 1/1 -o m/parts", "--keep m/parts -o kept.png", "--claim m/parts --part any/2"}) {
        folder.write("script", "mount -t tmpfs -o size=16k none m && " + render + where +
                                   "; echo $?; ls m/parts; mount -o remount,size=8m m && " +
                                   render + where +
                                   "; echo $?; $PXM join m/parts -o all.png "
                                   "--quiet; echo $?");
        const Outcome outcome = shell(unshare + "sh script");
        EXPECT_EQ(outcome.out, "4\n0\n0\n") << where;
        EXPECT_NE(outcome.err.find("No space left on device"), std::string::npos) << outcome.err;
        EXPECT_TRUE(folder.read("all.png") == folder.read("one.png")) << where;
    }
    EXPECT_TRUE(folder.read("kept.png") == folder.read("one.png"));
}

/// Computers of their own, as far as a kernel makes them: each with its name and network, and each
/// worker is process 1 there.
TEST_F(OwnNamespaces, workers_of_several_hosts_make_each_part_once) {
    if (shell(unshare + "-n -u sh -c 'hostname a'").exit_code != 0)
        GTEST_SKIP() << "no network and name of its own for a process";
    const std::string render = "$PXM render tetra.pxm --size 400x300 ";
    ASSERT_EQ(shell(render + "--quiet -o one.png").exit_code, 0);
    std::string script;
    for (const char* host : {"a", "b", "c"})
        script += unshare + "-n -u sh -c 'hostname " + host + " && exec " + render +
                  "--claim parts --part any/40 --threads 1' 2> " + host + " & ";
    const Outcome outcome = shell("export PXM; " + script + "wait; cat a b c; " + render +
                                  "--quiet --claim parts --part any/40 && $PXM join parts -o "
                                  "all.png --quiet");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    long made = 0;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) made += std::stol(line);
    EXPECT_EQ(made, 40) << outcome.out;
    EXPECT_TRUE(folder.read("all.png") == folder.read("one.png"));
}

TEST_F(OwnNamespaces, two_runs_that_are_both_process_1_write_into_one_folder) {
    const std::string render = unshare + "$PXM render tetra.pxm --quiet --size ";
    ASSERT_EQ(shell(render + "1000x4000 -o a.png").exit_code, 0);
    ASSERT_EQ(shell(render + "1200x4000 -o b.png").exit_code, 0);
    const Outcome both = shell("(" + render + "1000x4000 -o c.png) & (" + render +
                               "1200x4000 -o d.png); wait $! && echo done");
    EXPECT_EQ(both.out, "done\n") << both.err;
    EXPECT_TRUE(folder.read("c.png") == folder.read("a.png"));
    EXPECT_TRUE(folder.read("d.png") == folder.read("b.png"));
}

TEST_F(ProgramFiles, out_of_memory_is_code_1_with_a_message_in_every_engine) {
    // Cells of a ten thousandth of a pixel, of which a tile's rays meet millions.
    folder.write("fine.pxm", std::string(tetra_scene) + "render { detail: 1e-4 }\n");
    for (const char* engine :
         {"--intersect wide", "--intersect heap --heap 65536 --threads 64", "--machine 964dX"}) {
        for (const int megabytes : {600, 900}) {
            const std::string limited = "ulimit -v " + std::to_string(megabytes * 1024) + "; $PXM ";
            const Outcome outcome =
                shell(limited + "render fine.pxm --size 16x16 --quiet -o a.png " + engine);
            const bool told = outcome.exit_code == 1 && outcome.err.ends_with("out of memory\n");
            EXPECT_TRUE(told || outcome.exit_code == 0)
                << engine << " " << megabytes << ": " << outcome.exit_code << " " << outcome.err;
            EXPECT_EQ(folder.has("a.png"), outcome.exit_code == 0);
            std::filesystem::remove(folder.path("a.png"));
        }
    }
}

TEST_F(ProgramFiles, threads_that_cannot_start_are_done_without) {
    const std::string render = "$PXM render tetra.pxm --size 64x64 --quiet --no-scene ";
    ASSERT_EQ(shell(render + "-o a.png").exit_code, 0);
    for (const char* engine : {"", "--intersect heap", "--machine 964dX"}) {
        const Outcome outcome = shell("ulimit -v 3000000; " + render + "--threads 1024 -o b.png " +
                                      engine);  // their stacks alone want 8 GB
        EXPECT_EQ(outcome.exit_code, 0) << engine << outcome.err;
        EXPECT_TRUE(folder.read("b.png") == folder.read("a.png")) << engine;
    }
}

TEST_F(ProgramFiles, a_small_stack_changes_nothing) {
    std::string deep = "let x = ";
    for (int i = 0; i < 5000; ++i) deep += "(";
    folder.write("deep.pxm", deep);
    std::string ring = "ifs ring {\n";
    for (int i = 0; i < 1000; ++i) {
        ring += "newmap m" + std::to_string(i) +
                " scale: 0.4 translate: " + std::to_string(i % 50) + "," + std::to_string(i / 50) +
                ",0\n";
    }
    folder.write("ring.pxm", ring + "}\n");
    const std::string render = "$PXM render ring.pxm --size 32x32 --quiet --threads 3 -o ";
    ASSERT_EQ(shell(render + "a.png").exit_code, 0);
    for (const char* stack : {"ulimit -s 256; ", "ulimit -S -s 256; ", "ulimit -s unlimited; "}) {
        const Outcome refused = shell(stack + std::string("$PXM inspect deep.pxm"));
        EXPECT_EQ(refused.exit_code, 3) << stack << refused.err;
        const Outcome outcome = shell(stack + render + "b.png");
        EXPECT_EQ(outcome.exit_code, 0) << stack << outcome.err;
        EXPECT_TRUE(folder.read("b.png") == folder.read("a.png")) << stack;
        EXPECT_EQ(shell(stack + std::string("$PXM inspect ring.pxm > /dev/null")).exit_code, 0);
    }
}

}  // namespace
}  // namespace pxm::test
