#!/usr/bin/env bash
# Package: povray 1:3.7.0.10-2+b2, Debian 12.
#
# POV-Ray copies a declared union each time that it is used. A scene that builds a fractal as a union of four smaller
# ones, each of them declared once, is a text of a few hundred bytes; for its eight levels POV-Ray holds 65,536 objects
# and 100 MB more than for four, some 1.5 kB for each innermost object, before the first ray.
#
# One expects a declared object to be an instance: it is used by name, with a matrix of its own, and so are meshes,
# whose triangles POV-Ray keeps once for all uses. Hierarchies that share their branches are how other ray tracers hold
# fractals of any depth.
#
# So a small file in this language promises nothing about memory: twenty cubes in cubes, five levels deep, are 3.2
# million objects. pxm says how many objects POV-Ray will make of a file, and leaves the choice of the levels to the user
# (host/export/export_file.cpp, docs/export.md).
#
# Seen on 2026-11-30:
#   bytes of the scene with eight levels                         1659
#   objects that it holds with four levels                       256
#   objects that it holds with eight levels                      65536
#   more than 1,000 bytes for each object more                   yes
set -euo pipefail
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

fetch povray=1:3.7.0.10-2+b2
program povray

write_scene() {
    echo '#version 3.7; global_settings { assumed_gamma 1 } camera { location -4*z look_at 0 } #declare C0 = sphere { 0, 1 }'
    for ((i = 0; i < $1; ++i)); do
        echo "#declare C$((i + 1)) = union {"
        for place in -x-y x-y y z; do echo "object { C$i scale 1/2 translate ($place)/2 }"; done
        echo "}"
    done
    echo "object { C$1 pigment { rgb 1 } }"
}

# render LEVELS: the objects that it reports, and the most kilobytes that it had
render() {
    write_scene "$1" >"$work/scene.pov"
    (cd "$work" && HOME=$work python3 - "$ran" <<'PYTHON'
import re, resource, subprocess, sys
told = subprocess.run([sys.argv[1], "scene.pov", "+W16", "+H16", "-D", "-A", "-F", "+WT1"],
                      capture_output=True, text=True, check=True).stderr
print(re.search(r"Finite Objects:\s*(\d+)", told)[1], resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
PYTHON
    )
}

read -r few few_kilobytes <<<"$(render 4)"
read -r many many_kilobytes <<<"$(render 8)"
same "bytes of the scene with eight levels" "$(wc -c <"$work/scene.pov")" 1659
same "objects that it holds with four levels" "$few" 256
same "objects that it holds with eight levels" "$many" 65536
bytes=$(((many_kilobytes - few_kilobytes) * 1024 / (many - few)))
same "more than 1,000 bytes for each object more" "$([[ $bytes -gt 1000 ]] && echo yes || echo "no: $bytes")" yes
holds
