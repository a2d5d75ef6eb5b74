// Joins link, robot, stage and panels, and the keys and buttons.

import { Link } from './link.js';
import { Panels } from './panels.js';
import { Robot } from './robot.js';
import { Stage } from './stage.js';

const $ = (id) => document.getElementById(id);
const kBalanced = 1, kHold = 2;
const kSilent = 1500; // a picture older than this is not to be believed [ms]
const kAgain = 3000; // a second stop within this is meant as a harder one [ms]

const stage = new Stage($('view'));
const robot = new Robot(stage.scene);
const panels = new Panels((request) => link.send(request));
let newest = null;
let newestAt = 0;
let lastStop = -Infinity;

const link = new Link({
  connected: (yes) => { if (!yes) panels.connected(false); }, // the first picture says that it is there
  hello: (message) => {
    panels.hello(message);
    robot.load(message.joints).catch((error) => panels.toast(`The robot cannot be shown: ${error.message}`));
  },
  live: (message) => {
    newest = message;
    newestAt = performance.now();
    panels.connected(true);
  },
  status: (message) => panels.status(message),
  scene: (message) => stage.showObstacles(message.obstacles),
  note: (message) => panels.toast(message.text),
});

function stop() {
  const now = performance.now();
  const kind = now - lastStop < kAgain ? kHold : kBalanced;
  lastStop = now;
  if (!link.send({ do: 'stop', kind })) panels.toast('STOP COULD NOT BE SENT: use ./twinbus stop or the robot\'s own switch.');
  else panels.toast(kind === kHold ? 'Stop (hold) sent.' : 'Stop sent. Once more: hold at once.');
}

function toggle(id, change) {
  const button = $(id);
  button.onclick = () => {
    change(button.classList.toggle('on'));
    button.blur();
  };
  return () => button.onclick();
}

$('stop').onpointerdown = stop; // on pressing, not on letting go
$('clear').onclick = () => link.send({ do: 'clear' });
const toggleFollow = toggle('follow', (on) => { stage.follow = on; });
const togglePanels = toggle('show-panels', (on) => document.body.classList.toggle('no-panels', !on));
toggle('show-forces', (on) => { stage.forces.visible = on; });
toggle('show-balance', (on) => { stage.balance.visible = on; });

addEventListener('keydown', (event) => {
  if (event.key === ' ') {
    event.preventDefault(); // also keeps a focused button from being pressed
    if (!event.repeat) stop();
  } else if (event.key === 'Enter' && document.activeElement === $('stop') && !event.repeat) {
    stop();
  } else if (event.key === 'f') {
    toggleFollow();
  } else if (event.key === 'h') {
    togglePanels();
  }
});
addEventListener('keyup', (event) => { if (event.key === ' ') event.preventDefault(); });

stage.renderer.setAnimationLoop(() => {
  if (newest) {
    // The viewer process may hang with its connection open.
    if (performance.now() - newestAt > kSilent) panels.connected(false);
    robot.pose(newest.q, newest.base);
    robot.dim(!panels.online || newest.age_ms === null || newest.age_ms > 500 || newest.role === 'parked');
    stage.show(newest);
    panels.live(newest);
  }
  stage.draw();
});
