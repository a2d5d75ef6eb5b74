// The world around the robot: light, ground, camera, and what is drawn on top (forces, ZMP, polygon, pairs).

import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Arrows } from './arrows.js';
import { PaintedFloor, PlainFloor } from './floor.js';
import { Markers } from './markers.js';
import { makeRenderer } from './renderer.js';
import { Shapes } from './shapes.js';
import { plain } from './surface.js';

const kShownPair = 120;    // [mm]
const kSlowFrame = 70;     // a machine without graphics hardware: fewer pixels, no shadows [ms]
const kSlowFrames = 12;    // so many in a row
const kFollow = 200;       // the camera lags behind the robot [ms]
const kUsualSize = 0.85;   // half the diagonal of a robot that the first view fits [m]
const kFilled = 1.18;      // of the height between the bars, so that the robot of the first view just does not touch them
const kPlainPixels = 0.75; // of each direction, where the processor draws

const kDark = { sky: 0x141b26, floor: '#1c2634', thin: '#2b394c', thick: '#4d6685', ambient: 1.5 };
const kLight = { sky: 0xdfe7f0, floor: '#cfd8e3', thin: '#bcc8d6', thick: '#93a5ba', ambient: 2.2 };

function lineOf(count, color, options = {}) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * count), 3));
  const Kind = options.segments ? THREE.LineSegments : THREE.LineLoop;
  const line = new Kind(geometry, new THREE.LineBasicMaterial({ color, transparent: true, opacity: options.opacity ?? 1 }));
  line.frustumCulled = false;
  return line;
}

function setPoints(line, points, lift = 0) {
  const target = line.geometry.attributes.position;
  const count = Math.min(points.length, target.count);
  for (let i = 0; i < count; ++i) target.setXYZ(i, points[i][0], points[i][1], points[i][2] + lift);
  line.geometry.setDrawRange(0, count);
  target.needsUpdate = true;
}

export class Stage {
  constructor(canvas) {
    this.renderer = makeRenderer(canvas);
    this.renderer.shadowMap.enabled = !plain;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.toneMapping = plain ? THREE.NoToneMapping : THREE.ACESFilmicToneMapping;
    this.renderer.toneMappingExposure = 1.15;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(0x141b26);
    if (!plain) this.scene.fog = new THREE.Fog(0x141b26, 7, 19);
    this.camera = new THREE.PerspectiveCamera(38, 1, 0.05, 60);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(2.55, 1.55, 1.3);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.target.set(0, 0, 0.74);
    this.first = { z: 0.74, from: this.camera.position.clone().sub(this.controls.target), scale: 1 };
    this.controls.enableDamping = true;
    this.controls.minDistance = 0.5;
    this.controls.maxDistance = 14;
    this.tookIn = false;
    this.turned = false; // by the user, or a bookmark
    this.controls.addEventListener('start', () => { this.tookIn = this.turned = true; });
    this.follow = true;
    this.arrowScale = 1;
    this.leastForce = 5; // [N], smaller ones are not drawn
    this.pixels = plain ? kPlainPixels : Math.min(devicePixelRatio, 2);
    this.slowFrames = 0;
    this.fine = new URLSearchParams(location.hash.slice(1)).has('fine');
    this.light();
    this.ground();
    this.overlays();
    this.shapes = new Shapes(this.scene);
    addEventListener('resize', () => this.resize());
    this.resize();
  }

  light() {
    this.sky = new THREE.HemisphereLight(0xcfe3ff, 0x2b2f38, 1.5);
    this.scene.add(this.sky);
    const rim = new THREE.DirectionalLight(0x7fb4ff, 1.0);
    rim.position.set(-4, -3, 3);
    this.scene.add(rim);
    this.sun = new THREE.DirectionalLight(0xfff2df, 2.6);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    Object.assign(this.sun.shadow.camera, { left: -1.7, right: 1.7, top: 1.9, bottom: -1.7, near: 1, far: 12 });
    this.sun.shadow.bias = -0.0003;
    this.sun.shadow.normalBias = 0.012;
    this.sun.shadow.radius = 4;
    this.scene.add(this.sun, this.sun.target);
  }

  ground() {
    this.floor = plain ? new PlainFloor(kDark) : new PaintedFloor(kDark, this.renderer.capabilities.getMaxAnisotropy());
    this.scene.add(this.floor);
    const axes = lineOf(2, 0xe5484d, { segments: true });
    setPoints(axes, [[0, 0, 0.002], [0.5, 0, 0.002]]);
    const side = lineOf(2, 0x3ecf8e, { segments: true });
    setPoints(side, [[0, 0, 0.002], [0, 0.5, 0.002]]);
    this.scene.add(axes, side);
  }

  theme(light) {
    const look = light ? kLight : kDark;
    this.scene.background.set(look.sky);
    this.scene.fog?.color.set(look.sky);
    this.sky.intensity = look.ambient;
    this.floor.paint(look);
  }

  overlays() {
    this.forces = new Arrows(8, 0x38bdf8);
    this.push = new Arrows(1, 0xff8a3d);
    this.balance = new THREE.Group();
    this.support = new THREE.Mesh(new THREE.BufferGeometry(),
      new THREE.MeshBasicMaterial({ color: 0x3ecf8e, transparent: true, opacity: 0.34, side: THREE.DoubleSide, depthWrite: false }));
    this.support.geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * 12), 3));
    this.support.frustumCulled = false;
    this.rim = lineOf(12, 0x3ecf8e);
    this.zmp = new THREE.Group();
    const disc = new THREE.Mesh(new THREE.CircleGeometry(0.014, 24), new THREE.MeshBasicMaterial({ color: 0xff5ac8, depthTest: false }));
    const ring = new THREE.Mesh(new THREE.RingGeometry(0.024, 0.03, 32), new THREE.MeshBasicMaterial({ color: 0xff5ac8, depthTest: false }));
    for (const part of [disc, ring]) part.renderOrder = 10;
    this.zmp.add(disc, ring);
    this.com = new THREE.Mesh(new THREE.SphereGeometry(0.03, 20, 14),
      new THREE.MeshBasicMaterial({ color: 0xffd23f, depthTest: false, transparent: true, opacity: 0.85 }));
    this.com.renderOrder = 11;
    this.plumb = lineOf(2, 0xffd23f, { segments: true, opacity: 0.7 });
    this.plumb.material.depthTest = false;
    this.balance.add(this.support, this.rim, this.zmp, this.com, this.plumb);
    this.markers = new Markers(this.balance);
    this.pairs = lineOf(12, 0xffb020, { segments: true });
    this.pairs.material.depthTest = false;
    this.pairs.renderOrder = 12;
    this.scene.add(this.forces, this.push, this.balance, this.pairs);
  }

  resize() {
    this.renderer.setPixelRatio(this.pixels);
    this.renderer.setSize(innerWidth, innerHeight, false);
    this.camera.aspect = innerWidth / innerHeight;
    this.camera.updateProjectionMatrix();
  }

  // The robot stands in the middle between bars of that height at the top and at the bottom [px], and clear of them.
  keepBetween(top, foot) {
    this.camera.zoom = Math.min(1, kFilled * Math.max(0.4, (innerHeight - top - foot) / innerHeight));
    this.camera.setViewOffset(innerWidth, innerHeight, 0, (foot - top) / 2, innerWidth, innerHeight);
  }

  show(live) {
    this.forces.show(live.forces, this.arrowScale, this.leastForce);
    this.push.show(live.push ? [live.push] : [], this.arrowScale, this.leastForce);
    this.showBalance(live);
    this.markers.show(live);
    this.shapes.move(live);
    const near = live.pairs.filter((pair) => pair.mm < kShownPair);
    setPoints(this.pairs, near.flatMap((pair) => [pair.from, pair.to]));
    const worst = near.some((pair) => pair.level === 'touch') ? 0xff4d4d : near.some((pair) => pair.level) ? 0xffb020 : 0x8fb3d9;
    this.pairs.material.color.set(worst);
    if (this.follow) this.followTo(live.base);
  }

  showBalance(live) {
    const corners = live.polygon;
    const fan = [];
    for (let i = 1; i + 1 < corners.length; ++i) fan.push(corners[0], corners[i], corners[i + 1]);
    if (this.support.geometry.attributes.position.count < fan.length) {
      this.support.geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * fan.length), 3));
    }
    setPoints(this.support, fan, 0.003);
    setPoints(this.rim, corners, 0.004);
    const color = live.margin_mm === null ? 0x58c4ff : live.margin_mm > 20 ? 0x3ecf8e : live.margin_mm > 5 ? 0xffb020 : 0xff4d4d;
    this.support.material.color.set(color);
    this.rim.material.color.set(color);
    const known = (p) => p.every((v) => v !== null);
    this.zmp.visible = corners.length > 0 && known(live.zmp);
    if (this.zmp.visible) this.zmp.position.set(live.zmp[0], live.zmp[1], 0.006);
    this.com.visible = this.plumb.visible = known(live.com) && !this.fixed;
    if (this.com.visible) {
      this.com.position.set(...live.com);
      setPoints(this.plumb, [live.com, [live.com[0], live.com[1], 0.005]]);
    }
  }

  // What is drawn on top of the world.
  get onTop() { return [this.forces, this.push, this.balance, this.pairs, this.shapes.steps]; }

  // Steps back once, so that what lies around the robot is in the picture; not where somebody chose the place.
  takeIn(scene) {
    const near = ({ pose }) => Math.hypot(pose[0] - this.controls.target.x, pose[1] - this.controls.target.y) < 4;
    if (this.tookIn || !scene.loose?.some(near)) return;
    this.tookIn = true;
    this.first.from.multiplyScalar(1.7);
    this.lookFrom(this.first.scale);
  }

  // A robot that is much larger or smaller than usual fills the view as others do.
  fitTo(model) {
    model.updateMatrixWorld(true);
    const box = new THREE.Box3().setFromObject(model);
    if (this.turned || box.isEmpty()) return;
    const scale = Math.min(4, Math.max(0.3, 0.5 * box.getSize(new THREE.Vector3()).length() / kUsualSize));
    const usual = Math.abs(scale - 1) < 0.12;
    this.controls.target.z = usual ? this.first.z : 0.5 * (Math.max(0, box.min.z) + box.max.z);
    this.lookFrom(usual ? 1 : scale);
  }

  lookFrom(scale) {
    this.first.scale = scale;
    this.camera.position.copy(this.first.from).multiplyScalar(scale).add(this.controls.target);
    this.controls.minDistance = Math.min(0.5, 0.5 * scale);
    this.controls.maxDistance = 14 * Math.max(1, 2 * scale);
    if (this.scene.fog) Object.assign(this.scene.fog, { near: 7 * Math.max(1, scale), far: 19 * Math.max(1, scale) });
  }

  // Camera and light go along; what the user turned stays turned.
  followTo(base) {
    const shift = new THREE.Vector3(base[0] - this.controls.target.x, base[1] - this.controls.target.y, 0);
    const now = performance.now(), passed = now - (this.followedAt ?? now);
    this.followedAt = now;
    if (shift.length() < 3) shift.multiplyScalar(1 - Math.exp(-passed / kFollow)); // the same on slow machines
    this.controls.target.add(shift);
    this.camera.position.add(shift);
  }

  // Draws less finely on a machine that cannot keep up; never goes back, so that it does not flicker.  #fine=1 in the
  // address forbids it, for pictures.
  spare() {
    if (this.fine) return;
    const now = performance.now();
    this.slowFrames = now - (this.drawnAt ?? now) > kSlowFrame ? this.slowFrames + 1 : 0;
    this.drawnAt = now;
    if (this.slowFrames < kSlowFrames || document.hidden) return;
    this.slowFrames = 0;
    if (this.pixels > 0.6) {
      this.pixels = Math.max(0.6, 0.7 * this.pixels);
      this.resize();
    } else {
      this.sun.castShadow = false;
    }
  }

  // The first picture is of the floor and the robot alone: what else there is takes a while to be made ready to draw, and
  // is while the robot is looked at already.
  drawFirst(model) {
    const later = this.scene.children.filter((part) => part.visible && !part.isLight && part !== this.floor && part !== model);
    for (const part of later) part.visible = false;
    this.draw();
    for (const part of later) part.visible = true;
  }

  draw() {
    this.spare();
    this.controls.update();
    const at = this.controls.target;
    this.sun.position.set(at.x + 2.2, at.y - 1.6, 4.6);
    this.sun.target.position.set(at.x, at.y, 0.6);
    this.renderer.render(this.scene, this.camera);
  }
}
