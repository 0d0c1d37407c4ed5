import { Connection, type Socket } from './protocol/connection';
import type { PanelEvent, Reply, RunStatus, VerbRequest } from './protocol/messages';
import type { Scene } from './protocol/scene_file';
import { FrameScheduler } from './dom/frames';
import { Store } from './state/store';

const STATUS_PERIOD = 1000; // ms: counters of processes are in no event
const STATUS_SHORTEST = 500; // ms between two requests of the status
const STATUS_AGAIN = 100; // ms after a status that may be out of date

export type Listener = (event: PanelEvent) => void;

/** One page's connection with the run, the run's state, and the scene; every part of the page receives it. */
export class Session {
  readonly store = new Store();
  readonly scheduler = new FrameScheduler();
  readonly connection: Connection;
  private readonly listeners: Listener[] = [];
  private readonly losses: (() => void)[] = [];
  private status_time = -Infinity;
  private status_asked = false;
  private status_due = false;

  /** `announce` shows the answer of the run to the operator. */
  constructor(
    readonly scene: Scene,
    open_socket: () => Socket,
    readonly announce: (text: string, refused: boolean) => void,
  ) {
    this.store.servo_period = scene.servo_period;
    this.store.deployment = scene.deployment;
    this.store.clock = scene.clock;
    this.connection = new Connection(open_socket, {
      event: (event) => this.receive(event),
      opened: () => undefined,
      lost: () => this.lose(),
    });
  }

  start(): void {
    this.connection.connect();
    setInterval(() => this.poll_status(), STATUS_SHORTEST);
  }

  on_event(listener: Listener): void {
    this.listeners.push(listener);
  }

  on_loss(listener: () => void): void {
    this.losses.push(listener);
  }

  /** Sends a request and shows its reply: a refusal with what would allow it, and if `quiet` is not set the effect. */
  async request(request: VerbRequest, quiet = false): Promise<Reply> {
    const reply = await this.connection.request(request);
    if (!reply.ok) this.announce(answer_text(request, refusal_text(reply)), true);
    else if (!quiet) this.announce(answer_text(request, reply.text), false);
    this.scheduler.ask();
    return reply;
  }

  seconds(tick: number): number {
    return tick * this.store.servo_period;
  }

  private receive(event: PanelEvent): void {
    if (event.event === 'hello') {
      this.store.connected = true;
      this.status_asked = false;
      this.status_time = -Infinity;
    }
    if (event.event === 'gone') this.connection.end();
    if (this.store.apply(event)) this.status_due = true;
    for (const listener of this.listeners) listener(event);
    this.scheduler.ask();
    this.poll_status();
  }

  private lose(): void {
    this.store.connected = false;
    this.status_asked = false;
    for (const listener of this.losses) listener();
    this.scheduler.ask_now();
  }

  /** The reply may be older than an event that has come meanwhile. */
  private ask_again(): void {
    this.status_due = true;
    this.status_time = performance.now() - STATUS_SHORTEST + STATUS_AGAIN;
  }

  private poll_status(): void {
    const { store } = this;
    if (!store.connected || store.ended || this.status_asked || document.hidden) return;
    const passed = performance.now() - this.status_time;
    if (passed < (this.status_due ? STATUS_SHORTEST : STATUS_PERIOD)) return;
    this.status_time = performance.now();
    this.status_due = false;
    this.status_asked = true;
    const { changes } = store;
    void this.connection.request({ verb: 'status' }).then((reply) => {
      this.status_asked = false;
      if (store.changes !== changes) this.ask_again();
      else if (reply.ok && reply.data) store.apply_status(reply.data as RunStatus);
      this.scheduler.ask();
    });
  }
}

function answer_text(request: VerbRequest, text: string): string {
  const robot = request['robot'];
  const named = typeof robot !== 'string' || text.startsWith(robot);
  return `${request.verb}${named ? '' : ` ${robot}`}: ${text}`;
}

export function refusal_text(reply: Reply): string {
  return reply.expected ? `${reply.text}; expected: ${reply.expected}` : reply.text;
}
