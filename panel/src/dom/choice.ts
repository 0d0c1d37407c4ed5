import { element } from './element';

let groups = 0;

export interface Choice {
  node: HTMLElement;
  value(): string;
  choose(value: string): void;
}

/** A row of radio buttons that looks like one control. Hooks: `input[data-choice][value]`. */
export function choice(
  legend: string,
  key: string,
  options: [value: string, text: string][],
  changed: (value: string) => void,
): Choice {
  const group = `choice-${++groups}`;
  const node = element('fieldset', { class: 'choice' }, element('legend', { class: 'hidden-text' }, legend));
  const inputs = options.map(([value, text], index) => {
    const input = element('input', { type: 'radio', name: group, value, 'data-choice': key });
    input.checked = index === 0;
    input.addEventListener('change', () => changed(value));
    node.append(element('label', {}, input, element('span', {}, text)));
    return input;
  });
  return {
    node,
    value: () => inputs.find((input) => input.checked)?.value ?? '',
    choose(value) {
      for (const input of inputs) input.checked = input.value === value;
    },
  };
}
