// Soles, hands and IMU as robot.yaml places them, drawn on the robot, and moved with the mouse.
//
// A limb is { kind, side, frame, at, rpy, edges }: its own frame lies in the link `frame` of the URDF at `at` [m], turned by roll, pitch, yaw
// [rad]; edges of a sole are metres from there.  The handles work in that link while the robot moves.

import * as THREE from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';

const kColors = { sole: 0x58c4ff, hand: 0x7cf5d0, imu: 0xffd23f };
const kWays = { front: [0, 1], back: [0, -1], left: [1, 1], right: [1, -1] }; // axis and sign of an edge
const kLeast = 1e-3, kMost = 1; // of an edge [m]
const kClick = 4; // a pointer that moved less was not pulling [pixels]
const kUndo = 100; // steps
const kNear = 0.9; // from the camera to what it looks at [m], of a robot of the usual size

export const limbName = ({ kind, side }) => (kind === 'imu' ? 'IMU' : `${side} ${kind}`);
const fine = (value) => Number(value.toFixed(5)) + 0;
const onTop = (options) => ({ depthTest: false, transparent: true, ...options });

function label(text) {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [256, 64];
  const pen = canvas.getContext('2d');
  Object.assign(pen, { font: '600 34px system-ui, sans-serif', textAlign: 'center', textBaseline: 'middle', lineWidth: 8, lineJoin: 'round', strokeStyle: '#10161f', fillStyle: '#fff' });
  pen.strokeText(text, 128, 32);
  pen.fillText(text, 128, 32);
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial(onTop({ map: new THREE.CanvasTexture(canvas), sizeAttenuation: false })));
  sprite.scale.set(0.1, 0.025, 1);
  sprite.center.set(0.5, -0.4);
  sprite.renderOrder = 15;
  return sprite;
}

function axes(length) {
  const lines = new THREE.AxesHelper(length);
  Object.assign(lines.material, onTop({}));
  lines.renderOrder = 14;
  return lines;
}

export class Limbs {
  // changed(): something of a limb is another, or another is chosen.
  constructor(stage, canvas, robot, changed) {
    Object.assign(this, { stage, canvas, robot, changed, list: [], chosen: null, past: [], mode: 'translate', knob: null });
    this.ray = new THREE.Raycaster();
    this.root = new THREE.Group();
    this.root.visible = false;
    stage.scene.add(this.root);
    canvas.addEventListener('pointerdown', (event) => this.down(event), true);
    canvas.addEventListener('pointermove', (event) => this.pull(event), true);
    canvas.addEventListener('pointerup', (event) => this.up(event), true);
    canvas.addEventListener('pointercancel', () => { this.knob = this.pressed = null; }, true);
  }

  get shown() { return this.root.visible; }

  show(on) {
    this.root.visible = on;
    this.hold();
  }

  // list: of limbs, which are changed in place from now on.
  set(list) {
    this.original ??= JSON.stringify(list);
    this.root.clear();
    this.list = list;
    this.past = [];
    this.chosen = null;
    this.drawn = new Map(list.map((limb) => [limb, this.draw(limb)]));
    this.place();
    this.hold();
  }

  draw(limb) {
    const size = this.stage.first.scale, color = kColors[limb.kind];
    const carrier = new THREE.Group(), handle = new THREE.Group();
    carrier.matrixAutoUpdate = false;
    handle.rotation.order = 'ZYX'; // roll, pitch, yaw of URDF
    const shape = { sole: () => new THREE.PlaneGeometry(1, 1), hand: () => new THREE.SphereGeometry(0.018 * size, 16, 12), imu: () => new THREE.BoxGeometry(0.05 * size, 0.04 * size, 0.02 * size) }[limb.kind]();
    const body = new THREE.Mesh(shape, new THREE.MeshBasicMaterial(onTop({ color, opacity: 0.5, side: THREE.DoubleSide, depthWrite: false })));
    body.renderOrder = 13;
    const rim = new THREE.LineSegments(new THREE.EdgesGeometry(shape, 40), new THREE.LineBasicMaterial(onTop({ color })));
    rim.renderOrder = 14;
    body.add(rim);
    handle.add(body, axes(0.07 * size), label(limbName(limb)));
    const knobs = Object.keys(limb.edges ? kWays : {}).map((edge) => {
      const knob = new THREE.Mesh(new THREE.SphereGeometry(0.014 * size, 16, 12), new THREE.MeshBasicMaterial(onTop({ color: 0xffffff })));
      knob.renderOrder = 16;
      knob.edge = edge;
      return knob;
    });
    for (const knob of knobs) handle.add(knob);
    carrier.add(handle);
    this.root.add(carrier);
    return { carrier, handle, body, knobs };
  }

  // The drawing as the numbers are.
  place() {
    for (const [limb, { handle, body, knobs }] of this.drawn ?? []) {
      handle.position.set(...limb.at);
      handle.rotation.set(...limb.rpy, 'ZYX');
      const chosen = limb === this.chosen;
      body.material.opacity = chosen ? 0.75 : 0.35;
      for (const knob of knobs) {
        const [axis, sign] = kWays[knob.edge];
        knob.visible = chosen && this.mode === 'size';
        knob.position.set(0, 0, 0).setComponent(axis, sign * limb.edges[knob.edge]);
      }
      if (!limb.edges) continue;
      const { front, back, left, right } = limb.edges;
      body.scale.set(front + back, left + right, 1);
      body.position.set((front - back) / 2, (left - right) / 2, 0);
    }
  }

  choose(limb) {
    this.chosen = limb;
    if (this.mode === 'size' && !limb?.edges) this.mode = 'translate';
    this.place();
    this.hold();
    this.changed();
  }

  // Where the chosen one is; the camera goes near it.
  look() {
    const { controls, camera, first } = this.stage;
    const at = this.drawn.get(this.chosen).handle.getWorldPosition(new THREE.Vector3());
    const from = camera.position.clone().sub(controls.target).setLength(kNear * first.scale);
    controls.target.copy(at);
    camera.position.copy(at).add(from);
  }

  // mode: translate, rotate, or size, which soles have.
  work(mode) {
    this.mode = mode;
    this.place();
    this.hold();
    this.changed();
  }

  // When one is first chosen: the handles are the dearest part of the page.
  makeHandles() {
    const { stage, canvas } = this;
    this.handles = new TransformControls(stage.camera, canvas);
    this.handles.setSize(0.7);
    this.handles.setSpace('local');
    this.helper = this.handles.getHelper();
    stage.scene.add(this.helper);
    this.handles.addEventListener('dragging-changed', ({ value }) => {
      stage.controls.enabled = !value;
      if (value) this.remember();
    });
    this.handles.addEventListener('objectChange', () => {
      const { handle } = this.drawn.get(this.chosen);
      this.chosen.at = handle.position.toArray().map(fine);
      const { x, y, z } = new THREE.Euler().setFromQuaternion(handle.quaternion, 'ZYX');
      this.chosen.rpy = [x, y, z].map(fine);
      this.changed();
    });
  }

  hold() {
    const on = this.shown && this.chosen !== null && this.mode !== 'size';
    if (on && !this.handles) this.makeHandles();
    if (!this.handles) return;
    if (on) {
      this.handles.setMode(this.mode);
      this.handles.attach(this.drawn.get(this.chosen).handle);
    } else {
      this.handles.detach();
    }
    this.handles.enabled = on;
  }

  // --- changes, and back ---
  remember() {
    this.past.push(JSON.stringify(this.list));
    if (this.past.length > kUndo) this.past.shift();
  }

  take(text) {
    JSON.parse(text).forEach((limb, i) => Object.assign(this.list[i], limb));
    this.place();
    this.changed();
  }

  change(values) {
    this.remember();
    Object.assign(this.chosen, values);
    this.place();
    this.changed();
  }

  undo() { if (this.past.length > 0) this.take(this.past.pop()); }

  // As the robot was when the sheet was first opened.
  reset() {
    this.remember();
    this.take(this.original);
  }

  get changedAtAll() { return JSON.stringify(this.list) !== this.original; }

  // As the file of a robot groups them.
  asked() {
    const limbs = {};
    for (const { kind, side, frame, at, rpy, edges } of this.list) {
      const limb = { frame, at, rpy, ...edges };
      if (kind === 'imu') limbs.imu = limb;
      else (limbs[`${kind}s`] ??= {})[side] = limb;
    }
    return limbs;
  }

  // --- the pointer ---
  aim(event) {
    const box = this.canvas.getBoundingClientRect();
    this.ray.setFromCamera(new THREE.Vector2(2 * (event.clientX - box.x) / box.width - 1, 1 - 2 * (event.clientY - box.y) / box.height), this.stage.camera);
  }

  down(event) {
    if (!this.shown || event.button !== 0 || this.handles?.axis) return;
    this.aim(event);
    this.pressed = [event.clientX, event.clientY];
    if (!this.chosen || this.mode !== 'size') return;
    const [hit] = this.ray.intersectObjects(this.drawn.get(this.chosen).knobs, false);
    if (!hit) return;
    event.stopImmediatePropagation();
    this.knob = hit.object.edge;
    this.remember();
    this.canvas.setPointerCapture(event.pointerId);
  }

  // An edge goes where the ray meets the plane of the sole.
  pull(event) {
    if (!this.knob) return;
    event.stopImmediatePropagation();
    this.aim(event);
    const { handle } = this.drawn.get(this.chosen);
    const ray = this.ray.ray.clone().applyMatrix4(handle.matrixWorld.clone().invert());
    const at = ray.intersectPlane(new THREE.Plane(new THREE.Vector3(0, 0, 1)), new THREE.Vector3());
    if (!at) return;
    const [axis, sign] = kWays[this.knob];
    this.chosen.edges = { ...this.chosen.edges, [this.knob]: fine(Math.min(kMost, Math.max(kLeast, sign * at.getComponent(axis)))) };
    this.place();
    this.changed();
  }

  up(event) {
    if (this.knob) event.stopImmediatePropagation();
    const [x, y] = this.pressed ?? [Infinity, 0];
    if (!this.knob && Math.hypot(event.clientX - x, event.clientY - y) < kClick) {
      this.aim(event);
      const bodies = [...this.drawn].map(([limb, { body }]) => Object.assign(body, { limb }));
      const [hit] = this.ray.intersectObjects(bodies, false);
      if (hit) this.choose(hit.object.limb);
    }
    this.knob = this.pressed = null;
  }

  // What moves with the robot.
  tick() {
    if (!this.shown) return;
    const links = this.robot.model?.links ?? {};
    for (const [limb, { carrier }] of this.drawn ?? []) {
      const link = links[limb.frame];
      carrier.visible = link !== undefined;
      if (!link) continue;
      carrier.matrix.copy(link.matrixWorld);
      carrier.matrixWorldNeedsUpdate = true;
    }
  }
}
