import type {
  Hello,
  PanelEvent,
  Poses,
  ProcessState,
  Question,
  RobotState,
  RunStatus,
  SensorReading,
  TaskState,
} from '../protocol/messages';
import type { Situation } from './permissions';

/** What the page shows of the run. The frames of the server are applied here; the parts of the page read it. */
export class Store {
  hello: Hello | null = null;
  connected = false;
  end_text = '';
  ended = false;
  exit_code: number | undefined;
  tick = 0;
  task: TaskState = 'starting';
  emergency_stop = false;
  commander: string | null = null;
  wanted_by = '';
  speed: number | undefined;
  servo_period = 0.002;
  clock = '';
  deployment = '';
  readonly processes = new Map<string, ProcessState>();
  readonly robots = new Map<string, RobotState>();
  readonly readings = new Map<string, SensorReading>();
  /** The tick at which the present error of a robot, sensor or process was seen first. */
  readonly error_ticks = new Map<string, number>();
  questions: Question[] = [];
  /** Number of changes that events have reported: a status that was requested before the newest one may be older. */
  changes = 0;
  poses: Poses | null = null;

  /** The result says whether a new `status` is due: the event has changed what only a status shows. */
  apply(event: PanelEvent): boolean {
    if (this.ended && (event.event === 'command' || event.event === 'question')) return false;
    const jogged = event.event === 'command' && event.command === 'jog';
    if (['question', 'command', 'commander'].includes(event.event) && !jogged) ++this.changes;
    switch (event.event) {
      case 'hello':
        this.hello = event;
        this.deployment = event.deployment;
        return true;
      case 'poses':
        this.poses = event;
        this.see_tick(event.tick);
        return false;
      case 'robot':
        this.robots.set(event.name, event);
        this.note_error(event.name, event.error, event.tick);
        this.see_tick(event.tick);
        return false;
      case 'reading':
        this.readings.set(event.name, event);
        this.note_error(event.name, event.error, event.tick);
        return false;
      case 'process':
        this.processes.set(event.name, event);
        this.note_error(`process ${event.name}`, event.error, event.tick);
        return false;
      case 'question':
        this.questions = [...this.questions.filter((open) => open.from !== event.from), event];
        return true;
      case 'command':
        this.task = event.task;
        this.see_tick(event.tick);
        if (event.command === 'estop') this.emergency_stop = true;
        if (event.command === 'speed' && event.value !== undefined) this.speed = event.value / 100;
        return event.command !== 'jog';
      case 'commander':
        this.commander = event.commander;
        this.wanted_by = '';
        return false;
      case 'command_wanted':
        if (event.commander === this.hello?.client) this.wanted_by = event.by;
        return false;
      case 'end':
        this.exit_code = event.exit_code;
        this.finish(`The run has ended with exit code ${event.exit_code}${event.reason ? `: ${event.reason}` : '.'}`);
        return false;
      case 'gone':
        this.finish(this.end_text || event.text);
        return false;
      default:
        return false;
    }
  }

  /** A status may be read after the end that came after it: replies have another way to the page than events. */
  apply_status(status: RunStatus): void {
    if (this.ended) return;
    this.deployment = status.deployment;
    this.clock = status.clock;
    this.servo_period = status.servo_period;
    this.task = status.task;
    this.emergency_stop = status.emergency_stop;
    this.commander = status.commander;
    this.speed = status.speed;
    this.questions = status.questions;
    this.see_tick(status.tick);
    for (const process of status.processes) {
      this.processes.set(process.name, process);
      this.note_error(`process ${process.name}`, process.error, process.tick);
    }
  }

  get situation(): Situation {
    return {
      connected: this.connected,
      ended: this.ended,
      may_command: this.hello?.may_command ?? false,
      client: this.hello?.client ?? '',
      commander: this.commander,
      task: this.task,
      emergency_stop: this.emergency_stop,
    };
  }

  private finish(text: string): void {
    this.ended = true;
    this.task = 'ended';
    this.end_text = text;
    this.questions = [];
  }

  private see_tick(tick: number): void {
    if (tick > this.tick) this.tick = tick;
  }

  private note_error(name: string, error: { code: number } | undefined, tick: number): void {
    if (!error) this.error_ticks.delete(name);
    else if (!this.error_ticks.has(name)) this.error_ticks.set(name, tick);
  }
}
