// A stick on the page that walks the robot while it is held; letting go says zero several times.
//
// The robot's side is the judge: it stops by itself when the page falls silent.

const kEvery = 80;   // [ms]
const kZeros = 4;
const kMost = { vx: 0.3, vy: 0.15, wz: 0.3 }; // [m/s, m/s, rad/s] at the rim
const kDead = 0.12;

const bent = (v) => (Math.abs(v) < kDead ? 0 : Math.sign(v) * (Math.abs(v) - kDead) / (1 - kDead));

export class Joystick {
  // walk({vx, vy, wz}): to the robot; wanted(): the stick was taken hold of.
  constructor(pad, readout, walk, wanted) {
    this.pad = pad;
    this.readout = readout;
    this.walk = walk;
    this.wanted = wanted;
    this.stick = pad.querySelector('i');
    this.held = false;
    this.side = false;
    this.enabled = true;
    this.velocity = { vx: 0, vy: 0, wz: 0 };
    pad.onpointerdown = (event) => {
      if (!this.enabled) return;
      pad.setPointerCapture(event.pointerId);
      this.side = event.shiftKey || event.button === 2;
      this.take();
      this.move(event);
    };
    pad.onpointermove = (event) => { if (this.held) this.move(event); };
    pad.onpointerup = pad.onpointercancel = pad.onlostpointercapture = () => this.release();
    pad.oncontextmenu = (event) => event.preventDefault();
    addEventListener('blur', () => this.release());
    document.addEventListener('visibilitychange', () => { if (document.hidden) this.release(); });
    setInterval(() => this.say(), kEvery);
    this.zeros = 0;
  }

  take() {
    if (this.held) return;
    this.held = true;
    this.wanted();
  }

  move(event) {
    const box = this.pad.getBoundingClientRect();
    const x = (event.clientX - box.x - box.width / 2) / (box.width / 2);
    const y = (event.clientY - box.y - box.height / 2) / (box.height / 2);
    this.push(Math.max(-1, Math.min(1, x)), Math.max(-1, Math.min(1, y)), this.side);
  }

  // x right, y down, both -1..1; sideways: x steps to the side in place of turning.
  push(x, y, sideways) {
    this.stick.style.transform = `translate(${0.28 * this.pad.clientWidth * x}px, ${0.28 * this.pad.clientWidth * y}px)`;
    const [right, down] = [bent(x), bent(y)];
    this.velocity = { vx: -down * kMost.vx, vy: sideways ? -right * kMost.vy : 0, wz: sideways ? 0 : -right * kMost.wz };
    this.show();
  }

  release() {
    if (!this.held) return;
    this.held = false;
    this.push(0, 0, false);
    this.zeros = kZeros;
    this.say();
  }

  say() {
    if (this.held) this.walk(this.velocity);
    else if (this.zeros > 0) {
      --this.zeros;
      this.walk({ vx: 0, vy: 0, wz: 0 });
    }
  }

  show() {
    const { vx, vy, wz } = this.velocity;
    this.readout.textContent = `${vx.toFixed(2)} m/s · ${vy.toFixed(2)} m/s · ${(wz * 180 / Math.PI).toFixed(0)} °/s`;
  }
}
