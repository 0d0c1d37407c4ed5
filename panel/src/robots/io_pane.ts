import { button, element, is_refused, set_attribute, set_refusal, set_text } from '../dom/element';
import type { Robot } from '../protocol/scene_file';
import type { Session } from '../session';
import { refusal_of } from '../state/permissions';

const INPUTS = 16;

/**
 * Inputs and outputs of a robot's controller. Hooks: `[data-output="0"]` with `aria-pressed`, `[data-input="0"]` with
 * `data-on`, `[data-analogue]`, `[data-analogue-value]`.
 */
export function io_pane(session: Session, robot: Robot): { node: HTMLElement; update(): void } {
  const send = (output: string, value: number) =>
    void session.request({ verb: 'output', robot: robot.name, output, value });
  const outputs = numbers(robot.digital_outputs).map((index) => output_button(session, robot.name, index, send));
  const inputs = numbers(robot.digital_inputs ?? INPUTS).map(input_light);
  const analogue = analogue_outputs(session, robot, send);
  const node = element('section', { 'aria-label': `Inputs and outputs of ${robot.name}` });
  if (inputs.length > 0)
    node.append(
      element('h3', {}, 'Inputs'),
      element('div', { class: 'signals', role: 'list', 'aria-label': 'Inputs' }, ...inputs),
    );
  if (outputs.length > 0)
    node.append(
      element('h3', {}, 'Outputs'),
      element('div', { class: 'signals', role: 'group', 'aria-label': 'Outputs' }, ...outputs),
    );
  if (robot.analogue_outputs > 0) node.append(analogue.node);
  const update = () => {
    const state = session.store.robots.get(robot.name);
    const reason = refusal_of('output', session.store.situation);
    inputs.forEach((light, index) => show_input(light, index, bit(state?.inputs ?? 0, index)));
    outputs.forEach((made, index) => {
      set_attribute(made, 'aria-pressed', String(bit(state?.outputs ?? 0, index)));
      set_refusal(made, reason);
    });
    analogue.refuse(reason);
  };
  return { node, update };
}

function numbers(count: number): number[] {
  return Array.from({ length: count }, (_, index) => index);
}

function bit(bits: number, index: number): boolean {
  return Math.floor(bits / 2 ** index) % 2 === 1;
}

function output_button(
  session: Session,
  robot: string,
  index: number,
  send: (output: string, value: number) => void,
): HTMLButtonElement {
  const made = button(String(index), {
    class: 'signal',
    'aria-pressed': 'false',
    'aria-label': `Output ${index}`,
    'data-verb': 'output',
    'data-robot': robot,
    'data-output': index,
    'data-title': `Output ${index}`,
  });
  made.addEventListener('click', () => {
    if (is_refused(made)) session.announce(`output ${robot}: ${made.title}`, true);
    else send(String(index), made.getAttribute('aria-pressed') === 'true' ? 0 : 1);
  });
  return made;
}

function input_light(index: number): HTMLElement {
  return element('span', { class: 'signal light', role: 'listitem', 'data-input': index }, String(index));
}

function show_input(light: HTMLElement, index: number, on: boolean): void {
  set_attribute(light, 'data-on', on ? 'yes' : 'no');
  set_attribute(light, 'title', `Input ${index} is ${on ? 'on' : 'off'}`);
}

function analogue_outputs(
  session: Session,
  robot: Robot,
  send: (output: string, value: number) => void,
): { node: HTMLElement; refuse(reason: string): void } {
  const label = `Analogue output of ${robot.name}`;
  const select = element(
    'select',
    { 'aria-label': label, 'data-analogue': robot.name },
    ...numbers(robot.analogue_outputs).map((index) => element('option', { value: `a${index}` }, `a${index}`)),
  );
  const value = element('input', {
    type: 'number',
    step: 'any',
    value: 0,
    'aria-label': `Value, ${label}`,
    'data-analogue-value': robot.name,
  });
  const set = button('Set', { 'data-verb': 'output', 'data-robot': robot.name });
  const submit = () => {
    if (is_refused(set)) session.announce(`output ${robot.name}: ${set.title}`, true);
    else if (value.value === '' || !Number.isFinite(value.valueAsNumber))
      session.announce(`output ${robot.name}: the value is not a number`, true);
    else send(select.value, value.valueAsNumber);
  };
  set.addEventListener('click', submit);
  value.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') submit();
  });
  const text = element('span', { class: 'label' });
  set_text(text, 'Analogue');
  return {
    node: element('div', { class: 'group analogue' }, text, select, value, set),
    refuse: (reason) => set_refusal(set, reason),
  };
}
