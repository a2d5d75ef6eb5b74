// A pair of links on the robot: a line between them, and two links that are chosen by clicking at them in the picture.
//
// The line lies between the nearest points where the guard reports the pair, else it is dashed between the middles of the links.

import * as THREE from 'three';

const kClick = 4; // a pointer that moved less was not pulling [pixels]
const kGuard = 0xffb020, kUnknown = 0xd58cff;

// What of the link itself is drawn, without what hangs on it by joints that move.
function meshesOf(link) {
  const found = [];
  const walk = (object) => {
    if (object.isMesh && !object.drawsAll) found.push(object);
    for (const child of object.children) if (!child.isURDFJoint || child.jointType === 'fixed') walk(child);
  };
  walk(link);
  return found;
}

export class PairLine {
  constructor(stage, canvas, robot) {
    Object.assign(this, { stage, canvas, robot, pair: null, picked: null });
    this.ray = new THREE.Raycaster();
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(6), 3));
    const look = { depthTest: false, transparent: true };
    this.line = new THREE.Line(geometry, new THREE.LineDashedMaterial({ color: kUnknown, dashSize: 0.02, gapSize: 0.012, ...look }));
    this.ends = [0, 1].map(() => new THREE.Mesh(new THREE.SphereGeometry(0.009, 12, 8), new THREE.MeshBasicMaterial({ color: kUnknown, ...look })));
    this.group = new THREE.Group();
    this.group.visible = false;
    this.group.add(this.line, ...this.ends);
    for (const part of this.group.children) { part.frustumCulled = false; part.renderOrder = 14; }
    stage.scene.add(this.group);
    canvas.addEventListener('pointerdown', (event) => { this.pressed = [event.clientX, event.clientY]; }, true);
    canvas.addEventListener('pointerup', (event) => this.up(event), true);
  }

  // pair: two names of links, or null for none.
  show(pair) { this.pair = pair; }

  // taken(first, second): at every click at one of the links, second is null at the first one; null ends it.
  pick(taken, links = []) {
    this.known = new Set(links);
    this.taken = taken;
    this.picked = null;
    document.body.classList.toggle('picking', taken !== null);
  }

  up(event) {
    if (!this.taken || event.button !== 0) return;
    event.stopImmediatePropagation(); // it chooses nothing else
    const [x, y] = this.pressed ?? [Infinity, 0];
    if (Math.hypot(event.clientX - x, event.clientY - y) >= kClick) return;
    const link = this.linkAt(event);
    if (!link || link === this.picked) return;
    const first = this.picked;
    this.picked = link;
    this.taken(first ?? link, first ? link : null);
    if (first) this.pick(null);
  }

  // The moving link in front; null where none is.
  linkAt(event) {
    const box = this.canvas.getBoundingClientRect();
    this.ray.setFromCamera(new THREE.Vector2(2 * (event.clientX - box.x) / box.width - 1, 1 - 2 * (event.clientY - box.y) / box.height), this.stage.camera);
    const hits = [];
    this.robot.model?.traverse((part) => { if (part.isMesh && !part.drawsAll) part.raycast(this.ray, hits); }); // also what drawAsOne draws
    hits.sort((a, b) => a.distance - b.distance);
    let at = hits[0]?.object;
    while (at && !(at.isURDFLink && this.known.has(at.urdfName))) at = at.parent; // what robot.yaml fixes belongs to the link before it
    return at?.urdfName ?? null;
  }

  middle(name) {
    const box = new THREE.Box3();
    const link = this.robot.model?.links[name];
    if (!link) return null;
    for (const mesh of meshesOf(link)) box.expandByObject(mesh);
    return box.isEmpty() ? link.getWorldPosition(new THREE.Vector3()) : box.getCenter(new THREE.Vector3());
  }

  // near: pairs that the guard reports.
  tick(near) {
    const [a, b] = this.pair ?? [];
    const told = near.find((pair) => (pair.a === a && pair.b === b) || (pair.a === b && pair.b === a));
    const ends = told ? [told.from, told.to].map((p) => new THREE.Vector3(...p)) : [this.middle(a), this.middle(b)];
    this.group.visible = this.pair !== null && ends.every(Boolean);
    if (!this.group.visible) return;
    ends.forEach((end, i) => {
      this.line.geometry.attributes.position.setXYZ(i, end.x, end.y, end.z);
      this.ends[i].position.copy(end);
    });
    this.line.geometry.attributes.position.needsUpdate = true;
    this.line.computeLineDistances();
    this.line.material.gapSize = told ? 0 : 0.012;
    for (const { material } of this.group.children) material.color.set(told ? kGuard : kUnknown);
  }
}
