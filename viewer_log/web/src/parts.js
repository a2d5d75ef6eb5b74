// The tree of links: which are drawn, and a slider for every joint that the robot moves.  A joint is asked for where its slider
// is let go; the controller looks along the way first and says why it does not go there.

const kDegree = Math.PI / 180;
const kRenew = 150; // [ms]
const kForget = 4000; // a posture that was asked for is shown for so long [ms]

function element(tag, properties = {}, children = []) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
}

export class Parts {
  // robot: see robot.js; send(request): to the viewer.
  constructor(box, robot, { send, toast }) {
    Object.assign(this, { box, robot, send, toast });
    this.sliders = []; // by joint in bus order; null for one that has none
    this.wanted = {};  // name to angle [rad or m]: being chosen, or asked for
    this.hidden = new Set(); // names of links
    this.model = null;
    this.renewedAt = 0;
    this.askedAt = null;
    this.filter = box.querySelector('input');
    this.filter.oninput = () => this.narrow();
    box.querySelector('button').onclick = () => { for (const { name, box: own } of this.rows) if (!own.checked) { own.checked = true; this.show(name, true); } };
    this.list = box.querySelector('ol');
    this.rows = [];
  }

  get open() { return !this.box.hidden; }

  toggle(on) {
    this.box.hidden = !on;
    document.body.classList.toggle('with-parts', on);
    if (on) this.build();
    else this.wanted = {};
  }

  build() {
    const { model } = this.robot;
    if (!model || model === this.model) return;
    this.model = model;
    this.wanted = {};
    this.sliders = this.robot.joints.map(() => null);
    this.rows = [];
    const links = model.links ?? {};
    const walk = (object, depth, joint) => {
      if (object.isURDFJoint) { for (const child of object.children) walk(child, depth, object); return; }
      if (!object.isURDFLink && object !== model) return;
      this.row(object, depth, joint);
      for (const child of object.children) walk(child, depth + 1, null);
    };
    const root = Object.values(links).find((link) => !link.parent?.isURDFJoint) ?? model;
    walk(root, 0, null);
    this.list.replaceChildren(...this.rows.map(({ node }) => node));
    for (const name of this.hidden) this.show(name, false);
    this.narrow();
  }

  row(link, depth, joint) {
    const name = link.urdfName ?? link.name;
    const shown = element('input', { type: 'checkbox', checked: !this.hidden.has(name), ariaLabel: `draw ${name}` });
    shown.onchange = () => this.show(name, shown.checked);
    const title = element('span', { textContent: name, title: joint ? `${name}, moved by ${joint.urdfName ?? joint.name}` : name });
    title.style.paddingLeft = `${Math.min(6 * depth, 48)}px`;
    const children = [shown, title];
    const number = joint ? this.robot.joints.indexOf(joint) : -1;
    if (number >= 0) children.push(...this.slider(joint, number));
    this.rows.push({ name, box: shown, words: `${name} ${joint?.urdfName ?? joint?.name ?? ''}`.toLowerCase(), node: element('li', {}, children) });
  }

  slider(joint, number) {
    const name = joint.urdfName ?? joint.name;
    const turns = joint.jointType !== 'prismatic';
    const { lower, upper } = joint.limit;
    const ends = lower < upper ? [lower, upper] : [-Math.PI, Math.PI];
    const write = (value) => (turns ? `${(value / kDegree).toFixed(1)}°` : `${(1000 * value).toFixed(0)} mm`);
    const output = element('output', { textContent: '–' });
    const input = element('input', { type: 'range', min: ends[0], max: ends[1], step: (ends[1] - ends[0]) / 1000, ariaLabel: `move ${name}`, title: `${name}, ${write(ends[0])} to ${write(ends[1])}` });
    input.disabled = !this.mayAsk;
    const held = { name, input, output, write };
    input.oninput = () => {
      this.askedAt = null;
      this.wanted[name] = Number(input.value);
      output.textContent = write(this.wanted[name]);
    };
    input.onchange = () => {
      if (!this.send({ do: 'pose', joints: { [name]: Number(input.value) } })) this.toast('The viewer does not answer.');
      this.askedAt = performance.now();
      input.blur();
    };
    this.sliders[number] = held;
    return [input, output];
  }

  // allowed: the page may ask for something.
  allow(allowed) {
    this.mayAsk = allowed;
    for (const slider of this.sliders) if (slider) slider.input.disabled = !allowed;
  }

  // The link itself; what hangs on it has rows of its own.
  show(name, on) {
    if (on) this.hidden.delete(name); else this.hidden.add(name);
    const link = this.model.links[name];
    const walk = (object) => {
      if (object.isMesh && !object.drawsAll) object.visible = on;
      for (const child of object.children) if (!child.isURDFJoint) walk(child);
    };
    if (link) for (const child of link.children) if (!child.isURDFJoint) walk(child);
  }

  narrow() {
    const wanted = this.filter.value.trim().toLowerCase().split(/\s+/);
    for (const { node, words } of this.rows) node.hidden = !wanted.every((part) => words.includes(part));
  }

  // q: where the joints are, in bus order.
  tick(q) {
    if (!this.open) return;
    this.build();
    const now = performance.now();
    if (now - this.renewedAt < kRenew) return;
    this.renewedAt = now;
    if (this.askedAt !== null && now - this.askedAt > kForget) {
      this.wanted = {};
      this.askedAt = null;
    }
    this.sliders.forEach((slider, i) => {
      if (!slider || q[i] == null || slider.name in this.wanted) return;
      slider.input.value = q[i];
      slider.output.textContent = slider.write(q[i]);
    });
  }

  // The posture that is being chosen, in bus order; null when none is.
  posture(names, q) {
    if (!this.open || Object.keys(this.wanted).length === 0) return null;
    return names.map((name, i) => this.wanted[name] ?? q[i]);
  }
}
