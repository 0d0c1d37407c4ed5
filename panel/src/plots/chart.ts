import uPlot from 'uplot';
import type { Curve, Quantity } from './history';
import { curve_colour, curve_dash } from './style';
import type { PlotWindow } from './window';

const MOST_POINTS = 1200;

export interface ChartLook {
  dark: boolean;
  text: string;
  line: string;
}

/** One uPlot of the curves of a quantity. A unit is a scale of its own. */
export class Chart {
  private readonly plot: uPlot;
  private readonly units: string[];
  limits = true;

  constructor(
    parent: HTMLElement,
    private readonly quantity: Quantity,
    private readonly look: ChartLook,
    private readonly hidden: Set<string>,
    private readonly window: PlotWindow,
    selected: () => void,
  ) {
    this.units = [...new Set(quantity.curves.map((curve) => curve.unit))];
    const { clientWidth: width, clientHeight: height } = parent;
    const options: uPlot.Options = {
      width: Math.max(50, width),
      height: Math.max(50, height),
      legend: { show: false },
      cursor: { drag: { x: true, y: false, setScale: false }, points: { size: 5 } },
      padding: [8, 18, 0, 0],
      scales: { x: { time: false, range: () => this.window.interval(quantity.ring.last) } },
      axes: [this.axis('x', 3), ...this.units.slice(0, 2).map((unit, i) => this.axis(unit, i === 0 ? 3 : 1))],
      series: [{}, ...quantity.curves.map((curve, i) => this.series(curve, i))],
      hooks: {
        draw: [(plot) => this.draw_limits(plot)],
        setSelect: [
          (plot) => {
            if (plot.select.width < 5) return;
            const from = plot.posToVal(plot.select.left, 'x');
            const to = plot.posToVal(plot.select.left + plot.select.width, 'x');
            plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
            this.window.show(from, to);
            selected();
          },
        ],
      },
    };
    for (const unit of this.units) (options.scales ??= {})[unit] = { range: (_plot, low, high) => padded(low, high) };
    this.plot = new uPlot(options, this.data(), parent);
  }

  update(): void {
    this.plot.setData(this.data(), true);
  }

  resize(width: number, height: number): void {
    if (width > 0 && height > 0) this.plot.setSize({ width, height });
  }

  show(index: number, visible: boolean): void {
    this.plot.setSeries(index + 1, { show: visible });
  }

  /** The value of a curve under the cursor, or the newest one. */
  value(index: number): number | null {
    const column = this.plot.data[index + 1];
    const at = this.plot.cursor.idx ?? (this.plot.data[0]?.length ?? 0) - 1;
    return column?.[at] ?? null;
  }

  destroy(): void {
    this.plot.destroy();
  }

  private data(): uPlot.AlignedData {
    const { ring, curves } = this.quantity;
    const [from, to] = this.window.interval(ring.last);
    const { times, values } = ring.window(
      from,
      to,
      curves.map((curve) => curve.channel),
      MOST_POINTS,
    );
    const scaled = values.map((column, i) => {
      const factor = curves[i]?.factor ?? 1;
      return column.map((value) => (value === null ? null : value * factor));
    });
    return [times, ...scaled] as uPlot.AlignedData;
  }

  private axis(scale: string, side: number): uPlot.Axis {
    const label = scale === 'x' ? 's' : scale;
    return {
      scale,
      side: scale === 'x' ? 2 : side,
      stroke: this.look.text,
      size: scale === 'x' ? 24 : 46,
      gap: 4,
      font: '11px system-ui, sans-serif',
      grid: { stroke: this.look.line, width: 1, show: side === 3 },
      ticks: { show: false },
      values: (_plot, ticks) =>
        ticks.map((tick, i) => `${+tick.toPrecision(7)}${i === ticks.length - 1 ? ` ${label}` : ''}`),
    };
  }

  private series(curve: Curve, index: number): uPlot.Series {
    return {
      label: curve.name,
      scale: curve.unit,
      stroke: curve_colour(index, this.look.dark),
      width: 1.5,
      dash: curve_dash(index),
      show: !this.hidden.has(curve.name),
      points: { show: false },
    };
  }

  private draw_limits(plot: uPlot): void {
    if (!this.limits) return;
    const { left, top, width, height } = plot.bbox;
    const { ctx } = plot;
    ctx.save();
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([2 * devicePixelRatio, 2 * devicePixelRatio]);
    this.quantity.curves.forEach((curve, index) => {
      if (this.hidden.has(curve.name)) return;
      ctx.strokeStyle = curve_colour(index, this.look.dark);
      for (const limit of curve.limits) {
        const y = Math.round(plot.valToPos(limit, curve.unit, true));
        if (!(y >= top && y <= top + height)) continue;
        ctx.beginPath();
        ctx.moveTo(left, y);
        ctx.lineTo(left + width, y);
        ctx.stroke();
      }
    });
    ctx.restore();
  }
}

/** Some room above and below, and no range that shows only noise of the last digit. */
export function padded(low: number | null, high: number | null): [number, number] {
  if (low === null || high === null || !Number.isFinite(low) || !Number.isFinite(high)) return [-1, 1];
  const room = Math.max(0.08 * (high - low), 1e-3 * Math.max(Math.abs(low), Math.abs(high)), 0.005);
  return [low - room, high + room];
}
