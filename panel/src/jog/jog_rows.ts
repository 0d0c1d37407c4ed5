import { element, set_attribute, set_class, set_hidden, set_refusal, set_text } from '../dom/element';
import { fixed, position_text, shown_unit, to_shown, type Unit } from '../format/units';
import { jog_button, type JogActions } from './jog_button';

export interface JogAxis {
  name: string;
  unit: Unit;
  minimum?: number | null;
  maximum?: number | null;
}

export interface JogRow {
  node: HTMLElement;
  show(value: number | null | undefined): void;
  refuse(reason: string): void;
  set_active(sign: number): void;
}

const NEAR = 0.03; // of the range

/** One axis: name, position against its limits, − and +. Left and right arrows jog, up and down change the axis. */
export function jog_row(robot: string, axis: JogAxis, actions: JogActions): JogRow {
  const minus = jog_button(robot, axis.name, -1, actions);
  const plus = jog_button(robot, axis.name, 1, actions);
  const value = element('span', { class: 'figure value', 'data-value': axis.name });
  const marker = element('span', { class: 'marker' });
  const limited = typeof axis.minimum === 'number' && typeof axis.maximum === 'number';
  const scale = element('span', { class: 'scale', title: limited ? limits_text(axis) : undefined }, marker);
  set_hidden(scale, !limited);
  const node = element(
    'div',
    { class: 'jog-row', role: 'group', 'aria-label': axis.name, 'data-axis-row': axis.name },
    element('span', { class: 'name', title: axis.name }, axis.name),
    scale,
    value,
    minus,
    plus,
  );
  node.addEventListener('keydown', (event) => handle_key(event, node, minus, plus));
  node.addEventListener('keyup', (event) => {
    if (event.key === 'ArrowLeft' || event.key === 'ArrowRight') actions.release('');
  });

  const show_limits = (position: number) => {
    const minimum = axis.minimum ?? 0;
    const maximum = axis.maximum ?? 1;
    const part = (position - minimum) / (maximum - minimum);
    const left = `${(100 * Math.max(0, Math.min(1, part))).toFixed(1)}%`;
    if (marker.style.left !== left) marker.style.left = left;
    set_attribute(scale, 'data-near', part < NEAR ? 'minimum' : part > 1 - NEAR ? 'maximum' : null);
  };
  return {
    node,
    show(position) {
      set_text(value, position_text(position, axis.unit));
      if (!limited) return;
      set_class(marker, 'unknown', typeof position !== 'number');
      if (typeof position === 'number') show_limits(position);
    },
    refuse(reason) {
      set_refusal(minus, reason);
      set_refusal(plus, reason);
    },
    set_active(sign) {
      set_class(minus, 'active', sign < 0);
      set_class(plus, 'active', sign > 0);
    },
  };
}

function limits_text(axis: JogAxis): string {
  const text = (value: number | null | undefined) => fixed(to_shown(value ?? 0, axis.unit), 1);
  return `${text(axis.minimum)} to ${text(axis.maximum)} ${shown_unit(axis.unit)}`;
}

function handle_key(event: KeyboardEvent, row: HTMLElement, minus: HTMLElement, plus: HTMLElement): void {
  const up = event.key === 'ArrowUp';
  if (up || event.key === 'ArrowDown') {
    event.preventDefault();
    const next = up ? row.previousElementSibling : row.nextElementSibling;
    next?.querySelector<HTMLElement>(`[data-sign="${document.activeElement === minus ? '-' : '+'}"]`)?.focus();
    return;
  }
  const target = event.key === 'ArrowLeft' ? minus : event.key === 'ArrowRight' ? plus : null;
  if (!target) return;
  event.preventDefault();
  if (event.repeat) return;
  target.focus();
  target.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter' }));
}
