// The program as its user types it: texts are written with ./twinbus; where it is installed the viewer's page says twinbus.

export const kWritten = './twinbus';

// As data-command of index.html has it.
export function typed(text, command = globalThis.document?.documentElement.dataset.command ?? kWritten) {
  return text.replace(/(?<![./])\.\/twinbus(?![/_-])/g, command); // not of ../twinbus, a/./twinbus, ./twinbus_viewer
}
