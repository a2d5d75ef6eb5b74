// Pushes the simulated robot: pull at a link in the picture, and it is pushed that way when the pointer is let go.
//
// The force lies in the plane of the picture, at the origin of the link; its size is the length of the pull.

import { ArrowHelper, Plane, Raycaster, Vector2, Vector3 } from 'three';

const kNewtonPerMetre = 300;
const kMost = 500;     // [N]
const kSeconds = 0.2;
const kNear = 0.2;     // from the ray to the origin of a link [m]

export class Pusher {
  // push({ link, force, point, seconds }): to the viewer; say(text): to the operator.
  constructor(stage, canvas, robot, push, say) {
    Object.assign(this, { stage, canvas, robot, push, say, armed: false, held: null, done: () => {} });
    this.ray = new Raycaster();
    this.arrow = new ArrowHelper(new Vector3(1, 0, 0), new Vector3(), 0.1, 0xff5d5d, 0.06, 0.04);
    this.arrow.visible = false;
    stage.scene.add(this.arrow);
    canvas.addEventListener('pointerdown', (event) => this.take(event), true);
    canvas.addEventListener('pointermove', (event) => this.pull(event), true);
    canvas.addEventListener('pointerup', (event) => this.letGo(event), true);
    canvas.addEventListener('pointercancel', () => this.arm(false), true);
  }

  // What is next taken hold of in the picture is pushed; gives whether it is so.
  arm(on) {
    this.armed = on;
    this.held = null;
    this.arrow.visible = false;
    document.body.classList.toggle('pushing', on);
    if (on) this.say('Pull at the robot in the picture: it is pushed that way.');
    else this.done();
    return on;
  }

  aim(event) {
    const box = this.canvas.getBoundingClientRect();
    this.ray.setFromCamera(new Vector2(2 * (event.clientX - box.x) / box.width - 1, 1 - 2 * (event.clientY - box.y) / box.height), this.stage.camera);
  }

  // The moving link whose origin is nearest to the ray; null when none is near.
  linkAt() {
    let best = null, least = kNear;
    for (const [name, node] of Object.entries(this.robot.model.links)) {
      if (node.parent?.jointType === 'fixed') continue; // it belongs to the one that carries it
      const at = node.getWorldPosition(new Vector3());
      const distance = this.ray.ray.distanceToPoint(at);
      if (distance < least) [best, least] = [{ link: name, at }, distance];
    }
    return best;
  }

  take(event) {
    if (!this.armed || event.button !== 0 || !this.robot.model) return;
    event.stopImmediatePropagation();
    this.aim(event);
    this.held = this.linkAt();
    if (!this.held) { this.say('There is nothing of the robot there.'); return; }
    this.plane = new Plane().setFromNormalAndCoplanarPoint(this.stage.camera.getWorldDirection(new Vector3()), this.held.at);
    this.force = new Vector3();
    this.canvas.setPointerCapture(event.pointerId);
  }

  pull(event) {
    if (!this.held) return;
    event.stopImmediatePropagation();
    this.aim(event);
    const to = this.ray.ray.intersectPlane(this.plane, new Vector3());
    if (!to) return;
    const pulled = to.sub(this.held.at);
    this.force = pulled.clone().multiplyScalar(kNewtonPerMetre).clampLength(0, kMost);
    this.arrow.position.copy(this.held.at);
    this.arrow.setDirection(pulled.clone().normalize());
    this.arrow.setLength(Math.max(0.05, pulled.length()), 0.06, 0.04);
    this.arrow.visible = true;
  }

  letGo(event) {
    if (!this.held) return;
    event.stopImmediatePropagation();
    const { link } = this.held;
    if (this.force.length() > 5) {
      this.push({ link, force: this.force.toArray(), point: [0, 0, 0], seconds: kSeconds });
      this.say(`${link} is pushed with ${this.force.length().toFixed(0)} N for ${kSeconds} s.`);
    }
    this.arm(false);
  }
}
