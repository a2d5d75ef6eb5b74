// Plots under the 3D view: any number that was heard, found by typing; one cursor for all and for the 3D view.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { derive } from './derived.js';
import { kPresets } from './presets.js';
import { save } from './save.js';
import { XyChart } from './xy_chart.js';

const kColors = ['#58c4ff', '#ffb020', '#ff5ac8', '#3ecf8e', '#b07cff', '#ff6b6b', '#e8edf4', '#c9e265'];
const kEvery = 120;     // between redraws [ms]
const kMostFound = 40;
const kMostCurves = 8;
const kMostPlots = 3;
const kKept = 'twinbus.plots'; // in the browser's storage
const kOver = /^(.+?)\s+(?:over|vs)\s+(.+)$/;

const make = (tag, properties = {}, children = []) => {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
};

export class Plots {
  // lookBack(time or null): the 3D view shall show that time, or the present.
  constructor(box, history, lookBack) {
    this.box = box;
    this.history = history;
    this.lookBack = lookBack;
    this.plots = []; // { title, names, node, chart, size }
    this.held = null; // end of the window while looking back [s]
    this.drawnAt = 0;
    const find = (name) => box.querySelector(name);
    this.room = find('.plots');
    this.search = find('input');
    this.found = find('.found');
    this.seconds = find('select');
    find('.presets').append(...Object.keys(kPresets).map((name) => make('button', { className: 'chip', textContent: name, onclick: () => this.preset(name) })));
    this.layouts = find('.layouts');
    this.layouts.onchange = () => this.layout(this.layouts.value);
    find('.keep').onclick = () => this.keep();
    this.listLayouts();
    find('.png').onclick = () => this.png();
    find('.csv').onclick = () => this.csv();
    this.search.oninput = () => this.offer();
    this.search.onkeydown = (event) => {
      if (event.key === 'Enter' && this.found.firstChild) this.found.firstChild.click();
    };
    this.search.onfocus = () => this.offer();
    this.search.onblur = () => setTimeout(() => { this.found.hidden = true; }, 200);
    this.room.ondragover = (event) => event.preventDefault();
    this.room.ondrop = (event) => {
      event.preventDefault();
      const on = this.plots.find((plot) => plot.node.contains(event.target));
      this.put(event.dataTransfer.getData('text/plain'), on);
    };
    addEventListener('resize', () => this.plots.forEach((plot) => { plot.chart?.destroy(); plot.chart = null; }));
  }

  get open() { return !this.box.hidden; }

  toggle(open) {
    this.box.hidden = !open;
    if (open && this.plots.length === 0) this.preset('ZMP');
  }

  preset(name) {
    this.clear();
    for (const [title, names] of kPresets[name](this.history)) this.add(title, names);
    for (const button of this.box.querySelectorAll('.presets button')) button.classList.toggle('on', button.textContent === name);
  }

  // Sets of plots of one's own: what is kept in this browser, {name: {seconds, plots: [[title, names]]}}.
  kept() {
    try {
      return JSON.parse(localStorage.getItem(kKept) ?? '{}') ?? {};
    } catch {
      return {};
    }
  }

  listLayouts() {
    const names = Object.keys(this.kept()).sort();
    this.layouts.replaceChildren(make('option', { value: '', textContent: 'kept …' }), ...names.map((name) => make('option', { value: name, textContent: name })));
    this.layouts.hidden = names.length === 0;
  }

  // Keeps what is shown under a name; shown as nothing, the name is forgotten.
  keep(name = prompt('Keep these plots under which name?', this.layouts.value)) {
    if (!name) return;
    const all = this.kept();
    if (this.plots.length === 0) delete all[name];
    else all[name] = { seconds: this.seconds.value, plots: this.plots.map((plot) => [plot.title, plot.names]) };
    try {
      localStorage.setItem(kKept, JSON.stringify(all));
    } catch {
      // storage switched off or full: nothing is kept
    }
    this.listLayouts();
    this.layouts.value = all[name] ? name : '';
  }

  layout(name) {
    const one = this.kept()[name];
    if (!one) return;
    this.clear();
    this.seconds.value = one.seconds;
    for (const [title, names] of one.plots) this.add(title, names);
  }

  clear() { for (const plot of [...this.plots]) this.remove(plot); }

  remove(plot) {
    plot.chart?.destroy();
    plot.node.remove();
    this.plots = this.plots.filter((other) => other !== plot);
    this.rebuild();
  }

  add(title, names) {
    const plot = { title, names: names.slice(0, kMostCurves), chart: null };
    const close = make('button', { className: 'close', textContent: '×', title: 'remove this plot', onclick: () => this.remove(plot) });
    plot.legend = make('div', { className: 'legend' });
    plot.area = make('div', { className: 'area' });
    plot.node = make('div', { className: 'plot' }, [make('header', {}, [make('b', { textContent: title }), close]), plot.legend, plot.area]);
    this.room.append(plot.node);
    this.plots.push(plot);
    this.rebuild();
    return plot;
  }

  // A field to a plot; without one to the last, or to a new one.
  put(name, plot) {
    if (kOver.test(name)) { this.add(name, [name]); return; }
    if (!name.startsWith('=') && !this.history.columns.has(name)) return;
    const target = plot ?? (this.plots.length < kMostPlots ? null : this.plots.at(-1));
    if (!target || kOver.test(target.names[0] ?? '')) { this.add(name.startsWith('=') ? name.slice(1).trim() : name.split('.').slice(0, 2).join('.'), [name]); return; }
    if (!target.names.includes(name) && target.names.length < kMostCurves) target.names.push(name);
    target.chart?.destroy();
    target.chart = null;
  }

  // `= A - B` and `A over B` are typed whole; says whether it is one of them.
  offerComputed() {
    const typed = this.search.value.trim();
    const over = kOver.exec(typed);
    if (!typed.startsWith('=') && !over) return false;
    let problem = null;
    try {
      for (const part of over ? over.slice(1) : [typed]) derive(part, this.history);
    } catch (error) {
      problem = error.message;
    }
    const name = over ? over.slice(1).map((part) => (this.history.columns.has(part) ? part : `= ${part.replace(/^=\s*/, '')}`)).join(' over ') : typed;
    const item = make('li', { textContent: problem ?? `plot ${name}`, className: problem ? 'more' : '' });
    if (!problem) {
      item.onclick = () => {
        this.put(name);
        this.search.blur();
      };
    }
    this.found.replaceChildren(item);
    this.found.hidden = false;
    return true;
  }

  offer() {
    if (this.offerComputed()) return;
    const words = this.search.value.toLowerCase().split(/[\s.]+/).filter(Boolean);
    const names = this.history.names().filter((name) => words.every((word) => name.toLowerCase().includes(word)));
    this.found.replaceChildren(...names.slice(0, kMostFound).map((name) => {
      const item = make('li', { textContent: name, draggable: true });
      item.ondragstart = (event) => event.dataTransfer.setData('text/plain', name);
      item.onclick = () => {
        this.put(name);
        this.search.blur();
      };
      return item;
    }));
    if (names.length > kMostFound) this.found.append(make('li', { className: 'more', textContent: `and ${names.length - kMostFound} more` }));
    if (names.length === 0) this.found.append(make('li', { className: 'more', textContent: 'nothing of that name was heard' }));
    this.found.hidden = false;
  }

  rebuild() { for (const plot of this.plots) { plot.chart?.destroy(); plot.chart = null; } }

  chart(plot, data) {
    const style = getComputedStyle(document.body);
    const [dim, line] = [style.getPropertyValue('--dim').trim(), style.getPropertyValue('--grid').trim()];
    const axis = { stroke: dim, grid: { stroke: line, width: 1 }, ticks: { show: false }, font: '11px "DejaVu Sans", sans-serif' };
    const shortened = plot.names.map((name) => name.replace(/^(SHOWN|STATE|TRACKING|DIFFERENCE|RESIDUAL)\.(q\.|tau\.)?/, ''));
    plot.legend.replaceChildren(...shortened.map((name, i) => make('span', { title: plot.names[i] }, [make('i', { style: `background:${kColors[i]}` }), name])));
    return new uPlot({
      width: Math.max(120, plot.area.clientWidth), height: Math.max(60, plot.area.clientHeight),
      legend: { show: false },
      cursor: { sync: { key: 'twinbus' }, drag: { x: false, y: false }, points: { size: 6 } },
      scales: { x: { time: false } },
      axes: [{ ...axis, size: 24, values: (_, ticks) => ticks.map((t) => `${+t.toFixed(2)} s`) }, { ...axis, size: 52 }],
      series: [{}, ...plot.names.map((name, i) => ({ label: name, stroke: kColors[i], width: 1.6, points: { show: false } }))],
      hooks: {
        setCursor: [(chart) => { if (this.held !== null && chart.cursor.idx != null) this.lookBack(chart.data[0][chart.cursor.idx]); }],
        ready: [(chart) => {
          chart.over.addEventListener('click', () => {
            const time = chart.posToVal(chart.cursor.left, 'x');
            if (this.seek?.(time)) return; // a recording goes there itself
            this.hold(this.held === null ? this.history.last : null);
            if (this.held !== null) this.lookBack(time);
          });
        }],
      },
    }, data, plot.area);
  }

  // The window stands still at an end, or runs again.
  hold(end) {
    this.held = end;
    if (end === null) this.lookBack(null);
  }

  // Call once per picture.
  tick() {
    const now = performance.now();
    if (!this.open || now - this.drawnAt < kEvery || this.history.count === 0) return;
    this.drawnAt = now;
    const end = this.held ?? this.history.last;
    const seconds = Number(this.seconds.value);
    const rows = this.history.rows(seconds, end);
    const times = rows.map((row) => this.history.time[row]);
    for (const plot of this.plots) {
      if (this.held !== null && plot.chart && plot.heldAt === end) continue;
      plot.heldAt = this.held;
      const data = [times, ...plot.names.map((name) => this.history.pick(name, rows))];
      const over = kOver.exec(plot.names[0] ?? '');
      if (over) {
        plot.chart ??= new XyChart(over.slice(1), plot.area, kColors[0]);
        plot.chart.setData([times, ...over.slice(1).map((name) => this.history.pick(name, rows))]);
        continue;
      }
      if (!plot.chart) plot.chart = this.chart(plot, data);
      else plot.chart.setData(data, false);
      plot.chart.setScale('x', { min: end - seconds, max: end });
    }
  }

  // The plots as they are, under each other, with their titles.
  png() {
    const drawn = this.plots.filter((plot) => plot.chart);
    if (drawn.length === 0) return;
    const gap = 46;
    const canvas = document.createElement('canvas');
    canvas.width = Math.max(...drawn.map((plot) => plot.chart.ctx.canvas.width));
    canvas.height = drawn.reduce((sum, plot) => sum + plot.chart.ctx.canvas.height + gap, 0);
    const paint = canvas.getContext('2d');
    const style = getComputedStyle(document.body);
    paint.fillStyle = style.getPropertyValue('--ground').trim();
    paint.fillRect(0, 0, canvas.width, canvas.height);
    let y = 0;
    for (const plot of drawn) {
      paint.font = 'bold 14px "DejaVu Sans", sans-serif';
      paint.fillStyle = style.getPropertyValue('--ink').trim();
      paint.fillText(plot.title, 10, y + 18);
      paint.font = '12px "DejaVu Sans", sans-serif';
      let x = 10;
      plot.names.forEach((name, i) => {
        paint.fillStyle = kColors[i];
        paint.fillText(name, x, y + 36);
        x += paint.measureText(name).width + 14;
      });
      paint.drawImage(plot.chart.ctx.canvas, 0, y + gap);
      y += plot.chart.ctx.canvas.height + gap;
    }
    canvas.toBlob((blob) => save(blob, 'twinbus_plots.png'));
  }

  // Every curve that is shown, over the window that is shown.
  csv() {
    const names = [...new Set(this.plots.flatMap((plot) => plot.names).flatMap((name) => kOver.exec(name)?.slice(1) ?? [name]))];
    const rows = this.history.rows(Number(this.seconds.value), this.held ?? this.history.last);
    const columns = names.map((name) => this.history.pick(name, rows));
    const lines = rows.map((row, i) => [this.history.time[row], ...columns.map((column) => column[i] ?? '')].join(','));
    const text = [['time_s', ...names].join(','), ...lines].join('\n') + '\n';
    this.lastCsv = text;
    save(new Blob([text], { type: 'text/csv' }), 'twinbus_plots.csv');
  }
}
