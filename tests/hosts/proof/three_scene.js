// Objects that hold a geometry: plain, mirrored, scaled, back, instanced and skinned.
import * as THREE from 'three';

export const SIDE = 256;
const STEP = 31;  // of the pixels that are returned

// Two bones at one place, of which the second is turned: all vertices follow it.
function skinnedMesh(geometry) {
  const count = geometry.attributes.position.count;
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(new Uint16Array(4 * count).fill(0).map((_, i) => i % 4 === 0 ? 1 : 0), 4));
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(new Float32Array(4 * count).map((_, i) => i % 4 === 0 ? 1 : 0), 4));
  const bones = [new THREE.Bone(), new THREE.Bone()];
  bones[0].add(bones[1]);
  const mesh = new THREE.SkinnedMesh(geometry);
  mesh.add(bones[0]);
  mesh.bind(new THREE.Skeleton(bones));
  bones[1].rotation.set(0.3, -0.4, 0.6);
  return [mesh, () => bones[1].matrixWorld.clone()];
}

function instancedMesh(geometry) {
  const mesh = new THREE.InstancedMesh(geometry, undefined, 1);
  const matrix = new THREE.Matrix4().makeRotationX(0.8).scale(new THREE.Vector3(1, 0.7, 1.2));
  mesh.setMatrixAt(0, matrix);
  return [mesh, () => mesh.matrixWorld.clone().multiply(matrix)];
}

export function placed(geometry, object) {
  let mesh = new THREE.Mesh(geometry), world = () => mesh.matrixWorld.clone();
  if (object === 'skinned') [mesh, world] = skinnedMesh(geometry);
  if (object === 'instanced') [mesh, world] = instancedMesh(geometry);
  mesh.rotation.set(0.5, 0.7, 0.2);
  if (object === 'mirrored') mesh.scale.x = -1;
  if (object === 'scaled') mesh.scale.set(1, 0.6, 1.4);
  return [mesh, world];
}

function nearest(geometry, world, eye) {
  const at = new THREE.Vector3(), found = new THREE.Vector3(Infinity);
  for (let i = 0; i < geometry.attributes.position.count; i++) {
    at.fromBufferAttribute(geometry.attributes.position, i).applyMatrix4(world);
    if (at.distanceTo(eye) < found.distanceTo(eye)) found.copy(at);
  }
  return found;
}

// A camera at 4 along z; with a small angle it looks at the nearest vertex.
export function camera(angle, geometry, world) {
  const made = new THREE.PerspectiveCamera(angle, 1, 0.1, 100);
  made.position.set(0, 0, 4);
  if (angle < 10) made.lookAt(nearest(geometry, world, made.position));
  made.updateMatrixWorld(true);
  return made;
}

// For each STEPth covered pixel a list in the order of COLUMNS of three_test.py, then the normal in
// object space, the color and the roughness.
export function points({surface, normals, colors, world, camera}) {
  const toObject = new THREE.Matrix3().setFromMatrix4(
      new THREE.Matrix4().multiplyMatrices(camera.matrixWorldInverse, world)).transpose();
  const eye = camera.position.clone().applyMatrix4(world.clone().invert());
  const found = [];
  for (let i = 0; i < SIDE * SIDE; i += STEP) {
    const of = (key, count) => [...surface[key].slice(4 * i, 4 * i + count)];
    if (surface.position[4 * i + 3] === 0) continue;
    const view = eye.clone().sub(new THREE.Vector3().fromArray(of('position', 3))).normalize();
    const normal = new THREE.Vector3().fromArray(normals, 4 * i).applyMatrix3(toObject).normalize();
    found.push([...of('position', 3), ...of('dx_position', 3), ...of('dy_position', 3),
      ...of('normal', 3), ...of('dx_normal', 3), ...of('dy_normal', 3), ...of('tangent', 4),
      ...of('uv', 4), ...of('dx_uv', 4), ...of('dy_uv', 4), surface.side[4 * i],
      ...view.toArray(), ...normal.toArray(), ...colors.slice(4 * i, 4 * i + 4)]);
  }
  return found;
}
