// Dark or light, remembered by the browser.

function remembered() {
  try { return localStorage.getItem('theme'); } catch { return null; }
}

export class Theme {
  // change(light): told at once and at every change.
  constructor(change) {
    this.change = change;
    const asked = new URLSearchParams(location.hash.slice(1)).get('theme');
    this.set((asked ?? remembered() ?? 'dark') === 'light');
  }

  set(light) {
    this.light = light;
    document.body.classList.toggle('light', light);
    try { localStorage.setItem('theme', light ? 'light' : 'dark'); } catch { /* storage switched off */ }
    this.change(light);
  }

  toggle() { this.set(!this.light); }
}
