import { button, element, set_hidden, set_text } from '../dom/element';
import type { Question } from '../protocol/messages';
import type { Session } from '../session';
import { refusal_of } from '../state/permissions';
import { question_form } from './question_form';

/**
 * The open questions of the task, one at a time. The dialog is not modal: the stops of the header stay in reach.
 * Escape puts it aside. Hooks: `#question`, `#question-bar`.
 */
export class QuestionDialog {
  readonly node = element('dialog', { id: 'question', 'aria-labelledby': 'question-text' });
  readonly bar = element('div', { id: 'question-bar', class: 'bar bar-question' });
  private readonly bar_text = element('span');
  private readonly remark = element('p', { class: 'remark', id: 'answer-remark' });
  private shown = '';
  private aside = false;
  private pending = '';
  private before: Element | null = null;

  constructor(private readonly session: Session) {
    this.bar.append(
      this.bar_text,
      button('Show', {}, () => this.recall()),
    );
    this.bar.hidden = true;
  }

  update(): void {
    const open = this.session.store.questions.filter((question) => key_of(question) !== this.pending);
    const first = open[0];
    const key = first && !this.session.store.ended ? key_of(first) : '';
    if (key !== this.shown) {
      this.shown = key;
      this.aside = false;
      if (first && key) this.show(first);
      else this.close();
    }
    set_hidden(this.bar, key === '' || !this.aside);
    set_text(this.bar_text, first ? `${first.from} asks: ${first.text}` : '');
    const reason = refusal_of('answer', this.session.store.situation);
    const others = open.length > 1 ? `${open.length - 1} more after this one. ` : '';
    set_text(this.remark, others + reason);
  }

  /** Puts the question aside; a bar recalls it. */
  escape(): void {
    if (!this.node.open) return;
    this.aside = true;
    this.close();
    this.session.scheduler.ask_now();
  }

  private recall(): void {
    this.aside = false;
    const first = this.session.store.questions[0];
    if (first) this.show(first);
    this.session.scheduler.ask_now();
  }

  private show(question: Question): void {
    const range = element('p', { id: 'answer-range', class: 'quiet' }, `Expected: ${question.expected}`);
    this.node.replaceChildren(
      element('p', { class: 'label' }, `${question.from} asks`),
      element('h2', { id: 'question-text' }, question.text),
      range,
      question_form(question, (value) => void this.answer(question, value)),
      this.remark,
      button('Later', { class: 'plain', title: 'Put the question aside (Escape)' }, () => this.escape()),
    );
    this.before = document.activeElement;
    if (!this.node.open) this.node.show();
    this.node.querySelector<HTMLElement>('input, [data-answer]')?.focus();
  }

  private close(): void {
    if (!this.node.open) return;
    this.node.close();
    if (this.before instanceof HTMLElement && this.before.isConnected) this.before.focus();
  }

  private async answer(question: Question, value: string | number): Promise<void> {
    const reason = refusal_of('answer', this.session.store.situation);
    if (reason) {
      this.session.announce(`answer: ${reason}`, true);
      return;
    }
    const reply = await this.session.request({ verb: 'answer', value, from: question.from });
    if (!reply.ok) return;
    ++this.session.store.changes;
    this.pending = key_of(question); // until a status without it arrives
    this.session.store.questions = this.session.store.questions.filter((open) => key_of(open) !== this.pending);
    this.session.scheduler.ask_now();
  }
}

function key_of(question: Question): string {
  return `${question.from} ${question.number}`;
}
