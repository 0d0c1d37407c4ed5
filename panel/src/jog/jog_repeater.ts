/** Repeats a jog while a control is pressed. It has no page and no clock of its own, so that tests can drive it. */

export type JogFrame = 'axes' | 'motors' | 'base' | 'tool';

export interface JogOrder {
  robot: string;
  axis: string;
  velocity: number; // rad/s or m/s, with sign
  in: JogFrame;
}

export interface JogHost {
  /** ms; grows while the page is frozen. */
  now(): number;
  /** Calls `call` every `period` ms until the result is called. */
  every(call: () => void, period: number): () => void;
  /** ms since the panel's server has sent its newest beat. */
  silence(): number;
  jog(order: JogOrder): void;
  hold(robot: string): void;
  /** The jog has ended, or has not begun; `reason` is empty at a release. */
  ended(reason: string): void;
}

export const JOG_PERIOD = 80; // ms; the run ends a jog that is not repeated for 200 ms
export const LONGEST_GAP = 200; // ms between two calls of the timer: the page was frozen
export const LONGEST_SILENCE = 250; // ms without a beat of the panel's server

export class JogRepeater {
  private order: JogOrder | null = null;
  private last = 0;
  private cancel: () => void = () => undefined;

  constructor(private readonly host: JogHost) {}

  get active(): JogOrder | null {
    return this.order;
  }

  /** Begins a jog. While another one is active, nothing begins. */
  press(order: JogOrder): boolean {
    if (this.order) return false;
    this.order = order;
    this.last = this.host.now();
    this.cancel = this.host.every(() => this.repeat(), JOG_PERIOD);
    this.host.jog(order);
    return true;
  }

  /** Ends the jog: the robot receives `hold`. A new press begins the next one. */
  release(reason = ''): void {
    const order = this.order;
    if (!order) return;
    this.order = null;
    this.cancel();
    this.host.hold(order.robot);
    this.host.ended(reason);
  }

  private repeat(): void {
    if (!this.order) return;
    const now = this.host.now();
    const gap = now - this.last;
    this.last = now;
    if (gap > LONGEST_GAP) this.release(`the page was frozen for ${Math.round(gap)} ms`);
    else if (this.host.silence() > LONGEST_SILENCE) this.release('the panel is silent');
    else this.host.jog(this.order);
  }
}
