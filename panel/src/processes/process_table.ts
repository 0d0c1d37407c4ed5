import { element, set_attribute, set_text } from '../dom/element';
import { count_text, time_text } from '../format/units';
import type { ProcessState } from '../protocol/messages';
import type { Session } from '../session';
import { class_of, error_text } from '../state/errors';

const ROLES = { mp: 'MP', ecp: 'ECP', edp: 'EDP', vsp: 'VSP', sim: 'simulator' };
const HEADINGS: [string, string][] = [
  ['Process', ''],
  ['Role', 'MP: coordinates; ECP: program of a robot; EDP: driver of a robot; VSP: driver of a sensor'],
  ['State', ''],
  ['Instruction', 'Number and kind of the instruction in progress'],
  ['Step', 'Macrostep of the instruction'],
  ['Time', 'Time of the last report'],
  ['Ticks', 'Servo ticks that the process has executed'],
  ['Missed', 'Servo ticks that began too late'],
  ['Late', 'Commands that arrived after their tick'],
  ['Error', 'Class, cause and tick'],
];

interface Row {
  node: HTMLTableRowElement;
  cells: HTMLTableCellElement[];
}

/** State and loop health of every process. Hooks: `#processes`, `tr[data-process]`, cells `data-column`. */
export function process_table(session: Session): { node: HTMLElement; update(): void } {
  const rows = new Map<string, Row>();
  const body = element('tbody');
  const headings = HEADINGS.map(([text, title]) => element('th', { scope: 'col', title: title || undefined }, text));
  const table = element(
    'table',
    { class: 'processes' },
    element('caption', { class: 'hidden-text' }, 'Processes'),
    element('thead', {}, element('tr', {}, ...headings)),
    body,
  );
  const node = element('div', { id: 'processes', class: 'pane scroll', tabindex: 0 }, table);

  const make_row = (name: string): Row => {
    const cells = HEADINGS.map(([text]) => element('td', { 'data-column': text.toLowerCase() }));
    const row = { node: element('tr', { 'data-process': name }, ...cells), cells };
    rows.set(name, row);
    body.append(row.node);
    return row;
  };
  const update = () => {
    if (node.hidden) return;
    for (const [name, process] of session.store.processes) show(rows.get(name) ?? make_row(name), process, session);
  };
  return { node, update };
}

function show(row: Row, process: ProcessState, session: Session): void {
  const error = process.error;
  const error_tick = session.store.error_ticks.get(`process ${process.name}`);
  const texts = [
    process.name,
    ROLES[process.role] ?? process.role,
    process.state,
    process.instruction > 0 ? `${process.instruction} ${process.activity}` : '',
    process.instruction > 0 ? count_text(process.step) : '',
    process.tick > 0 ? time_text(session.seconds(process.tick)) : '',
    process.ticks > 0 ? count_text(process.ticks) : '',
    count_text(process.missed_ticks),
    count_text(process.late_commands),
    error ? `${class_of(error)}: ${error_text(error)}${error_tick ? ` [tick ${error_tick}]` : ''}` : '',
  ];
  texts.forEach((text, index) => {
    const cell = row.cells[index];
    if (cell) set_text(cell, text);
  });
  set_attribute(row.node, 'data-state', error ? 'error' : process.state);
  set_attribute(row.node, 'data-missed', process.missed_ticks > 0 ? 'yes' : null);
  set_attribute(row.node, 'data-late', process.late_commands > 0 ? 'yes' : null);
}
