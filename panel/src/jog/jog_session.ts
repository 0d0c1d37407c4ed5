import type { Session } from '../session';
import { JogRepeater, type JogOrder } from './jog_repeater';

/** The page's one jog: everything that can separate the operator from the robot ends it. */
export class JogSession {
  private readonly repeater: JogRepeater;
  private readonly watchers: ((order: JogOrder | null) => void)[] = [];

  constructor(private readonly session: Session) {
    this.repeater = new JogRepeater({
      now: () => performance.now(),
      every: (call, period) => {
        const timer = setInterval(call, period);
        return () => clearInterval(timer);
      },
      silence: () => session.connection.silence,
      jog: (order) => this.send(order),
      hold: (robot) => this.hold(robot),
      ended: (reason) => {
        if (reason) session.announce(`jog ended: ${reason}`, true);
        this.publish();
      },
    });
    const end = (reason: string) => () => this.repeater.release(reason);
    document.addEventListener('visibilitychange', end('the page was hidden'));
    window.addEventListener('blur', end('the window has lost the focus'));
    window.addEventListener('pagehide', end('the page is left'));
    document.addEventListener('freeze', end('the page was frozen'));
    session.on_loss(end('the connection is lost'));
    session.on_event((event) => {
      if (event.event === 'gone' || event.event === 'end') this.repeater.release('the run has ended');
      if (event.event === 'command' && event.command === 'estop') this.repeater.release('emergency stop');
    });
  }

  get active(): JogOrder | null {
    return this.repeater.active;
  }

  press(order: JogOrder): void {
    if (this.repeater.press(order)) this.publish();
  }

  release(reason = ''): void {
    this.repeater.release(reason);
  }

  watch(watcher: (order: JogOrder | null) => void): void {
    this.watchers.push(watcher);
  }

  private publish(): void {
    for (const watcher of this.watchers) watcher(this.repeater.active);
  }

  private send(order: JogOrder): void {
    const { connection } = this.session;
    void connection.request({ verb: 'jog', ...order, beat: connection.beat }).then((reply) => {
      if (reply.ok || this.repeater.active !== order) return;
      this.repeater.release(reply.expected ? `${reply.text}; expected: ${reply.expected}` : reply.text);
    });
  }

  private hold(robot: string): void {
    void this.session.connection.request({ verb: 'hold', robot });
  }
}
