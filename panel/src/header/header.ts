import { element, set_text } from '../dom/element';
import type { Session } from '../session';
import { command_holder } from './command_holder';
import { speed_control } from './speed_control';
import { task_state } from './task_state';
import { verb_button } from './verb_button';

/** The header, always on screen: state, holder of command, task verbs, stops. Hooks: `header [data-verb]`. */
export function make_header(session: Session): { node: HTMLElement; update(): void } {
  const state = task_state(session);
  const holder = command_holder(session);
  const speed = speed_control(session);
  const verbs = [
    verb_button(session, 'Start', 'Start the task', { verb: 'start' }),
    verb_button(session, 'Pause', 'Bring the robots to rest on their path and hold them', { verb: 'pause' }),
    verb_button(session, 'Resume', 'Continue the paused task', { verb: 'resume' }),
    verb_button(session, 'Trigger', 'Give the task one trigger', { verb: 'trigger' }),
  ];
  const stop = verb_button(session, 'STOP', 'Bring the robots to rest and end the run', { verb: 'stop' });
  stop.node.replaceChildren('STOP', element('small', {}, 'end the run'));
  const emergency = verb_button(
    session,
    'EMERGENCY STOP',
    'Every robot brakes at once and stays stopped until Reset (space bar)',
    { verb: 'estop' },
  );
  const key = element('small', {}, 'Space');
  emergency.node.replaceChildren('EMERGENCY STOP', key);
  emergency.node.setAttribute('aria-keyshortcuts', 'Space');
  const reset = verb_button(session, 'RESET', 'Release the emergency stop; no robot moves because of it', {
    verb: 'reset',
  });
  reset.node.replaceChildren('RESET', element('small', {}, 'release'));
  const node = element(
    'header',
    {},
    state.node,
    element('div', { class: 'group task-verbs', role: 'group', 'aria-label': 'Task' }, ...verbs.map((it) => it.node)),
    speed.node,
    holder.node,
    element(
      'div',
      { class: 'group stops', role: 'group', 'aria-label': 'Stop' },
      stop.node,
      emergency.node,
      reset.node,
    ),
  );
  const parts = [state, holder, speed, ...verbs, stop, emergency, reset];
  const update = () => {
    parts.forEach((part) => part.update());
    set_text(key, session.store.emergency_stop ? 'active · Space' : 'Space');
  };
  return { node, update };
}
