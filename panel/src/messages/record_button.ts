import { button, is_refused, set_refusal } from '../dom/element';
import type { Session } from '../session';
import { refusal_of } from '../state/permissions';

/**
 * Writes the last steps of the tasks on the runner's machine to the file DEPLOYMENT_TICK.mcap in the working folder of
 * the run; the reply names its path. Hook: `[data-verb="record"]`.
 */
export function record_button(session: Session): { node: HTMLButtonElement; update(): void } {
  const { store } = session;
  const title = "Write the last steps of the tasks on the runner's machine to a new file in the folder of the run";
  const node = button('Record', { title, 'data-title': title, 'data-verb': 'record' });
  node.addEventListener('click', () => {
    if (is_refused(node)) session.announce(node.title, true);
    else void session.request({ verb: 'record', file: `${store.deployment}_${store.tick}.mcap` });
  });
  return { node, update: () => set_refusal(node, refusal_of('record', store.situation)) };
}
