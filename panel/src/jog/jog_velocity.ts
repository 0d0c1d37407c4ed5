import type { Robot } from '../protocol/scene_file';
import type { Unit } from '../format/units';
import type { JogFrame } from './jog_repeater';

/** Velocities at 100 % of the slider. Those of the tool are of a robot that is taught by hand (ISO 10218-1). */
export const TOOL_VELOCITY = 0.25; // m/s
export const TOOL_ROTATION = 0.5; // rad/s
export const MOTOR_VELOCITY = 50; // rad/s of the shaft

export const TOOL_AXES = ['x', 'y', 'z', 'rx', 'ry', 'rz'];

export interface MovedAxis {
  name: string;
  unit: Unit;
  minimum?: number | null;
  maximum?: number | null;
  velocity: number; // at 100 %
}

/** The axes of a robot that can be jogged in `frame`. */
export function moved_axes(robot: Robot, frame: JogFrame): MovedAxis[] {
  if (frame === 'axes') return robot.axes;
  if (frame === 'motors') return robot.motors.map((name) => ({ name, unit: 'rad', velocity: MOTOR_VELOCITY }));
  return TOOL_AXES.map((name, index) =>
    index < 3 ? { name, unit: 'm', velocity: TOOL_VELOCITY } : { name, unit: 'rad', velocity: TOOL_ROTATION },
  );
}

/** The jog's velocity at `percent` of the limit, with the sign of the button. */
export function jog_velocity(axis: MovedAxis, percent: number, sign: 1 | -1): number {
  return (sign * axis.velocity * Math.max(0, Math.min(100, percent))) / 100;
}
