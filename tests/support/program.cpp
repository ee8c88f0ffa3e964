#include "tests/support/program.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "tests/support/paths.hpp"

extern char** environ;

namespace pxm::test {

namespace fs = std::filesystem;

namespace {

constexpr double patience_seconds = 120;  // for a run that nobody means to interrupt

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> list;
    for (std::string& text : texts) list.push_back(text.data());
    list.push_back(nullptr);
    return list;
}

Environment child_environment(const Environment& additions) {
    Environment all = additions;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text = *entry;
        if (text.starts_with("SOURCE_DATE_EPOCH=") || text.starts_with("NO_COLOR=")) continue;
        all.emplace_back(text);
    }
    return all;
}

}  // namespace

Process::Process(const Folder& folder, const Arguments& arguments, const Environment& environment)
    : Process(folder, binary, arguments, environment) {}

Process::Process(const Folder& folder, const std::string& program, const Arguments& arguments,
                 const Environment& environment)
    : out_(std::tmpfile(), &std::fclose), err_(std::tmpfile(), &std::fclose) {
    std::vector<std::string> words{fs::path(program).filename().string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables = child_environment(environment);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, fileno(out_.get()), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(err_.get()), STDERR_FILENO);
    const int error = posix_spawn(&pid_, program.c_str(), &actions, nullptr, pointers(words).data(),
                                  pointers(variables).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error("cannot start " + program);
}

Process::~Process() {
    if (pid_ < 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
}

void Process::wait_until_it_catches(int signal) const {
    const fs::path status = fs::path("/proc") / std::to_string(pid_) / "status";
    for (int i = 0; i < 20'000; ++i) {
        std::istringstream lines(text_of(status));
        for (std::string line; std::getline(lines, line);) {
            if (!line.starts_with("SigCgt:")) continue;
            const std::uint64_t caught = std::stoull(line.substr(line.find('\t') + 1), nullptr, 16);
            if ((caught >> (signal - 1) & 1U) != 0) return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ADD_FAILURE() << "the program never caught signal " << signal;
}

void Process::send(int signal) const { kill(pid_, signal); }

Outcome Process::wait(double limit_seconds) {
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_seconds);
    Outcome outcome;
    int status = 0;
    while (waitpid(pid_, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > end) {
            outcome.timed_out = true;
            kill(pid_, SIGKILL);
            waitpid(pid_, &status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    pid_ = -1;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    outcome.out = text_of(out_.get());
    outcome.err = text_of(err_.get());
    return outcome;
}

Outcome run_program(const Folder& folder, const Arguments& arguments,
                    const Environment& environment) {
    return Process(folder, arguments, environment).wait(patience_seconds);
}

Outcome run_shell(const Folder& folder, const std::string& script) {
    return Process(folder, "/bin/sh", {"-c", script}, {"PXM=" + binary}).wait(patience_seconds);
}

}  // namespace pxm::test
