// Everything around the 3D view: badge, health, rates, sources, balance map, guard, processes, messages.

import { handName } from './hand_target.js';
import { typed } from './typed.js';

const $ = (id) => document.getElementById(id);
const kVerdicts = { clear: '✓', near: '•', 'will collide': '▲', 'in collision': '✖' }; // not by colour alone
const kLevels = { close: '▲ ', touch: '✖ ' }; // of a pair of links
const kSeverities = ['', '▲ ', '✖ '];
const kNames = { simulator: 'SIMULATOR', robot: 'ROBOT', replay: 'REPLAY', none: 'NO SOURCE' };

function text(id, value) {
  const node = $(id);
  if (node.textContent !== value) node.textContent = value;
}

function element(tag, properties = {}, children = []) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
}

const kWrongToken = typed('The token of this address is wrong or of an earlier run: open the address that ./twinbus up prints now.');
const hertz = (value) => (value > 0 ? `${value.toFixed(0)} Hz` : '–');
const age = (ms) => (ms === null ? 'never' : ms < 1000 ? `${Math.round(ms)} ms` : `${(ms / 1000).toFixed(1)} s`);
const kStanding = ['balance', 'walk', 'sway', 'squat']; // modes
const kLong = 70; // a headline of more letters is written smaller
const clock = (utime) => new Date(utime / 1000).toTimeString().slice(0, 8);

export class Panels {
  // send(request): to the viewer.
  constructor(send) {
    this.send = send;
    this.trusted = false;
    this.active = 0;
    this.lastEvent = -1;
    this.weight = 1000; // [N]
    this.robot = '';
    for (const button of document.querySelectorAll('#modes button')) {
      button.onclick = () => send({ do: 'mode', mode: button.dataset.mode });
    }
  }

  // A button for each; those that are there stay, one of them may be on.
  hands(names) {
    const had = [...$('reach').children].map((button) => button.dataset.side);
    if (names.length === had.length && names.every((name, i) => name === had[i])) return;
    $('reach').replaceChildren(...names.map((name) => {
      const said = handName(name);
      const button = element('button', { title: 'a handle to drag; the hand goes where it is let go', textContent: `${said[0].toUpperCase()}${said.slice(1)} …` });
      button.dataset.side = name;
      return button;
    }));
  }

  hello(message) {
    this.trusted = message.trusted && !this.recording;
    this.weight = message.mass * 9.81;
    this.robot = message.robot;
    // A robot on a fixed base neither stands nor walks.
    for (const button of document.querySelectorAll('#modes button')) button.hidden = message.fixed && kStanding.includes(button.dataset.mode);
    $('drive').hidden = message.fixed;
    this.hands(message.hands.map(({ name }) => name));
    document.title = `twinbus: ${message.robot}`;
    $('watching').hidden = message.trusted;
    for (const button of document.querySelectorAll('#modes button, #reach button, #sim-box button')) button.disabled = !message.trusted;
    document.body.classList.toggle('watching', !message.trusted);
    $('clear').disabled = !message.trusted;
  }

  // The newest replay message: from now on nothing can be asked of a robot.
  replaying(message) {
    this.recording = message;
    text('drive-name', 'Mode');
    this.trusted = false;
  }

  // What was shown is of another moment.
  forget() { this.lastEvent = -1; }

  live(live) {
    const present = live.age_ms !== null && live.age_ms < 500;
    let source = !present ? 'none' : this.recording ? 'replay' : live.source;
    this.active = present ? live.run : 0;
    this.lived = true;
    const badge = `source-${source}`;
    if (this.badge !== badge) {
      document.body.classList.remove(this.badge);
      document.body.classList.add(badge);
      this.badge = badge;
    }
    if (source === 'none' && !this.recording && this.paused) source = live.source; // it stands still on purpose
    text('badge-name', kNames[source] ?? source);
    const now = performance.now();
    if (now - (this.slow ?? 0) < 100) return; // figures that change faster cannot be read
    this.slow = now;
    text('badge-detail', present && this.recording ? `${this.robot} · recorded from ${live.source}, ${live.role} · term ${live.term}` : present ? `${this.robot} · ${live.role}, term ${live.term} · ${age(live.age_ms)} old`
      : live.age_ms === null ? 'waiting for STATE' : `last state ${age(live.age_ms)} ago`);
    text('rate-time', `${(live.time ?? 0).toFixed(1)} s`);
    text('rate-tick', String(live.tick));
    this.feet(live);
    this.map(live);
    this.pairs(live.pairs);
  }

  // Of 0 to 6 feet: what each carries; how far inside the support the ZMP is, or on how few feet it lies between.
  feet(live) {
    const stand = live.loaded.filter(Boolean).length;
    $('balance-box').hidden = live.feet.length === 0;
    text('margin', live.margin_mm !== null ? `ZMP ${live.margin_mm.toFixed(0)} mm inside` : live.feet.length === 0 ? 'no feet'
      : stand === 0 ? 'no foot stands' : `stands on ${stand === 1 ? 'one foot' : `${stand} feet`}`);
    const names = live.feet.join();
    if (this.footNames !== names) {
      this.footNames = names;
      $('feet').replaceChildren(...live.feet.map((name, i) => element('div', {}, [
        element('label', { textContent: `${name.replaceAll('_', ' ')} ` }, []), element('b', { id: `force-${i}` }),
        element('div', { className: 'bar' }, [element('i', { id: `bar-${i}` })])])));
    }
    live.feet.forEach((_, i) => {
      const force = live.foot_force[i] ?? 0;
      text(`force-${i}`, `${force.toFixed(0)} N`);
      $(`bar-${i}`).style.width = `${Math.max(0, Math.min(100, 100 * force / this.weight))}%`;
    });
  }

  // Seen from above, forward up, centred between the feet.
  map(live) {
    const all = live.soles.flat();
    if (all.length === 0) return;
    const [sx, sy] = all.reduce(([x, y], p) => [x + p[0] / all.length, y + p[1] / all.length], [0, 0]);
    const [w, x, y, z] = live.base.slice(3);
    const yaw = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
    const turned = (p) => [-(-s * (p[0] - sx) + c * (p[1] - sy)), -(c * (p[0] - sx) + s * (p[1] - sy))];
    const reach = (i) => Math.max(0.1, ...all.map((p) => Math.abs(turned(p)[i])));
    const scale = Math.min(125 / reach(0), 52 / reach(1)); // units per metre
    const at = (p) => turned(p).map((v) => (scale * v).toFixed(1));
    const outline = (points) => points.map((p) => at(p).join(',')).join(' ');
    const known = (p) => p && p.every((v) => v !== null);
    const dot = (p, radius, fill) => (known(p) ? `<circle cx="${at(p)[0]}" cy="${at(p)[1]}" r="${radius}" fill="${fill}"/>` : '');
    $('map').innerHTML =
      `<polygon points="${outline(live.polygon)}" fill="#3ecf8e2e" stroke="#3ecf8e" stroke-width=".8"/>` +
      live.soles.map((sole, i) => (sole.length > 1 ? `<polygon points="${outline(sole)}" fill="${live.loaded[i] ? '#58c4ff30' : 'none'}" stroke="#8fb3d9" stroke-width=".6"/>`
        : `<circle cx="${at(sole[0])[0]}" cy="${at(sole[0])[1]}" r="4" fill="${live.loaded[i] ? '#58c4ff60' : 'none'}" stroke="#8fb3d9" stroke-width=".6"/>`)).join('') +
      (known(live.zmp_reference) ? `<circle cx="${at(live.zmp_reference)[0]}" cy="${at(live.zmp_reference)[1]}" r="3" fill="none" stroke="#ffffff99" stroke-width=".7"/>` : '') +
      dot(live.dcm, 1.7, '#7cf5d0') +
      dot(live.com, 2.4, '#ffd23f') + dot(live.zmp, 2.4, '#ff5ac8');
  }

  pairs(pairs) {
    this.close = pairs.some((pair) => pair.level);
    const rows = pairs.slice(0, 4).map((pair) => element('div', {
      className: `pair ${pair.level}`,
    }, [element('span', { textContent: `${pair.a} – ${pair.b}` }), element('b', { textContent: `${kLevels[pair.level] ?? ''}${pair.mm.toFixed(0)} mm` })]));
    $('pairs').replaceChildren(...rows);
  }

  limits(near) {
    const all = near.slice(0, 4).map(({ name, words }) => `${name} ${words}`).join(', ');
    text('limits', all);
    $('limits-row').hidden = near.length === 0;
    $('tint-row').hidden = near.length === 0 && !this.close;
  }

  status(status) {
    if (!this.online) return;
    let { level, text: sentence, remedy } = status.health;
    if (level === 'good' && this.active === 0 && this.lived && !this.recording) [level, sentence, remedy] = ['waiting', 'No state comes at this moment.', ''];
    const stopped = level === 'stopped' || (status.stop ?? 'none') !== 'none';
    if (remedy) sentence += ` ${this.trusted || this.recording ? remedy : 'It is ended at the computer where it runs.'}`;
    if (this.recording) sentence = sentence.replace(/ ?Press (Clear|STOP).*$/, '');
    if ($('health').className !== level) $('health').className = level;
    text('health-text', typed(sentence));
    $('health-text').classList.toggle('long', sentence.length > kLong);
    document.body.classList.toggle('stopped', stopped);
    document.body.classList.toggle('bad', level === 'bad');
    $('clear').hidden = !stopped || !this.trusted;
    $('anew').hidden = !status.health.anew || !this.trusted;
    const shown = status.sources.find((source) => source.run === (this.active || this.lastRun));
    if (this.active) this.lastRun = this.active;
    this.paused = shown?.pace === 4;
    this.slowed = shown?.pace === 5;
    $('sim-box').hidden = this.recording || shown?.kind !== 'simulator';
    text('sim-now', this.paused ? 'paused' : this.slowed ? `× ${status.realtime_factor.toFixed(2)}` : 'runs');
    text('sim-pause', this.paused ? 'Go on' : 'Pause');
    text('sim-slow', this.slowed ? '× 1' : '× 0.1');
    text('rate-state', hertz(status.state_hz));
    text('rate-command', hertz(status.command_hz));
    text('rate-guard', hertz(status.guard_hz));
    text('rate-factor', status.realtime_factor > 0 ? `× ${status.realtime_factor.toFixed(2)}` : '–');
    const mode = status.controller;
    this.mode = mode?.mode ?? null;
    const name = !mode ? '–' : mode.motion !== 'none' ? mode.motion : mode.mode;
    text('mode-now', !mode ? 'no controller' : mode.stopping !== 'none' ? `stopping (${mode.stopping})` : name);
    for (const button of document.querySelectorAll('#modes button')) button.classList.toggle('on', button.dataset.mode === name);
    text('guard-now', status.guard ? `${kVerdicts[status.guard.verdict] ?? ''} ${status.guard.verdict} · ${status.guard.pairs} pairs` : 'not heard');
    this.sources(status.sources);
    this.processes(status.processes);
    this.events(status.events);
  }

  sources(list) {
    if (list.length === 0) {
      $('sources').replaceChildren(element('p', { className: 'hint', textContent: this.recording ? 'None is told of here.' : typed('None heard. Start the stack with ./twinbus up.') }));
      return;
    }
    // Buttons stay the same nodes while the list does, so that a click is never lost to a redraw.
    const key = JSON.stringify([this.active, this.trusted, list.map((s) => [s.run, s.role, s.kind])]);
    if (key !== this.sourcesKey) {
      this.sourcesKey = key;
      this.sourceNotes = new Map();
      $('sources').replaceChildren(...list.map((source) => {
        const active = source.run === this.active;
        const end = active ? element('span', { className: 'active', textContent: 'active' })
          : element('button', {
            textContent: this.active ? 'Switch to it' : 'Activate', disabled: !this.trusted,
            onclick: () => this.send({ do: 'switch', run: source.run }),
          });
        const note = element('small');
        this.sourceNotes.set(source.run, note);
        return element('div', { className: 'source' },
          [element('i', { className: `c-${source.kind}` }), element('b', { textContent: kNames[source.kind] ?? source.kind }), end, note]);
      }));
    }
    for (const source of list) {
      const parts = [source.age_ms > 1000 ? `silent for ${age(source.age_ms)}` : source.role, `${source.missed} missed`, `${source.late} late`, `${source.rejected} rejected`];
      if (source.refusal) parts.push(source.refusal);
      this.sourceNotes.get(source.run).textContent = parts.join(' · ');
    }
  }

  processes(list) {
    const rows = list.map((p) => {
      const silent = p.age_ms > 1000;
      return element('tr', { className: silent ? 'silent' : p.state === 3 ? 'degraded' : p.state < 2 ? 'waiting' : '', title: `pid ${p.pid}, rejected ${p.rejected}, lost ${p.lost}` }, [
        element('td', {}, [element('i')]),
        element('td', { textContent: p.kind + (silent ? ' (silent)' : '') }),
        element('td', { textContent: p.rate ? p.rate.toFixed(0) : '–' }),
        element('td', { textContent: p.p99_us ? `${p.p99_us.toFixed(0)} µs` : '–' }),
        element('td', { textContent: String(p.missed) }),
      ]);
    });
    document.querySelector('#processes tbody').replaceChildren(...rows);
  }

  events(list) {
    const last = list.at(-1)?.n ?? 0;
    if (last === this.lastEvent) return;
    this.lastEvent = last;
    $('events').replaceChildren(...[...list].reverse().map((event) => element('li', { className: `s${event.severity}` },
      [element('small', { textContent: `${clock(event.utime)} ${event.from}` }), `${kSeverities[event.severity] ?? ''}${typed(event.text)}${event.count > 1 ? ` (×${event.count})` : ''}`])));
  }

  connected(yes) {
    if (this.online === yes) return;
    this.online = yes;
    document.body.classList.toggle('offline', !yes);
    if (yes) return;
    this.lastEvent = -1;
    $('health').className = 'bad';
    text('health-text', this.wrongToken ? kWrongToken : 'The viewer process does not answer: the picture is old. Trying again.');
  }

  // It answers, but does not know the token of this address.
  refused() {
    this.wrongToken = true;
    $('health').className = 'bad';
    text('health-text', kWrongToken);
  }

  toast(message) {
    $('toast').textContent = typed(message);
    $('toast').hidden = false;
    clearTimeout(this.toastTimer);
    this.toastTimer = setTimeout(() => { $('toast').hidden = true; }, 5000);
  }
}
