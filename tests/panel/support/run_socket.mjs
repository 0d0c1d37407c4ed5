// The operator socket of a run: cheaper than a command for every look at the state.
import { connect } from 'node:net';

export class RunSocket {
  #waiting = new Map();
  #next_id = 1;
  #rest = '';

  constructor(path) {
    this.socket = connect(path);
    this.socket.setEncoding('utf8');
    this.socket.on('data', (data) => this.#receive(data));
    this.socket.on('error', () => this.#end());
    this.socket.on('close', () => this.#end());
  }

  /** The reply, or null when the run has ended. */
  request(request) {
    if (this.socket.destroyed) return Promise.resolve(null);
    const id = this.#next_id++;
    this.socket.write(`${JSON.stringify({ ...request, id })}\n`);
    return new Promise((resolve) => this.#waiting.set(id, resolve));
  }

  close() {
    this.socket.destroy();
  }

  #receive(data) {
    const lines = (this.#rest + data).split('\n');
    this.#rest = lines.pop();
    for (const line of lines) {
      const frame = JSON.parse(line);
      this.#waiting.get(frame.id)?.(frame);
      this.#waiting.delete(frame.id);
    }
  }

  #end() {
    for (const resolve of this.#waiting.values()) resolve(null);
    this.#waiting.clear();
    this.socket.destroy();
  }
}
