# shellcheck shell=bash
# Sourced by the findings. Makes a temporary folder `work`, which goes when the script ends, and has
#   fetch PACKAGE=VERSION...   unpacks these packages of the distribution into $work/root; installs nothing
#   same WHAT FOUND EXPECTED   prints the fact; ends the script if it is no longer so
#   holds                      the last line of a finding
# Exit codes: 0 it holds, 1 it has changed, 77 it could not be tried.
set -euo pipefail
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf --one-file-system -- "$work"' EXIT

fetch() {
    mkdir -p "$work/root" "$work/packages"
    (cd "$work/packages" && apt-get -q download "$@" >log 2>&1) || {
        cat "$work/packages/log" >&2
        echo "not tried: $* cannot be fetched" >&2
        exit 77
    }
    local package
    for package in "$work"/packages/*.deb; do
        dpkg-deb -x "$package" "$work/root"
        rm "$package"
    done
}

same() {
    printf '%-60s %s\n' "$1" "$2"
    [[ $2 == "$3" ]] || { echo "changed: expected $3" >&2; exit 1; }
}

holds() { echo holds; }
