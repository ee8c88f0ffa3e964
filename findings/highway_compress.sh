#!/usr/bin/env bash
# libhwy-dev 1.0.3-3+deb12u1 (Debian 12, amd64), g++ 12.
#
# Compress, which puts the wanted lanes of a register together, copies a table of 1024 bytes to the stack in every
# call where registers are those of AVX2 and the compiler is g++: the table of orders is a constant inside the function,
# but no static one, and g++ 12 makes such a constant anew wherever it is looked into by a number that is not known. The
# one permutation that is wanted waits for 128 moves. A good engineer takes an operation of this library for what its
# documents say that it becomes, a few instructions, and the name for one instruction of AVX-512, which it is there.
#
# For a program: in a loop over rays, lanes put together one by one from an array were 1.24 times as fast on AVX2. pxm uses
# Compress on AVX-512 alone (host/wide/search/grid_entry.inl).
#
# Seen on 2026-12-01:
#   bytes that a call copies to the stack, AVX2                  1024
#   bytes that a call copies to the stack, AVX-512               0
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

for tool in g++ objdump; do
    command -v $tool >/dev/null || { echo "not tried: no $tool" >&2; exit 77; }
done
[[ $(g++ -dumpversion) == 12* ]] || { echo "not tried: g++ is no 12" >&2; exit 77; }
fetch libhwy-dev=1.0.3-3+deb12u1

cat >"$work/positive.cpp" <<'CPP'
#include <hwy/highway.h>

namespace hn = hwy::HWY_NAMESPACE;

void positive_ones_together(const float* from, float* to) {
    const hn::ScalableTag<float> d;
    const auto all = hn::LoadU(d, from);
    hn::StoreU(hn::Compress(all, hn::Lt(hn::Zero(d), all)), d, to);
}
CPP

# copied FLAG...: bytes that the function moves by a repeated instruction, eight each time.
copied() {
    g++ -std=c++17 -O3 "$@" -isystem "$work/root/usr/include" -c "$work/positive.cpp" -o "$work/positive.o"
    local count
    count=$(objdump -d --no-show-raw-insn "$work/positive.o" |
        awk '/mov +\$0x[0-9a-f]+,%ecx/ { split($0, part, /[$,]/) } /rep movsq/ { print part[2] }')
    echo $(( 8 * ${count:-0} ))
}

same "bytes that a call copies to the stack, AVX2" \
    "$(copied -mavx2 -mbmi -mbmi2 -mfma -mf16c -maes -mpclmul)" 1024
same "bytes that a call copies to the stack, AVX-512" "$(copied -march=skylake-avx512 -maes -mpclmul)" 0
holds
