// Exports of cubes.pxm at level 3 in the eyes of others: no error for the validator, and for three.js
// 27 cells, instances or not, in the box of the PLY file with z turned over, with colours.
import assert from 'node:assert';
import fs from 'node:fs';
import path from 'node:path';
import validator from 'gltf-validator';
import * as THREE from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';

globalThis.self ??= globalThis;
globalThis.ProgressEvent ??= class {};
const folder = process.argv[2];
const cells = 27;
const bytes = (name) => {
  const data = fs.readFileSync(path.join(folder, name));
  return data.buffer.slice(data.byteOffset, data.byteOffset + data.length);
};

const ply = new PLYLoader().parse(bytes('cubes.ply'));
ply.computeBoundingBox();
const { min, max } = ply.boundingBox;
const expected = new THREE.Box3(new THREE.Vector3(min.x, min.y, -max.z), new THREE.Vector3(max.x, max.y, -min.z));

for (const name of ['instances.glb', 'geometry.glb']) {
  const report = await validator.validateBytes(new Uint8Array(bytes(name)));
  assert.equal(report.issues.numErrors, 0, JSON.stringify(report.issues.messages));
  const { scene } = await new GLTFLoader().parseAsync(bytes(name), '');
  scene.updateMatrixWorld(true);
  const box = new THREE.Box3();
  const colors = new Set();
  let triangles = 0;
  scene.traverse((thing) => {
    if (!thing.isMesh) return;
    const { position, color } = thing.geometry.attributes;
    const copies = thing.isInstancedMesh ? thing.count : 1;
    assert.equal(thing.isInstancedMesh ?? false, name === 'instances.glb');
    triangles += (copies * thing.geometry.index.count) / 3;
    const place = new THREE.Matrix4();
    for (let i = 0; i < copies; i += 1) {
      if (thing.isInstancedMesh) {
        thing.getMatrixAt(i, place);
        const { array } = thing.instanceColor;
        colors.add([0, 1, 2].map((k) => array[3 * i + k].toFixed(2)).join());
      }
      place.premultiply(thing.matrixWorld);
      for (let v = 0; v < position.count; v += 1) box.expandByPoint(new THREE.Vector3().fromBufferAttribute(position, v).applyMatrix4(place));
    }
    for (let v = 0; color && v < color.count; v += 1) colors.add([color.getX(v), color.getY(v), color.getZ(v)].map((c) => c.toFixed(2)).join());
  });
  assert.equal(triangles, cells * 12, name);
  assert.ok(box.min.distanceTo(expected.min) < 1e-5 && box.max.distanceTo(expected.max) < 1e-5, `${name}: ${JSON.stringify(box)}`);
  assert.deepEqual([...colors].sort(), ['0.10,0.20,0.70', '0.10,0.60,0.30', '0.80,0.10,0.20'], name);
}
console.log('gltf: valid, and 27 cells in their box with their colours for three.js');
