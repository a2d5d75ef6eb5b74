// A robot drawn in one go: a processor that draws spends longer on beginning sixty small shapes, and on the corners of
// round ones, than on filling them.

import * as THREE from 'three';

const kAlike = 0.7;  // cosine between the normals of one corner
const kMost = 100;   // shapes; so many matrices every WebGL 2 can take

// Light from the sky and one sun, once per corner of a triangle; a pixel is then only filled.
const kVertex = `
  uniform mat4 onScreen[PARTS];
  uniform mat3 turned[PARTS];
  uniform vec3 tone[PARTS];
  attribute float part;
  varying vec3 shade;
  void main() {
    int i = int(part);
    vec3 n = turned[i] * normal;
    shade = tone[i] * (0.42 + 0.16 * n.z + 0.62 * max(0.0, dot(n, vec3(0.423, -0.308, 0.852))));
    gl_Position = onScreen[i] * vec4(position, 1.0);
  }`;
const kFragment = `
  uniform float cover;
  varying vec3 shade;
  void main() {
    gl_FragColor = vec4(shade, cover);
    #include <colorspace_fragment>
  }`;

const kNowhere = new THREE.Matrix4().makeScale(0, 0, 0); // of a shape that is not drawn

const kBall = new THREE.SphereGeometry(1, 10, 7), kCylinder = new THREE.CylinderGeometry(1, 1, 1, 12);
function coarse(geometry) {
  return geometry.type === 'SphereGeometry' ? kBall : geometry.type === 'CylinderGeometry' ? kCylinder : geometry;
}

// The link or joint that carries a shape: it turns and moves, and scales nothing.
function carrier(part) {
  let at = part;
  while (at.parent && !at.isURDFLink && !at.isURDFJoint && !at.isURDFRobot) at = at.parent;
  return at;
}

// Corners of one place whose normals are alike are one corner: an STL file has each six times.
class Corners {
  constructor() {
    this.position = [];
    this.normal = []; // sums
    this.part = [];
    this.index = [];
  }

  add(geometry, part) {
    const known = new Map(); // place -> corners there
    const { position: { array: p }, normal: { array: n } } = geometry.attributes;
    const fine = (v) => Math.round(1e5 * v) + 65536;
    const corner = (k) => {
      const i = 3 * k;
      const key = (fine(p[i]) * 131072 + fine(p[i + 1])) * 131072 + fine(p[i + 2]); // of places near one another none has it twice
      let here = known.get(key);
      if (!here) known.set(key, here = []);
      let found = here.find((at) => this.alike(3 * at, p, n, i));
      if (found === undefined) {
        found = this.part.length;
        here.push(found);
        this.position.push(p[i], p[i + 1], p[i + 2]);
        this.normal.push(0, 0, 0);
        this.part.push(part + 0.5);
      }
      for (let axis = 0; axis < 3; ++axis) this.normal[3 * found + axis] += n[i + axis];
      return found;
    };
    const count = geometry.index?.count ?? p.length / 3;
    for (let k = 0; k < count; ++k) this.index.push(corner(geometry.index ? geometry.index.getX(k) : k));
  }

  // Whether the corner of ours at `at` is in the place of theirs at i and looks the same way.
  alike(at, p, n, i) {
    const { position: q, normal: m } = this;
    if (Math.abs(q[at] - p[i]) + Math.abs(q[at + 1] - p[i + 1]) + Math.abs(q[at + 2] - p[i + 2]) > 1e-3) return false;
    return m[at] * n[i] + m[at + 1] * n[i + 1] + m[at + 2] * n[i + 2] > kAlike * Math.hypot(m[at], m[at + 1], m[at + 2]);
  }

  geometry() {
    for (let i = 0; i < this.normal.length; i += 3) {
      const length = Math.hypot(this.normal[i], this.normal[i + 1], this.normal[i + 2]) || 1;
      for (let axis = 0; axis < 3; ++axis) this.normal[i + axis] /= length;
    }
    const all = new THREE.BufferGeometry();
    all.setAttribute('position', new THREE.Float32BufferAttribute(this.position, 3));
    all.setAttribute('normal', new THREE.Float32BufferAttribute(this.normal, 3));
    all.setAttribute('part', new THREE.Float32BufferAttribute(this.part, 1));
    all.setIndex(this.index);
    return all;
  }
}

// The same for a robot and its ghosts, which share their shapes.
let last = { of: '', geometry: null };
function joined(parts, carriers) {
  const of = parts.map((mesh) => mesh.geometry.uuid).join();
  if (last.of === of) return last.geometry;
  const corners = new Corners();
  parts.forEach((mesh, i) => {
    const geometry = coarse(mesh.geometry).clone();
    if (!geometry.attributes.normal) geometry.computeVertexNormals();
    geometry.applyMatrix4(carriers[i].matrixWorld.clone().invert().multiply(mesh.matrixWorld));
    corners.add(geometry, i);
  });
  last = { of, geometry: corners.geometry() };
  return last.geometry;
}

// Takes over the drawing of every mesh below model: their places, colours and opacity are followed.  Does nothing where
// there are too many.
export function drawAsOne(model, { depthWrite = true } = {}) {
  const parts = [];
  model.traverse((part) => { if (part.isMesh) parts.push(part); });
  if (parts.length === 0 || parts.length > kMost) return;
  model.updateMatrixWorld(true);
  const carriers = parts.map(carrier);
  const onScreen = parts.map(() => new THREE.Matrix4()), turned = parts.map(() => new THREE.Matrix3());
  const tone = parts.map(() => new THREE.Vector3()), glow = new THREE.Vector3();
  const seen = new THREE.Matrix4();
  const one = new THREE.Mesh(joined(parts, carriers), new THREE.ShaderMaterial({
    defines: { PARTS: parts.length }, vertexShader: kVertex, fragmentShader: kFragment, depthWrite,
    uniforms: { onScreen: { value: onScreen }, turned: { value: turned }, tone: { value: tone }, cover: { value: 1 } },
  }));
  one.drawsAll = true;
  one.frustumCulled = false;
  one.onBeforeRender = (renderer, scene, camera) => {
    seen.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    parts.forEach(({ material: { color, emissive, emissiveIntensity } }, i) => {
      if (parts[i].visible) onScreen[i].multiplyMatrices(seen, carriers[i].matrixWorld);
      else onScreen[i].copy(kNowhere);
      turned[i].setFromMatrix4(carriers[i].matrixWorld);
      tone[i].set(color.r, color.g, color.b);
      if (emissive) tone[i].add(glow.set(emissive.r, emissive.g, emissive.b).multiplyScalar(emissiveIntensity));
    });
    const first = parts[0].material;
    one.material.transparent = first.transparent;
    one.material.uniforms.cover.value = first.opacity;
    one.material.uniformsNeedUpdate = true;
  };
  for (const part of parts) part.layers.disableAll(); // still posed, no longer drawn
  model.add(one);
}
