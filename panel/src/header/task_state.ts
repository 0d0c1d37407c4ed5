import { element, set_attribute, set_hidden, set_text } from '../dom/element';
import { time_text } from '../format/units';
import type { Session } from '../session';

/** Deployment, state of the task and time of the run. Hooks: `#deployment`, `#task`, `#time`, `#emergency`. */
export function task_state(session: Session): { node: HTMLElement; update(): void } {
  const { store } = session;
  const deployment = element('h1', { id: 'deployment' }, store.deployment);
  const task = element('span', { id: 'task', class: 'state', role: 'status', 'aria-label': 'State of the task' });
  const emergency = element('span', { id: 'emergency', class: 'state', 'data-state': 'emergency' }, 'emergency stop');
  const time = element('span', { id: 'time', class: 'figure', title: 'Time of the run' });
  const tick = element('span', { id: 'tick', class: 'quiet', title: 'Servo tick' });
  const node = element(
    'div',
    { class: 'task-state' },
    element('div', { class: 'name-and-time' }, deployment, element('div', { class: 'times' }, time, tick)),
    element('div', { class: 'states' }, task, emergency),
  );
  const update = () => {
    set_text(deployment, store.deployment);
    set_attribute(deployment, 'title', store.deployment);
    const state = store.ended || store.connected ? store.task : 'not connected';
    set_text(task, state);
    set_attribute(task, 'data-state', store.ended || store.connected ? store.task : 'lost');
    set_hidden(emergency, !store.emergency_stop || store.ended);
    set_text(time, time_text(session.seconds(store.tick)));
    set_text(tick, `tick ${store.tick} · ${store.clock}`);
    const title = `${store.deployment}: ${store.emergency_stop ? 'emergency stop' : state}`;
    if (document.title !== title) document.title = title;
  };
  return { node, update };
}
