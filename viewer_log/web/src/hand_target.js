// A handle in the scene: drag it, let go, and the hand is asked to go there.

import * as THREE from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import { surface } from './surface.js';

// For people: "left hand", or what robot.yaml calls an arm.
export const handName = (name) => (name === 'left' || name === 'right' ? `${name} hand` : name);

export class HandTarget {
  // reach(side, [x, y, z]): when the handle is let go.
  constructor(stage, canvas, reach) {
    this.stage = stage;
    this.canvas = canvas;
    this.reach = reach;
    this.side = null;
  }

  // When it is first wanted: the handles are the dearest part of the whole page.
  make() {
    const { stage, canvas, reach } = this;
    this.ball = new THREE.Mesh(new THREE.SphereGeometry(0.03, 24, 16),
      surface({ color: 0x7cf5d0, emissive: 0x1f9e78, transparent: true, opacity: 0.85, depthTest: false }));
    this.ball.renderOrder = 13;
    this.ball.visible = false;
    this.handles = new TransformControls(stage.camera, canvas);
    this.handles.setSize(0.75);
    this.handles.attach(this.ball);
    this.handles.enabled = false;
    this.helper = this.handles.getHelper();
    this.helper.visible = false;
    stage.scene.add(this.ball, this.helper);
    this.handles.addEventListener('dragging-changed', (event) => {
      stage.controls.enabled = !event.value;
      if (!event.value && this.side) reach(this.side, this.ball.position.toArray().map((v) => +v.toFixed(4)));
    });
  }

  // Shows the handle at a hand, which is there now, or hides it when it was that hand's already.  True when it is shown.
  offer(side, at) {
    if (!this.ball) this.make();
    this.side = this.side === side || !at ? null : side;
    if (this.side) this.ball.position.set(...at);
    this.ball.visible = this.helper.visible = this.handles.enabled = this.side !== null;
    return this.side !== null;
  }
}
