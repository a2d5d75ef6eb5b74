// How many pictures this page draws in a second: one that draws few says so, because its picture is then older than its numbers.

const kLook = 2000; // [ms]
const kFew = 8;     // pictures per second

export class Lateness {
  // node: where it is said, in its first child.
  constructor(node) { Object.assign(this, { node, since: performance.now(), drawn: 0 }); }

  // At every picture.
  tick() {
    ++this.drawn;
    const now = performance.now(), passed = now - this.since;
    if (passed < kLook) return;
    const rate = 1000 * this.drawn / passed;
    const hidden = document.hidden || passed > 10 * kLook; // a page that was not looked at drew nothing
    this.node.hidden = hidden || rate >= kFew;
    if (!this.node.hidden) this.node.firstChild.textContent = `This page draws late: ${rate.toFixed(rate < 3 ? 1 : 0)} pictures/s.`;
    this.since = now;
    this.drawn = 0;
  }
}
