import { button, element, set_attribute, set_hidden, set_text } from './element';

export interface Tab {
  id: string;
  title: string;
  content: HTMLElement;
}

/** A tab list after the ARIA pattern: arrow keys choose, the tab key enters the content. */
export class Tabs {
  readonly list: HTMLElement;
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly badges = new Map<string, HTMLElement>();

  constructor(
    label: string,
    private readonly tabs: Tab[],
    private readonly chosen: (id: string) => void = () => {},
  ) {
    this.list = element('div', { role: 'tablist', 'aria-label': label, class: 'tabs' });
    for (const tab of tabs) {
      const made = button(tab.title, {
        role: 'tab',
        id: `tab-${tab.id}`,
        'aria-controls': tab.content.id,
        class: 'tab',
      });
      const badge = element('span', { class: 'badge' });
      badge.hidden = true;
      made.append(badge);
      made.addEventListener('click', () => this.choose(tab.id));
      made.addEventListener('keydown', (event) => this.move(event, tab.id));
      set_attribute(tab.content, 'role', 'tabpanel');
      set_attribute(tab.content, 'aria-labelledby', made.id);
      this.buttons.set(tab.id, made);
      this.badges.set(tab.id, badge);
      this.list.append(made);
    }
    if (tabs[0]) this.choose(tabs[0].id);
  }

  choose(id: string): void {
    for (const tab of this.tabs) {
      const made = this.buttons.get(tab.id);
      const chosen = tab.id === id;
      if (made) {
        set_attribute(made, 'aria-selected', String(chosen));
        set_attribute(made, 'tabindex', chosen ? '0' : '-1');
      }
      set_hidden(tab.content, !chosen);
    }
    this.chosen(id);
  }

  /** A number beside the title, e.g. of errors; 0: none. `what` is for screen readers. */
  badge(id: string, number: number, what: string): void {
    const badge = this.badges.get(id);
    if (!badge) return;
    set_hidden(badge, number === 0);
    set_text(badge, String(number));
    set_attribute(badge, 'title', number === 0 ? null : `${number} ${what}`);
  }

  private move(event: KeyboardEvent, id: string): void {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const index = this.tabs.findIndex((tab) => tab.id === id);
    const next = this.tabs[(index + step + this.tabs.length) % this.tabs.length];
    if (!next) return;
    this.choose(next.id);
    this.buttons.get(next.id)?.focus();
  }
}
