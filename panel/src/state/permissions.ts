import type { TaskState } from '../protocol/messages';

/** What decides whether a verb has an effect now. */
export interface Situation {
  connected: boolean;
  ended: boolean;
  may_command: boolean;
  client: string;
  commander: string | null;
  task: TaskState;
  emergency_stop: boolean;
}

const EVERYBODYS = new Set(['stop', 'estop']);

/** Why the run would refuse `verb`, or an empty text. The run decides: this only disables the control. */
export function refusal_of(verb: string, now: Situation): string {
  if (now.ended) return 'The run has ended.';
  if (!now.connected) return 'The connection to the panel is lost.';
  if (!now.may_command) return 'This address is for watching only.';
  if (verb === 'record') return ['starting', 'held'].includes(now.task) ? 'No task has made a step.' : '';
  if (verb === 'release') return now.commander === now.client ? '' : 'This browser does not hold command.';
  if (verb === 'command') return now.commander === now.client ? 'This browser holds command.' : '';
  if (!EVERYBODYS.has(verb) && now.commander !== null && now.commander !== now.client)
    return `${now.commander} holds command.`;
  if (verb === 'estop') return '';
  if (verb === 'reset') return now.emergency_stop ? '' : 'The emergency stop is not active.';
  return phase_refusal(verb, now.task);
}

function phase_refusal(verb: string, task: TaskState): string {
  if (task === 'stopping') return 'The run ends.';
  if (verb === 'stop') return '';
  if (task === 'starting') return 'The processes are being started.';
  if (verb === 'start' && task !== 'held') return 'The task has started.';
  if (task === 'held' && ['pause', 'resume', 'trigger'].includes(verb)) return 'The task has not started.';
  if (verb === 'pause' && task === 'paused') return 'The task is paused.';
  if (verb === 'resume' && task !== 'paused') return 'The task is not paused.';
  return '';
}
