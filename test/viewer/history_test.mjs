// What the page keeps for plots and for looking back.   node history_test.mjs
import assert from 'node:assert/strict';
import { derive } from '../../viewer_log/web/src/derived.js';
import { History } from '../../viewer_log/web/src/history.js';
import { kPresets } from '../../viewer_log/web/src/presets.js';
import { nearLimits } from '../../viewer_log/web/src/tint.js';

const history = new History();
history.joints = Array.from({ length: 29 }, (_, i) => `JOINT_${i}`);
const q = (value) => history.joints.map(() => value);
for (let i = 1; i <= 5000; ++i) {
  history.add(i / 60, { STATE: { q: q(i), wrench: { left_foot: [1, 2, 3, 4, 5, 6] } }, SHOWN: { zmp: i % 2 ? [0.1, 0.2, 0] : null } }, { tick: i });
}
assert.ok(history.columns.has('STATE.q.JOINT_3') && history.columns.has('STATE.wrench.left_foot.fz') && history.columns.has('SHOWN.zmp.y'), 'names');
const rows = history.rows(10);
assert.equal(rows.length, 601, 'ten seconds');
assert.equal(history.pick('STATE.q.JOINT_3', rows).at(-1), 5000, 'the newest last');
assert.equal(history.pick('SHOWN.zmp.x', rows).at(-1), null, 'what was not heard is a gap');
assert.equal(history.pick('SHOWN.zmp.x', rows).at(-2), 0.1);
assert.equal(history.rows(1000).length, 3600, 'a minute is kept');
assert.equal(history.pictureAt(4990 / 60).live.tick, 4990, 'looking back');
history.add(5000 / 60, { STATE: { q: q(0) } }, {});
assert.equal(history.rows(1).length, 61, 'a tick said again is no row');
for (const [name, make] of Object.entries(kPresets)) {
  for (const [title, names] of make(history)) assert.ok(typeof title === 'string' && Array.isArray(names), name);
}

// Numbers that follow from those heard.
const last = history.rows(0.5);
assert.equal(history.pick('= STATE.q.JOINT_3 - STATE.q.JOINT_4', last).at(-1), 0, 'a difference');
assert.equal(history.pick('= 2 * (STATE.wrench.left_foot.fz + 1) / 4', last).at(-2), 2, 'sums, products, brackets');
assert.ok(Math.abs(history.pick('= d(STATE.q.JOINT_3)', last).at(-2) - 60) < 1e-6, 'a slope per second');
assert.equal(history.pick('= -abs(STATE.q.JOINT_3)', last).at(-1), -5000);
assert.equal(history.pick('= 1 / (STATE.q.JOINT_3 - STATE.q.JOINT_3)', last).at(-1), null, 'no number where there is none');
assert.equal(history.pick('= SHOWN.zmp.x + 1', last).at(-1), null, 'nor where one is missing');
for (const [text, words] of [['= STATE.q.NOBODY', 'was heard'], ['= (1', 'not closed'], ['= 1 1', 'too many'], ['= ', 'missing'], ['= 1 ^ 2', 'only names'], ['= *', 'was to stand'], ['= alert(1)', 'was heard']])
  assert.throws(() => derive(text, history), new RegExp(words), text);

history.add(1, { STATE: { q: q(0) } }, {});
assert.equal(history.rows(1000).length, 1, 'another run begins anew');

const joint = (lower, upper) => ({ name: 'a', limit: { lower, upper } });
assert.deepEqual(nearLimits([joint(-1, 1), joint(-1, 1), joint(0, 0), null], [0.99, 0, 0, 0]).map((limit) => limit.left.toFixed(2)), ['0.01'], 'limits');
const lift = { name: 'lift', jointType: 'prismatic', limit: { lower: 0, upper: 0.4 } };
assert.deepEqual(nearLimits([lift, joint(-1, 1), lift], [0.0019, 0.97, 0.02]).map((limit) => `${limit.name} ${limit.words}`), ['lift 1.9 mm', 'a 1.7°'], 'a lift has millimetres');
console.log('history: ok');
