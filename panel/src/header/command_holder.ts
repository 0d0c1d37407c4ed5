import { button, element, is_refused, set_attribute, set_hidden, set_refusal, set_text } from '../dom/element';
import type { Session } from '../session';
import { refusal_of } from '../state/permissions';

/** The holder of command, and the button that takes it or gives it back. Hooks: `#holder`, `#take`, `#release`. */
export function command_holder(session: Session): { node: HTMLElement; update(): void } {
  const { store } = session;
  const holder = element('span', { id: 'holder', class: 'holder', role: 'status' });
  const send = (node: HTMLElement, verb: string) => () => {
    if (is_refused(node)) session.announce(node.title, true);
    else void session.request({ verb });
  };
  const take = button('Take command', { id: 'take', 'data-verb': 'command' });
  take.addEventListener('click', send(take, 'command'));
  const release = button('Release', { id: 'release', 'data-verb': 'release' });
  release.addEventListener('click', send(release, 'release'));
  const label = element('span', { class: 'label' }, 'Command');
  const node = element('div', { class: 'command-holder' }, element('div', {}, label, holder), take, release);
  const update = () => {
    const { situation } = store;
    const mine = store.commander !== null && store.commander === situation.client;
    const other = store.commander !== null && !mine;
    let text = 'free';
    if (mine) text = 'this browser';
    if (other) text = short_client(store.commander ?? '');
    if (!situation.may_command && store.hello) text += ' · watching only';
    set_text(holder, text);
    set_attribute(holder, 'title', store.commander);
    set_text(take, other ? 'Ask for command' : 'Take command');
    set_hidden(take, mine);
    set_hidden(release, !mine);
    set_refusal(take, refusal_of('command', situation));
    set_refusal(release, refusal_of('release', situation));
  };
  return { node, update };
}

/** "mrroc_panel (process 7) #5" without its process, which the title has. */
function short_client(name: string): string {
  return name.replace(/ \(process \d+\)(?= #)/, '');
}

/** Shown to the holder when another client asks for command. Hook: `#wanted`. */
export function command_wanted(session: Session): { node: HTMLElement; update(): void } {
  const { store } = session;
  const text = element('span');
  const release = button('Release command', { 'data-verb': 'release' }, () => {
    void session.request({ verb: 'release' });
  });
  const keep = button('Keep', {}, () => {
    store.wanted_by = '';
    session.scheduler.ask();
  });
  const node = element('div', { id: 'wanted', class: 'bar bar-wanted', role: 'alert' }, text, release, keep);
  const update = () => {
    const wanted = store.wanted_by !== '' && store.commander === store.hello?.client && !store.ended;
    set_hidden(node, !wanted);
    set_text(text, wanted ? `${store.wanted_by} asks for command.` : '');
  };
  return { node, update };
}
