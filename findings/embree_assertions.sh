#!/usr/bin/env bash
# libembree3-3 3.13.5+dfsg-2 (Debian 12, amd64).
#
# The shared library of Embree that Debian ships is compiled with its assertions on: it imports __assert_fail and
# calls it from 61,552 places. A good engineer takes a distribution's package of a ray tracing library for a release
# build, and a time measured with it for Embree's: a release build of CMake's defines NDEBUG, and nothing in the package's
# name or version says that this one does not.
#
# For a program: whatever is measured against this package is measured against code that checks itself as it runs. pxm
# has Embree as a peer in its benchmarks alone, and docs/measurements/other-renderers.md says so at the numbers. Who wants to know how
# fast Embree is builds it.
#
# Seen on 2026-11-30:
#   imports __assert_fail                                        yes
#   calls of __assert_fail                                       61552
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

command -v objdump >/dev/null || { echo "not tried: no objdump (binutils)" >&2; exit 77; }
fetch libembree3-3=3.13.5+dfsg-2
library=$(find "$work/root" -name 'libembree3.so.3' -print -quit)

imported=$(objdump -T "$library" | grep -c ' \*UND\*.* __assert_fail$' || true)
same "imports __assert_fail" "$( ((imported)) && echo yes || echo no)" yes
calls=$(objdump -d --no-show-raw-insn "$library" | grep -c 'call.*<__assert_fail@plt>' || true)
same "calls of __assert_fail" "$calls" 61552
holds
