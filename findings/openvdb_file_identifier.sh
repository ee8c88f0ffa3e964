#!/usr/bin/env bash
# python3-openvdb, libopenvdb10.0 10.0.1-2 (Debian 12).
#
# OpenVDB draws lots for every file that it writes: behind the magic number and the versions stand 36 letters of a
# random identifier (RFC 4122, version 4), which no call sets. The same grid written twice by one program makes two
# files of different bytes. A good engineer expects a writer of numbers to be a function of the numbers, and compares
# builds, caches and renders by the hash of their files.
#
# For a program: compare .vdb files by what is behind that header, or write the identifier anew. pxm makes it of the
# contents (host/openvdb/vdb_library.cpp), so that an export has the same bytes each time.
#
# Seen on 2026-12-01, of a ball that is written twice:
#   files of equal length                                        yes
#   bytes that differ                                            some
#   ... outside of the identifier's 36                           0
#   ... form of the identifier                                   version 4
#   grids that are read back are equal                           yes
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

fetch python3-openvdb=10.0.1-2 libopenvdb10.0=10.0.1-2 libopenvdb-ax10.0=10.0.1-2 libllvm14=1:14.0.6-12 \
    libboost-numpy1.74.0=1.74.0+ds1-21 libboost-python1.74.0=1.74.0+ds1-21 libboost-iostreams1.74.0=1.74.0+ds1-21 \
    libblosc1=1.21.3+ds-1 libsnappy1v5=1.1.9-3 libtbb12=2021.8.0-2+deb12u1 libimath-3-1-29=3.1.6-1 \
    liblog4cplus-2.0.5=2.0.8-1
LD_LIBRARY_PATH=$(find "$work/root/usr/lib" -name '*.so.*' -printf '%h\n' | sort -u | paste -sd:)
export LD_LIBRARY_PATH PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 -c 'import pyopenvdb' 2>"$work/log" || {
    tail -1 "$work/log" >&2
    echo "not tried: pyopenvdb cannot be loaded; it needs python3-numpy" >&2
    exit 77
}
mapfile -t facts < <(cd "$work" && /usr/bin/python3 - <<'PY'
import re
import pyopenvdb as vdb

ball = vdb.createLevelSetSphere(radius=3.0, voxelSize=0.5)
for name in ("a.vdb", "b.vdb"):
    vdb.write(name, grids=[ball])
a, b = (open(name, "rb").read() for name in ("a.vdb", "b.vdb"))
places = re.compile(rb"[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}")
at = places.search(a)
apart = [i for i, (x, y) in enumerate(zip(a, b)) if x != y]
print("yes" if len(a) == len(b) else "no")
print("some" if apart else "none")
print(sum(1 for i in apart if not (at and at.start() <= i < at.end())))
print("version 4" if at and at.start() < 64 else "another")


def values(name):
    grid = vdb.readAll(name)[0][0]
    return [(x.min, x.max, x.value) for x in grid.citerOnValues()]


print("yes" if values("a.vdb") == values("b.vdb") else "no")
PY
)
same "files of equal length" "${facts[0]-}" yes
same "bytes that differ" "${facts[1]-}" some
same "... outside of the identifier's 36" "${facts[2]-}" 0
same "... form of the identifier" "${facts[3]-}" "version 4"
same "grids that are read back are equal" "${facts[4]-}" yes
holds
