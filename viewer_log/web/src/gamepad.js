// A game pad at the browser: left bumper held drives the joystick, B stops.

const kBumper = 4, kB = 1;

export class BrowserPad {
  constructor(joystick, stop, label) {
    this.joystick = joystick;
    this.stop = stop;
    this.label = label;
    this.driving = false;
    this.pressedB = false;
  }

  // Call once per picture.
  tick() {
    const pad = navigator.getGamepads?.().find((one) => one?.connected && one.mapping === 'standard');
    this.label.hidden = !pad;
    const b = pad?.buttons[kB].pressed ?? false;
    if (b && !this.pressedB) this.stop();
    this.pressedB = b;
    const bumper = pad?.buttons[kBumper].pressed ?? false;
    if (bumper && this.joystick.enabled) {
      if (!this.driving) this.joystick.take();
      this.driving = true;
      const sideways = Math.abs(pad.axes[0]) > Math.abs(pad.axes[2]);
      this.joystick.push(sideways ? pad.axes[0] : pad.axes[2], pad.axes[1], sideways);
    } else if (this.driving) {
      this.driving = false;
      this.joystick.release();
    }
  }
}
