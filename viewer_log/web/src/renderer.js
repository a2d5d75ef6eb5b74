// What draws: WebGL, or nothing at all where the browser has none; the rest of the page, STOP above all, works without.

import * as THREE from 'three';
import { plain } from './surface.js';

class Nothing {
  constructor(canvas) {
    this.domElement = canvas;
    this.shadowMap = {};
    this.capabilities = { getMaxAnisotropy: () => 1 };
    for (const name of ['setPixelRatio', 'setSize', 'setViewport', 'render']) this[name] = () => {};
  }
  getPixelRatio() { return 1; }
  getSize(target) { return target.set(innerWidth, innerHeight); }
  setAnimationLoop(draw) {
    const again = () => { draw(); requestAnimationFrame(again); };
    requestAnimationFrame(again);
  }
}

export function makeRenderer(canvas) {
  try {
    const renderer = new THREE.WebGLRenderer({ canvas, antialias: !plain });
    renderer.debug.checkShaderErrors = false; // asking waits for every shader
    return renderer;
  } catch {
    document.body.classList.add('no-3d');
    return new Nothing(canvas);
  }
}
