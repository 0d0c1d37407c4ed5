import { element } from '../dom/element';
import { verb_button } from '../header/verb_button';
import type { Robot } from '../protocol/scene_file';
import type { Session } from '../session';

/** Buttons to the named postures of a robot. Hooks: `[data-verb="go"]`, `data-robot`, `data-posture`. */
export function posture_row(session: Session, robot: Robot): { node: HTMLElement; update(): void } {
  const unsynchronised = () =>
    session.store.robots.get(robot.name)?.synchronised === false ? 'The robot is not synchronised.' : '';
  const buttons = [...new Set(robot.postures)].map((posture) => {
    const made = verb_button(
      session,
      posture,
      `Move to the posture '${posture}'`,
      { verb: 'go', robot: robot.name, posture },
      unsynchronised,
    );
    made.node.dataset['posture'] = posture;
    return made;
  });
  const node = element(
    'section',
    { 'aria-label': `Postures of ${robot.name}` },
    element('h3', {}, 'Go to posture'),
    element('div', { class: 'group' }, ...buttons.map((it) => it.node)),
  );
  node.hidden = buttons.length === 0;
  return { node, update: () => buttons.forEach((it) => it.update()) };
}
