/** Curves differ in colour and in their dashes. */
const LIGHT = ['#0b62c4', '#b45309', '#0f7a4f', '#a21caf', '#b91c1c', '#475569'];
const DARK = ['#6cb2ff', '#f5b14c', '#4fd08c', '#e58bf0', '#ff8a80', '#b6c2d1'];
const DASHES: number[][] = [[], [8, 4], [2, 3], [10, 3, 2, 3], [5, 2], [14, 4]];

export function curve_colour(index: number, dark: boolean): string {
  const colours = dark ? DARK : LIGHT;
  return colours[index % colours.length] ?? '#888';
}

export function curve_dash(index: number): number[] {
  return DASHES[index % DASHES.length] ?? [];
}
