import type { PanelEvent, RobotState, SensorReading } from '../protocol/messages';
import type { Robot, Scene, Sensor } from '../protocol/scene_file';
import { Ring } from './ring';

const SAMPLES = 3200; // 60 s of 50 samples a second, and some more
const WRENCH = ['force x', 'force y', 'force z', 'torque x', 'torque y', 'torque z'];

/** One curve: a channel of a source, in the unit that is shown. */
export interface Curve {
  name: string;
  channel: number;
  unit: string;
  factor: number; // from the unit of the run to the one that is shown
  limits: number[]; // in the unit that is shown
}

export interface Quantity {
  key: string;
  title: string;
  ring: Ring;
  curves: Curve[];
}

const DEGREE = 180 / Math.PI;

/** The last minute of every robot and sensor, and what can be plotted of it. */
export class History {
  readonly quantities: Quantity[] = [];
  private readonly robots = new Map<string, Ring>();
  private readonly sensors = new Map<string, { ring: Ring; channels: string[] }>();

  constructor(
    scene: Scene,
    private readonly seconds: (tick: number) => number,
  ) {
    for (const robot of scene.robots) this.add_robot(robot);
    for (const sensor of scene.sensors) this.add_sensor(sensor);
  }

  event(event: PanelEvent): void {
    if (event.event === 'robot') this.robots.get(event.name)?.push(this.seconds(event.tick), row_of(event));
    if (event.event === 'reading') this.add_reading(event);
  }

  private add_reading(reading: SensorReading): void {
    const sensor = this.sensors.get(reading.name);
    sensor?.ring.push(
      this.seconds(reading.tick),
      sensor.channels.map((channel) => reading.values[channel]),
    );
  }

  private add_robot(robot: Robot): void {
    const axes = robot.axes.length;
    const motors = robot.motors.length;
    const ring = new Ring(3 * axes + 6 + motors, SAMPLES);
    this.robots.set(robot.name, ring);
    const add = (key: string, title: string, curves: Curve[]) =>
      this.quantities.push({ key: `${robot.name}/${key}`, title: `${robot.name}: ${title}`, ring, curves });
    add(
      'joints',
      'positions',
      robot.axes.map((axis, i) => axis_curve(axis, i, '', [axis.minimum, axis.maximum])),
    );
    add(
      'velocity',
      'velocities',
      robot.axes.map((axis, i) => axis_curve(axis, axes + i, '/s', [-axis.velocity, axis.velocity])),
    );
    add(
      'error',
      'following error',
      robot.axes.map((axis, i) => axis_curve(axis, 2 * axes + i, '', [])),
    );
    if (robot.force_sensor)
      add(
        'wrench',
        'wrench',
        WRENCH.map((name, i) => ({ name, channel: 3 * axes + i, unit: i < 3 ? 'N' : 'N m', factor: 1, limits: [] })),
      );
    add(
      'current',
      'motor currents',
      robot.motors.map((name, i) => ({
        name: name || `motor ${i + 1}`,
        channel: 3 * axes + 6 + i,
        unit: 'A',
        factor: 1,
        limits: [],
      })),
    );
  }

  private add_sensor(sensor: Sensor): void {
    const ring = new Ring(sensor.channels.length, SAMPLES);
    this.sensors.set(sensor.name, { ring, channels: sensor.channels });
    const curves = sensor.channels.map((name, channel) => ({
      name: name.replaceAll('_', ' '),
      channel,
      unit: unit_of(name),
      factor: 1,
      limits: [],
    }));
    this.quantities.push({ key: sensor.name, title: `${sensor.name}: readings`, ring, curves });
  }
}

function axis_curve(axis: Robot['axes'][number], channel: number, per: string, limits: (number | null)[]): Curve {
  const factor = axis.unit === 'rad' ? DEGREE : 1000;
  const unit = (axis.unit === 'rad' ? '°' : 'mm') + per;
  return {
    name: axis.name,
    channel,
    unit,
    factor,
    limits: limits.flatMap((limit) => (limit === null ? [] : [limit * factor])),
  };
}

/** Joints, velocities, following errors, wrench, currents: the channels of a robot's ring. Unknown positions are gaps. */
function row_of(state: RobotState): (number | null | undefined)[] {
  const errors = state.desired.map((desired, i) => {
    const joint = state.joints[i];
    return desired === null || joint === null || joint === undefined ? null : desired - joint;
  });
  const joints = state.synchronised ? state.joints : state.joints.map(() => null);
  const wrench = Array.from({ length: 6 }, (_, i) => state.wrench[i]);
  return [...joints, ...state.velocity, ...errors, ...wrench, ...state.current];
}

function unit_of(channel: string): string {
  if (channel.startsWith('force')) return 'N';
  if (channel.startsWith('torque')) return 'N m';
  return '';
}
