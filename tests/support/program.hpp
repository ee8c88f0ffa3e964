// The program as its user meets it: bin/pxm as a process of its own, in a folder of its own.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pxm::test {

/// A new empty folder, removed with all it holds at the end of the test.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string path(const std::string& name = "") const;
    void write(const std::string& name, const std::string& text) const;
    [[nodiscard]] std::string read(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// Everything in it by name, hidden files too, with the files' bytes.
    [[nodiscard]] std::map<std::string, std::string> contents() const;
    /// The names alone, sorted.
    [[nodiscard]] std::vector<std::string> names() const;

  private:
    std::filesystem::path path_;
};

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

/// Runs the program in the folder to its end. SOURCE_DATE_EPOCH and NO_COLOR are not inherited.
[[nodiscard]] Outcome run(const Folder& folder, const Arguments& arguments,
                          const Environment& environment = {});

/// Expects the program to refuse: that exit code, exactly this one message, nothing on stdout, and
/// every file in the folder as it was.
void expect_refusal(const Folder& folder, const Arguments& arguments, int exit_code,
                    const std::string& message);
/// The same where the message's details are not ours: it must contain each of these, and `pxm: `
/// once, at its beginning.
void expect_refusal_naming(const Folder& folder, const Arguments& arguments, int exit_code,
                           const std::vector<std::string>& parts);

/// Expects success; what it wrote on stderr.
std::string expect_done(const Folder& folder, const Arguments& arguments,
                        const Environment& environment = {});

/// Sierpinski's tetrahedron as four homotheties, and nothing else.
extern const char* const tetra_scene;

}  // namespace pxm::test
