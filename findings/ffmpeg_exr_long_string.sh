#!/usr/bin/env bash
# ffmpeg, libavcodec59 and libavformat59 7:5.1.9-0+deb12u1 (Debian 12).
#
# ffmpeg loses its place in the header of an OpenEXR file behind a string attribute of more than 255 bytes: the rest of
# the string is taken for attributes, and the table of offsets is looked for elsewhere. Rows of the picture, or all of
# them, come out black, and ffmpeg says nothing and exits 0; with other lengths it refuses the file ("Incomplete
# frame."). A good engineer expects a reader to go past an attribute by the length that stands before it, and puts
# metadata of any length into a header: manifests of Cryptomatte, the command that wrote the file, a scene.
#
# For a program: keep each string at 255 bytes or less, and cut a longer text into several attributes
# (host/files/carried_text.cpp does).
#
# Seen on 2026-12-01, black rows of 16 in a grey picture:
#   a string of 255 bytes                                        0
#   a string of 256 bytes                                        1
#   a string of 600 bytes                                        16
#   sixty strings of 255 bytes                                   0
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

command -v python3 >/dev/null || { echo "not tried: no python3" >&2; exit 77; }
version=7:5.1.9-0+deb12u1
fetch "ffmpeg=$version" "libavcodec59=$version" "libavformat59=$version" "libavutil57=$version" \
    "libavfilter8=$version" "libavdevice59=$version" "libswscale6=$version" "libswresample4=$version" \
    "libpostproc56=$version"
program ffmpeg
cat >"$work/exr.py" <<'PY'
import struct
import sys


def attribute(name, of, data):
    return name.encode() + b"\0" + of.encode() + b"\0" + struct.pack("<i", len(data)) + data


path, count, length = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
side = 16
window = struct.pack("<4i", 0, 0, side - 1, side - 1)
channels = b"".join(name + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
head = struct.pack("<ii", 20000630, 2) + b"".join([
    attribute("channels", "chlist", channels), attribute("compression", "compression", b"\0"),
    attribute("dataWindow", "box2i", window), attribute("displayWindow", "box2i", window),
    attribute("lineOrder", "lineOrder", b"\0"), attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
    attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
    attribute("screenWindowWidth", "float", struct.pack("<f", 1))] +
    [attribute(f"note{i}", "string", b"x" * length) for i in range(count)]) + b"\0"
row = struct.pack("<f", 0.25) * (3 * side)
lines = [struct.pack("<ii", y, len(row)) + row for y in range(side)]
table = b"".join(struct.pack("<Q", len(head) + 8 * side + y * len(lines[0])) for y in range(side))
open(path, "wb").write(head + table + b"".join(lines))
PY
cat >"$work/rows.py" <<'PY'
import struct
import sys

data = sys.stdin.buffer.read()
values = struct.unpack(f"<{len(data) // 4}f", data)
print(sum(values[16 * y] == 0 for y in range(16)))
PY

black_rows() {
    python3 "$work/exr.py" "$work/a.exr" "$1" "$2"
    "$ran" -v error -i "$work/a.exr" -frames:v 1 -f rawvideo -pix_fmt gbrpf32le - | python3 "$work/rows.py"
}

same "a string of 255 bytes" "$(black_rows 1 255)" 0
same "a string of 256 bytes" "$(black_rows 1 256)" 1
same "a string of 600 bytes" "$(black_rows 1 600)" 16
same "sixty strings of 255 bytes" "$(black_rows 60 255)" 0
holds
