#include "host/process/terminal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "host/error.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

[[noreturn]] void results_are_lost(int error) {
    throw Error(ErrorKind::file, std::string("cannot write to the standard output: ") +
                                     (error == 0 ? "an earlier part was lost" : strerror(error)));
}

}  // namespace

// Linux gives the lowest number that is free. A place opened as a mere path can be neither read nor
// written: results for a closed output are an error. The top folder is there even without /dev.
void fill_standard_descriptors() {
    int descriptor = 0;
    do {
        descriptor = open("/", O_PATH | O_DIRECTORY);
    } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
    if (descriptor > STDERR_FILENO) close(descriptor);
}

void put_result(std::string_view text) {
    const std::string shown = printable_lines(text);
    errno = 0;
    if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size()) results_are_lost(errno);
}

// What a failed write leaves in the buffer would be tried again at the end of the program.
void finish_results() {
    errno = 0;
    const bool taken = std::fflush(stdout) == 0;
    const int error = errno;
    const bool earlier_taken = std::ferror(stdout) == 0;
    std::clearerr(stdout);
    if (!taken || !earlier_taken) results_are_lost(error);
}

void tell(std::string_view text) noexcept {
    try {
        const std::string shown = printable_lines(text);
        std::fwrite(shown.data(), 1, shown.size(), stderr);
    } catch (const std::bad_alloc&) {
        constexpr std::string_view words = "pxm: out of memory\n";
        std::fwrite(words.data(), 1, words.size(), stderr);
    }
    std::clearerr(stderr);
}

}  // namespace pxm::host
