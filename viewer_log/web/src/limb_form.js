// The numbers of a sole, a hand or the IMU, beside the picture in which limbs.js moves them; and the button that writes the robot.

import { withToken } from './link.js';
import { limbName } from './limbs.js';
import { typed } from './typed.js';

const kDegree = Math.PI / 180;
const kLook = 300, kPatience = 20000; // for the answer [ms]
const kEdges = ['front', 'back', 'left', 'right'];

function element(tag, properties = {}, children = []) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
}
const pause = (ms) => new Promise((done) => { setTimeout(done, ms); });

export class LimbForm {
  // request(): what of the robot is changed, as `up` reads it; send(request): to the viewer; look(): the camera goes near the chosen one.
  constructor(limbs, { request, send, look }) {
    Object.assign(this, { limbs, request, send, look });
    limbs.changed = () => this.show();
    addEventListener('keydown', (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z' || !limbs.shown || event.target.tagName === 'INPUT') return;
      event.preventDefault();
      limbs.undo();
    });
  }

  // The section of the sheet; frames: links of the URDF.
  section(frames) {
    const { limbs } = this;
    const button = (id, textContent, title, onclick) => element('button', { id, textContent, title, onclick });
    this.rows = limbs.list.map((limb) => element('button', { className: 'limb', textContent: limbName(limb), onclick: () => limbs.choose(limbs.chosen === limb ? null : limb) }));
    this.modes = [['translate', 'Move'], ['rotate', 'Turn'], ['size', 'Size']].map(([mode, text]) => {
      const node = button(`limb-${mode}`, text, '', () => limbs.work(mode));
      node.mode = mode;
      return node;
    });
    this.frame = element('select', { ariaLabel: 'link that carries it', onchange: () => limbs.change({ frame: this.frame.value }) },
      frames.map((name) => element('option', { value: name, textContent: name })));
    const place = (key, names, unit, scale, step) => names.map((name, i) => this.number(`${name} [${unit}]`, scale, step,
      (limb) => limb[key][i], (limb, value) => ({ [key]: limb[key].map((old, k) => (k === i ? value : old)) })));
    this.numbers = [...place('at', ['x', 'y', 'z'], 'mm', 1e-3, 1), ...place('rpy', ['roll', 'pitch', 'yaw'], '°', kDegree, 1)];
    this.edges = kEdges.map((edge) => this.number(`${edge} [mm]`, 1e-3, 1, (limb) => limb.edges?.[edge], (limb, value) => ({ edges: { ...limb.edges, [edge]: value } })));
    this.sizes = element('div', { className: 'numbers four' }, this.edges.map(({ node }) => node));
    this.form = element('div', { hidden: true }, [
      element('div', { className: 'line' }, [...this.modes, button('limb-look', 'Go near', 'the camera goes near it, and follows no longer', () => this.look())]),
      element('label', { className: 'line' }, [element('span', { textContent: 'in the link' }), this.frame]),
      element('div', { className: 'numbers' }, this.numbers.map(({ node }) => node)), this.sizes]);
    this.hint = element('p', { className: 'hint' });
    this.said = element('p', { id: 'robot-saved', className: 'hint', role: 'status' });
    this.back = button('limb-undo', 'Undo', 'takes back the last change (Ctrl Z)', () => limbs.undo());
    this.anew = button('limb-reset', 'Reset', 'as the robot was', () => limbs.reset());
    const save = button('save-robot', 'Save robot', "writes the robot's folder; the next start uses it", () => this.save());
    const section = element('section', { id: 'limbs' }, [element('h2', { textContent: 'Soles, hands, IMU' }),
      element('div', { className: 'limb-list', role: 'group', ariaLabel: 'soles, hands, IMU' }, this.rows), this.hint, this.form,
      element('div', { className: 'line' }, [this.back, this.anew, save]), this.said]);
    this.show();
    return section;
  }

  number(text, scale, step, read, write) {
    const input = element('input', { type: 'number', step, ariaLabel: text, className: 'narrow' });
    input.onchange = () => {
      const value = input.value === '' ? NaN : Number(input.value) * scale;
      if (Number.isFinite(value)) this.limbs.change(write(this.limbs.chosen, Number(value.toFixed(6))));
      else this.show(); // what was there
    };
    return { input, scale, read, node: element('label', {}, [element('span', { textContent: text }), input]) };
  }

  show() {
    if (!this.form) return;
    const { chosen, list, mode, past } = this.limbs;
    this.rows.forEach((row, i) => { row.ariaPressed = String(list[i] === chosen); });
    this.hint.textContent = chosen ? 'Pull at the handles in the picture, or write numbers. Axes are those of the link: x red, y green, z blue.'
      : 'Choose one here or in the picture, then move it with the mouse.';
    this.form.hidden = !chosen;
    this.back.disabled = past.length === 0;
    this.anew.disabled = !this.limbs.changedAtAll;
    if (!chosen) return;
    for (const node of this.modes) {
      node.ariaPressed = String(node.mode === mode);
      node.hidden = node.mode === 'size' && !chosen.edges;
    }
    this.frame.value = chosen.frame;
    this.sizes.hidden = !chosen.edges;
    for (const { input, scale, read } of [...this.numbers, ...this.edges]) {
      const value = read(chosen);
      if (value !== undefined) input.value = Number((value / scale).toFixed(2));
    }
  }

  say(text, bad) {
    this.said.textContent = typed(text);
    this.said.classList.toggle('bad', bad);
  }

  async save() {
    const save = Date.now();
    if (!this.send({ do: 'setup', setup: { ...this.request(), save } })) { this.say('The viewer does not answer.', true); return; }
    this.say('Saving …', false);
    for (let waited = 0; waited < kPatience; waited += kLook) {
      await pause(kLook);
      const answer = await fetch(withToken('setup/saved.json'), { cache: 'no-store' }).catch(() => null);
      const saved = answer?.ok ? await answer.json() : null;
      if (saved?.save !== save) continue;
      this.kept = this.kept || saved.ok;
      this.say(saved.ok ? `Saved. Start anew uses it; later: ./twinbus up --robot ${saved.folder}` : saved.text, !saved.ok);
      return;
    }
    this.say('Nobody answered: this page sets up what ./twinbus up runs.', true);
  }
}
