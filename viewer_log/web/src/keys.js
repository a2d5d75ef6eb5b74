// What the keyboard does, and the table of it that `?` shows.

const kNoText = ['range', 'checkbox', 'radio', 'button', 'color', 'file'];

// Does this element take what is typed as text?  Then no key does anything else.
export const isText = (node) => node?.tagName === 'TEXTAREA' || node?.isContentEditable === true ||
  (node?.tagName === 'INPUT' && !kNoText.includes(node.type));

export class Keys {
  // rows: [key as the browser names it, how it is written, what it does, function]; stop: on space.
  constructor(rows, stop, sheet) {
    this.sheet = sheet;
    sheet.querySelector('dl').replaceChildren(...[[' ', 'space', 'stop; twice: hold at once'], ...rows, ['?', '?', 'this table']].filter(([, written]) => written).flatMap(([, written, does]) => {
      const term = document.createElement('dt'), text = document.createElement('dd');
      term.className = text.className = does.startsWith('recording:') ? 'of-recording' : does.startsWith('simulated world:') || does.startsWith('stop;') ? 'of-robot' : '';
      term.append(Object.assign(document.createElement('kbd'), { textContent: written }));
      text.textContent = does;
      return [term, text];
    }));
    sheet.onclick = () => { sheet.hidden = true; };
    addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || event.isComposing) return;
      const at = document.activeElement;
      if (isText(at)) { if (event.key === 'Escape') at.blur(); return; }
      if (event.key === ' ') {
        event.preventDefault(); // also keeps a focused button from being pressed
        if (!event.repeat) stop();
        return;
      }
      if (at?.tagName === 'SELECT') { if (event.key === 'Escape') at.blur(); return; }
      if (event.repeat && !event.key.startsWith('Arrow')) return;
      if (event.key === '?') sheet.hidden = !sheet.hidden;
      else if (event.key === 'Escape' && !sheet.hidden) sheet.hidden = true;
      else rows.find(([key]) => key === event.key || key === event.key.toLowerCase())?.[3](event);
    });
    addEventListener('keyup', (event) => { if (event.key === ' ' && !isText(document.activeElement)) event.preventDefault(); });
    // The button says which key stops: none while a text is typed.
    const hint = document.querySelector('#stop small');
    const written = hint?.textContent;
    const say = () => { if (hint) hint.textContent = isText(document.activeElement) ? 'click' : written; };
    addEventListener('focusin', say);
    addEventListener('focusout', () => setTimeout(say));
  }
}
