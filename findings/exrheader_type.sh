#!/usr/bin/env bash
# openexr 3.1.5-5, libopenexr-3-1-30 3.1.5-5 (Debian 12).
#
# exrheader shows an attribute `type` with the value "scanlineimage" for a file that holds no such attribute: the library
# adds it to the headers of files with one part when it opens them, as files of several parts must have it. A good
# engineer takes the tool for one that prints what is in the file, and compares two writers by its output: there the two
# files are the same, and differ by the 29 bytes of an attribute in which one of them says what the other leaves out.
#
# For a program: two headers are compared by their bytes. pxm's files have no `type`, as those of OpenImageIO have none
# (host/openexr/exr_output.cpp, tests/host/output/exr_test.cpp).
#
# Seen on 2026-11-30:
#   bytes that say "scanlineimage" in the file                   0
#   lines of exrheader that say it                               1
#   bytes that the attribute takes in a file that has it         29
#   exrheader's lines of the two files                           the same
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

command -v python3 >/dev/null || { echo "not tried: no python3" >&2; exit 77; }
fetch openexr=3.1.5-5 libopenexr-3-1-30=3.1.5-5
program exrheader

# One pixel of one channel, not compressed, with the attributes that every file must have.
cat >"$work/pixel.py" <<'PY'
import struct, sys

def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value

box = struct.pack("<4i", 0, 0, 0, 0)
channel = b"R\0" + struct.pack("<iBxxxii", 2, 0, 1, 1) + b"\0"
head = b"".join([struct.pack("<ii", 20000630, 2),
                 attribute("channels", "chlist", channel),
                 attribute("compression", "compression", b"\0"),
                 attribute("dataWindow", "box2i", box),
                 attribute("displayWindow", "box2i", box),
                 attribute("lineOrder", "lineOrder", b"\0"),
                 attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
                 attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)),
                 attribute("screenWindowWidth", "float", struct.pack("<f", 1)),
                 attribute("type", "string", b"scanlineimage") if sys.argv[1:] else b"",
                 b"\0"])
row = struct.pack("<iif", 0, 4, 0.5)
sys.stdout.buffer.write(head + struct.pack("<q", len(head) + 8) + row)
PY
python3 "$work/pixel.py" >"$work/without.exr"
python3 "$work/pixel.py" type >"$work/with.exr"

said() { (cd "$work" && cp "$1.exr" pixel.exr && "$ran" pixel.exr); }
same 'bytes that say "scanlineimage" in the file' "$(grep -c scanlineimage "$work/without.exr" || true)" 0
same 'lines of exrheader that say it' "$(said without | grep -c scanlineimage)" 1
same 'bytes that the attribute takes in a file that has it' \
    $(( $(stat -c %s "$work/with.exr") - $(stat -c %s "$work/without.exr") )) 29
same "exrheader's lines of the two files" "$([[ $(said without) == "$(said with)" ]] && echo "the same" || echo different)" \
    "the same"
holds
