/** The interval of time that a plot shows: it follows the run, or it stands still. */
export class PlotWindow {
  private fixed: [number, number] | null = null;

  constructor(private span: number) {}

  get live(): boolean {
    return this.fixed === null;
  }

  /** The interval, s; `newest`: time of the newest sample. */
  interval(newest: number): [number, number] {
    if (this.fixed) return this.fixed;
    return newest > this.span ? [newest - this.span, newest] : [0, this.span];
  }

  set_span(span: number): void {
    this.span = span;
    this.fixed = null;
  }

  pause(newest: number): void {
    this.fixed = this.interval(newest);
  }

  follow(): void {
    this.fixed = null;
  }

  show(from: number, to: number): void {
    if (to > from) this.fixed = [from, to];
  }

  /** Below 1: nearer. The centre stays. */
  zoom(factor: number, newest: number): void {
    const [from, to] = this.interval(newest);
    const centre = (from + to) / 2;
    const half = Math.max(0.01, (factor * (to - from)) / 2);
    this.fixed = [centre - half, centre + half];
  }

  /** Moves the interval by a part of its length. */
  move(part: number, newest: number): void {
    const [from, to] = this.interval(newest);
    const step = part * (to - from);
    this.fixed = [from + step, to + step];
  }
}
