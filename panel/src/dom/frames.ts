/** Calls the parts of the page at most once per animation frame, however many frames of the server have come. */
export class FrameScheduler {
  private readonly parts: { update: () => void; period: number; due: number }[] = [];
  private asked = false;
  private readonly run = (now: number): void => {
    this.asked = false;
    let later = false;
    for (const part of this.parts) {
      if (now < part.due) {
        later = true;
        continue;
      }
      part.due = now + part.period;
      part.update();
    }
    if (later) this.ask_later();
  };
  private timer: ReturnType<typeof setTimeout> | null = null;

  /** `period`: shortest time between two updates of this part, ms. */
  add(update: () => void, period = 0): void {
    this.parts.push({ update, period, due: 0 });
  }

  ask(): void {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(this.run);
  }

  /** Ask again at once, for parts that were just updated. */
  ask_now(): void {
    for (const part of this.parts) part.due = 0;
    this.ask();
  }

  private ask_later(): void {
    if (this.timer !== null) return;
    this.timer = setTimeout(() => {
      this.timer = null;
      this.ask();
    }, 50);
  }
}
