# shellcheck shell=bash disable=SC2034
# Shared by tools/pxm and tools/test; sourced, not run. Sets `root`, the top of the tree, and makes
# sure that packages are installed. Everything it says goes to stderr: stdout is the program's.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
assume_yes=no

say() { printf '%s\n' "$*" >&2; }
die() { say "$(basename "$0"): $*"; exit 1; }

# A line on the terminal that the next one overwrites; nothing where messages go elsewhere.
status() { if [[ -t 2 ]]; then printf '\r\033[K%s' "$*" >&2; fi; }

# about SECONDS: a time as one would say it.
about() {
    if (( $1 < 90 )); then echo "$(( ($1 + 9) / 10 * 10 )) seconds"; else echo "$(( ($1 + 30) / 60 )) minutes"; fi
}

# The packages of the given lists that dpkg does not know as installed, one a line.
missing_packages() {
    local package
    grep -hv '^#' "$@" | while read -r package; do
        dpkg -s "$package" 2>/dev/null | grep '^Status: install ok installed$' >/dev/null || echo "$package"
    done
}

# How to become root: nothing for root; `sudo` with the user's leave; else an error that says what to do.
ask_for_root() {
    [[ $(id -u) == 0 ]] && return
    local by_hand="apt-get install --no-install-recommends $*"
    command -v sudo >/dev/null || die "packages are missing and there is no sudo; as root: $by_hand"
    if [[ $assume_yes == no ]]; then
        [[ -t 0 ]] || die "packages are missing; give --yes first, or as root: $by_hand"
        local answer
        read -r -p "Install with sudo: $*? [y/N] " answer
        [[ $answer == [yY]* ]] || die "not installed; as root: $by_hand"
    fi
    echo sudo
}

# Shows what apt tells of its progress as one line; keeps the rest on stdout. Its lines are
# dlstatus:FILES:PERCENT:TEXT while it fetches and pmstatus:PACKAGE:PERCENT:TEXT while it installs.
show_packages() {
    local line _ percent what
    while IFS= read -r line; do
        IFS=: read -r _ _ percent what <<<"$line"
        case $line in
            dlstatus:*) status "fetching packages, ${percent%.*} %: $what" ;;
            pmstatus:*) status "installing packages, ${percent%.*} %: $what" ;;
            *) printf '%s\n' "$line" ;;
        esac
    done
    status ""
}

# install_packages LIST...: installs what is missing of the package lists.
install_packages() {
    command -v dpkg >/dev/null || { say "no dpkg here: install the likes of tools/packages*.txt yourself"; return; }
    local missing as_root log
    read -ra missing <<<"$(missing_packages "$@" | tr '\n' ' ')"
    (( ${#missing[@]} )) || return 0
    as_root=$(ask_for_root "${missing[@]}") || exit 1
    say "installing ${missing[*]}"
    log=$(mktemp)
    # A failed update may still leave a list that is good enough.
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q update </dev/null >"$log" 2>&1 || true
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends \
        -o DPkg::Lock::Timeout=300 -o APT::Status-Fd=1 "${missing[@]}" </dev/null 2>&1 | show_packages >>"$log" ||
        { cat "$log" >&2; rm -f "$log"; die "the packages could not be installed"; }
    rm -f "$log"
}

# Seconds that a core takes for a step of the build: the mean of a whole build of the program, without ccache.
seconds_per_step=4

# announce PRESET: says, before a build begins, how many steps are left and how long they take. They are counted with a
# copy of ninja's file: of its own one ninja would first say that CMake has to look for new files, and count no further.
announce() {
    local steps copy=$root/build/$1/steps.ninja
    cp "$root/build/$1/build.ninja" "$copy" 2>/dev/null || true
    steps=$(cmake --build --preset "$1" -- -f steps.ninja -n 2>/dev/null | sed -n 's/^\[[0-9]*\/\([0-9]*\)\].*/\1/p' | tail -1)
    rm -f "$copy"
    say "building pxm: ${steps:-some} steps, about $(about $(( ${steps:-0} * seconds_per_step / $(nproc) ))) on $(nproc) free cores"
}

# Shows what ninja prints as one line of progress; keeps all of it on stdout.
show_steps() {
    local line done total from=$SECONDS
    while IFS= read -r line; do
        printf '%s\n' "$line"
        [[ $line =~ ^\[([1-9][0-9]*)/([0-9]+)\] ]] || continue
        done=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
        status "step $done of $total, about $(about $(( (SECONDS - from) * (total - done) / done ))) left"
    done
    status ""
}

# compile_preset PRESET: configures and builds what is newer than its objects. All output is in the folder's
# build.log, and shown if the build fails; on a terminal there is a line of progress.
compile_preset() {
    local log=$root/build/$1/build.log
    (
        cd "$root"
        cmake --preset "$1" >"$log" 2>&1 || exit
        announce "$1"
        NINJA_STATUS='[%f/%t] ' cmake --build --preset "$1" 2>&1 | show_steps >>"$log"
    ) </dev/null || { cat "$log" >&2; return 1; }
}

# Compile through ccache where it is present (read by CMake when a build folder is first configured).
use_ccache() {
    command -v ccache >/dev/null || return 0
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}  # else it keeps nothing of a precompiled header's users
}

# Fetches what drives a browser in the tests of reports. Where that cannot be had they are skipped, and say so.
prepare_browser() {
    local modules=$root/tests/browser
    [[ -d $modules/node_modules/playwright-core ]] && return
    command -v npm >/dev/null || return 0
    say "fetching playwright-core for the tests in a browser"
    npm install --prefix "$modules" --no-audit --no-fund --no-package-lock >/dev/null 2>&1 ||
        say "playwright-core could not be fetched: tests in a browser will be skipped"
}
