#include "host/interrupt.hpp"

#include <csignal>

namespace pxm::host {

namespace {

std::atomic<bool> stop = false;
volatile std::sig_atomic_t received = 0;

void on_signal(int signal) {
    received = signal;
    stop = true;
}

}  // namespace

void catch_signals() {
    struct sigaction action = {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESETHAND;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& stop_requested() { return stop; }

ExitCode signal_exit_code() {
    return received == SIGTERM ? ExitCode::terminated : ExitCode::interrupted;
}

}  // namespace pxm::host
