// What the keyboard does, and the table of it that `?` shows.

export class Keys {
  // rows: [key as the browser names it, how it is written, what it does, function]; stop: on space.
  constructor(rows, stop, sheet) {
    this.sheet = sheet;
    sheet.querySelector('dl').replaceChildren(...[[' ', 'space', 'stop; twice: hold at once'], ...rows, ['?', '?', 'this table']].filter(([, written]) => written).flatMap(([, written, does]) => {
      const term = document.createElement('dt'), text = document.createElement('dd');
      term.append(Object.assign(document.createElement('kbd'), { textContent: written }));
      text.textContent = does;
      return [term, text];
    }));
    sheet.onclick = () => { sheet.hidden = true; };
    const typing = () => ['INPUT', 'TEXTAREA', 'SELECT'].includes(document.activeElement?.tagName) && document.activeElement.type !== 'range';
    addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      if (event.key === ' ') {
        event.preventDefault(); // also keeps a focused button from being pressed, and stops while something is typed
        if (!event.repeat) stop();
        return;
      }
      if (typing()) { if (event.key === 'Escape') document.activeElement.blur(); return; }
      if (event.repeat && !event.key.startsWith('Arrow')) return;
      if (event.key === '?') sheet.hidden = !sheet.hidden;
      else if (event.key === 'Escape' && !sheet.hidden) sheet.hidden = true;
      else rows.find(([key]) => key === event.key || key === event.key.toLowerCase())?.[3](event);
    });
    addEventListener('keyup', (event) => { if (event.key === ' ') event.preventDefault(); });
  }
}
