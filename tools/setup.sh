# shellcheck shell=bash disable=SC2034
# Shared by tools/pxm and tools/test; sourced, not run. Sets `root`, the top of the tree, and makes
# sure that packages are installed. Everything it says goes to stderr: stdout is the program's.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
assume_yes=no

say() { printf '%s\n' "$*" >&2; }
die() { say "$(basename "$0"): $*"; exit 1; }

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
        -o DPkg::Lock::Timeout=300 "${missing[@]}" </dev/null >>"$log" 2>&1 ||
        { cat "$log" >&2; rm -f "$log"; die "the packages could not be installed"; }
    rm -f "$log"
}

# Compile through ccache where it is present (read by CMake when a build folder is first configured).
use_ccache() {
    if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache; fi
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
