// What the robot sees: the newest picture of its camera, or, while none comes, the scene drawn from where the camera is.

import * as THREE from 'three';
import { plain } from './surface.js';

const kWidth = 320, kHeight = 240;
const kEvery = plain ? 400 : 100; // between pictures that are drawn [ms]
const kFresh = 2000;              // a picture older than this is not what it sees [ms]

export class Eye {
  // box: with a canvas, an img and a caption.
  constructor(box) {
    this.box = box;
    this.canvas = box.querySelector('canvas');
    this.image = box.querySelector('img');
    this.caption = box.querySelector('figcaption');
    this.canvas.width = kWidth;
    this.canvas.height = kHeight;
    this.camera = new THREE.PerspectiveCamera(60, kWidth / kHeight, 0.03, 40);
    this.cameAt = -Infinity;
    this.drawnAt = -Infinity;
    this.wanted = false;
  }

  toggle(on) { this.wanted = on; this.box.hidden = !on; }

  // A camera message.
  picture({ image }) {
    this.image.src = image;
    this.cameAt = performance.now();
  }

  // Where it looks from: the first link of that name, forward along its x axis.
  link(model) {
    const names = Object.keys(model?.links ?? {});
    return names.find((name) => /camera/i.test(name)) ?? names.find((name) => /head/i.test(name)) ?? null;
  }

  // Before the view itself is drawn; hide: what is no part of the world.
  tick(stage, model, hide) {
    if (!this.wanted) return;
    const now = performance.now();
    const seen = now - this.cameAt < kFresh;
    this.image.hidden = !seen;
    this.canvas.hidden = seen;
    const name = seen ? null : this.link(model);
    this.caption.textContent = seen ? 'camera' : name ? `from ${name}, drawn` : 'this robot has no camera';
    if (!name || now - this.drawnAt < kEvery) return;
    this.drawnAt = now;
    const frame = model.links[name];
    frame.updateWorldMatrix(true, false);
    const axis = (k) => new THREE.Vector3().setFromMatrixColumn(frame.matrixWorld, k);
    this.camera.position.setFromMatrixPosition(frame.matrixWorld);
    this.camera.up.copy(axis(2));
    this.camera.lookAt(axis(0).add(this.camera.position));
    const shown = hide.map((part) => part.visible);
    for (const part of hide) part.visible = false;
    const { renderer } = stage;
    const ratio = renderer.getPixelRatio();
    const size = renderer.getSize(new THREE.Vector2());
    const [w, h] = [Math.min(kWidth / ratio, size.x), Math.min(kHeight / ratio, size.y)];
    renderer.setViewport(0, 0, w, h);
    renderer.render(stage.scene, this.camera);
    renderer.setViewport(0, 0, size.x, size.y);
    hide.forEach((part, i) => { part.visible = shown[i]; });
    const source = renderer.domElement;
    this.canvas.getContext('2d').drawImage(source, 0, source.height - h * ratio, w * ratio, h * ratio, 0, 0, kWidth, kHeight);
  }
}
