// One number over another, as a line through the time that is shown; its newest end is a dot.

export class XyChart {
  // names: of y and x. room: the element it fills.
  constructor(names, room, colour) {
    this.names = names;
    this.colour = colour;
    this.canvas = Object.assign(document.createElement('canvas'), { width: Math.max(120, room.clientWidth), height: Math.max(60, room.clientHeight) });
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', `${names[0]} over ${names[1]}`);
    this.ctx = this.canvas.getContext('2d');
    room.append(this.canvas);
  }

  destroy() { this.canvas.remove(); }
  setScale() {}

  // data: times, y, x.
  setData([, y, x]) {
    const { ctx, canvas } = this;
    const style = getComputedStyle(document.body);
    ctx.clearRect(0, 0, canvas.width, canvas.height);
    const points = y.map((v, i) => [x[i], v]).filter(([a, b]) => a !== null && b !== null);
    this.points = points.length;
    if (points.length === 0) return;
    const range = (k) => {
      const values = points.map((p) => p[k]);
      const [low, high] = [Math.min(...values), Math.max(...values)];
      const margin = 0.05 * (high - low) || 1e-3 * Math.max(1, Math.abs(high));
      return [low - margin, high + margin];
    };
    const [[x0, x1], [y0, y1]] = [range(0), range(1)];
    const [left, bottom] = [52, 24];
    const at = ([a, b]) => [left + (a - x0) / (x1 - x0) * (canvas.width - left - 6), (canvas.height - bottom) - (b - y0) / (y1 - y0) * (canvas.height - bottom - 6)];
    ctx.font = '11px "DejaVu Sans", sans-serif';
    ctx.fillStyle = ctx.strokeStyle = style.getPropertyValue('--dim').trim();
    ctx.lineWidth = 1;
    for (let i = 0; i <= 4; ++i) {
      const [a, b] = [x0 + i / 4 * (x1 - x0), y0 + i / 4 * (y1 - y0)];
      ctx.textAlign = i === 4 ? 'right' : 'center';
      ctx.fillText(Number(a.toPrecision(3)), at([a, y0])[0], canvas.height - 8);
      ctx.textAlign = 'right';
      ctx.fillText(Number(b.toPrecision(3)), left - 6, at([x0, b])[1] + (i === 4 ? 10 : 4));
    }
    ctx.strokeRect(left, 6, canvas.width - left - 6, canvas.height - bottom - 6);
    ctx.strokeStyle = ctx.fillStyle = this.colour;
    ctx.lineWidth = 1.6;
    ctx.beginPath();
    points.forEach((p, i) => (i === 0 ? ctx.moveTo(...at(p)) : ctx.lineTo(...at(p))));
    ctx.stroke();
    ctx.beginPath();
    ctx.arc(...at(points.at(-1)), 3.5, 0, 2 * Math.PI);
    ctx.fill();
  }
}
