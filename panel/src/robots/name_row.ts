import { element } from '../dom/element';
import { verb_button } from '../header/verb_button';
import type { Robot } from '../protocol/scene_file';
import type { Session } from '../session';

/** A row of buttons, one for each name that the robot's parameter file gives to something. */
export interface NameRow {
  node: HTMLElement;
  update(): void;
}

interface RowOf {
  verb: 'go' | 'tool';
  /** The verb's argument, and the name of the hook. */
  argument: 'posture' | 'tool';
  heading: string;
  label: string;
  names: string[];
  title: (name: string) => string;
  /** Why it is impossible now; empty: it is possible. */
  blocked?: () => string;
}

function name_row(session: Session, robot: Robot, row: RowOf): NameRow {
  const buttons = row.names.map((name) => {
    const request = { verb: row.verb, robot: robot.name, [row.argument]: name };
    const made = verb_button(session, name, row.title(name), request, row.blocked);
    made.node.dataset[row.argument] = name;
    return made;
  });
  const node = element(
    'section',
    { 'aria-label': `${row.label} of ${robot.name}` },
    element('h3', {}, row.heading),
    element('div', { class: 'group' }, ...buttons.map((it) => it.node)),
  );
  return { node, update: () => buttons.forEach((it) => it.update()) };
}

/** Buttons to the named postures of a robot. Hooks: `[data-verb="go"]`, `data-robot`, `data-posture`. */
export function posture_row(session: Session, robot: Robot): NameRow {
  const row = name_row(session, robot, {
    verb: 'go',
    argument: 'posture',
    heading: 'Go to posture',
    label: 'Postures',
    names: robot.postures,
    title: (name) => `Move to the posture '${name}'`,
    blocked: () =>
      session.store.robots.get(robot.name)?.synchronised === false ? 'The robot is not synchronised.' : '',
  });
  row.node.hidden = robot.postures.length === 0;
  return row;
}

/** Buttons that change the tool frame of a robot. Hooks: `[data-verb="tool"]`, `data-robot`, `data-tool`. */
export function tool_row(session: Session, robot: Robot): NameRow {
  const tools = robot.tools ?? [];
  const row = name_row(session, robot, {
    verb: 'tool',
    argument: 'tool',
    heading: 'Change tool',
    label: 'Tools',
    names: tools,
    title: (name) => `Poses refer to the tool '${name}' from now on`,
  });
  row.node.hidden = tools.length < 2;
  return row;
}
