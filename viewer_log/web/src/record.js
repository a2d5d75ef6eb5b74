// Writes the 3D view to a video file (webm) for as long as the button is on.

import { save } from './save.js';

export class Recorder {
  constructor(canvas) { this.canvas = canvas; this.recorder = null; }

  // False when this browser cannot.
  start() {
    if (!window.MediaRecorder || !this.canvas.captureStream) return false;
    const type = ['video/webm;codecs=vp9', 'video/webm'].find((name) => MediaRecorder.isTypeSupported(name));
    if (!type) return false;
    const parts = [];
    this.recorder = new MediaRecorder(this.canvas.captureStream(30), { mimeType: type, videoBitsPerSecond: 6e6 });
    this.recorder.ondataavailable = (event) => parts.push(event.data);
    this.recorder.onstop = () => save(new Blob(parts, { type: 'video/webm' }), 'twinbus.webm');
    this.recorder.start(1000);
    return true;
  }

  stop() {
    this.recorder?.stop();
    this.recorder = null;
  }
}
