// Sets of plots that are asked for again and again: a title and the names of the fields, from what is there.

const leg = (side) => new RegExp(`^(${side}|${side === 'R' ? 'right' : 'left'}).*(hip|knee|ankle|leg)`, 'i');

// The names with the largest numbers in the last ten seconds.
function largest(history, prefix, count) {
  const rows = history.rows(10);
  const size = (name) => Math.max(0, ...history.pick(name, rows).map((v) => Math.abs(v ?? 0)));
  return history.names().filter((name) => name.startsWith(prefix)).map((name) => [size(name), name])
    .sort((a, b) => b[0] - a[0]).slice(0, count).map(([, name]) => name);
}

export const kPresets = {
  'Legs': (history) => [['right leg [rad]', 'R', 'STATE.q.'], ['left leg [rad]', 'L', 'STATE.q.'], ['knees and ankles [N m]', '', 'STATE.tau.']]
    .map(([title, side, prefix]) => [title, history.joints.filter((name) => (side ? leg(side).test(name) : /knee|ankle_p/i.test(name))).map((name) => prefix + name)]),
  'Feet forces': (history) => {
    const vertical = history.names().filter((name) => name.startsWith('SHOWN.foot_force.'));
    return [['vertical force [N]', vertical]].concat(vertical.map((name) => name.slice('SHOWN.foot_force.'.length)).map((foot) => [
      `${foot.replaceAll('_', ' ')} [N, N m]`, ['fx', 'fy', 'tx', 'ty'].map((axis) => `STATE.wrench.${foot}.${axis}`)]));
  },
  'ZMP': () => ['x', 'y'].map((axis) => [`${axis} [m]`, ['zmp_reference', 'zmp', 'dcm', 'com'].map((field) => `SHOWN.${field}.${axis}`)])
    .concat([['ZMP inside [mm]', ['SHOWN.margin_mm']]]),
  'Tracking error': (history) => [['commanded less measured [rad], the largest six', largest(history, 'TRACKING.q.', 6)]],
  // The paper's Figs. 12 and 13: a foot's force in both, the joint that differs most in both, and what is left.
  'Two logs': (history) => {
    const worst = largest(history, 'RESIDUAL.q.', 6);
    const joint = worst[0]?.slice('RESIDUAL.q.'.length);
    return [['left foot, vertical force [N]', ['STATE.wrench.left_foot.fz', 'OTHER.wrench.left_foot.fz']],
      [`${joint ?? 'joint'} [rad]`, joint ? [`STATE.q.${joint}`, `OTHER.q.${joint}`] : []],
      ['second less first [rad]', worst]];
  },
  'Source difference': (history) => [['standby less active [rad], the largest six', largest(history, 'DIFFERENCE.q.', 6)]],
};
