import { button, element, set_text } from '../dom/element';
import type { Question } from '../protocol/messages';

/** An answer as it is sent, or why the typed one is invalid. */
export type Checked = { value: string | number } | { problem: string };

/** Checks the typed number against the question's range. */
export function check_number(question: Question, text: string): Checked {
  const value = Number(text.trim().replace(',', '.'));
  if (text.trim() === '' || !Number.isFinite(value)) return { problem: `expected: ${question.expected}` };
  const { minimum, maximum } = question;
  if (typeof minimum === 'number' && value < minimum) return { problem: `${value} is below ${minimum}` };
  if (typeof maximum === 'number' && value > maximum) return { problem: `${value} is above ${maximum}` };
  return { value };
}

/** The controls with which a question is answered. Hooks: `[data-answer]`, `#answer-number`. */
export function question_form(question: Question, answer: (value: string | number) => void): HTMLElement {
  if (question.kind === 'yes_no') return buttons(['yes', 'no'], answer);
  if (question.kind === 'choice') return buttons(question.choices ?? [], answer);
  const input = element('input', {
    id: 'answer-number',
    type: 'text',
    inputmode: 'decimal',
    autocomplete: 'off',
    'aria-describedby': 'answer-range answer-problem',
  });
  const problem = element('p', { id: 'answer-problem', class: 'problem', role: 'alert' });
  const form = element(
    'form',
    { class: 'group' },
    element('label', { for: 'answer-number' }, 'Answer'),
    input,
    button('Answer', { type: 'submit', class: 'primary', 'data-answer': 'number' }),
    problem,
  );
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const checked = check_number(question, input.value);
    if ('problem' in checked) {
      set_text(problem, checked.problem);
      input.setAttribute('aria-invalid', 'true');
      input.focus();
    } else {
      answer(checked.value);
    }
  });
  return form;
}

function buttons(values: string[], answer: (value: string) => void): HTMLElement {
  return element(
    'div',
    { class: 'group answers' },
    ...values.map((value) => button(value, { 'data-answer': value }, () => answer(value))),
  );
}
