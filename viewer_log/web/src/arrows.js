// Forces as arrows, seen through the legs; all of one colour are drawn together.

import * as THREE from 'three';
import { plain } from './surface.js';

const kMetresPerNewton = 1 / 1100; // at scale 1
const kLongest = 1.4; // [m]
const kUp = new THREE.Vector3(0, 1, 0);

function material(color) {
  const seen = { color, depthTest: false, transparent: true, opacity: 0.9 };
  return plain ? new THREE.MeshBasicMaterial(seen)
    : new THREE.MeshStandardMaterial({ ...seen, emissive: color, emissiveIntensity: 0.45, roughness: 0.5 });
}

export class Arrows extends THREE.Group {
  constructor(most, color) {
    super();
    const look = material(color);
    const sides = plain ? 6 : 16;
    this.shafts = new THREE.InstancedMesh(new THREE.CylinderGeometry(0.008, 0.008, 1, sides).translate(0, 0.5, 0), look, most);
    this.heads = new THREE.InstancedMesh(new THREE.ConeGeometry(0.022, 0.055, sides).translate(0, 0.0275, 0), look, most);
    for (const part of [this.shafts, this.heads]) {
      part.renderOrder = 9;
      part.frustumCulled = false;
      this.add(part);
    }
    this.show([], 1, 0);
  }

  // rows: place and force, six numbers each; those under `least` newtons are left out.
  show(rows, scale, least) {
    const at = new THREE.Vector3(), force = new THREE.Vector3(), turn = new THREE.Quaternion(), size = new THREE.Vector3();
    const matrix = new THREE.Matrix4();
    let count = 0;
    for (const row of rows) {
      if (count === this.shafts.instanceMatrix.count) break;
      at.fromArray(row, 0);
      force.fromArray(row, 3);
      const length = Math.min(force.length() * kMetresPerNewton * scale, kLongest);
      if (!(length > 0.005) || force.length() < least) continue;
      turn.setFromUnitVectors(kUp, force.normalize());
      this.shafts.setMatrixAt(count, matrix.compose(at, turn, size.set(1, length, 1)));
      this.heads.setMatrixAt(count, matrix.compose(at.addScaledVector(force, length), turn, size.set(1, 1, 1)));
      ++count;
    }
    for (const part of [this.shafts, this.heads]) {
      part.count = count;
      part.visible = count > 0;
      part.instanceMatrix.needsUpdate = true;
    }
  }
}
