// three-mesh-bvh over three.js: corners in single precision, as its buffers hold them, rays in doubles.
//
//     cd common/corpus/adapters/three && npm install && node ask.js
//
// All numbers of single.toml have single precision; arithmetic is in doubles.

import { readFileSync, writeFileSync, mkdirSync } from 'node:fs';
import { parse } from 'smol-toml';
import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3, REVISION } from 'three';
import { MeshBVH } from 'three-mesh-bvh';

function find({ triangles, under, ray, within: [low, high] }) {
  if (!triangles || under) return undefined;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(triangles.flat(2)), 3));
  const bvh = new MeshBVH(geometry);
  const direction = new Vector3(...ray.direction);
  // Its rays have directions of length 1, and its distances are lengths.
  const length = direction.length();
  const unit = direction.clone().divideScalar(length);
  const hit = bvh.raycastFirst(
    new Ray(new Vector3(...ray.origin), unit), DoubleSide, low * length, high * length);
  return hit ? hit.distance / length : 'miss';
}

const corpus = new URL('../../', import.meta.url);
const { version } = JSON.parse(
  readFileSync(new URL('node_modules/three-mesh-bvh/package.json', import.meta.url)));
const lines = [`# three-mesh-bvh ${version} with three.js r${REVISION}, \`raycastFirst\``, '# single'];
for (const one of parse(readFileSync(new URL('single.toml', corpus), 'utf8')).case) {
  const found = find(one);
  if (found !== undefined) lines.push(`${one.id} ${found}`);
}
mkdirSync(new URL('results', corpus), { recursive: true });
writeFileSync(new URL('results/three-mesh-bvh.txt', corpus), lines.join('\n') + '\n');
console.log(`three-mesh-bvh: ${lines.length - 2}`);
