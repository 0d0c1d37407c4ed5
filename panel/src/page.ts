import { cameras_pane } from './cameras/cameras_pane';
import { element } from './dom/element';
import { Tabs } from './dom/tabs';
import { Announcer, gone_bar } from './header/announcer';
import { command_wanted } from './header/command_holder';
import { make_header } from './header/header';
import { install_shortcuts } from './header/shortcuts';
import { theme_switch } from './header/theme_switch';
import { JogSession } from './jog/jog_session';
import { MessageLog } from './messages/message_log';
import { message_pane } from './messages/message_pane';
import { plots_pane } from './plots/plots_pane';
import { fault_list } from './processes/fault_list';
import { process_table } from './processes/process_table';
import type { Socket } from './protocol/connection';
import type { Scene } from './protocol/scene_file';
import { QuestionDialog } from './questions/question_dialog';
import { robots_pane } from './robots/robots_pane';
import { Session } from './session';
import { view_pane } from './view/view_pane';

const SAFETY = 'Software stops are no safety functions: the emergency stop of a real cell is wired.';
const TEXT_PERIOD = 100; // ms between two updates of figures

/** Makes the page's parts and connects them with the run. `body[data-ready]`: the first frame of the run has come. */
export function make_page(scene: Scene, open_socket: () => Socket): void {
  const log = new MessageLog();
  const announcer = new Announcer((text, refused) => log.answer(text, refused));
  const session = new Session(scene, open_socket, (text, refused) => announcer.announce(text, refused));
  session.on_event((event) => log.event(event));
  const jog = new JogSession(session);
  const header = make_header(session);
  const wanted = command_wanted(session);
  const faults = fault_list(session);
  const gone = gone_bar();
  const questions = new QuestionDialog(session);
  const view = view_pane(session);
  const robots = robots_pane(session, jog);
  const plots = plots_pane(session);
  const processes = process_table(session);
  const messages = message_pane(session, log);
  const cameras = cameras_pane(session);
  const tabs = new Tabs(
    'Details',
    [
      { id: 'plots', title: 'Plots', content: plots.node },
      { id: 'processes', title: 'Processes', content: processes.node },
      { id: 'messages', title: 'Messages', content: messages.node },
      ...(cameras ? [{ id: 'cameras', title: 'Cameras', content: cameras.node }] : []),
    ],
    () => session.scheduler.ask_now(),
  );
  const details = element(
    'section',
    { id: 'details', 'aria-label': 'Details' },
    tabs.list,
    plots.node,
    processes.node,
    messages.node,
    ...(cameras ? [cameras.node] : []),
  );
  const version = element('span', { id: 'version', class: 'quiet' });
  const set_theme = () => {
    view.set_theme();
    plots.set_theme();
  };
  const footer = element(
    'footer',
    {},
    announcer.node,
    element('span', { id: 'safety' }, SAFETY),
    version,
    theme_switch(() => set_theme()),
  );
  document.body.append(
    element('a', { class: 'skip', href: '#robots' }, 'Skip to the robots'),
    header.node,
    element(
      'main',
      {},
      view.node,
      element('div', { class: 'bars' }, gone.node, wanted.node, questions.bar, faults.node),
      robots.node,
      details,
    ),
    questions.node,
    footer,
  );
  install_shortcuts(session, () => {
    if (jog.active) jog.release('Escape');
    else questions.escape();
  });

  const show_connection = () => {
    const { store } = session;
    if (store.ended) gone.show(store.end_text, store.exit_code === 0);
    else if (!store.connected)
      gone.show('The connection to the panel is lost. The page connects again on its own.', false);
    else gone.show('', false);
    version.textContent = store.hello ? `MRROC++ ${store.hello.version} · process ${store.hello.pid}` : '';
    if (store.connected || store.ended) document.body.dataset['ready'] = 'yes';
  };
  const { scheduler } = session;
  scheduler.add(() => view.update());
  scheduler.add(show_connection, TEXT_PERIOD);
  scheduler.add(() => {
    header.update();
    wanted.update();
    questions.update();
    robots.update();
    const errors = faults.update();
    tabs.badge('processes', errors, 'errors');
    processes.update();
    messages.update();
  }, TEXT_PERIOD);
  scheduler.add(() => plots.update(), TEXT_PERIOD);
  scheduler.add(() => cameras?.update(), TEXT_PERIOD);
  set_theme();
  session.start();
  scheduler.ask();
}
