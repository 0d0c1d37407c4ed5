import { button, element, set_attribute, set_text } from '../dom/element';
import { fixed } from '../format/units';
import { is_dark } from '../header/theme_switch';
import { Chart } from './chart';
import type { History, Quantity } from './history';
import { curve_colour, curve_dash } from './style';
import { PlotWindow } from './window';

const SPANS = [10, 20, 30, 60];

/**
 * One plot: choice of the quantity, its curves, pause and zoom (drag, or + and − while the plot has the focus, arrows
 * move it, Home follows the run). Hooks: `.plot`, `[data-plot-quantity]`, `[data-plot-pause]`, `[data-curve]`.
 */
export class PlotPane {
  readonly node: HTMLElement;
  private readonly area = element('div', { class: 'area', tabindex: 0, role: 'application' });
  private readonly legend = element('div', { class: 'legend' });
  private readonly select = element('select', { 'aria-label': 'Plotted quantity', 'data-plot-quantity': '' });
  private readonly pause = button('Pause', { 'data-plot-pause': '', 'aria-pressed': 'false' }, () => this.toggle());
  private readonly window = new PlotWindow(20);
  private readonly hidden = new Set<string>();
  private readonly figures: HTMLElement[] = [];
  private chart: Chart | null = null;
  private quantity: Quantity | undefined;

  constructor(
    private readonly history: History,
    first: string,
  ) {
    for (const { key, title } of history.quantities) this.select.append(element('option', { value: key }, title));
    this.quantity = history.quantities.find(({ key }) => key === first) ?? history.quantities[0];
    if (this.quantity) this.select.value = this.quantity.key;
    this.select.addEventListener('change', () => this.choose(this.select.value));
    const span = element(
      'select',
      { 'aria-label': 'Plotted time' },
      ...SPANS.map((seconds) => element('option', { value: seconds, selected: seconds === 20 }, `${seconds} s`)),
    );
    span.addEventListener('change', () => {
      this.window.set_span(Number(span.value));
      this.refresh();
    });
    const limits = button('Limits', {
      'aria-pressed': 'true',
      title: 'Draw the limits, dotted, where they are in range',
    });
    limits.addEventListener('click', () => {
      const on = limits.getAttribute('aria-pressed') !== 'true';
      set_attribute(limits, 'aria-pressed', String(on));
      if (this.chart) this.chart.limits = on;
      this.refresh();
    });
    const zoom = (text: string, label: string, factor: number) =>
      button(text, { class: 'plain', 'aria-label': label }, () => this.zoom(factor));
    this.node = element(
      'div',
      { class: 'plot' },
      element(
        'div',
        { class: 'toolbar' },
        this.select,
        span,
        limits,
        element('span', { class: 'spacer' }),
        zoom('−', 'Zoom out', 2),
        zoom('+', 'Zoom in', 0.5),
        this.pause,
      ),
      this.area,
      this.legend,
    );
    this.area.addEventListener('keydown', (event) => this.handle_key(event));
    this.area.addEventListener('dblclick', () => this.follow());
    new ResizeObserver(() => this.resize()).observe(this.area);
  }

  /** Draws the newest samples, unless the plot is paused. */
  update(): void {
    if (this.area.clientWidth === 0) return;
    if (!this.chart) this.rebuild();
    if (this.window.live) this.chart?.update();
    this.show_values();
  }

  /** Makes the plot again, after a change of the quantity or the theme. */
  rebuild(): void {
    this.chart?.destroy();
    this.chart = null;
    const quantity = this.quantity;
    if (!quantity || this.area.clientWidth === 0) return;
    const style = getComputedStyle(document.documentElement);
    const look = { dark: is_dark(), text: style.getPropertyValue('--quiet'), line: style.getPropertyValue('--line') };
    this.chart = new Chart(this.area, quantity, look, this.hidden, this.window, () => this.refresh());
    this.area.setAttribute('aria-label', `Plot of ${quantity.title}`);
    this.figures.length = 0;
    this.legend.replaceChildren(
      ...quantity.curves.map((_curve, index) => this.legend_entry(quantity, index, look.dark)),
    );
  }

  private choose(key: string): void {
    this.quantity = this.history.quantities.find((quantity) => quantity.key === key);
    this.hidden.clear();
    this.window.follow();
    this.rebuild();
    this.refresh();
  }

  private legend_entry(quantity: Quantity, index: number, dark: boolean): HTMLElement {
    const { name, unit } = quantity.curves[index] ?? { name: '', unit: '' };
    const sample = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    sample.setAttribute('viewBox', '0 0 24 4');
    sample.setAttribute('aria-hidden', 'true');
    const line = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    line.setAttribute('d', 'M0 2H24');
    line.setAttribute('stroke', curve_colour(index, dark));
    line.setAttribute('stroke-width', '2.5');
    line.setAttribute('stroke-dasharray', curve_dash(index).join(' '));
    sample.append(line);
    const figure = element('span', { class: 'figure' });
    this.figures.push(figure);
    const made = button('', { class: 'curve', 'data-curve': name, 'aria-pressed': String(!this.hidden.has(name)) });
    made.append(sample, element('span', {}, name), figure, element('span', { class: 'quiet' }, unit));
    made.addEventListener('click', () => {
      const visible = this.hidden.delete(name);
      if (!visible) this.hidden.add(name);
      set_attribute(made, 'aria-pressed', String(visible));
      this.chart?.show(index, visible);
    });
    return made;
  }

  private show_values(): void {
    this.figures.forEach((figure, index) => set_text(figure, fixed(this.chart?.value(index), 2)));
  }

  private get newest(): number {
    return this.quantity?.ring.last ?? 0;
  }

  private toggle(): void {
    if (this.window.live) this.window.pause(this.newest);
    else this.window.follow();
    this.refresh();
  }

  private follow(): void {
    this.window.follow();
    this.refresh();
  }

  private zoom(factor: number): void {
    this.window.zoom(factor, this.newest);
    this.refresh();
  }

  private refresh(): void {
    set_attribute(this.pause, 'aria-pressed', String(!this.window.live));
    set_text(this.pause, this.window.live ? 'Pause' : 'Follow');
    this.chart?.update();
    this.show_values();
  }

  private handle_key(event: KeyboardEvent): void {
    if (event.key === '+' || event.key === '=') this.zoom(0.5);
    else if (event.key === '-') this.zoom(2);
    else if (event.key === 'Home') this.follow();
    else if (event.key === 'ArrowLeft' || event.key === 'ArrowRight') {
      this.window.move(event.key === 'ArrowLeft' ? -0.25 : 0.25, this.newest);
      this.refresh();
    } else return;
    event.preventDefault();
  }

  private resize(): void {
    if (this.chart) this.chart.resize(this.area.clientWidth, this.area.clientHeight);
    else this.update();
  }
}
