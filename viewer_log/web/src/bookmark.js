// The page's address as a bookmark: log, time, camera and plots, behind the #.

const round = (v) => +v.toFixed(3);

export function fragment() { return new URLSearchParams(location.hash.slice(1)); }

// timeline may be without a log: then camera and plots only.
export function bookmark(stage, plots, timeline) {
  const parts = new URLSearchParams();
  const token = fragment().get('token');
  if (token) parts.set('token', token);
  if (timeline.active) {
    const { log, position, beside } = timeline.state;
    parts.set('log', timeline.fileOf(log));
    parts.set('t', position.toFixed(3));
    if (beside) { parts.set('with', timeline.fileOf(beside.log)); parts.set('shift', String(beside.shift)); }
  }
  parts.set('cam', [...stage.camera.position.toArray(), ...stage.controls.target.toArray()].map(round).join(','));
  if (!stage.follow) parts.set('follow', '0');
  if (plots.open) {
    parts.set('plots', JSON.stringify(plots.plots.map((plot) => [plot.title, plot.names])));
    parts.set('window', plots.seconds.value);
  }
  return `${location.origin}${location.pathname}#${parts.toString().replaceAll('+', '%20')}`;
}

// Camera and plots as in the address.  True when plots are to be open.
export function restoreView(stage, plots) {
  const parts = fragment();
  const cam = (parts.get('cam') ?? '').split(',').map(Number);
  if (cam.length === 6 && cam.every(Number.isFinite)) {
    stage.camera.position.set(...cam.slice(0, 3));
    stage.controls.target.set(...cam.slice(3));
    stage.tookIn = stage.turned = true;
  }
  let wanted = null;
  try { wanted = JSON.parse(parts.get('plots')); } catch { /* not one of ours */ }
  if (!Array.isArray(wanted)) return false;
  for (const [title, names] of wanted.slice(0, 3)) {
    if (Array.isArray(names)) plots.add(String(title), names.map(String));
  }
  if (parts.get('window')) plots.seconds.value = parts.get('window');
  return true;
}

// What is to be asked of the viewer so that log, second log and time are those of the address.
export function restoreLog(timeline) {
  const parts = fragment(), requests = [];
  const log = parts.get('log');
  if (!log) return requests;
  const name = timeline.nameOf(log);
  if (name !== timeline.state.log) requests.push({ do: 'open', log: name });
  const beside = parts.get('with');
  if (beside) requests.push({ do: 'beside', log: timeline.nameOf(beside), shift: Number(parts.get('shift')) || 0 });
  const t = Number(parts.get('t'));
  if (parts.get('t') !== null && Number.isFinite(t)) requests.push({ do: 'seek', s: Math.max(0, t) });
  return requests;
}
