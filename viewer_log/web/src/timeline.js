// A recording on a line of time: play, scrub, step, speed, loop between two marks, jump to what happened, another log beside it.

const $ = (id) => document.getElementById(id);
const kSimulated = 1e15; // clocks show less only where time began with the run [us]
const kSeekEvery = 60;   // between places asked for while the line is dragged [ms]
const kFillAfter = 250;  // a place where it stays so long gets its plots filled [ms]
const kKinds = { switch: 'switches', stop: 'stops', fall: 'falls', guard: 'guard', missed: 'missed ticks', message: 'messages' };
const kSpeeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8, 16];

const option = (value, text) => Object.assign(document.createElement('option'), { value, textContent: text });
const seconds = (s) => {
  const minutes = Math.floor(s / 60);
  return minutes > 0 ? `${minutes}:${(s - 60 * minutes).toFixed(3).padStart(6, '0')}` : s.toFixed(3);
};
const megabytes = (bytes) => (bytes < 1e9 ? `${(bytes / 1e6).toFixed(0)} MB` : `${(bytes / 1e9).toFixed(1)} GB`);

export class Timeline {
  // send(request): to the viewer; jumped(): the log went somewhere else; fill(): plots want what was before.
  constructor(send, { jumped, fill, toast }) {
    Object.assign(this, { send, jumped, fill, toast });
    this.state = null; // the newest replay message
    this.marks = [];
    this.dragging = false;
    this.askedAt = 0;
    this.wanted = null; // a place to go to, not yet asked for
    $('tl-speed').append(...kSpeeds.map((x) => option(x, `× ${x}`)));
    $('tl-kind').append(option('', 'all events'), ...Object.entries(kKinds).map(([kind, name]) => option(kind, name)));
    const press = (id, act) => { $(id).onclick = () => { act(); $(id).blur(); }; };
    press('tl-play', () => this.toggle());
    press('tl-back', () => this.step(-1));
    press('tl-on', () => this.step(1));
    press('tl-in', () => this.mark('in'));
    press('tl-out', () => this.mark('out'));
    press('tl-loop', () => this.loop());
    press('tl-last', () => this.jump(-1));
    press('tl-next', () => this.jump(1));
    $('tl-speed').onchange = () => { this.send({ do: 'speed', x: Number($('tl-speed').value) }); $('tl-speed').blur(); };
    $('tl-kind').onchange = () => { this.drawMarks(); $('tl-kind').blur(); };
    $('tl-log').onchange = () => { this.send({ do: 'open', log: $('tl-log').value }); $('tl-log').blur(); };
    $('tl-beside').onchange = () => { this.send({ do: 'beside', log: $('tl-beside').value, shift: 0 }); $('tl-beside').blur(); };
    $('tl-shift').onchange = () => this.send({ do: 'beside', log: this.state?.beside?.log ?? '', shift: Number($('tl-shift').value) || 0 });
    const line = $('tl-line');
    line.onpointerdown = (event) => {
      line.setPointerCapture(event.pointerId);
      this.dragging = true;
      this.drag(event);
    };
    line.onpointermove = (event) => { if (this.dragging) this.drag(event); };
    line.onpointerup = line.onpointercancel = () => { this.dragging = false; };
  }

  get active() { return this.state !== null; }

  replay(message) {
    const first = this.state === null;
    const opened = this.state?.log !== message.log;
    const jumped = !first && (opened || this.state.jumps !== message.jumps);
    this.state = message;
    if (first) document.body.classList.add('replaying');
    if (first || jumped) {
      if (jumped) this.jumped();
      clearTimeout(this.fillTimer);
      this.fillTimer = setTimeout(this.fill, kFillAfter);
    }
    this.draw();
  }

  // The place is believed when it comes back; while it is dragged the line shows where the hand is.
  seek(s) {
    if (!this.state) return;
    this.wanted = Math.max(0, Math.min(s, this.state.duration));
    this.tick();
  }

  // Call once per picture.
  tick() {
    const now = performance.now();
    if (this.wanted === null || now - this.askedAt < kSeekEvery) return;
    this.askedAt = now;
    this.send({ do: 'seek', s: this.wanted });
    this.wanted = null;
  }

  drag(event) {
    const box = $('tl-line').getBoundingClientRect();
    this.seek((event.clientX - box.left) / box.width * this.state.duration);
  }

  toggle() { this.send({ do: this.state?.playing ? 'pause' : 'play' }); }
  step(by) { this.send({ do: 'step', by }); }
  loop() { this.send({ do: 'loop', on: !this.state?.loop }); }

  // Sets a mark here; where it is already, takes it away.
  mark(which) {
    const marks = { in: this.state.in, out: this.state.out };
    marks[which] = marks[which] !== null && Math.abs(marks[which] - this.state.position) < 1e-3 ? null : this.state.position;
    if (marks.in !== null && marks.out !== null && marks.out <= marks.in) marks[which === 'in' ? 'out' : 'in'] = null;
    this.send({ do: 'mark', ...marks });
  }

  chosen() {
    const kind = $('tl-kind').value;
    return this.marks.filter((mark) => !kind || mark[1] === kind);
  }

  // To the next event of the chosen kind, or the one before.
  jump(by) {
    const here = this.state.position, apart = 0.004;
    const list = this.chosen();
    const mark = by > 0 ? list.find((m) => m[0] > here + apart) : list.findLast((m) => m[0] < here - apart);
    if (!mark) { this.toast(by > 0 ? 'No such event after this.' : 'No such event before this.'); return; }
    this.send({ do: 'pause' });
    this.seek(mark[0]);
    this.toast(mark[2]);
  }

  showMarks(message) {
    this.marks = message.marks;
    this.leftOut = message.left_out;
    this.drawMarks();
  }

  drawMarks() {
    if (!this.state) return;
    const share = (s) => `${100 * s / Math.max(this.state.duration, 1e-6)}%`;
    $('tl-marks').replaceChildren(...this.chosen().map(([s, kind, words]) => {
      const node = Object.assign(document.createElement('i'), { className: `mark-${kind}`, title: `${seconds(s)} s  ${words}` });
      node.style.left = share(s);
      return node;
    }));
    this.marksOf = `${this.state.log} ${this.state.duration}`;
  }

  shelf(message) {
    if (message.trouble) this.toast(message.trouble);
    const key = JSON.stringify(message.logs.map((log) => [log.log, log.bytes]));
    if (key === this.shelfKey) return;
    this.shelfKey = key;
    this.logs = message.logs;
    const rows = () => message.logs.map((log) => option(log.log, `${log.log} · ${megabytes(log.bytes)}`));
    $('tl-log').replaceChildren(...rows());
    $('tl-beside').replaceChildren(option('', 'no second log'), ...rows());
    if (this.state) this.draw();
  }

  fileOf(name) { return this.logs?.find((log) => log.log === name)?.file ?? name; }
  nameOf(asked) { return this.logs?.find((log) => log.log === asked || log.file === asked)?.log ?? asked; }

  draw() {
    const s = this.state;
    const set = (id, value) => { const node = $(id); if (node.textContent !== value) node.textContent = value; };
    set('tl-play', s.playing ? '❚❚' : '▶');
    set('tl-time', seconds(s.position));
    set('tl-all', `of ${seconds(s.duration)} s`);
    const clock = s.began_us > kSimulated ? new Date((s.began_us + 1e6 * s.position) / 1000).toLocaleTimeString() : ''; // a run without a bus begins at 0
    set('tl-clock', clock);
    const damage = s.damage.places > 0 ? `${s.damage.places} damaged places, ${s.damage.bytes} bytes` : '';
    set('tl-note', [s.scanned < 1 ? `looking for events: ${Math.floor(100 * s.scanned)} %` : '', damage,
      s.beside && !s.beside.shown ? 'the second log has nothing here' : '', this.leftOut ? `${this.leftOut} more events` : ''].filter(Boolean).join(' · '));
    const share = (t) => `${100 * t / Math.max(s.duration, 1e-6)}%`;
    const at = this.dragging && this.wanted !== null ? this.wanted : s.position;
    $('tl-head').style.left = share(at);
    const from = s.in ?? 0, to = s.out ?? s.duration;
    Object.assign($('tl-range').style, { left: share(from), width: share(to - from) });
    $('tl-range').classList.toggle('marked', s.in !== null || s.out !== null);
    $('tl-loop').classList.toggle('on', s.loop);
    $('tl-in').classList.toggle('on', s.in !== null);
    $('tl-out').classList.toggle('on', s.out !== null);
    for (const [id, value] of [['tl-speed', String(s.speed)], ['tl-log', s.log], ['tl-beside', s.beside?.log ?? '']]) {
      if ($(id).value !== value && document.activeElement !== $(id)) $(id).value = value;
    }
    $('tl-shift').parentElement.hidden = !s.beside;
    if (document.activeElement !== $('tl-shift')) $('tl-shift').value = s.beside?.shift ?? 0;
    if (this.marksOf !== `${s.log} ${s.duration}`) this.drawMarks();
  }
}
