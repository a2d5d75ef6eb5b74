// The robot from its URDF: primitives or meshes, posed by joint angles in bus order.

import * as THREE from 'three';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import URDFLoader from 'urdf-loader';
import { withToken } from './link.js';
import { drawAsOne } from './one_mesh.js';
import { plain, surface } from './surface.js';
import { Tint, nearLimits } from './tint.js';

const kCrease = 0.8; // faces that meet at less are one round surface [rad]

// The URDF loader's materials are flat; these take light and shadow.  An STL file's faces are flat, too.
function dress(object) {
  object.traverse((part) => {
    if (!part.isMesh) return;
    part.castShadow = true;
    part.receiveShadow = true;
    if (!plain && part.geometry.type === 'BufferGeometry' && !part.geometry.index) part.geometry = toCreasedNormals(part.geometry, kCrease);
    const old = Array.isArray(part.material) ? part.material[0] : part.material;
    if (!old?.isMeshPhongMaterial || old.map) return;
    const dark = old.color.r + old.color.g + old.color.b < 0.6;
    part.material = surface({
      color: old.color, transparent: old.transparent, opacity: old.opacity,
      roughness: dark ? 0.5 : 0.38, metalness: dark ? 0.35 : 0.08,
    });
  });
}

// The robot as it is described; meshes: a promise that is kept when all of them are there.
async function build() {
  const answer = await fetch(withToken('robot.urdf'), { cache: 'no-store' });
  if (!answer.ok) throw new Error(`robot.urdf: ${answer.status}`);
  const text = await answer.text();
  const manager = new THREE.LoadingManager();
  manager.setURLModifier(withToken);
  const loader = new URDFLoader(manager);
  loader.packages = (name) => `/robot/package/${encodeURIComponent(name)}`; // package://NAME/path: the folder that robot.yaml names
  loader.loadMeshCb = (path, meshManager, material, done) => {
    if (!/\.obj$/i.test(path)) { loader.defaultMeshLoader(path, meshManager, material, done); return; }
    new OBJLoader(meshManager).load(path, (object) => {
      object.traverse((part) => { if (part.isMesh && material) part.material = material; });
      done(object);
    }, undefined, (error) => done(null, error));
  };
  loader.workingPath = '/robot/';
  const meshes = new Promise((resolve) => { manager.onLoad = resolve; });
  manager.itemStart('urdf'); // so that the end is told though there be no mesh
  const model = loader.parse(text, '/robot/');
  manager.itemEnd('urdf');
  return { model, meshes };
}

export class Robot {
  constructor(scene) {
    this.scene = scene;
    this.model = null;
    this.joints = [];
    this.whole = false; // with all meshes
    // At once: how the messages order the joints is not needed for it.
    this.begun = build().catch(() => null);
  }

  // joints: names in bus order; ready(model): called when all meshes are there.
  async load(joints, ready) {
    const { begun } = this;
    this.begun = null;
    const { model, meshes } = await begun ?? await build();
    if (this.model) this.scene.remove(this.model);
    this.whole = false;
    this.model = model;
    this.joints = joints.map((name) => model.joints[name] ?? null);
    for (const joint of this.joints) if (joint) joint.ignoreLimits = true; // show what is, not what should be
    this.tint = new Tint();
    this.scene.add(model);
    await meshes;
    dress(model);
    ready(model);
    if (plain) drawAsOne(model); // after ready: ghosts are copies of what it was
    this.whole = this.model === model;
  }

  // Colours for what is about to touch or at its limit; returns the joints near a limit.
  warn(q, pairs) {
    if (!this.model) return [];
    const limits = nearLimits(this.joints, q);
    this.tint.show(this.model, pairs, limits);
    return limits;
  }

  // base: x y z, quaternion w x y z.
  pose(q, base) {
    if (!this.model) return;
    this.model.position.set(base[0], base[1], base[2]);
    this.model.quaternion.set(base[4], base[5], base[6], base[3]);
    q.forEach((angle, i) => this.joints[i]?.setJointValue(angle ?? 0));
  }

  // A robot that nobody drives is shown pale.
  dim(pale) {
    if (!this.model || this.pale === pale) return;
    this.pale = pale;
    this.model.traverse((part) => {
      if (!part.isMesh) return;
      part.material.transparent = pale;
      part.material.opacity = pale ? 0.45 : 1;
    });
  }
}
