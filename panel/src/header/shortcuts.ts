import { is_text_field } from '../dom/element';
import type { Session } from '../session';

/**
 * The space bar is the emergency stop everywhere except in a field for text, also when a button has the focus; Enter
 * presses buttons. Escape calls `escape`. Space is sent whatever the page shows of the run: the run decides.
 */
export function install_shortcuts(session: Session, escape: () => void): void {
  const is_stop = (event: KeyboardEvent) =>
    event.code === 'Space' && !event.ctrlKey && !event.altKey && !event.metaKey && !is_text_field(event.target);
  document.addEventListener(
    'keydown',
    (event) => {
      if (event.key === 'Escape') escape();
      if (!is_stop(event)) return;
      event.preventDefault();
      event.stopPropagation();
      if (!event.repeat) void session.request({ verb: 'estop' });
    },
    true,
  );
  document.addEventListener(
    'keyup',
    (event) => {
      if (!is_stop(event)) return;
      event.preventDefault(); // a focused button is not pressed by space
      event.stopPropagation();
    },
    true,
  );
}
