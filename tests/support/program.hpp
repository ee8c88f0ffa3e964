// The program as its user meets it: bin/pxm as a process of its own. Starting it takes a while (its
// image library brings some 250 others along): most tests of the command line use command.hpp.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/folder.hpp"

namespace pxm::test {

/// How a run of the program ended.
struct Outcome {
    int exit_code = -1;  // minus the signal that ended it
    bool timed_out = false;
    std::string out;
    std::string err;
};

using Arguments = std::vector<std::string>;
/// Variables of the environment in the form NAME=value.
using Environment = std::vector<std::string>;

/// A run of the program that is under way. Ended with it.
class Process {
  public:
    Process(const Folder& folder, const Arguments& arguments, const Environment& environment = {});
    /// Of another program, by its path.
    Process(const Folder& folder, const std::string& program, const Arguments& arguments,
            const Environment& environment);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Waits until the program has a handler for the signal: before that it would just die of it.
    void wait_until_it_catches(int signal) const;
    void send(int signal) const;
    /// Waits for its end; kills it once the limit is over.
    [[nodiscard]] Outcome wait(double limit_seconds);

  private:
    using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
    pid_t pid_ = -1;
    File out_;
    File err_;
};

/// Runs a script of /bin/sh in the folder to its end, with the program's path in $PXM.
[[nodiscard]] Outcome run_shell(const Folder& folder, const std::string& script);

/// Runs the program in the folder to its end. SOURCE_DATE_EPOCH and NO_COLOR are not inherited.
[[nodiscard]] Outcome run_program(const Folder& folder, const Arguments& arguments,
                                  const Environment& environment = {});

}  // namespace pxm::test
