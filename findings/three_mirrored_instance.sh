#!/usr/bin/env bash
# three 0.170.0 (npm), in Chromium by its software renderer.
#
# A mesh whose matrix mirrors (a negative determinant) has its triangles the other way round on the screen. three.js
# notices and turns the front over, so that a mirrored Mesh shows the same faces as before. Of an InstancedMesh it looks
# at the matrix of the whole alone: an instance that mirrors is culled where it should be seen, and shows its inside
# where it is closed. A good engineer expects an instance of a mesh to look as that mesh does with the same matrix.
#
# For a program that writes instances (EXT_mesh_gpu_instancing, which three.js loads as an InstancedMesh): mark the
# material of mirrored cells as two-sided, or write their triangles. pxm marks it (host/export/gltf_json.cpp).
#
# Seen on 2026-12-01, pixels of 64x64 that a square of 32x32 covers:
#   a mesh                                                       1024
#   ... mirrored                                                 1024
#   an instance                                                  1024
#   ... mirrored                                                 0
#   ... mirrored, of a two-sided material                        1024
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

for tool in npm chromium; do
    command -v $tool >/dev/null || { echo "not tried: $tool is not installed" >&2; exit 77; }
done
cd "$work"
npm pack --silent three@0.170.0 >/dev/null 2>log || { cat log >&2; echo "not tried: three cannot be fetched" >&2; exit 77; }
tar -xzf three-0.170.0.tgz package/build/three.cjs

cat >counts.js <<'JS'
const T = module.exports;
function covered(thing) {
  const renderer = new T.WebGLRenderer({ antialias: false });
  const camera = new T.OrthographicCamera(-2, 2, 2, -2, 1, 9);
  camera.position.z = 5;
  const scene = new T.Scene(), target = new T.WebGLRenderTarget(64, 64);
  scene.add(thing);
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const bytes = new Uint8Array(4 * 64 * 64);
  renderer.readRenderTargetPixels(target, 0, 0, 64, 64, bytes);
  return bytes.filter((byte, i) => i % 4 === 0 && byte > 127).length;
}
const square = new T.PlaneGeometry(2, 2);
function mesh(x) {
  const made = new T.Mesh(square, new T.MeshBasicMaterial());
  made.scale.x = x;
  return made;
}
function instance(x, side = T.FrontSide) {
  const made = new T.InstancedMesh(square, new T.MeshBasicMaterial({ side }), 1);
  made.setMatrixAt(0, new T.Matrix4().makeScale(x, 1, 1));
  return made;
}
document.body.textContent = 'covered ' +
  [mesh(1), mesh(-1), instance(1), instance(-1), instance(-1, T.DoubleSide)].map(covered).join(' ');
JS
{
    echo '<!doctype html><body><script>var module = { exports: {} }, exports = module.exports;</script><script>'
    cat package/build/three.cjs
    echo '</script><script>'
    cat counts.js
    echo '</script>'
} >page.html
chromium --headless --no-sandbox --user-data-dir="$work/profile" --use-angle=swiftshader --enable-unsafe-swiftshader \
    --dump-dom "file://$work/page.html" >dom 2>log || { tail -3 log >&2; echo "not tried: chromium does not start" >&2; exit 77; }
read -r _ mesh mirrored instance lost both < <(grep -ao 'covered [0-9 ]*' dom | tail -1) || {
    echo "not tried: chromium has no WebGL here" >&2
    exit 77
}
same "a mesh" "$mesh" 1024
same "... mirrored" "$mirrored" 1024
same "an instance" "$instance" 1024
same "... mirrored" "$lost" 0
same "... mirrored, of a two-sided material" "$both" 1024
holds
