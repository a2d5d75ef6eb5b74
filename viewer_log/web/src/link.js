// The WebSocket to the viewer: JSON in, requests out, tried again for ever when it breaks.

const kRetry = 700; // [ms]

function tokenOfPage() {
  const given = new URLSearchParams(location.hash.slice(1)).get('token');
  try {
    if (given) sessionStorage.setItem('token', given);
    return given ?? sessionStorage.getItem('token') ?? '';
  } catch {
    return given ?? ''; // storage switched off
  }
}

export class Link {
  // on: an object with a function per message type (live, status, scene, hello, note) and `connected(bool)`.
  constructor(on) {
    this.on = on;
    this.socket = null;
    this.connect();
  }

  connect() {
    const token = tokenOfPage();
    const query = token ? `?token=${encodeURIComponent(token)}` : '';
    const socket = new WebSocket(`ws://${location.host}/ws${query}`);
    this.socket = socket;
    socket.onopen = () => {
      this.on.connected(true);
      this.send({ do: 'hello' });
    };
    socket.onmessage = (event) => {
      const message = JSON.parse(event.data);
      this.on[message.type]?.(message);
    };
    socket.onclose = () => {
      this.on.connected(false);
      setTimeout(() => this.connect(), kRetry);
    };
  }

  // False when nobody is there to hear it.
  send(request) {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(request));
    return true;
  }
}
