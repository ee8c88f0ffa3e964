# shellcheck shell=bash
# Sourced by the findings. Makes a temporary folder `work`, which goes when the script ends, and has
#   fetch PACKAGE=VERSION...   unpacks these packages of the distribution into $work/root; installs nothing
#   program NAME               sets `ran` to a fetched program; what it links is fetched too or, else, the system's
#   same WHAT FOUND EXPECTED   prints the fact; ends the script if it is no longer so
#   holds                      the last line of a finding
# Exit codes: 0 it holds, 1 it has changed, 77 it could not be tried.
set -euo pipefail
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf --one-file-system -- "$work"' EXIT

fetch() {
    mkdir -p "$work/root/usr/lib" "$work/packages"
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

program() {
    local path=$work/root/usr/bin/$1
    LD_LIBRARY_PATH=$(find "$work/root/usr/lib" -name '*.so.*' -printf '%h\n' | sort -u | paste -sd:)
    export LD_LIBRARY_PATH
    ! ldd "$path" | grep -q 'not found' || {
        echo "not tried: $1 needs $(ldd "$path" | awk '/not found/ { print $1 }' | paste -sd' ')" >&2
        exit 77
    }
    # shellcheck disable=SC2034
    ran=$path
}

same() {
    printf '%-60s %s\n' "$1" "$2"
    [[ $2 == "$3" ]] || { echo "changed: expected $3" >&2; exit 1; }
}

holds() { echo holds; }
