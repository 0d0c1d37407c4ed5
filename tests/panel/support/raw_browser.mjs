// The socket of the panel without a page: what any program of this machine could send.
import { WebSocket } from './packages.mjs';

export const socket_url = (url) => new URL('socket', url).href.replace(/^http/, 'ws');

/**
 * Resolves with the open socket, or with the status code of the refusal. `made` receives the socket at once: frames may
 * come together with the answer that opens it.
 */
export function open_socket(address, { origin, ...options } = {}, made = (socket) => socket) {
  const own = new URL(address).origin.replace(/^ws/, 'http');
  return new Promise((resolve) => {
    const socket = new WebSocket(address, { origin: origin === undefined ? own : (origin ?? undefined), ...options });
    const result = made(socket);
    socket.on('open', () => resolve({ socket: result, code: 101 }));
    socket.on('unexpected-response', (_request, response) => resolve({ socket: null, code: response.statusCode }));
    socket.on('error', () => resolve({ socket: null, code: 0 }));
  });
}

/** A socket with its frames. */
export class RawBrowser {
  frames = [];
  closed = false;
  #waiting = [];
  #next_id = 1;

  static async open(url, options) {
    const wrap = (socket) => new RawBrowser(socket);
    const { socket, code } = await open_socket(socket_url(url), options, wrap);
    if (!socket) throw new Error(`the server refuses the socket with ${code}`);
    return socket;
  }

  constructor(socket) {
    this.socket = socket;
    socket.on('message', (data) => {
      const frame = JSON.parse(data.toString());
      if (frame.event === 'beat') this.beat = frame.number;
      else if (this.frames.length < 10_000) this.frames.push(frame);
      this.#waiting = this.#waiting.filter((waits) => !waits(frame));
    });
    socket.on('close', () => {
      this.closed = true;
      for (const waits of this.#waiting) waits(null);
    });
    socket.on('error', () => undefined);
  }

  /** The first frame for which `holds` is true, also if it has come already. */
  async first(holds) {
    return this.frames.find(holds) ?? (await this.next(holds));
  }

  /** The next frame for which `holds` is true; null when the server closes the socket. */
  next(holds) {
    if (this.closed) return Promise.resolve(null);
    return new Promise((resolve) =>
      this.#waiting.push((frame) => {
        if (frame !== null && !holds(frame)) return false;
        resolve(frame);
        return true;
      }),
    );
  }

  send(text) {
    this.socket.send(text);
  }

  request(request) {
    const id = this.#next_id++;
    const reply = this.next((frame) => frame.id === id);
    this.send(JSON.stringify({ ...request, id }));
    return reply;
  }

  close() {
    this.socket.terminate();
  }
}
