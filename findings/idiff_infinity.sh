#!/usr/bin/env bash
# openimageio-tools and libopenimageio2.4 2.4.7.1+dfsg-2 (Debian 12).
#
# idiff passes two pictures of which one has infinity where the other has a finite number: it prints PASS and exits 0,
# while a difference of 1 at the same place fails. It forgives the first such value of a comparison; with a second one
# it fails, and says that one pixel differs. A good engineer expects the largest difference that there is to fail at any
# threshold, and each to be counted; depth has infinity wherever a ray meets nothing, so pictures whose outlines differ
# in one pixel compare as equal.
#
# For a program: compare what is hit and what is not before the numbers (`pxm compare` does), and do not take idiff's
# PASS for more than that the finite pixels agree.
#
# Seen on 2026-11-30:
#   1 2 3 inf against 1 2 3 4                                    0 PASS
#   1 2 3 5 against 1 2 3 4                                      2 FAILURE
#   1 2 inf inf against 1 2 3 4                                  2 FAILURE
#   pixels that it counts there                                  1
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

command -v python3 >/dev/null || { echo "not tried: no python3" >&2; exit 77; }
fetch openimageio-tools=2.4.7.1+dfsg-2 libopenimageio2.4=2.4.7.1+dfsg-2
program idiff
cat >"$work/exr.py" <<'PY'
import struct
import sys


def exr(path, channel, kind, values):
    """One scan line, uncompressed, of one channel; kind 0 is UINT, 2 is FLOAT."""
    def attribute(name, of, data):
        return name.encode() + b"\0" + of.encode() + b"\0" + struct.pack("<i", len(data)) + data
    window = struct.pack("<4i", 0, 0, len(values) - 1, 0)
    channels = channel.encode() + b"\0" + struct.pack("<iB3xii", kind, 0, 1, 1) + b"\0"
    head = struct.pack("<ii", 20000630, 2) + b"".join([
        attribute("channels", "chlist", channels), attribute("compression", "compression", b"\0"),
        attribute("dataWindow", "box2i", window), attribute("displayWindow", "box2i", window),
        attribute("lineOrder", "lineOrder", b"\0"), attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1))]) + b"\0"
    body = struct.pack(f"<{len(values)}{'I' if kind == 0 else 'f'}", *values)
    line = struct.pack("<Qii", len(head) + 8, 0, len(body)) + body
    open(path, "wb").write(head + line)


infinity = float("inf")
for path, last in zip(sys.argv[1:], ((3, infinity), (3, 4), (3, 5), (infinity, infinity))):
    exr(path, "Z", 2, [1, 2, *last])
PY

python3 "$work/exr.py" "$work/infinite.exr" "$work/finite.exr" "$work/off.exr" "$work/two.exr"
# The exit code and the last word.
verdict() {
    local code=0
    "$ran" "$work/$1.exr" "$work/finite.exr" >"$work/said" 2>&1 || code=$?
    echo "$code $(tail -1 "$work/said")"
}

same "1 2 3 inf against 1 2 3 4" "$(verdict infinite)" "0 PASS"
same "1 2 3 5 against 1 2 3 4" "$(verdict off)" "2 FAILURE"
same "1 2 inf inf against 1 2 3 4" "$(verdict two)" "2 FAILURE"
same "pixels that it counts there" "$(awk '/pixels .* over/ { print $1; exit }' "$work/said")" 1
holds
