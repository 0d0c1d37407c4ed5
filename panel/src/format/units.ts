/** Numbers as the operator reads them: degrees and millimetres, with a true minus sign and a fixed width. */

export type Unit = 'rad' | 'm';

const DEGREE = 180 / Math.PI;

export function shown_unit(unit: Unit): string {
  return unit === 'rad' ? '°' : 'mm';
}

export function to_shown(value: number, unit: Unit): number {
  return unit === 'rad' ? value * DEGREE : value * 1000;
}

export function from_shown(value: number, unit: Unit): number {
  return unit === 'rad' ? value / DEGREE : value / 1000;
}

/** "−12.30", or "–" for a missing value. */
export function fixed(value: number | null | undefined, digits: number): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const text = Math.abs(value).toFixed(digits);
  return value < 0 && Number(text) !== 0 ? `−${text}` : text;
}

/** A position with its unit: "−12.30 °", "250.0 mm". */
export function position_text(value: number | null | undefined, unit: Unit): string {
  if (value === null || value === undefined) return '–';
  return `${fixed(to_shown(value, unit), unit === 'rad' ? 2 : 1)} ${shown_unit(unit)}`;
}

/** Time of the run: "12.34 s", "3:05.20", "1:02:03.4". */
export function time_text(seconds: number): string {
  if (!Number.isFinite(seconds)) return '–';
  if (seconds < 60) return `${seconds.toFixed(2)} s`;
  const minutes = Math.floor(seconds / 60);
  const rest = seconds - 60 * minutes;
  if (minutes < 60) return `${minutes}:${rest.toFixed(2).padStart(5, '0')}`;
  return `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, '0')}:${rest.toFixed(1).padStart(4, '0')}`;
}

/** "1 234 567": thousands apart, so that counters are legible. */
export function count_text(value: number): string {
  return String(value).replace(/\B(?=(\d{3})+(?!\d))/g, '\u202f');
}
