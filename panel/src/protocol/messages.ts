/** The frames of the panel's socket: replies and events of the run, and those of the panel's server. */

export interface ErrorReport {
  code: number;
  text: string;
  detail: string;
}

export interface ProcessState {
  name: string;
  role: 'mp' | 'ecp' | 'edp' | 'vsp' | 'sim';
  state: 'starting' | 'ready' | 'running' | 'ended' | 'failed';
  pid: number;
  tick: number;
  instruction: number;
  activity: string;
  step: number;
  ticks: number;
  missed_ticks: number;
  late_commands: number;
  error?: ErrorReport;
}

export interface Question {
  from: string;
  number: number;
  text: string;
  kind: 'number' | 'yes_no' | 'choice';
  expected: string;
  minimum?: number | null;
  maximum?: number | null;
  choices?: string[];
}

export type TaskState = 'starting' | 'held' | 'running' | 'paused' | 'stopping' | 'ended';

export interface RunStatus {
  deployment: string;
  clock: string;
  servo_period: number;
  tick: number;
  task: TaskState;
  emergency_stop: boolean;
  commander: string | null;
  speed?: number;
  processes: ProcessState[];
  questions: Question[];
}

/** Values that are not finite arrive as null. */
export type Numbers = (number | null)[];

export interface RobotState {
  name: string;
  tick: number;
  joints: Numbers;
  velocity: Numbers;
  desired: Numbers;
  motors: Numbers;
  current: Numbers;
  pose: Numbers;
  desired_pose: Numbers;
  wrench: Numbers;
  inputs: number;
  outputs: number;
  synchronised: boolean;
  enabled: boolean;
  late_commands: number;
  error?: ErrorReport;
}

export interface SensorReading {
  name: string;
  tick: number;
  values: Record<string, number | null>;
  error?: ErrorReport;
}

export interface Hello {
  version: string;
  deployment: string;
  pid: number;
  may_command: boolean;
  client: string;
}

export interface Poses {
  tick: number;
  bodies: number[];
  desired?: number[];
}

export type PanelEvent =
  | ({ event: 'hello' } & Hello)
  | ({ event: 'poses' } & Poses)
  | { event: 'beat'; number: number }
  | { event: 'gone'; text: string }
  | { event: 'message'; text: string }
  | ({ event: 'process' } & ProcessState)
  | ({ event: 'question' } & Question)
  | { event: 'command'; command: string; by: string; tick: number; task: TaskState; value?: number }
  | { event: 'commander'; commander: string | null }
  | { event: 'command_wanted'; by: string; commander: string }
  | ({ event: 'robot' } & RobotState)
  | ({ event: 'reading' } & SensorReading)
  | { event: 'end'; exit_code: number; reason: string };

export interface Reply {
  id?: number;
  ok: boolean;
  reason?: string;
  tick?: number;
  text: string;
  expected?: string;
  data?: unknown;
}

export interface VerbRequest {
  verb: string;
  [argument: string]: string | number;
}
