#!/usr/bin/env bash
# Packages: assimp-utils, libassimp5 5.2.5~ds0-1+b1, Debian 12.
#
# A glTF file names in `extensionsRequired` what a reader must know to show it. Assimp reads a file that requires
# EXT_mesh_gpu_instancing, of which it knows nothing, without a word: of a mesh with three places it makes the mesh once,
# where it was made, and ends with 0.
#
# One expects a refusal, or a warning at least: that is what the list of required extensions is for, beside that of
# those that are merely used.
#
# So a file of thousands of cells opens as one cell there, and nothing tells the user. pxm writes triangles instead of
# places with `pxm export --geometry` and says so beside the formats (docs/export.md, host/commands/cmd_export.cpp).
#
# Seen on 2026-12-01:
#   exit code                                                    0
#   vertices that are read, of three triangles                   3
#   words about the extension                                    0
set -euo pipefail
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

fetch assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1
program assimp

python3 - "$work/three.gltf" <<'PYTHON'
import base64, json, struct, sys
triangle = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
places = struct.pack("<9f", 0, 0, 0, 5, 0, 0, 0, 5, 0)
data = triangle + places
json.dump({
    "asset": {"version": "2.0"},
    "extensionsUsed": ["EXT_mesh_gpu_instancing"], "extensionsRequired": ["EXT_mesh_gpu_instancing"],
    "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36}],
    "buffers": [{"byteLength": 72, "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
}, open(sys.argv[1], "w"))
PYTHON
code=0
"$ran" info "$work/three.gltf" >"$work/told" 2>&1 || code=$?
same "exit code" "$code" 0
same "vertices that are read, of three triangles" "$(awk '/^Vertices:/ { print $2 }' "$work/told")" 3
same "words about the extension" "$(grep -ciE 'extension|instanc' "$work/told" || true)" 0
holds
