// The last minute of everything that was received, by robot time: numbers to plot, and pictures to look back at.
//
// A column per number that was ever heard, named like CHANNEL.field.joint; a ring, so nothing grows.

import { derive } from './derived.js';

const kRows = 3600;      // a minute at 60 Hz
const kPictures = 1800;  // live messages are larger
const kAxes = { 2: ['x', 'y'], 3: ['x', 'y', 'z'], 4: ['w', 'x', 'y', 'z'], 6: ['fx', 'fy', 'fz', 'tx', 'ty', 'tz'] };

export class History {
  constructor() {
    this.joints = [];
    this.clear();
  }

  clear() {
    this.count = 0;
    this.last = -Infinity;
    this.time = new Float64Array(kRows);
    this.pictures = new Array(kPictures);
    this.columns = new Map();
    this.trees = new Map();
  }

  // groups: { CHANNEL: {...} }, anything nested; picture: the live message shown at that time.
  add(time, groups, picture) {
    if (time === this.last || time == null) return;
    if (time < this.last) this.clear(); // another run
    this.last = time;
    const row = this.count++ % kRows;
    for (const column of this.columns.values()) column[row] = NaN;
    this.time[row] = time;
    this.pictures[(this.count - 1) % kPictures] = { time, live: picture };
    for (const [channel, fields] of Object.entries(groups)) {
      if (fields == null) continue;
      let tree = this.trees.get(channel);
      if (!tree) this.trees.set(channel, tree = { name: channel, children: new Map(), column: null });
      this.put(tree, fields, row);
    }
  }

  put(node, value, row) {
    if (value === null || value === undefined) return;
    if (typeof value === 'object') {
      for (const key in value) {
        let child = node.children.get(key);
        if (!child) node.children.set(key, child = { name: `${node.name}.${this.label(key, value)}`, children: new Map(), column: null });
        this.put(child, value[key], row);
      }
    } else if (typeof value !== 'string') {
      if (!node.column) this.columns.set(node.name, node.column = new Float64Array(kRows).fill(NaN));
      node.column[row] = Number(value);
    }
  }

  label(key, value) {
    if (!Array.isArray(value)) return key;
    if (value.length === this.joints.length) return this.joints[key];
    return kAxes[value.length]?.[key] ?? key;
  }

  names() { return [...this.columns.keys()].sort(); }

  // Rows of the last seconds before end, oldest first: a list of indices into the columns.
  rows(seconds, end = this.last) {
    const rows = [];
    for (let n = Math.max(0, this.count - kRows); n < this.count; ++n) {
      const t = this.time[n % kRows];
      if (t >= end - seconds && t <= end) rows.push(n % kRows);
    }
    return rows;
  }

  pick(name, rows) {
    if (name.startsWith('=')) {
      try {
        return derive(name, this)(rows);
      } catch {
        return rows.map(() => null); // of another robot or run
      }
    }
    const column = this.columns.get(name);
    return rows.map((row) => (column && !Number.isNaN(column[row]) ? column[row] : null));
  }

  // The picture nearest to a time, or null.
  pictureAt(time) {
    let best = null;
    for (const one of this.pictures) if (one && (!best || Math.abs(one.time - time) < Math.abs(best.time - time))) best = one;
    return best;
  }
}
