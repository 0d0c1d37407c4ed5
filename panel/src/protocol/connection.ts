import type { PanelEvent, Reply, VerbRequest } from './messages';

/** The part of WebSocket that the connection uses; tests give their own. */
export interface Socket {
  readyState: number;
  send(text: string): void;
  close(): void;
  onopen: (() => void) | null;
  onmessage: ((message: { data: unknown }) => void) | null;
  onclose: (() => void) | null;
}

export interface ConnectionEvents {
  event(event: PanelEvent): void;
  opened(): void;
  lost(): void;
}

const OPEN = 1;
const LOST: Reply = { ok: false, reason: 'lost', text: 'the connection to the panel is lost' };

/** The socket of the panel's server: requests with their replies, and events. It connects again after a loss. */
export class Connection {
  private socket: Socket | null = null;
  private next_id = 1;
  private readonly waiting = new Map<number, (reply: Reply) => void>();
  private newest_beat = 0;
  private beat_time = -Infinity;
  private delay = 250;
  private ended = false;

  constructor(
    private readonly open_socket: () => Socket,
    private readonly events: ConnectionEvents,
    private readonly wait: (call: () => void, milliseconds: number) => void = (call, time) => setTimeout(call, time),
  ) {}

  connect(): void {
    const socket = this.open_socket();
    this.socket = socket;
    socket.onopen = () => {
      this.delay = 250;
      this.events.opened();
    };
    socket.onmessage = (message) => this.receive(String(message.data));
    socket.onclose = () => this.closed();
  }

  /** No further attempt to connect after the run has ended. */
  end(): void {
    this.ended = true;
  }

  get connected(): boolean {
    return this.socket?.readyState === OPEN;
  }

  /** The newest beat of the server. It is part of every jog. */
  get beat(): number {
    return this.newest_beat;
  }

  /** ms since the newest beat. */
  get silence(): number {
    return performance.now() - this.beat_time;
  }

  request(request: VerbRequest): Promise<Reply> {
    const socket = this.socket;
    if (!socket || socket.readyState !== OPEN) return Promise.resolve(LOST);
    const id = this.next_id++;
    socket.send(JSON.stringify({ ...request, id }));
    return new Promise((resolve) => this.waiting.set(id, resolve));
  }

  private receive(text: string): void {
    const frame = parse(text);
    if (!frame) return;
    if ('event' in frame) {
      if (frame.event === 'beat') this.take_beat(frame.number);
      else this.events.event(frame);
      return;
    }
    if (frame.id === undefined) return;
    this.waiting.get(frame.id)?.(frame);
    this.waiting.delete(frame.id);
  }

  private take_beat(number: number): void {
    this.newest_beat = number;
    this.beat_time = performance.now();
  }

  private closed(): void {
    this.socket = null;
    for (const resolve of this.waiting.values()) resolve(LOST);
    this.waiting.clear();
    this.events.lost();
    if (this.ended) return;
    this.wait(() => this.connect(), this.delay);
    this.delay = Math.min(2 * this.delay, 4000);
  }
}

function parse(text: string): PanelEvent | Reply | null {
  try {
    const frame: unknown = JSON.parse(text);
    if (typeof frame !== 'object' || frame === null) return null;
    if ('event' in frame || 'ok' in frame) return frame as PanelEvent | Reply;
  } catch {
    // a frame that is not JSON is ignored: the panel's server sends none
  }
  return null;
}
