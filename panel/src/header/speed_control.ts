import { element, set_hidden, set_text } from '../dom/element';
import type { Session } from '../session';
import { refusal_of } from '../state/permissions';

/** The speed override, 1..100 %. Hidden when the run has none. Hook: `#speed`. */
export function speed_control(session: Session): { node: HTMLElement; update(): void } {
  const { store } = session;
  const slider = element('input', { id: 'speed', type: 'range', min: 1, max: 100, step: 1, value: 100 });
  const output = element('output', { for: 'speed', class: 'figure' });
  const node = element(
    'div',
    { class: 'speed' },
    element('label', { for: 'speed', class: 'label' }, 'Speed'),
    slider,
    output,
  );
  let touched = 0;
  slider.addEventListener('input', () => {
    touched = performance.now();
    set_text(output, `${slider.value} %`);
  });
  slider.addEventListener('change', () => {
    touched = performance.now();
    void session.request({ verb: 'speed', value: Number(slider.value) });
  });
  const update = () => {
    set_hidden(node, store.speed === undefined);
    if (store.speed === undefined) return;
    const reason = refusal_of('speed', store.situation);
    slider.disabled = reason !== '';
    slider.title = reason || 'Speed of the task in percent';
    if (performance.now() - touched < 1000) return;
    const percent = String(Math.round(store.speed * 100));
    if (slider.value !== percent) slider.value = percent;
    set_text(output, `${percent} %`);
  };
  return { node, update };
}
