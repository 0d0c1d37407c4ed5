import { element } from '../dom/element';
import { verb_button } from '../header/verb_button';
import type { Robot } from '../protocol/scene_file';
import type { Session } from '../session';

/** Buttons that change the tool frame of a robot. Hooks: `[data-verb="tool"]`, `data-robot`, `data-tool`. */
export function tool_row(session: Session, robot: Robot): { node: HTMLElement; update(): void } {
  const buttons = (robot.tools ?? []).map((tool) => {
    const title = `Poses refer to the tool '${tool}' from now on`;
    const made = verb_button(session, tool, title, { verb: 'tool', robot: robot.name, tool });
    made.node.dataset['tool'] = tool;
    return made;
  });
  const node = element(
    'section',
    { 'aria-label': `Tools of ${robot.name}` },
    element('h3', {}, 'Change tool'),
    element('div', { class: 'group' }, ...buttons.map((it) => it.node)),
  );
  node.hidden = buttons.length < 2;
  return { node, update: () => buttons.forEach((it) => it.update()) };
}
