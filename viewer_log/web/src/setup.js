// How the run begins: scene, engine, posture, pushes, and which pairs of links are not checked.  Nothing acts until "Start anew".

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
  // near(): the guard's pairs of the newest picture; send(request): to the viewer.
  constructor(box, { near, send, toast }) {
    Object.assign(this, { box, near, send, toast });
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
    if (!on || this.choices) return;
    try {
      this.choices = await (await fetch(withToken('setup.json'))).json();
      const now = await fetch(withToken('setup/now.json'));
      this.build(now.ok ? await now.json() : {});
    } catch (error) {
      this.choices = null;
      this.toast(`Cannot set up: ${error.message}`);
    }
  }

  build(now) {
    const { scenes, engines, poses, joints, links, unchecked } = this.choices;
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
    const start = element('button', { textContent: 'Start anew', onclick: () => this.start() });
    start.id = 'start-anew';
    const title = (text) => element('h2', { textContent: text });
    this.box.replaceChildren(
      element('section', {}, [title('Scene'), this.scene, this.engine, this.about]),
      element('section', {}, [title('Posture at the start'), this.pose, this.filter, this.jointRows]),
      element('section', {}, [title('Pushes'), this.pushRows,
        element('button', { id: 'add-push', textContent: '+ push', onclick: () => { this.pushes.push({ link: links[0], at: 3, impulse: [30, 0, 0] }); this.showPushes(); } })]),
      element('section', {}, [title('Pairs that are not checked'), this.pairRows, element('div', { className: 'line' }, [this.first, this.second, leaveOut]), this.nearRows]),
      element('section', { className: 'end' }, [start, element('p', { className: 'hint', textContent: 'The simulated robot starts anew, its controller and guard with it; the log goes on.' })]));
    this.scene.value = scenes.some((scene) => scene.name === now.scene) ? now.scene : 'stand';
    this.engine.value = now.engine ?? '';
    this.pose.value = now.pose ?? '';
    this.joints = { ...now.joints };
    this.pushes = (now.pushes ?? []).map((push) => ({ ...push }));
    this.unchecked = (now.unchecked ?? unchecked).map((pair) => [...pair]);
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

  showPairs() {
    this.pairRows.replaceChildren(...this.unchecked.map((pair, i) => element('div', { className: 'line pair-out' },
      [element('span', { textContent: pair.join(' – ') }), this.cross(() => { this.unchecked.splice(i, 1); this.showPairs(); })])));
    if (this.unchecked.length === 0) this.pairRows.textContent = 'Every pair is checked but neighbours.';
    const near = this.near().filter(({ a, b }) => [a, b].every((link) => this.choices.links.includes(link)) && !this.unchecked.some((other) => same([a, b], other)));
    this.nearRows.replaceChildren(...near.slice(0, 3).map(({ a, b, mm }) => element('div', { className: 'line' },
      [element('span', { textContent: `near now: ${a} – ${b}, ${mm.toFixed(0)} mm` }), element('button', { textContent: 'Leave out', onclick: () => this.leaveOut([a, b]) })])));
  }

  // The posture as it is being chosen, in bus order; null when nothing is.
  posture(names) {
    if (!this.open || !this.choices) return null;
    return names.map((name) => this.joints[name] ?? this.base[name] ?? 0);
  }

  start() {
    const setup = { scene: this.scene.value, engine: this.engine.value, pose: this.pose.value, joints: this.joints, pushes: this.pushes };
    const known = this.choices.unchecked;
    const changed = known.length !== this.unchecked.length || this.unchecked.some((pair) => !known.some((other) => same(pair, other)));
    if (changed) setup.unchecked = this.unchecked; // an unchanged robot keeps its folder
    if (!this.send({ do: 'setup', setup })) this.toast('The viewer does not answer.');
  }
}
