// The floor with a line every 25 cm and a strong one every metre.

import * as THREE from 'three';

const kSize = 60;   // [m]
const kFar = [2, 8]; // a plain floor has thin and thick lines this far [m]
const kFade = 19;   // and has become sky there [m]

// A picture on the floor, not lines: long lines are dropped by some drivers, and a picture takes shadows.
export class PaintedFloor extends THREE.Mesh {
  constructor(look, anisotropy) {
    super(new THREE.PlaneGeometry(kSize, kSize), new THREE.MeshStandardMaterial({ roughness: 0.95, depthWrite: false }));
    this.anisotropy = anisotropy;
    this.receiveShadow = true;
    this.renderOrder = -1;
    this.paint(look);
  }

  paint(look) {
    this.material.map?.dispose();
    this.material.map = this.tile(look);
    this.material.needsUpdate = true;
  }

  // One metre of floor.
  tile(look) {
    const canvas = document.createElement('canvas');
    const n = (canvas.width = canvas.height = 512);
    const paint = canvas.getContext('2d');
    paint.fillStyle = look.floor;
    paint.fillRect(0, 0, n, n);
    const lines = (step, width, color) => {
      paint.fillStyle = color;
      for (let at = 0; at <= n; at += step) {
        paint.fillRect(at - width / 2, 0, width, n);
        paint.fillRect(0, at - width / 2, n, width);
      }
    };
    lines(n / 4, 3, look.thin);
    lines(n, 8, look.thick);
    const texture = new THREE.CanvasTexture(canvas);
    texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
    texture.repeat.set(kSize, kSize);
    texture.anisotropy = this.anisotropy;
    texture.colorSpace = THREE.SRGBColorSpace;
    return texture;
  }
}

// A colour that fades into the sky, and short lines: looking up a picture for every pixel takes a processor longer than
// all the rest.
export class PlainFloor extends THREE.Group {
  constructor(look) {
    super();
    const disc = new THREE.RingGeometry(0, 1.5 * kFade, 32, 12);
    disc.setAttribute('color', new THREE.BufferAttribute(new Float32Array(3 * disc.attributes.position.count), 3));
    this.disc = new THREE.Mesh(disc, new THREE.MeshBasicMaterial({ vertexColors: true, depthWrite: false }));
    this.disc.renderOrder = -2;
    this.lines = [0.25, 1].map((step, i) => {
      const lines = new THREE.LineSegments(grid(step, kFar[i]), new THREE.LineBasicMaterial({ depthWrite: false }));
      lines.renderOrder = -1;
      this.add(lines);
      return lines;
    });
    this.add(this.disc);
    this.paint(look);
  }

  paint(look) {
    const floor = new THREE.Color(look.floor), sky = new THREE.Color(look.sky), mixed = new THREE.Color();
    const { position, color } = this.disc.geometry.attributes;
    for (let i = 0; i < position.count; ++i) {
      const far = Math.min(1, Math.hypot(position.getX(i), position.getY(i)) / kFade);
      mixed.lerpColors(floor, sky, far);
      color.setXYZ(i, mixed.r, mixed.g, mixed.b);
    }
    color.needsUpdate = true;
    this.lines[0].material.color.set(look.thin);
    this.lines[1].material.color.set(look.thick);
  }
}

function grid(step, far) {
  const at = [];
  for (let across = -far; across <= far; across += step) {
    if (step < 1 && across % 1 === 0) continue; // those are the strong ones
    for (let along = -far; along < far; along += 4) {
      at.push(across, along, 0, across, along + 4, 0, along, across, 0, along + 4, across, 0);
    }
  }
  return new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(at, 3));
}
