// Joins link, robot, stage, panels, plots and what the operator can do.

import { ArmPath } from './arm_path.js';
import { followBars } from './bars.js';
import { bookmark, fragment, restoreLog, restoreView } from './bookmark.js';
import { BrowserPad } from './gamepad.js';
import { Eye } from './eye.js';
import { Ghost } from './ghost.js';
import { HandTarget, handName } from './hand_target.js';
import { History } from './history.js';
import { Joystick } from './joystick.js';
import { Keys } from './keys.js';
import { Lateness } from './lateness.js';
import { Limbs } from './limbs.js';
import { Link } from './link.js';
import { PairLine } from './pair_line.js';
import { Panels } from './panels.js';
import { Parts } from './parts.js';
import { beginOnPhone, onPhone } from './phone.js';
import { Plots } from './plots.js';
import { Pusher } from './push.js';
import { Recorder } from './record.js';
import { Robot } from './robot.js';
import { Setup } from './setup.js';
import { Stage } from './stage.js';
import { plain } from './surface.js';
import { Theme } from './theme.js';
import { Timeline } from './timeline.js';
import './style.css';
import './setup.css';
import './phone.css';

const $ = (id) => document.getElementById(id);
const kBalanced = 1, kHold = 2;
const kSilent = 1500; // a picture older than this is not to be believed [ms]
const kTell = 80; // nobody reads numbers that change faster [ms]
const kBusy = 300; // a page that draws less often is slow itself [ms]
const kPatience = 1500; // a page without a robot is drawn then [ms]
const kAgain = 3000; // a second stop within this is meant as a harder one [ms]

document.body.classList.toggle('plain', plain);
const stage = new Stage($('view'));
const robot = new Robot(stage.scene);
const commanded = new Ghost(stage.scene, 0xffd23f);
const standby = new Ghost(stage.scene, 0xff5d5d);
const other = new Ghost(stage.scene, 0xff9d1f); // of a second log, or of the posture that is being set up
other.wanted = true;
const armPath = new ArmPath(stage.scene);
const panels = new Panels((request) => link.send(request));
const history = new History();
const plots = new Plots($('plot-box'), history, lookBack);
const recorder = new Recorder($('view'));
const lateness = new Lateness($('late'));
const eye = new Eye($('eye'));
const timeline = new Timeline((request) => link.send(request), {
  jumped: () => {
    history.clear();
    panels.forget();
  },
  fill: () => { if (plots.open) link.send({ do: 'fill', seconds: Number(plots.seconds.value) }); },
  toast: (text) => panels.toast(text),
});
plots.seek = (time) => {
  if (!timeline.active) return false;
  link.send({ do: 'pause' });
  timeline.seek(time);
  return true;
};
function see(live) {
  robot.pose(live.q, live.base);
  stage.fitTo(unseen);
  unseen = null;
}

let hello = { joints: [], hands: [] };
let newest = null;
let unseen = null; // a robot that the view has not been fitted to
let newestAt = 0;
let drawnAt = -Infinity;
let toldAt = -Infinity;
let lastStop = -Infinity;
let past = null; // { time, live } while looking back
let plan = null; // the newest path message
const figures = { drawn: 0, first: null }; // pictures; when the first one with the whole robot was on the screen [ms since the page began]
let wholeDrawn = false; // the last picture was one
let placed = false; // log and time of the address were asked for

const link = new Link({
  connected: (yes) => { if (!yes) panels.connected(false); }, // the first picture says that it is there
  hello: (message) => {
    hello = message;
    if (String(history.joints) !== String(message.joints)) history.clear();
    history.joints = message.joints;
    panels.hello(message);
    stage.fixed = message.fixed;
    joystick.enabled = message.trusted && !timeline.active;
    parts.allow(joystick.enabled);
    robot.load(message.joints, (model) => {
      if (robot.model !== model) return; // a newer one is on its way
      const pattern = model.clone();
      for (const ghost of [commanded, standby, other]) ghost.adopt(pattern, message.joints);
      unseen = model;
      if (newest) see(newest);
    }).then(beginDrawing).catch((error) => panels.toast(`The robot cannot be shown: ${error.message}`));
  },
  live: (message) => {
    newest = message;
    newestAt = performance.now();
    panels.connected(true);
  },
  signals: (message) => {
    if (hello.joints.length === 0) return; // the numbers have no names yet
    addRow(message, newest);
  },
  replay: (message) => {
    const first = !timeline.active;
    timeline.replay(message);
    panels.replaying(message);
    newestAt = performance.now();
    panels.connected(true);
    if (first) {
      joystick.enabled = false;
      parts.allow(false);
    }
  },
  marks: (message) => timeline.showMarks(message),
  shelf: (message) => {
    timeline.shelf(message);
    if (!placed && timeline.active) {
      placed = true;
      for (const request of restoreLog(timeline)) link.send(request);
    }
  },
  past: (message) => {
    if (message.jumps !== timeline.state?.jumps) return; // it is somewhere else by now
    history.clear();
    for (const [signals, live] of message.rows) addRow(signals, live);
    plots.rebuild();
  },
  status: (message) => panels.status(message),
  scene: (message) => {
    stage.shapes.show(message);
    stage.takeIn(message);
  },
  camera: (message) => eye.picture(message),
  recording: (message) => recordingLog(message),
  path: (message) => {
    plan = message;
    if (message.status !== 'ok') panels.toast(`No arm path: ${message.status}.`);
  },
  note: (message) => panels.toast(message.text),
  refused: () => panels.refused(),
});

// What a message of signals has, for plots; a recording is on the time of its log.
function addRow(signals, picture) {
  const { type, time, log_s: logTime, ...groups } = signals;
  const live = picture ?? {};
  groups.SHOWN = { base: live.base?.slice(0, 3), com: live.com, zmp: live.zmp, zmp_reference: live.zmp_reference, dcm: live.dcm,
    margin_mm: live.margin_mm, foot_force: Object.fromEntries((live.feet ?? []).map((name, i) => [name, live.foot_force[i]])) };
  history.add(logTime ?? time, groups, picture);
}

function stop() {
  if (timeline.active) { timeline.toggle(); return; } // nothing moves: the same key plays and pauses

  joystick.release();
  const now = performance.now();
  const kind = now - lastStop < kAgain ? kHold : kBalanced;
  lastStop = now;
  if (!link.send({ do: 'stop', kind })) panels.toast('STOP COULD NOT BE SENT: use ./twinbus stop or the robot\'s own switch.');
  else panels.toast(kind === kHold ? 'Stop (hold) sent.' : 'Stop sent. Once more: hold at once.');
}

const pairLine = new PairLine(stage, $('view'), robot);
const limbs = new Limbs(stage, $('view'), robot, () => {}); // after it: a click that picks a link chooses nothing else
const setup = new Setup($('setup'), limbs, pairLine, {
  near: () => newest?.pairs ?? [],
  look: () => {
    if (stage.follow) chips.follow();
    limbs.look();
  },
  send: (request) => link.send(request),
  toast: (text) => panels.toast(text),
});

const parts = new Parts($('parts'), robot, { send: (request) => link.send(request), toast: (text) => panels.toast(text) });

// --- driving ---
const joystick = new Joystick($('joystick'), $('speed'), (velocity) => link.send({ do: 'walk', ...velocity }), () => {
  if (panels.mode !== 'walk') link.send({ do: 'mode', mode: 'walk' });
});
const pad = new BrowserPad(joystick, stop, $('pad'));
const target = new HandTarget(stage, $('view'), (side, at) => {
  link.send({ do: 'reach', side, at });
  panels.toast(`The ${handName(side)} is asked to go there.`);
});
$('reach').onclick = ({ target: button }) => {
  const { side } = button.dataset;
  if (!side) return;
  const shown = target.offer(side, newest?.hands?.[hello.hands.findIndex(({ name }) => name === side)]);
  for (const other of $('reach').children) other.classList.toggle('on', shown && other === button);
  $('reach-note').hidden = !shown;
  $('reach-note').textContent = 'Drag the handle in the picture; the hand goes where you let go.';
  button.blur();
};
$('stop').onpointerdown = stop; // on pressing, not on letting go
$('stop').onkeydown = (event) => { if (event.key === 'Enter' && !event.repeat) stop(); };
$('clear').onclick = () => link.send({ do: 'clear' });

// --- what only a simulated world can do ---
const sim = (request) => { if (!link.send({ do: 'sim', ...request })) panels.toast('The viewer process does not answer.'); };
const world = {
  pause: () => sim({ action: panels.paused ? 'go' : 'pause' }),
  step: (ticks) => sim({ action: 'step', ticks }),
  slow: () => sim({ action: 'pace', pace: panels.slowed ? 1 : 0.1 }),
  reset: () => link.send({ do: 'reset' }),
};
const pusher = new Pusher(stage, $('view'), robot, (request) => link.send({ do: 'push', ...request }), (words) => panels.toast(words));
const press = (id, act) => { $(id).onclick = () => { act(); $(id).blur(); }; };
press('sim-pause', world.pause);
press('sim-step', () => world.step(1));
press('sim-ten', () => world.step(50));
press('sim-slow', world.slow);
press('sim-reset', world.reset);
press('anew', world.reset);
press('sim-push', () => $('sim-push').classList.toggle('on', pusher.arm(!pusher.armed)));
pusher.done = () => $('sim-push').classList.remove('on');

// --- looking ---
function toggle(id, change) {
  const button = $(id);
  button.onclick = () => {
    change(button.classList.toggle('on'));
    button.blur();
  };
  return () => button.onclick();
}

// The 3D view shows another time; badge, health and STOP stay with the present.
function lookBack(time) {
  past = time === null ? null : history.pictureAt(time);
  document.body.classList.toggle('past', past !== null);
  $('past').hidden = past === null;
  if (past) $('past-text').textContent = `Looking back: robot time ${past.time.toFixed(2)} s. The robot goes on.`;
}

const theme = new Theme((light) => {
  stage.theme(light);
  plots.rebuild();
  $('light').textContent = light ? 'dark' : 'light';
});
$('light').onclick = () => { theme.toggle(); $('light').blur(); };
$('present').onclick = () => plots.hold(null);
const chips = {
  follow: toggle('follow', (on) => { stage.follow = on; }),
  forces: toggle('show-forces', (on) => { stage.forces.visible = on; }),
  balance: toggle('show-balance', (on) => { stage.balance.visible = on; }),
  command: toggle('show-command', (on) => { commanded.wanted = on; }),
  standby: toggle('show-standby', (on) => {
    standby.wanted = on;
    if (on && !newest?.standby) panels.toast('No standby source is heard: ./twinbus up --stack both has one.');
  }),
  plots: toggle('show-plots', (on) => {
    plots.toggle(on);
    if (!on) plots.hold(null);
    else if (timeline.active) timeline.fill();
  }),
  other: toggle('show-other', (on) => { other.wanted = on; }),
  panels: toggle('show-panels', (on) => document.body.classList.toggle('no-panels', !on)),
  setup: toggle('show-setup', (on) => { if (on && parts.open) chips.parts(); setup.toggle(on); }),
  parts: toggle('show-parts', (on) => { if (on && setup.open) chips.setup(); parts.toggle(on); }),
  eye: toggle('show-eye', (on) => eye.toggle(on)),
  record: toggle('record', (on) => {
    $('record').classList.toggle('recording', on);
    if (!on) recorder.stop();
    else if (!recorder.start()) panels.toast('This browser cannot record.');
  }),
};
const [arrowScale, arrowLeast] = $('arrow-scale').querySelectorAll('input');
arrowScale.oninput = () => { stage.arrowScale = 2 ** Number(arrowScale.value); };
arrowLeast.oninput = () => {
  stage.leastForce = Number(arrowLeast.value);
  $('arrow-least').textContent = `${arrowLeast.value} N`;
  arrowLeast.title = `forces under ${arrowLeast.value} N are not drawn`;
};

// A log of its own, beside the one that `up` records anyway.
$('record-log').onclick = () => {
  if (!link.send({ do: 'record', on: !$('record-log').classList.contains('recording') })) panels.toast('The viewer does not answer.');
  $('record-log').blur();
};
let recordings = 0; // messages
function recordingLog({ on, text }) {
  $('record-log').classList.toggle('recording', on);
  $('record-log').textContent = on ? 'end the log' : 'log';
  if (recordings++ > 0 && text) panels.toast(text);
}

$('more').onclick = () => {
  const open = document.querySelector('footer nav').classList.toggle('open');
  $('more').setAttribute('aria-expanded', String(open));
  $('more').textContent = open ? 'less' : 'more …';
  $('more').blur();
};

function inRecording(act) {
  if (timeline.active) act();
  else panels.toast('For recordings: ./twinbus view shows one.');
}
function nudge(by, event) {
  if (!timeline.active) return;
  if (event.shiftKey) timeline.seek(timeline.state.position + by);
  else timeline.step(by);
}
async function shareLink() {
  const address = bookmark(stage, plots, timeline);
  window.history.replaceState(null, '', address);
  let copied = true;
  try { await navigator.clipboard.writeText(address); } catch { copied = false; } // not allowed: it is in the address bar
  panels.toast(copied ? 'The address of this view is copied.' : 'The address of this view is in the address bar.');
}
$('link').onclick = () => { shareLink(); $('link').blur(); };

const live = (act) => () => { if (!timeline.active && panels.trusted) act(); };
const keys = new Keys([
  ['f', 'F', 'camera follows the robot', chips.follow],
  ['c', 'C', 'contact forces', chips.forces],
  ['b', 'B', 'soles, support, ZMP, CoM, DCM', chips.balance],
  ['g', 'G', 'ghost of the commanded posture', chips.command],
  ['j', 'J', 'ghost of the standby source', chips.standby],
  ['p', 'P', 'plots', chips.plots],
  ['l', 'L', 'look back, and to now again', () => {
    if (plots.held !== null) plots.hold(null);
    else { plots.hold(history.last); lookBack(history.last); }
  }],
  ['h', 'H', 'panels at the sides', chips.panels],
  ['t', 'T', 'dark or light', () => theme.toggle()],
  ['n', 'N', 'ghost of the second log', chips.other],
  ['y', 'Y', 'the address of this view', shareLink],
  ['ArrowLeft', '← →', 'recording: the state before, the next (with shift a second)', (event) => nudge(-1, event)],
  ['ArrowRight', '', '', (event) => nudge(1, event)],
  ['[', '[ ]', 'recording: the event before, the next', () => inRecording(() => timeline.jump(-1))],
  [']', '', '', () => inRecording(() => timeline.jump(1))],
  ['i', 'I O', 'recording: the loop begins here, ends here', () => inRecording(() => timeline.mark('in'))],
  ['o', '', '', () => inRecording(() => timeline.mark('out'))],
  ['k', 'K', 'recording: loop', () => inRecording(() => timeline.loop())],
  ['m', 'M', 'simulated world: pause, go on', live(world.pause)],
  ['.', '. ,', 'simulated world: one tick, a tenth of a second', live(() => world.step(1))],
  [',', '', '', live(() => world.step(50))],
  ['x', 'X', 'push the simulated robot: pull at it in the picture', live(() => $('sim-push').onclick())],
  ['s', 'S', 'set up: scene, soles, hands, IMU, posture, pushes, checked pairs', chips.setup],
  ['q', 'Q', 'links and joints: what is drawn, a slider for each joint', chips.parts],
  ['e', 'E', 'what the robot\'s camera sees', chips.eye],
  ['r', 'R', 'record a log, and end it', () => { if (!timeline.active) $('record-log').onclick(); }],
  ['v', 'V', 'record a video of the view', chips.record],
], stop, $('keys'));
$('help').onclick = () => { keys.sheet.hidden = !keys.sheet.hidden; $('help').blur(); };

function draw() {
  if (wholeDrawn) figures.first ??= performance.now(); // a picture begins when the last one is on the screen
  if (newest) {
    // The viewer process may hang with its connection open; a page that was busy itself has not read what came.
    const now = performance.now();
    if (now - newestAt > kSilent && now - drawnAt < kBusy) panels.connected(false);
    drawnAt = now;
    const shown = past?.live ?? newest;
    robot.pose(shown.q, shown.base);
    if (unseen && robot.whole) see(shown);
    stage.shapes.carry(robot.model);
    robot.dim(!panels.online || shown.age_ms === null || shown.age_ms > 500 || shown.role === 'parked');
    const limits = robot.warn(shown.q, shown.pairs);
    if (plan && robot.whole) {
      armPath.show(plan, commanded.model, hello.hands, newest, hello.joints);
      plan = null;
    }
    commanded.pose(shown.command, shown.base);
    standby.pose(shown.standby?.q, shown.base);
    other.pose(shown.other?.q ?? setup.posture(hello.joints) ?? parts.posture(hello.joints, shown.q), shown.other?.base ?? shown.base);
    stage.show(shown);
    parts.tick(shown.q);
    if (now - toldAt >= kTell) {
      toldAt = now;
      panels.live(newest);
      panels.limits(limits);
    }
  }
  armPath.tick();
  limbs.tick();
  pairLine.tick(newest?.pairs ?? []);
  pad.tick();
  plots.tick();
  timeline.tick();
  eye.tick(stage, robot.model, [...stage.onTop, armPath.group, limbs.root, pairLine.group]);
  if (figures.drawn === 0) stage.drawFirst(robot.model);
  else stage.draw();
  lateness.tick();
  ++figures.drawn;
  wholeDrawn = newest !== null && robot.whole;
}
beginOnPhone(chips.panels);
followBars(document.querySelector('header'), document.querySelector('footer'), (top, foot) => stage.keepBetween(...(onPhone() ? [top, foot] : [0, 0])));
if (restoreView(stage, plots)) chips.plots();
if (fragment().get('follow') === '0') chips.follow();
// The first picture is slow to come: it waits for the robot, but not for ever.
function beginDrawing() {
  if (figures.drawn === 0) stage.renderer.setAnimationLoop(draw);
}
setTimeout(beginDrawing, kPatience);
link.connect();

// For tests of the page.
globalThis.twinbus = { figures, link, history, plots, stage, robot, commanded, standby, armPath, joystick, target, timeline, other, setup, limbs, pairLine, parts, eye, chips, panels, pad, pusher };
