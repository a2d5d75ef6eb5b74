// Drawn on the floor: outlines of the soles, where the weight shall go (ZMP reference) and where it is falling to (DCM).

import * as THREE from 'three';

const kLift = 0.005; // [m]
const kPoint = 0.015; // half of the square that is drawn for a foot without a sole [m]
const known = (p) => p != null && p.every((v) => v !== null);

function ring(inner, outer, color) {
  const mesh = new THREE.Mesh(new THREE.RingGeometry(inner, outer, 32),
    new THREE.MeshBasicMaterial({ color, depthTest: false, transparent: true }));
  mesh.renderOrder = 10;
  mesh.visible = false;
  return mesh;
}

export class Markers {
  constructor(parent) {
    this.soles = [0, 1, 2, 3, 4, 5].map(() => {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(12), 3));
      const line = new THREE.LineLoop(geometry, new THREE.LineBasicMaterial({ color: 0x8fb3d9, depthTest: false, transparent: true }));
      line.frustumCulled = false;
      line.renderOrder = 8;
      return line;
    });
    this.reference = ring(0.036, 0.041, 0xffffff);
    this.dcm = ring(0.008, 0.02, 0x7cf5d0);
    parent.add(...this.soles, this.reference, this.dcm);
  }

  show(live) {
    this.soles.forEach((line, i) => {
      let corners = live.soles[i];
      if (corners?.length === 1) corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([x, y]) => [corners[0][0] + kPoint * x, corners[0][1] + kPoint * y, corners[0][2]]);
      line.visible = corners?.length === 4;
      if (!line.visible) return;
      corners.forEach((p, k) => line.geometry.attributes.position.setXYZ(k, p[0], p[1], p[2] + 0.002));
      line.geometry.attributes.position.needsUpdate = true;
      line.material.color.set(live.loaded[i] ? 0x58c4ff : 0x8b97a8);
      line.material.opacity = live.loaded[i] ? 1 : 0.5;
    });
    for (const [marker, p] of [[this.reference, live.zmp_reference], [this.dcm, live.dcm]]) {
      marker.visible = known(p) && live.polygon.length > 0;
      if (marker.visible) marker.position.set(p[0], p[1], (p[2] ?? 0) + kLift);
    }
  }
}
