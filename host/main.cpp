// The program: one command line in, one exit code out. The only place that catches.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "host/cli.hpp"
#include "host/error.hpp"
#include "host/interrupt.hpp"

int main(int argc, char** argv) {
    using pxm::host::ExitCode;
    const auto fail = [](ExitCode code, const char* message) {
        fmt::print(stderr, "pxm: {}\n", message);
        return static_cast<int>(code);
    };
    try {
        pxm::host::catch_signals();
        return static_cast<int>(pxm::host::run_command_line(argc, argv));
    } catch (const pxm::host::Error& error) {
        return fail(error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::run_failed, "out of memory");
    } catch (const std::exception& error) {
        return fail(ExitCode::run_failed, error.what());
    }
}
