import { button, is_refused } from '../dom/element';

export interface JogActions {
  /** True: the button moves by a step when it is clicked. False: it moves while it is pressed. */
  stepwise(): boolean;
  step(sign: 1 | -1): void;
  press(sign: 1 | -1): void;
  release(reason: string): void;
  refused(reason: string): void;
}

/**
 * A "−" or "+" button of a jog: by pointer, or by holding Enter while it has the focus. Hooks: `data-verb="jog"`,
 * `data-robot`, `data-axis`, `data-sign`.
 */
export function jog_button(robot: string, axis: string, sign: 1 | -1, actions: JogActions): HTMLButtonElement {
  const name = sign > 0 ? 'plus' : 'minus';
  const node = button(sign > 0 ? '+' : '−', {
    class: 'jog',
    'aria-label': `${axis} ${name}`,
    'data-verb': 'jog',
    'data-robot': robot,
    'data-axis': axis,
    'data-sign': sign > 0 ? '+' : '-',
  });
  const begin = () => {
    if (is_refused(node)) actions.refused(node.title);
    else if (actions.stepwise()) actions.step(sign);
    else actions.press(sign);
  };
  node.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    node.focus();
    node.setPointerCapture(event.pointerId);
    begin();
  });
  node.addEventListener('pointerup', () => actions.release(''));
  node.addEventListener('pointercancel', () => actions.release('the pointer was cancelled'));
  node.addEventListener('lostpointercapture', () => actions.release(''));
  node.addEventListener('contextmenu', (event) => event.preventDefault());
  node.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter') return;
    event.preventDefault();
    if (!event.repeat) begin();
  });
  node.addEventListener('keyup', (event) => {
    if (event.key === 'Enter') actions.release('');
  });
  node.addEventListener('blur', () => actions.release(''));
  return node;
}
