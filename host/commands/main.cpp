// The program: one command line in, one exit code out. The only place that catches.
#include <cstdint>
#include <exception>
#include <new>
#include <string>

#include "host/commands/cli.hpp"
#include "host/error.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/stack.hpp"
#include "host/process/terminal.hpp"

namespace {

using pxm::host::ExitCode;

int fail(ExitCode code, const char* message) {
    pxm::host::tell("pxm: ");
    pxm::host::tell(message);
    pxm::host::tell("\n");
    return static_cast<int>(code);
}

int run(int argc, const char* const* argv) {
    try {
        const ExitCode code = pxm::host::run_command_line(argc, argv);
        pxm::host::finish_results();
        return static_cast<int>(code);
    } catch (const pxm::host::Error& error) {
        return fail(pxm::host::exit_code_of(error.kind()), error.what());
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::run_failed, "out of memory");
    } catch (const std::exception& error) {
        return fail(ExitCode::run_failed, error.what());
    }
}

}  // namespace

// The library of wide registers asks this before main for the step of a clock that pxm never reads,
// and spends 3 ms of every start on the answer (findings/highway_start.sh). What the program has
// stands before what a library has.
namespace hwy::platform {
std::uint64_t TimerResolution() { return 1; }
}  // namespace hwy::platform

int main(int argc, char** argv) {
    pxm::host::fill_standard_descriptors();
    pxm::host::catch_signals();
    return pxm::host::with_enough_stack([&] { return run(argc, argv); });
}
