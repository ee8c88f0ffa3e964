#include "tests/support/command.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "host/commands/cli.hpp"
#include "host/process/terminal.hpp"

namespace pxm::test {

namespace {

namespace fs = std::filesystem;

/// While it lives, that folder is where the process is.
class Inside {
  public:
    explicit Inside(const Folder& folder) : before_(fs::current_path()) {
        fs::current_path(folder.path());
    }
    ~Inside() { fs::current_path(before_); }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

  private:
    fs::path before_;
};

/// While it lives, what is written to a stream goes to a file of its own.
class Caught {
  public:
    explicit Caught(std::FILE* stream)
        : stream_(stream), before_(dup(fileno(stream))), file_(std::tmpfile()) {
        std::fflush(stream_);
        dup2(fileno(file_), fileno(stream_));
    }
    ~Caught() {
        std::fflush(stream_);
        dup2(before_, fileno(stream_));
        close(before_);
        std::fclose(file_);
    }
    Caught(const Caught&) = delete;
    Caught& operator=(const Caught&) = delete;

    [[nodiscard]] std::string text() const {
        std::fflush(stream_);
        return text_of(file_);
    }

  private:
    std::FILE* stream_;
    int before_;
    std::FILE* file_;
};

/// While it lives, the environment has these entries more.
class Variables {
  public:
    explicit Variables(const Environment& entries) {
        for (const std::string& entry : entries) {
            names_.push_back(entry.substr(0, entry.find('=')));
            setenv(names_.back().c_str(), entry.substr(entry.find('=') + 1).c_str(), 1);
        }
    }
    ~Variables() {
        for (const std::string& name : names_) unsetenv(name.c_str());
    }
    Variables(const Variables&) = delete;
    Variables& operator=(const Variables&) = delete;

  private:
    std::vector<std::string> names_;
};

/// As main does it.
int exit_code(const Arguments& arguments) {
    std::vector<const char*> words{"pxm"};
    for (const std::string& argument : arguments) words.push_back(argument.c_str());
    words.push_back(nullptr);
    try {
        const host::ExitCode code =
            host::run_command_line(static_cast<int>(words.size()) - 1, words.data());
        host::finish_results();
        return static_cast<int>(code);
    } catch (const host::Error& error) {
        host::tell(std::string("pxm: ") + error.what() + "\n");
        return static_cast<int>(host::exit_code_of(error.kind()));
    }
}

}  // namespace

Outcome run(const Folder& folder, const Arguments& arguments, const Environment& environment) {
    unsetenv("SOURCE_DATE_EPOCH");
    const Inside inside(folder);
    const Variables variables(environment);
    const Caught out(stdout);
    const Caught err(stderr);
    Outcome outcome;
    outcome.exit_code = exit_code(arguments);
    outcome.out = out.text();
    outcome.err = err.text();
    return outcome;
}

void expect_refusal(const Folder& folder, const Arguments& arguments, int exit_code,
                    const std::string& message) {
    const auto before = folder.contents();
    const Outcome outcome = run(folder, arguments);
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.err, "pxm: " + message + "\n");
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.contents(), before);
}

void expect_refusal_naming(const Folder& folder, const Arguments& arguments, int exit_code,
                           const std::vector<std::string>& parts) {
    const auto before = folder.contents();
    const Outcome outcome = run(folder, arguments);
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.err.rfind("pxm: ", 0), 0U) << outcome.err;
    for (const std::string& part : parts) {
        EXPECT_NE(outcome.err.find(part), std::string::npos) << part << " in\n" << outcome.err;
    }
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.contents(), before);
}

std::string expect_done(const Folder& folder, const Arguments& arguments,
                        const Environment& environment) {
    const Outcome outcome = run(folder, arguments, environment);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.err;
}

const char* const tetra_scene =
    "ifs tetra {\n"
    "    newmap scale: 0.5 translate: 0,0.5,0\n"
    "    newmap scale: 0.5 translate: 0,-0.166,-0.472\n"
    "    newmap scale: 0.5 translate: 0.409,-0.166,0.236\n"
    "    newmap scale: 0.5 translate: -0.409,-0.166,0.236\n"
    "}\n";

const char* const turning_film = R"(
animation { frames: 5  rate: 10 }
ifs a {
    newmap scale: 0.5 rotate: y,90*t
    newmap scale: 0.5 translate: 0.5,0,0
    newmap scale: 0.5 translate: 0,0.5*key(t: 0 -> 1, 1 -> 0.5),0
}
camera { eye: 0.3,0.4,-2  look: 0.3,0.3,0 }
image { size: 24,16 }
)";

}  // namespace pxm::test
