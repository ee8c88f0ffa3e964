#!/usr/bin/env bash
# assimp-utils, libassimp5 5.2.5~ds0-1+b1 (Debian 12).
#
# A glTF file names in `extensionsRequired` what a reader must know to load it. assimp loads one that requires an
# extension that it does not know, or that nobody knows, says nothing of it and ends with 0: of two instances
# (EXT_mesh_gpu_instancing) it has one, at the place where none is. A good engineer expects a file that requires what
# is not there to be refused, for that is what sets the list apart from `extensionsUsed`.
#
# For a program: count what a converter of this kind has read before trusting it with instances, and give it geometry.
# pxm names the extension as required nevertheless (host/export/gltf_json.cpp), and says so in docs/export.md.
#
# Seen on 2026-12-01:
#   two instances at x = 0 and 5: nodes                          1
#   ... their largest x                                          1.000000
#   ... exit code                                                0
#   EXT_no_such_thing required: vertices                         3
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

fetch assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 libminizip1=1.1-8+deb12u1
program assimp

# A triangle, and two places: little-endian floats and whole numbers.
one='\x00\x00\x80\x3f' nought='\x00\x00\x00\x00' five='\x00\x00\xa0\x40'
printf '%b' "$nought$nought$nought$one$nought$nought$nought$one$nought" \
    "$nought"'\x01\x00\x00\x00\x02\x00\x00\x00' "$nought$nought$nought$five$nought$nought" >"$work/a.bin"
gltf() {
    cat >"$work/$1.gltf" <<JSON
{"asset": {"version": "2.0"}, "extensionsUsed": ["$1"], "extensionsRequired": ["$1"],
 "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0, "extensions": {"$1": {"attributes": {"TRANSLATION": 2}}}}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
 "accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
  {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"},
  {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 12},
  {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
 "buffers": [{"byteLength": 72, "uri": "a.bin"}]}
JSON
}
gltf EXT_mesh_gpu_instancing
gltf EXT_no_such_thing

status=0
(cd "$work" && "$ran" info EXT_mesh_gpu_instancing.gltf >instances 2>&1) || status=$?
(cd "$work" && "$ran" info EXT_no_such_thing.gltf >nothing 2>&1) || true
number() { grep -a "^$2" "$work/$1" | grep -aoE '[-0-9.]+' | head -1; }
same "two instances at x = 0 and 5: nodes" "$(number instances Nodes:)" 1
same "... their largest x" "$(number instances 'Maximum point')" 1.000000
same "... exit code" "$status" 0
same "EXT_no_such_thing required: vertices" "$(number nothing Vertices:)" 3
holds
