import { element, set_attribute, set_class, set_hidden, set_text } from '../dom/element';
import { verb_button } from '../header/verb_button';
import { jog_pane } from '../jog/jog_pane';
import type { JogSession } from '../jog/jog_session';
import type { ProcessState, RobotState } from '../protocol/messages';
import type { Robot } from '../protocol/scene_file';
import type { Session } from '../session';
import { robot_advice } from '../state/advice';
import { class_of, error_text } from '../state/errors';
import { io_pane } from './io_pane';
import { posture_row, tool_row } from './name_row';

/** Everything of one robot. Hooks: `#robot-NAME`, `[data-robot-state]`, buttons with `data-verb` and `data-robot`. */
export function robot_pane(session: Session, jog: JogSession, robot: Robot): { node: HTMLElement; update(): void } {
  const state = state_line(session, robot);
  const verb = (text: string, name: string, title: string) =>
    verb_button(session, text, title, { verb: name, robot: robot.name });
  const verbs = [
    verb('Hold', 'hold', 'End a jog, a step or a motion to a posture: the robot comes to rest'),
    verb('Recover', 'recover', "Clear the robot's fault and switch its drives on"),
    verb('Synchronise', 'synchronise', "Find the absolute positions of the robot's motors"),
  ];
  if (robot.force_sensor)
    verbs.push(verb('Zero force', 'bias', 'Take the present reading of the force sensor as zero'));
  const postures = posture_row(session, robot);
  const tools = tool_row(session, robot);
  const jogging = jog_pane(session, jog, robot);
  const signals = io_pane(session, robot);
  const node = element(
    'div',
    { id: `robot-${robot.name}`, class: 'robot-pane scroll', tabindex: -1 },
    state.node,
    element(
      'div',
      { class: 'group', role: 'group', 'aria-label': `Robot ${robot.name}` },
      ...verbs.map((it) => it.node),
    ),
    jogging.node,
    postures.node,
    tools.node,
    signals.node,
  );
  const parts = [state, ...verbs, jogging, postures, tools, signals];
  const update = () => {
    if (!node.hidden) parts.forEach((part) => part.update());
  };
  return { node, update };
}

/** Two lines whatever the state is, so that no control moves under the operator's finger. */
function state_line(session: Session, robot: Robot): { node: HTMLElement; update(): void } {
  const made = (title: string) => element('span', { class: 'state', title });
  const synchronised = made('Absolute positions of the motors');
  const drives = made('Power of the drives');
  const error = element('span', { class: 'state', 'data-state': 'emergency' }, 'error');
  const activity = element('p', { class: 'activity' });
  const node = element(
    'div',
    { class: 'robot-state', 'data-robot-state': robot.name },
    element(
      'div',
      { class: 'line' },
      element('h2', {}, robot.name),
      element('span', { class: 'quiet kind' }, `${robot.type} · ${robot.hardware}`),
      error,
      drives,
      synchronised,
    ),
    activity,
  );
  const update = () => {
    const state = session.store.robots.get(robot.name);
    show_flags(state, drives, synchronised);
    set_hidden(error, !state?.error);
    set_attribute(error, 'title', state?.error ? `${class_of(state.error)}: ${error_text(state.error)}` : null);
    const process = session.store.processes.get(robot.name);
    const advice = state && !session.store.ended ? robot_advice(state, session.store.emergency_stop) : null;
    set_text(activity, advice?.text ?? (process ? activity_text(process) : ''));
    set_class(activity, 'advice', advice !== null);
    set_attribute(activity, 'title', activity.textContent);
  };
  return { node, update };
}

function activity_text(process: ProcessState): string {
  const instruction =
    process.instruction > 0 ? ` · ${process.instruction} ${process.activity}, step ${process.step}` : '';
  return `program ${process.state}${instruction}`;
}

function show_flags(state: RobotState | undefined, drives: HTMLElement, synchronised: HTMLElement): void {
  set_text(drives, state ? (state.enabled ? 'drives on' : 'drives off') : 'no data');
  set_attribute(drives, 'data-state', state?.enabled ? 'good' : 'warning');
  set_hidden(synchronised, !state);
  set_text(synchronised, state?.synchronised ? 'synchronised' : 'not synchronised');
  set_attribute(synchronised, 'data-state', state?.synchronised ? 'good' : 'warning');
}
