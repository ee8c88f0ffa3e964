#include "host/process/interrupt.hpp"

#include <unistd.h>

#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace pxm::host {

namespace {

constexpr long patience_nanoseconds = 500'000'000;  // "within a second" (docs/command-line.md)

std::atomic<bool> stop = false;
std::atomic<int> received = 0;
timer_t patience;
bool has_timer = false;

/// A file to be removed. The state changes around the path, never under a handler's eyes.
struct Part {
    std::atomic<bool> taken = false;
    std::atomic<bool> complete = false;  // the path can be used
    char path[PATH_MAX];
};
Part parts[PartFileGuard::most];

bool part_exists() {
    for (const Part& part : parts) {
        if (part.complete) return true;
    }
    return false;
}

void remove_parts() {
    for (const Part& part : parts) {
        if (part.complete) unlink(part.path);
    }
}

/// As shells have it.
[[noreturn]] void end_now() { end_at_once(128 + received); }

void on_signal(int signal) {
    const bool second = received.exchange(signal) != 0;
    stop = true;
    if (second || part_exists() || !has_timer) end_now();
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

bool is_ignored(int signal) {
    struct sigaction action = {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
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
    handle(SIGXCPU, on_signal);
    if (!is_ignored(SIGHUP)) handle(SIGHUP, on_signal);
    handle(SIGPIPE, SIG_IGN);
    handle(SIGXFSZ, SIG_IGN);
    // A library may end the process: libgomp does where it cannot start a thread.
    (void)std::atexit(remove_parts);
}

const std::atomic<bool>& stop_requested() { return stop; }

int received_signal() { return received; }

void request_stop() { stop = true; }

/// Only what POSIX allows in a signal handler.
void end_at_once(int exit_code) {
    remove_parts();
    _exit(exit_code);
}

PartFileGuard::PartFileGuard(const std::string& path) {
    if (path.size() >= sizeof parts[0].path) return;
    for (int slot = 0; slot < most; ++slot) {
        if (parts[slot].taken.exchange(true)) continue;
        std::memcpy(parts[slot].path, path.c_str(), path.size() + 1);
        parts[slot].complete = true;
        slot_ = slot;
        return;
    }
}

PartFileGuard::~PartFileGuard() {
    if (slot_ < 0) return;
    parts[slot_].complete = false;
    parts[slot_].taken = false;
}

}  // namespace pxm::host
