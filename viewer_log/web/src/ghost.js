// A pale second robot in another posture: what is commanded, or what a standby source measures.

import { drawAsOne } from './one_mesh.js';
import { plain, surface } from './surface.js';

export class Ghost {
  constructor(scene, color) {
    this.scene = scene;
    this.made = null;
    this.wanted = false;
    this.material = surface({ color, emissive: color, emissiveIntensity: 0.25,
      transparent: true, opacity: 0.34, depthWrite: false, roughness: 0.6 });
  }

  // pattern: a robot that nobody draws; its meshes are shared.  The ghost is made of it when it is first wanted.
  adopt(pattern, joints) {
    if (this.made) this.scene.remove(this.made);
    this.made = null;
    this.pattern = pattern;
    this.names = joints;
  }

  get model() {
    if (!this.made && this.pattern) this.make();
    return this.made;
  }

  make() {
    const model = this.made = this.pattern.clone();
    model.visible = false;
    model.traverse((part) => {
      if (!part.isMesh) return;
      part.material = this.material;
      part.castShadow = part.receiveShadow = false;
    });
    this.joints = this.names.map((name) => model.joints[name] ?? null);
    for (const joint of this.joints) if (joint) joint.ignoreLimits = true;
    if (plain) drawAsOne(model, { depthWrite: false });
    this.scene.add(model);
  }

  // q null: there is nothing to show.  Base as in a live message.
  pose(q, base) {
    const visible = this.wanted && q != null;
    if (this.made) this.made.visible = visible;
    if (!visible || !this.model) return;
    this.model.visible = true;
    this.model.position.set(base[0], base[1], base[2]);
    this.model.quaternion.set(base[4], base[5], base[6], base[3]);
    q.forEach((angle, i) => this.joints[i]?.setJointValue(angle ?? 0));
  }
}
