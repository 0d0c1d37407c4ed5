import { button, is_refused, set_refusal } from '../dom/element';
import type { Session } from '../session';
import { refusal_of } from '../state/permissions';
import type { VerbRequest } from '../protocol/messages';

export interface VerbButton {
  node: HTMLButtonElement;
  update(): void;
}

/**
 * A button that sends one request. Hooks: `data-verb`, and `data-robot` if the request names a robot. It is
 * `aria-disabled` while the run would refuse the verb; its title is then the reason.
 */
export function verb_button(
  session: Session,
  text: string,
  title: string,
  request: VerbRequest,
  extra_refusal: () => string = () => '',
): VerbButton {
  const robot = request['robot'];
  const node = button(text, {
    class: `verb verb-${request.verb}`,
    title,
    'data-title': title,
    'data-verb': request.verb,
    'data-robot': typeof robot === 'string' ? robot : undefined,
  });
  node.addEventListener('click', () => {
    if (is_refused(node)) session.announce(node.title, true);
    else void session.request(request);
  });
  const update = () => set_refusal(node, refusal_of(request.verb, session.store.situation) || extra_refusal());
  return { node, update };
}
