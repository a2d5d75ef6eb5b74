// The WebSocket to the viewer: JSON in, requests out, tried again for ever when it breaks.

const kAnswers = new Set(['hello', 'note']); // everything else is a frame
const kRetry = 700; // [ms]

const kHere = new Set(['127.0.0.1', 'localhost']);

let known = null; // the token, and the address that it was read from
export function tokenOfPage() {
  if (known?.address === location.hash) return known.token;
  let token = new URLSearchParams(location.hash.slice(1)).get('token');
  try {
    if (token) sessionStorage.setItem('token', token);
    else token = sessionStorage.getItem('token');
  } catch {
    // storage switched off
  }
  known = { address: location.hash, token: token ?? '' };
  return known.token;
}

// What is of this robot is given to another machine only with the token.
export function withToken(url) {
  const token = tokenOfPage();
  if (!token || url.startsWith('blob:') || url.startsWith('data:')) return url;
  return `${url}${url.includes('?') ? '&' : '?'}token=${encodeURIComponent(token)}`;
}

export class Link {
  // on: an object with a function per message type (live, status, scene, hello, note) and `connected(bool)`.
  // Call connect() once the page is ready to draw: until then frames would pile up.
  constructor(on) {
    this.on = on;
    this.socket = null;
    this.received = 0; // messages
  }

  connect() {
    const token = tokenOfPage();
    const query = token ? `?token=${encodeURIComponent(token)}` : '';
    const socket = new WebSocket(`ws://${location.host}/ws${query}`);
    this.socket = socket;
    if (!token && !kHere.has(location.hostname)) this.on.note?.({ text: 'This address is opened with its token: the whole of what ./twinbus up printed.' });
    socket.onopen = () => {
      this.on.connected(true);
      this.send({ do: 'hello' });
    };
    socket.onmessage = (event) => {
      const message = JSON.parse(event.data);
      ++this.received;
      if (!kAnswers.has(message.type)) socket.send('ack'); // the server then sends no more than can be drawn
      this.on[message.type]?.(message);
    };
    let opened = false;
    socket.addEventListener('open', () => { opened = true; });
    socket.onclose = () => {
      this.on.connected(false);
      if (!opened && token) this.askWhy();
      setTimeout(() => this.connect(), kRetry);
    };
  }

  // A socket does not say why it was refused; a file does.
  async askWhy() {
    try {
      const answer = await fetch(withToken('robot.urdf'), { cache: 'no-store' });
      if (answer.status === 403) this.on.refused?.();
    } catch {
      // nobody is there
    }
  }

  // False when nobody is there to hear it.
  send(request) {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(request));
    return true;
  }
}
