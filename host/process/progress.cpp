#include "host/process/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace pxm::host {

namespace {

constexpr int bar_width = 30;  // characters
constexpr auto redraw_interval = std::chrono::milliseconds(100);

std::string clock_text(double seconds) {
    const auto whole = static_cast<long>(seconds + 0.5);
    if (whole >= 3600)
        return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

Progress::Progress(bool quiet)
    : enabled_(!quiet && isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr),
      start_(std::chrono::steady_clock::now()),
      drawn_(start_) {}

Progress::~Progress() {
    if (enabled_) std::fputs("\r\033[K", stderr);
}

void Progress::update(double share) {
    if (!enabled_) return;
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (share < shown_ || now - drawn_ < redraw_interval) return;
    drawn_ = now;
    shown_ = share;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const int filled = std::clamp(static_cast<int>(share * bar_width), 0, bar_width);
    const std::string left =
        share > 0.01 ? clock_text(elapsed / share * (1 - share)) + " left" : "";
    const std::string bar = fmt::format(
        "\r\033[K[{}{}] {:3.0f} %  {}", std::string(static_cast<std::size_t>(filled), '#'),
        std::string(static_cast<std::size_t>(bar_width - filled), '-'), share * 100, left);
    std::fputs(bar.c_str(), stderr);  // a terminal that is gone changes nothing
}

}  // namespace pxm::host
