// The planned motion of an arm as a line that the hand will draw, from joint angles by the robot's own kinematics.

import * as THREE from 'three';

const kDone = 4; // a path stays to be seen this long after its end [s]
const kMostPoints = 400;

export class ArmPath {
  constructor(scene) {
    this.line = new THREE.Line(new THREE.BufferGeometry(),
      new THREE.LineDashedMaterial({ color: 0x7cf5d0, dashSize: 0.03, gapSize: 0.012, depthTest: false, transparent: true }));
    this.line.geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * kMostPoints), 3));
    this.dots = new THREE.Points(this.line.geometry, new THREE.PointsMaterial({ color: 0x7cf5d0, size: 5, sizeAttenuation: false, depthTest: false, transparent: true }));
    this.group = new THREE.Group();
    this.group.add(this.line, this.dots);
    this.group.visible = false;
    for (const part of [this.line, this.dots]) { part.frustumCulled = false; part.renderOrder = 12; }
    scene.add(this.group);
  }

  // message: a path frame; model: a robot whose posture may be used up; hands: as in hello; live: where the robot is.
  show(message, model, hands, live, names) {
    this.group.visible = false;
    if (!model || !live || message.knots.length < 2) return;
    const moved = message.joints.map((name) => model.joints[name] ?? null);
    model.position.set(...live.base.slice(0, 3));
    model.quaternion.set(live.base[4], live.base[5], live.base[6], live.base[3]);
    names.forEach((name, i) => model.joints[name]?.setJointValue(live.q[i] ?? 0));
    const hand = this.movedHand(hands, model, moved);
    if (!hand) return;
    const points = message.knots.slice(0, kMostPoints).map((q) => {
      moved.forEach((joint, i) => joint?.setJointValue(q[i] ?? 0));
      model.updateMatrixWorld(true);
      return new THREE.Vector3(...hand.at).applyMatrix4(model.links[hand.link].matrixWorld);
    });
    points.forEach((p, i) => this.line.geometry.attributes.position.setXYZ(i, p.x, p.y, p.z));
    this.line.geometry.attributes.position.needsUpdate = true;
    this.line.geometry.setDrawRange(0, points.length);
    this.line.computeLineDistances();
    this.group.visible = true;
    this.until = performance.now() + 1000 * (message.seconds + kDone);
  }

  // The hand that hangs from one of the moved joints.
  movedHand(hands, model, moved) {
    return hands.find((hand) => {
      if (!hand || !model.links[hand.link]) return false;
      for (let part = model.links[hand.link]; part; part = part.parent) if (moved.includes(part)) return true;
      return false;
    });
  }

  tick() {
    if (this.group.visible && performance.now() > this.until) this.group.visible = false;
  }
}
