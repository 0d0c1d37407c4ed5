import { element } from '../dom/element';
import type { Session } from '../session';
import { History } from './history';
import { PlotPane } from './plot_pane';

const DRAW_PERIOD = 150; // ms

/** Two plots side by side. Hook: `#plots`. */
export function plots_pane(session: Session): { node: HTMLElement; update(): void; set_theme(): void } {
  const history = new History(session.scene, (tick) => session.seconds(tick));
  session.on_event((event) => history.event(event));
  const robot = session.scene.robots[0];
  const second = robot?.force_sensor ? `${robot.name}/wrench` : robot ? `${robot.name}/error` : '';
  const keys = history.quantities.length > 1 ? [`${robot?.name}/joints`, second] : [`${robot?.name}/joints`];
  const plots = keys.map((key) => new PlotPane(history, key));
  const node = element('div', { id: 'plots', class: 'pane plots' }, ...plots.map((plot) => plot.node));
  let due = 0;
  const update = () => {
    if (node.hidden || performance.now() < due) return;
    due = performance.now() + DRAW_PERIOD;
    for (const plot of plots) plot.update();
  };
  return { node, update, set_theme: () => plots.forEach((plot) => plot.rebuild()) };
}
