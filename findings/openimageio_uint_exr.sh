#!/usr/bin/env bash
# openimageio-tools and libopenimageio2.4 2.4.7.1+dfsg-2 (Debian 12).
#
# A channel of 32-bit whole numbers (UINT) in an OpenEXR file is read by OpenImageIO as a fraction of 2^32 - 1 wherever
# floating-point values are asked for: the object number 7 becomes 1.6e-9. A good engineer expects 7, as OpenEXR's own
# library gives it: the format has UINT for numbers of objects and samples, which are counts and not intensities, and its
# half and float channels come through unscaled. OpenImageIO treats every integer type as normalized, of any format, and
# the file written back in float has lost the numbers for good.
#
# For a program: read such a channel in its own type, or multiply by 2^32 - 1 in double before anything else is done; a
# writer that wants its numbers read by others stores them as float where they fit in 24 bits.
#
# Seen on 2026-11-30:
#   7 in a UINT channel, as a float                              1.6298145e-09
#   1000000 in a UINT channel, as a float                        0.00023283064
#   7 in a FLOAT channel                                         7.000000000
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

command -v python3 >/dev/null || { echo "not tried: no python3" >&2; exit 77; }
fetch openimageio-tools=2.4.7.1+dfsg-2 libopenimageio2.4=2.4.7.1+dfsg-2
program oiiotool
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


exr(sys.argv[1], "object", 0, [0, 1, 7, 1000000])
exr(sys.argv[2], "object", 2, [0, 1, 7, 1000000])
PY

python3 "$work/exr.py" "$work/uint.exr" "$work/float.exr"
# `Pixel (2, 0): 7 (1.6298145e-09)`: the word of the file, and what a caller gets who asks for floats
pixel() { "$ran" --dumpdata "$work/$1.exr" | sed -n "s/.*Pixel ($2, 0): //p"; }

same "7 in a UINT channel, as a float" "$(pixel uint 2 | sed 's/.*(\(.*\))/\1/')" 1.6298145e-09
same "1000000 in a UINT channel, as a float" "$(pixel uint 3 | sed 's/.*(\(.*\))/\1/')" 0.00023283064
same "7 in a FLOAT channel" "$(pixel float 2)" 7.000000000
holds
