// How the run begins: scene, engine, posture, pushes, soles, hands, IMU, and which pairs of links are not checked.  Nothing acts until
// "Start anew", or "Save robot", which only writes its folder.

import { LimbForm } from './limb_form.js';
import { withToken } from './link.js';

const kDegree = Math.PI / 180;

function element(tag, properties = {}, children = []) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
}
const options = (names) => names.map((name) => element('option', { value: name, textContent: name }));
const number = (value, step, title) => element('input', { type: 'number', value, step, title, className: 'narrow' });
const same = ([a, b], [c, d]) => (a === c && b === d) || (a === d && b === c);

export class Setup {
  // limbs: see limbs.js; pairLine: see pair_line.js; near(): the guard's pairs of the newest picture; send(request): to the viewer.
  constructor(box, limbs, pairLine, { near, look, send, toast }) {
    Object.assign(this, { box, limbs, pairLine, near, send, toast });
    this.form = new LimbForm(limbs, { request: () => this.robot(true), send, look });
    this.choices = null;
    this.joints = {}; // changed ones: name to angle [rad]
    this.pushes = [];
    this.unchecked = [];
    this.base = {}; // the chosen pose
  }

  get open() { return !this.box.hidden; }

  async toggle(on) {
    this.box.hidden = !on;
    document.body.classList.toggle('setting-up', on);
    this.limbs.show(on && this.choices !== null);
    this.pairLine.pick(null);
    this.pairLine.show(on ? this.shownPair ?? null : null);
    if (!on || this.choices) return;
    try {
      this.choices = await (await fetch(withToken('setup.json'))).json();
      const [now, kept] = await Promise.all(['now', 'robot'].map(async (name) => {
        const answer = await fetch(withToken(`setup/${name}.json`), { cache: 'no-store' });
        return answer.ok ? answer.json() : {};
      }));
      this.build(now, kept);
      this.limbs.show(this.open);
    } catch (error) {
      this.choices = null;
      this.toast(`Cannot set up: ${error.message}`);
    }
  }

  // now: what runs; kept: what of the robot was changed last.
  build(now, kept) {
    const { scenes, engines, poses, joints, links, unchecked, frames } = this.choices;
    this.kept = { limbs: 'limbs' in kept, unchecked: 'unchecked' in kept };
    this.limbs.set(this.choices.limbs);
    for (const limb of this.choices.limbs) {
      const { frame, at, rpy, ...edges } = (limb.kind === 'imu' ? kept.limbs?.imu : kept.limbs?.[`${limb.kind}s`]?.[limb.side]) ?? {};
      if (frame) Object.assign(limb, { frame, at, rpy }, limb.edges ? { edges } : {});
    }
    this.limbs.place();
    this.scene = element('select', { ariaLabel: 'scene', onchange: () => this.show() }, options(scenes.map((scene) => scene.name)));
    this.about = element('p', { className: 'hint' });
    this.engine = element('select', { ariaLabel: 'engine' }, [element('option', { value: '', textContent: "the scene's engine" }), ...options(engines)]);
    this.pose = element('select', { ariaLabel: 'posture', onchange: () => { this.joints = {}; this.showJoints(); } },
      [element('option', { value: '', textContent: "the scene's posture" }), ...options(Object.keys(poses))]);
    this.filter = element('input', { type: 'search', placeholder: 'joint: knee, waist …', oninput: () => this.showJoints() });
    this.jointRows = element('div', { className: 'rows' });
    this.pushRows = element('div', { className: 'rows' });
    this.first = element('select', { ariaLabel: 'first link' }, options(links));
    this.second = element('select', { ariaLabel: 'second link' }, options(links));
    this.second.selectedIndex = Math.min(1, links.length - 1);
    this.pairRows = element('div', { className: 'rows' });
    this.nearRows = element('div', { className: 'rows' });
    const leaveOut = element('button', { textContent: 'Leave out', onclick: () => this.leaveOut([this.first.value, this.second.value]) });
    leaveOut.id = 'leave-out';
    for (const select of [this.first, this.second]) select.onchange = () => this.showPair([this.first.value, this.second.value]);
    this.picker = element('button', { id: 'pick-pair', textContent: 'Pick two links in the picture', onclick: () => this.pick() });
    const start = element('button', { textContent: 'Start anew', onclick: () => this.start() });
    start.id = 'start-anew';
    const title = (text) => element('h2', { textContent: text });
    this.box.replaceChildren(
      element('section', {}, [title('Scene'), this.scene, this.engine, this.about]),
      this.form.section(frames),
      element('section', {}, [title('Posture at the start'), this.pose, this.filter, this.jointRows]),
      element('section', {}, [title('Pushes'), this.pushRows,
        element('button', { id: 'add-push', textContent: '+ push', onclick: () => { this.pushes.push({ link: links[0], at: 3, impulse: [30, 0, 0] }); this.showPushes(); } })]),
      element('section', {}, [title('Pairs that are not checked'), this.pairRows, element('div', { className: 'line' }, [this.first, this.second, leaveOut]), this.picker, this.nearRows]),
      element('section', { className: 'end' }, [start, element('p', { className: 'hint', textContent: 'The simulated robot starts anew, its controller and guard with it; the log goes on.' })]));
    this.scene.value = scenes.some((scene) => scene.name === now.scene) ? now.scene : 'stand';
    this.engine.value = now.engine ?? '';
    this.pose.value = now.pose ?? '';
    this.joints = { ...now.joints };
    this.pushes = (now.pushes ?? []).map((push) => ({ ...push }));
    this.unchecked = (kept.unchecked ?? now.unchecked ?? unchecked).map((pair) => [...pair]);
    this.known = joints;
    this.show();
    this.showJoints();
    this.showPushes();
    this.showPairs();
  }

  show() {
    this.about.textContent = this.choices.scenes.find((scene) => scene.name === this.scene.value)?.about ?? '';
  }

  showJoints() {
    this.base = this.choices.poses[this.pose.value || 'half_sitting'] ?? {};
    const wanted = this.filter.value.trim().toLowerCase().split(/\s+/);
    const shown = this.known.filter(({ name }) => wanted.every((part) => name.toLowerCase().includes(part)));
    this.jointRows.replaceChildren(...shown.map(({ name, lower, upper }) => {
      const value = this.joints[name] ?? this.base[name] ?? 0;
      const degrees = element('output', { textContent: `${(value / kDegree).toFixed(1)}°` });
      const slider = element('input', { type: 'range', min: lower, max: upper, step: 0.001, value, title: name });
      slider.oninput = () => {
        this.joints[name] = Number(slider.value);
        degrees.textContent = `${(slider.value / kDegree).toFixed(1)}°`;
      };
      return element('label', { className: 'joint' }, [element('span', { textContent: name }), slider, degrees]);
    }));
  }

  showPushes() {
    this.pushRows.replaceChildren(...this.pushes.map((push, i) => {
      const link = element('select', { ariaLabel: 'pushed link', onchange: () => { push.link = link.value; } }, options(this.choices.links));
      link.value = push.link;
      const at = number(push.at, 0.1, 'seconds after the start');
      at.oninput = () => { push.at = Number(at.value); };
      const parts = ['forward', 'left', 'up'].map((way, axis) => {
        const part = number(push.impulse[axis], 5, `impulse ${way} [N s]`);
        part.oninput = () => { push.impulse[axis] = Number(part.value); };
        return part;
      });
      return element('div', { className: 'line push' }, [link, at, 's', ...parts, 'N s', this.cross(() => { this.pushes.splice(i, 1); this.showPushes(); })]);
    }));
  }

  cross(act) { return element('button', { className: 'close', textContent: '×', title: 'take away', onclick: act }); }

  leaveOut(pair) {
    if (pair[0] === pair[1] || this.unchecked.some((other) => same(pair, other))) return;
    this.unchecked.push(pair);
    this.showPairs();
  }

  pick() {
    this.picker.textContent = 'Click at the first link …';
    this.pairLine.pick((first, second) => {
      this.first.value = first;
      if (second) this.second.value = second;
      this.picker.textContent = second ? 'Pick two links in the picture' : `${first}, and … click at the second`;
      if (second) this.showPair([first, second]);
    }, this.choices.links);
  }

  // As a line on the robot; once more: no longer.
  showPair(pair) {
    this.shownPair = this.shownPair && same(pair, this.shownPair) ? null : pair;
    this.pairLine.show(this.shownPair);
    this.showPairs();
  }

  // The names of a pair, as a button that shows it on the robot.
  pairName(pair, text) {
    return element('button', { className: 'pair-name', textContent: text, title: 'shows the two on the robot', onclick: () => this.showPair(pair),
      ariaPressed: String(Boolean(this.shownPair && same(pair, this.shownPair))) });
  }

  showPairs() {
    this.pairRows.replaceChildren(...this.unchecked.map((pair, i) => element('div', { className: 'line pair-out' },
      [this.pairName(pair, pair.join(' – ')), this.cross(() => { this.unchecked.splice(i, 1); this.showPairs(); })])));
    if (this.unchecked.length === 0) this.pairRows.textContent = 'Every pair is checked but neighbours.';
    const near = this.near().filter(({ a, b }) => [a, b].every((link) => this.choices.links.includes(link)) && !this.unchecked.some((other) => same([a, b], other)));
    this.nearRows.replaceChildren(...near.slice(0, 3).map(({ a, b, mm }) => element('div', { className: 'line' },
      [this.pairName([a, b], `near now: ${a} – ${b}, ${mm.toFixed(0)} mm`), element('button', { textContent: 'Leave out', onclick: () => this.leaveOut([a, b]) })])));
  }

  // The posture as it is being chosen, in bus order; null when nothing is.
  posture(names) {
    if (!this.open || !this.choices) return null;
    return names.map((name) => this.joints[name] ?? this.base[name] ?? 0);
  }

  // What of the robot is another; an unchanged one keeps its folder.  all: limbs in any case.
  robot(all) {
    const setup = { scene: this.scene.value, pose: this.pose.value, joints: this.joints };
    const known = this.choices.unchecked;
    const changed = known.length !== this.unchecked.length || this.unchecked.some((pair) => !known.some((other) => same(pair, other)));
    if (changed || this.kept.unchecked) setup.unchecked = this.unchecked;
    if (all || this.kept.limbs || this.form.kept || this.limbs.changedAtAll) setup.limbs = this.limbs.asked();
    return setup;
  }

  start() {
    const setup = { ...this.robot(false), engine: this.engine.value, pushes: this.pushes };
    if (!this.send({ do: 'setup', setup })) this.toast('The viewer does not answer.');
  }
}
