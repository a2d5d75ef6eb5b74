// A pale second robot in another posture: what is commanded, or what a standby source measures.

import { drawAsOne } from './one_mesh.js';
import { plain, surface } from './surface.js';

export class Ghost {
  constructor(scene, color) {
    this.scene = scene;
    this.model = null;
    this.wanted = false;
    this.material = surface({ color, emissive: color, emissiveIntensity: 0.25,
      transparent: true, opacity: 0.34, depthWrite: false, roughness: 0.6 });
  }

  // model: the robot's own; its meshes are shared.
  adopt(model, joints) {
    if (this.model) this.scene.remove(this.model);
    this.model = model.clone();
    this.model.visible = false;
    this.model.traverse((part) => {
      if (!part.isMesh) return;
      part.material = this.material;
      part.castShadow = part.receiveShadow = false;
    });
    this.joints = joints.map((name) => this.model.joints[name] ?? null);
    for (const joint of this.joints) if (joint) joint.ignoreLimits = true;
    if (plain) drawAsOne(this.model, { depthWrite: false });
    this.scene.add(this.model);
  }

  // q null: there is nothing to show.  Base as in a live message.
  pose(q, base) {
    if (!this.model) return;
    this.model.visible = this.wanted && q != null;
    if (!this.model.visible) return;
    this.model.position.set(base[0], base[1], base[2]);
    this.model.quaternion.set(base[4], base[5], base[6], base[3]);
    q.forEach((angle, i) => this.joints[i]?.setJointValue(angle ?? 0));
  }
}
