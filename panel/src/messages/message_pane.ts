import { button, element, set_attribute, set_hidden, set_text } from '../dom/element';
import type { Session } from '../session';
import { time_text } from '../format/units';
import { black_box_of, type Message } from './message_buffer';
import type { MessageLog } from './message_log';
import { record_button } from './record_button';

const SHOWN = 400; // the page stays fast; the filter finds older ones

/**
 * The messages of the run: filter, pause of the scrolling, copy. Hooks: `#messages`, `#filter`, `#follow`, `#copy`,
 * `[data-verb="record"]`, `[data-kind]`.
 */
export function message_pane(session: Session, log: MessageLog): { node: HTMLElement; update(): void } {
  const filter = element('input', {
    id: 'filter',
    type: 'search',
    placeholder: 'Filter',
    'aria-label': 'Filter messages',
  });
  const follow = button('Pause', { id: 'follow', 'aria-pressed': 'false', title: 'Keep the list as it is' });
  const copy = button('Copy', { id: 'copy', title: 'Copy the messages that are shown' });
  const record = record_button(session);
  const hint = element('p', { class: 'hint' });
  const list = element('div', {
    id: 'message-list',
    class: 'message-list scroll',
    role: 'log',
    'aria-label': 'Messages',
    'aria-live': 'off',
    tabindex: 0,
  });
  const node = element(
    'div',
    { id: 'messages', class: 'pane' },
    element('div', { class: 'toolbar' }, filter, follow, copy, record.node),
    hint,
    list,
  );
  hint.hidden = true;
  let paused = false;
  let shown = -2;
  let filtered = '';

  const line_of = (message: Message) =>
    element(
      'div',
      { class: 'entry', 'data-kind': message.kind },
      element('span', { class: 'time' }, time_text(session.seconds(message.tick))),
      element('span', { class: 'kind' }, message.kind),
      element('span', { class: 'text' }, message.text),
    );
  const show_hint = (message: Message) => {
    const file = black_box_of(message.text);
    if (file === '') return;
    set_hidden(hint, false);
    const where = file.startsWith('/') ? file : `${file}, in the folder of the run`;
    set_text(hint, `Black box: ${where}. It is checked with: mrroc trace check ${file}`);
  };
  const refresh = () => {
    const messages = log.buffer.newest(filter.value, SHOWN);
    list.replaceChildren(...messages.map(line_of));
    list.scrollTop = list.scrollHeight;
    filtered = filter.value;
  };
  const append = () => {
    const added = log.buffer.newest(filter.value, SHOWN).filter((message) => message.number > shown);
    list.append(...added.map(line_of));
    while (list.childElementCount > SHOWN) list.firstElementChild?.remove();
    list.scrollTop = list.scrollHeight;
  };
  const update = () => {
    record.update();
    const last = log.buffer.last;
    if (last === shown && filter.value === filtered) return;
    for (const message of log.buffer.newest('black box', 1)) show_hint(message);
    if (node.hidden || paused) return;
    if (shown < 0 || filter.value !== filtered) refresh();
    else append();
    shown = last;
  };
  filter.addEventListener('input', () => {
    refresh();
    shown = log.buffer.last;
  });
  follow.addEventListener('click', () => {
    paused = !paused;
    set_attribute(follow, 'aria-pressed', String(paused));
    set_text(follow, paused ? 'Continue' : 'Pause');
    session.scheduler.ask_now();
  });
  copy.addEventListener('click', () => {
    const text = log.buffer
      .newest(filter.value, Infinity)
      .map((message) => `${time_text(session.seconds(message.tick))}\t${message.kind}\t${message.text}`)
      .join('\n');
    copy_text(text).then(
      () => session.announce('the messages are copied', false),
      () => session.announce('the browser does not allow to copy', true),
    );
  });
  return { node, update };
}

async function copy_text(text: string): Promise<void> {
  if (navigator.clipboard) return navigator.clipboard.writeText(text);
  throw new Error('no clipboard');
}
