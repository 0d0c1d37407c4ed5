import { element } from '../dom/element';
import { Tabs } from '../dom/tabs';
import type { JogSession } from '../jog/jog_session';
import type { Session } from '../session';
import { robot_pane } from './robot_pane';

/** The robots of the deployment; with several, a tab for each. Hook: `#robots`. */
export function robots_pane(session: Session, jog: JogSession): { node: HTMLElement; update(): void } {
  const robots = session.scene.robots;
  const panes = robots.map((robot) => robot_pane(session, jog, robot));
  const node = element('section', { id: 'robots', 'aria-label': 'Robots' });
  if (robots.length === 0) {
    node.append(element('p', { class: 'hint' }, 'This deployment has no robot.'));
    return { node, update: () => undefined };
  }
  const tabs =
    robots.length < 2
      ? null
      : new Tabs(
          'Robots',
          robots.map((robot, i) => ({ id: `robot-${robot.name}`, title: robot.name, content: panes[i]?.node ?? node })),
          () => {
            jog.release();
            session.scheduler.ask_now();
          },
        );
  if (tabs) node.append(tabs.list);
  node.append(...panes.map((pane) => pane.node));
  const update = () => {
    panes.forEach((pane) => pane.update());
    for (const robot of robots)
      tabs?.badge(`robot-${robot.name}`, session.store.robots.get(robot.name)?.error ? 1 : 0, 'error');
  };
  return { node, update };
}
