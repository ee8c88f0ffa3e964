#include "host/interrupt.hpp"

#include <unistd.h>

#include <climits>
#include <csignal>
#include <cstring>
#include <ctime>

namespace pxm::host {

namespace {

constexpr long patience_nanoseconds = 500'000'000;  // "within a second" (docs/command-line.md)

std::atomic<bool> stop = false;
std::atomic<int> received = 0;
std::atomic<bool> part_exists = false;
char part_path[PATH_MAX];
timer_t patience;
bool has_timer = false;

/// Only what POSIX allows in a signal handler.
[[noreturn]] void end_now() {
    if (part_exists) unlink(part_path);
    _exit(static_cast<int>(signal_exit_code()));
}

void on_signal(int signal) {
    const bool second = received.exchange(signal) != 0;
    stop = true;
    if (second || part_exists || !has_timer) end_now();
    itimerspec once = {};
    once.it_value.tv_nsec = patience_nanoseconds;
    timer_settime(patience, 0, &once, nullptr);
}

void on_alarm(int) { end_now(); }

void handle(int signal, void (*handler)(int)) {
    struct sigaction action = {};
    action.sa_handler = handler;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_signals() {
    sigevent event = {};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    has_timer = timer_create(CLOCK_MONOTONIC, &event, &patience) == 0;
    handle(SIGALRM, on_alarm);
    handle(SIGINT, on_signal);
    handle(SIGTERM, on_signal);
}

const std::atomic<bool>& stop_requested() { return stop; }

ExitCode signal_exit_code() {
    return received == SIGTERM ? ExitCode::terminated : ExitCode::interrupted;
}

PartFileGuard::PartFileGuard(const std::string& path) {
    if (path.size() >= sizeof part_path) return;
    std::memcpy(part_path, path.c_str(), path.size() + 1);
    part_exists = true;
}

PartFileGuard::~PartFileGuard() { part_exists = false; }

}  // namespace pxm::host
