import { element, set_class, set_hidden, set_text } from '../dom/element';

const FRESH_TIME = 8000; // ms

/** The newest answer of the run to this browser, for eyes and screen readers. Hook: `#answer`. */
export class Announcer {
  private readonly text = element('span');
  readonly node = element('div', { id: 'answer', class: 'answer', role: 'status', 'aria-live': 'polite' }, this.text);
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly log: (text: string, refused: boolean) => void) {
    set_text(this.text, 'No request so far.');
  }

  announce(text: string, refused: boolean): void {
    set_text(this.text, (refused ? 'Refused. ' : '') + text);
    set_class(this.node, 'refused', refused);
    set_class(this.node, 'fresh', true);
    this.node.title = text;
    this.log(text, refused);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => set_class(this.node, 'fresh', false), FRESH_TIME);
  }
}

/** What ends the use of the page: the run is gone, or the connection is lost. Hook: `#gone`. */
export function gone_bar(): { node: HTMLElement; show(text: string, orderly: boolean): void } {
  const node = element('div', { id: 'gone', class: 'bar bar-gone', role: 'alert' });
  node.hidden = true;
  return {
    node,
    show(text, orderly) {
      set_class(node, 'orderly', orderly);
      set_hidden(node, text === '');
      set_text(node, text);
    },
  };
}
