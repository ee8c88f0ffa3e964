#!/usr/bin/env bash
# Packages: imagemagick-6.q16, libmagickcore-6.q16-6, libmagickcore-6.q16-6-extra and libmagickwand-6.q16-6
# 8:6.9.11.60+dfsg-1.6+deb12u11, Debian 12.
#
# ImageMagick reads every OpenEXR file through 16-bit floats, also one of 32-bit floats, and says "16-bit" of it. 4,096
# different values between 1/2 and 1 come out as 1,025.
#
# One expects the worse of file (24 bits) and program (its pixels have 16 bits: 65,536 steps): steps of 1/65535. But
# 16-bit floats have 11 bits, so steps of 1/2048 near white, coarser than those of a 12-bit picture.
#
# A channel that counts, as object or cell, keeps whole numbers to 2,048 only on such a way; pxm writes 32-bit floats,
# and its documents warn of it: docs/pictures.md.
#
# Seen on 2026-11-30:
#   different values in the file                                 4096
#   different values as ImageMagick reads them                   1025
set -euo pipefail
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

version=8:6.9.11.60+dfsg-1.6+deb12u11
fetch imagemagick-6.q16="$version" libmagickcore-6.q16-6="$version" \
    libmagickcore-6.q16-6-extra="$version" libmagickwand-6.q16-6="$version" \
    liblqr-1-0=0.4.2-2.1 libfftw3-double3=3.3.10-1 liblcms2-2=2.14-2+deb12u1
libraries="$work/root/usr/lib/x86_64-linux-gnu"
export LD_LIBRARY_PATH="$libraries"
MAGICK_CODER_MODULE_PATH=$(echo "$libraries"/ImageMagick-*/modules-*/coders)
export MAGICK_CODER_MODULE_PATH
export MAGICK_CONFIGURE_PATH="$work/root/etc/ImageMagick-6"
convert="$work/root/usr/bin/convert-im6.q16"
if ! "$convert" -version >/dev/null 2>&1 || ! "$convert" -list format | grep -q ' EXR '; then
    echo "not tried: a library that ImageMagick needs (OpenEXR, GLib, X11, ...) is not installed" >&2
    exit 77
fi

# An OpenEXR file of one row with channels B, G, R, 32-bit floats, not compressed: grey from 1/2 to 1.
python3 - "$work/a.exr" <<'PYTHON'
import struct, sys
count = 4096
values = [0.5 + i / (2 * count) for i in range(count)]
window = struct.pack("<4i", 0, 0, count - 1, 0)
attribute = lambda name, kind, data: (name.encode() + b"\0" + kind.encode() + b"\0" +
                                      struct.pack("<i", len(data)) + data)
channel = lambda name: name + b"\0" + struct.pack("<4i", 2, 0, 1, 1)
header = (struct.pack("<2I", 20000630, 2) +
          attribute("channels", "chlist", b"".join(map(channel, (b"B", b"G", b"R"))) + b"\0") +
          attribute("compression", "compression", b"\0") +
          attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window) +
          attribute("lineOrder", "lineOrder", b"\0") +
          attribute("pixelAspectRatio", "float", struct.pack("<f", 1)) +
          attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)) +
          attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0")
row = struct.pack("<2i", 0, 12 * count) + 3 * struct.pack(f"<{count}f", *values)
open(sys.argv[1], "wb").write(header + struct.pack("<Q", len(header) + 8) + row)
print(len(set(values)), file=open(sys.argv[1] + ".count", "w"))
PYTHON
"$convert" "$work/a.exr" -set colorspace RGB -depth 16 "gray:$work/a.raw"
different=$(python3 - "$work/a.raw" <<'PYTHON'
import array, sys
print(len(set(array.array("H", open(sys.argv[1], "rb").read()))))
PYTHON
)
same "different values in the file" "$(cat "$work/a.exr.count")" 4096
same "different values as ImageMagick reads them" "$different" 1025
holds
