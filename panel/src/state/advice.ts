import type { ErrorReport } from '../protocol/messages';

export type Action = 'reset' | 'recover' | 'synchronise';

export interface Advice {
  text: string;
  action?: Action;
}

const EMERGENCY_STOP = 113;
const LOST_POSITIONS = new Set([11, 104]); // not_synchronised, synchronisation_failed
const LIMIT_SWITCH = 111;
const SENSOR_HARDWARE = 102;

const CAUSES: Record<number, string> = {
  15: 'Move the tool away from the contact.',
  17: 'Recover the robot: it switches the drives on.',
  100: 'Remove the obstacle, then recover the robot.',
  101: "Remove the drive's fault, then recover the robot.",
  103: 'Restore the connection to the hardware, then recover the robot.',
  110: 'Remove the obstacle or the excess load, then recover the robot.',
  115: 'Free the axis or repair its encoder, then recover the robot.',
  116: 'Repair the bus and bring its interface up, then recover the robot.',
  117: 'Check wires, terminators and bit rate, then recover the robot.',
  118: "Check the drive's supply and safety inputs, then recover the robot.",
};

/** What the operator does about a robot: the first thing that is necessary, or null. */
export function robot_advice(
  robot: { error?: ErrorReport; synchronised: boolean; enabled: boolean },
  emergency_stop: boolean,
): Advice | null {
  if (emergency_stop)
    return { text: 'Release the emergency stop with Reset, then recover the robot.', action: 'reset' };
  const error = robot.error;
  if (error && LOST_POSITIONS.has(error.code) && robot.enabled)
    return { text: 'Synchronise the robot.', action: 'synchronise' };
  if (error?.code === EMERGENCY_STOP) return { text: 'Recover the robot.', action: 'recover' };
  if (error?.code === LIMIT_SWITCH)
    return { text: 'Recover the robot, then move it away from the switch.', action: 'recover' };
  if (error && error.code >= 100 && error.code < 200)
    return { text: CAUSES[error.code] ?? 'Remove the cause, then recover the robot.', action: 'recover' };
  if (error && CAUSES[error.code] && robot.enabled) return { text: CAUSES[error.code] ?? '' };
  if (!robot.enabled) return { text: 'The drives are off: recover the robot.', action: 'recover' };
  if (!robot.synchronised)
    return { text: 'The robot is not synchronised: only its motors can be jogged.', action: 'synchronise' };
  return null;
}

/** What the operator does about a process whose error is not one of its robot. */
export function process_advice(error: ErrorReport): Advice {
  if (error.code === SENSOR_HARDWARE) return { text: 'Check the sensor and its wires.' };
  if (error.code === 205) return { text: 'Correct the deployment or the parameters, then run it again.' };
  if (error.code >= 200) return { text: 'Run the deployment again.' };
  if (error.code >= 100) return { text: 'Recover the robot; the task decides how it continues.' };
  return { text: 'The robots hold; the task decides how it continues.' };
}
