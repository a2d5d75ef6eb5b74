// What stands, lies and moves around the robot: obstacles, terrain, loose bodies, what hands hold, and the footsteps to come.

import * as THREE from 'three';
import { plain, surface } from './surface.js';

const kRound = plain ? 16 : 32; // corners of what is round
const kHeld = 0xff8a5c;
const kSole = 0x58c4ff, kWay = 0xffffff;
const kTiles = [0x6f8195, 0x62748a, 0x7b8ca0];

function geometryOf({ shape, size: [a, b, c] }) {
  if (shape === 1) return new THREE.BoxGeometry(a, b, c);
  if (shape === 2) return new THREE.SphereGeometry(a, kRound, kRound / 2);
  if (shape === 3) return new THREE.CylinderGeometry(a, a, b, kRound).rotateX(Math.PI / 2); // along z, as in URDF
  return null;
}

function place(object, pose) {
  object.position.set(pose[0], pose[1], pose[2]);
  object.quaternion.set(pose[4], pose[5], pose[6], pose[3]);
}

function fill(group, list, materialOf) {
  for (const old of group.children) old.geometry.dispose();
  group.clear();
  list.forEach((item, i) => {
    const geometry = geometryOf(item);
    const mesh = geometry ? new THREE.Mesh(geometry, materialOf(i)) : new THREE.Mesh();
    mesh.castShadow = mesh.receiveShadow = true;
    place(mesh, item.pose);
    group.add(mesh); // also what is unknown, so that the order stays
  });
}

export class Shapes {
  constructor(scene) {
    this.obstacles = new THREE.Group();
    this.terrain = new THREE.Group();
    this.loose = new THREE.Group();
    this.held = new THREE.Group();
    this.steps = new THREE.Group();
    scene.add(this.obstacles, this.terrain, this.loose, this.held, this.steps);
    this.grip = new THREE.LineBasicMaterial({ color: kHeld, depthTest: false });
    this.wood = surface({ color: 0xc98a3c, roughness: 0.7, transparent: true, opacity: 0.88 });
    this.ground = surface({ color: 0xffffff, roughness: 0.95 });
    this.bodies = [0xd9a441, 0x5fa777, 0xb9695d, 0x8d7fc2].map((color) => surface({ color, roughness: 0.6 }));
    this.sole = new THREE.MeshBasicMaterial({ color: kSole, transparent: true, opacity: 0.35, depthTest: false });
    this.next = new THREE.MeshBasicMaterial({ color: kSole, transparent: true, opacity: 0.7, depthTest: false });
    this.dot = new THREE.MeshBasicMaterial({ color: kWay, transparent: true, opacity: 0.9, depthTest: false });
    this.box = new THREE.BoxGeometry(1, 1, 1);
    this.ball = new THREE.SphereGeometry(1, 8, 6);
  }

  // A scene message.
  show({ obstacles, terrain = [], loose = [], held = [] }) {
    fill(this.obstacles, obstacles, () => this.wood);
    this.lay(terrain);
    fill(this.loose, loose, (i) => this.bodies[i % this.bodies.length]);
    for (const old of this.held.children) old.geometry.dispose();
    this.held.clear();
    for (const item of held) {
      const geometry = geometryOf(item);
      if (!geometry) continue;
      const edges = new THREE.LineSegments(new THREE.EdgesGeometry(geometry), this.grip); // the body itself may be drawn, too
      geometry.dispose();
      edges.renderOrder = 11;
      place(edges, item.pose);
      edges.updateMatrix();
      edges.userData = { link: item.link, inLink: edges.matrix.clone() };
      edges.matrixAutoUpdate = false;
      this.held.add(edges);
    }
  }

  // What is held goes with the robot as it is drawn.
  carry(model) {
    for (const edges of this.held.children) {
      const link = model?.links[edges.userData.link];
      edges.visible = link !== undefined;
      if (!link) continue;
      link.updateWorldMatrix(true, false);
      edges.matrix.multiplyMatrices(link.matrixWorld, edges.userData.inLink);
    }
  }

  // Tiles are many, and boxes: drawn in one go.
  lay(tiles) {
    for (const old of this.terrain.children) old.dispose();
    this.terrain.clear();
    if (tiles.length === 0) return;
    const all = new THREE.InstancedMesh(this.box, this.ground, tiles.length);
    const at = new THREE.Object3D(), color = new THREE.Color();
    tiles.forEach(({ size, pose }, i) => {
      place(at, pose);
      at.scale.set(...size);
      at.updateMatrix();
      all.setMatrixAt(i, at.matrix);
      all.setColorAt(i, color.set(kTiles[i % kTiles.length]));
    });
    all.receiveShadow = true;
    all.frustumCulled = false;
    this.terrain.add(all);
  }

  // A live message: loose bodies and footsteps; without any the steps are gone and the bodies lie where they lay.
  move({ loose, footsteps = [] }) {
    loose?.forEach((pose, i) => { if (this.loose.children[i]) place(this.loose.children[i], pose); });
    while (this.steps.children.length < footsteps.length) this.steps.add(new THREE.Mesh(this.box, this.sole));
    this.steps.children.forEach((mesh, i) => {
      const item = footsteps[i];
      mesh.visible = item !== undefined;
      if (!item) return;
      const [a, b, c] = item.size, box = item.shape === 1;
      mesh.geometry = box ? this.box : this.ball;
      mesh.material = !box ? this.dot : i === 0 ? this.next : this.sole;
      if (box) mesh.scale.set(a, b, c); else mesh.scale.setScalar(a);
      mesh.renderOrder = box ? 6 : 9;
      place(mesh, item.pose);
    });
  }
}
