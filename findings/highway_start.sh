#!/usr/bin/env bash
# libhwy1 1.0.3-3+deb12u1, libhwy-dev 1.0.3-3+deb12u1 (Debian 12), g++ 12.
#
# A program that is linked with Highway's shared library calibrates a clock whenever it is started, before main and
# whether or not it ever computes with a wide register: the library's tools for measuring time are in it too, and one of
# their constants is the resolution of the processor's time stamp counter, which the loader has to find out by repeated
# reading. That takes 3 ms of a start, more than all else that the loader does for a small program. A good engineer knows
# the library as headers with a function that asks the processor what it has, and expects that its library costs a start
# what mapping a file costs.
#
# For a program: who starts often and briefly links a static libhwy, where there is one (Debian has none), loads what
# computes when it is needed, or has a function of that name of its own, which the loader finds first (host/commands/main.cpp).
#
# Seen on 2026-11-30:
#   calls of the clock's calibration before main                 1
#   milliseconds of the processor, of a start: without the library 1.2, with it 4.5
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

command -v g++ >/dev/null || { echo "not tried: no g++" >&2; exit 77; }
fetch libhwy1=1.0.3-3+deb12u1 libhwy-dev=1.0.3-3+deb12u1
libraries=$work/root/usr/lib/x86_64-linux-gnu

# The program asks once which registers there are; main comes after a line of its own.
cat >"$work/registers.cpp" <<'CPP'
#include <hwy/targets.h>

#include <cstdio>

int main(int argc, char**) {
    std::puts("main");
    return argc > 5 && hwy::SupportedTargets() == 0 ? 1 : 0;
}
CPP
g++ -std=c++17 -O2 -isystem "$work/root/usr/include" "$work/registers.cpp" -o "$work/with" \
    -L"$libraries" -lhwy -Wl,-rpath,"$libraries"
sed 's/hwy::SupportedTargets()/argc/; /include <hwy/d' "$work/registers.cpp" >"$work/plain.cpp"
g++ -std=c++17 -O2 "$work/plain.cpp" -o "$work/without"

# Stands before the library's function of that name, tells of the call, and answers in its place.
cat >"$work/tell.cpp" <<'CPP'
#include <cstdio>
#include <cstdint>

namespace hwy::platform {
std::uint64_t TimerResolution() {
    std::puts("calibration");
    std::fflush(stdout);
    return 1;
}
}  // namespace hwy::platform
CPP
g++ -std=c++17 -O2 -shared -fPIC "$work/tell.cpp" -o "$work/tell.so"

before_main=$(LD_PRELOAD=$work/tell.so "$work/with" | sed '/^main$/,$d' | grep -c calibration || true)
same "calls of the clock's calibration before main" "$before_main" 1

# Told, not judged: how long that takes is the computer's matter.
milliseconds_of_a_start() {
    local TIMEFORMAT='%U %S' i
    { time for (( i = 0; i < 100; ++i )); do "$1" >/dev/null; done; } 2>&1 | awk '{ printf "%.1f", 10 * ($1 + $2) }'
}
echo "milliseconds of the processor, of a start: without the library $(milliseconds_of_a_start "$work/without")," \
    "with it $(milliseconds_of_a_start "$work/with")"
holds
