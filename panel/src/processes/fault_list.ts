import { button, element, set_attribute, set_hidden, set_text } from '../dom/element';
import type { ErrorReport } from '../protocol/messages';
import type { Session } from '../session';
import { process_advice, robot_advice, type Action, type Advice } from '../state/advice';
import { class_of, error_text } from '../state/errors';
import { refusal_of } from '../state/permissions';

const ACTIONS: Record<Action, string> = { reset: 'Reset', recover: 'Recover', synchronise: 'Synchronise' };

interface Fault {
  key: string;
  subject: string;
  robot?: string;
  error: ErrorReport;
  tick: number;
  advice: Advice | null;
}

interface Line {
  node: HTMLElement;
  title: HTMLElement;
  cause: HTMLElement;
  advice: HTMLElement;
  action: HTMLButtonElement;
}

/** Every present error with class, cause, tick and what to do. Hooks: `#faults`, `[data-fault]`. */
export function fault_list(session: Session): { node: HTMLElement; update(): number } {
  const node = element('section', { id: 'faults', class: 'faults', role: 'alert', 'aria-label': 'Errors' });
  const lines = new Map<string, Line>();
  const update = () => {
    const faults = collect(session);
    const keys = new Set(faults.map((fault) => fault.key));
    for (const [key, line] of lines) {
      if (keys.has(key)) continue;
      line.node.remove();
      lines.delete(key);
    }
    for (const fault of faults) show(session, lines, node, fault);
    set_hidden(node, faults.length === 0);
    return faults.length;
  };
  return { node, update };
}

/** An error of a robot is in its EDP's and its ECP's state, too: it is listed once. */
function collect(session: Session): Fault[] {
  const { store } = session;
  const faults: Fault[] = [];
  const codes = new Set<string>();
  for (const [name, robot] of store.robots) {
    if (!robot.error) continue;
    codes.add(`${name} ${robot.error.code}`);
    const advice = robot_advice(robot, store.emergency_stop);
    const tick = store.error_ticks.get(name) ?? robot.tick;
    faults.push({ key: name, subject: `robot ${name}`, robot: name, error: robot.error, tick, advice });
  }
  for (const [name, reading] of store.readings) {
    if (!reading.error) continue;
    codes.add(`${name} ${reading.error.code}`);
    const tick = store.error_ticks.get(name) ?? reading.tick;
    faults.push({
      key: name,
      subject: `sensor ${name}`,
      error: reading.error,
      tick,
      advice: process_advice(reading.error),
    });
  }
  for (const [name, process] of store.processes) {
    const owner = name.replace(/_edp$/, '');
    if (!process.error || codes.has(`${owner} ${process.error.code}`)) continue;
    const tick = store.error_ticks.get(`process ${name}`) ?? process.tick;
    const advice = process_advice(process.error);
    faults.push({ key: `process ${name}`, subject: `process ${name}`, error: process.error, tick, advice });
  }
  return faults;
}

function make_line(session: Session, fault: Fault): Line {
  const title = element('strong');
  const cause = element('span', { class: 'cause' });
  const advice = element('span', { class: 'advice' });
  const action = button('', {}, () => {
    const verb = action.dataset['verb'] ?? '';
    void session.request(verb === 'reset' || !fault.robot ? { verb } : { verb, robot: fault.robot });
  });
  const node = element('div', { class: 'fault', 'data-fault': fault.key }, title, cause, advice, action);
  return { node, title, cause, advice, action };
}

function show(session: Session, lines: Map<string, Line>, parent: HTMLElement, fault: Fault): void {
  let line = lines.get(fault.key);
  if (!line) {
    line = make_line(session, fault);
    lines.set(fault.key, line);
    parent.append(line.node);
  }
  set_text(line.title, `${fault.subject}: ${class_of(fault.error)}`);
  set_text(line.cause, `${error_text(fault.error)} [tick ${fault.tick}]`);
  set_text(line.advice, fault.advice?.text ?? '');
  const action = fault.advice?.action;
  const refused = action ? refusal_of(action, session.store.situation) : '';
  set_hidden(line.action, !action || refused !== '');
  if (!action) return;
  set_text(line.action, ACTIONS[action]);
  set_attribute(line.action, 'data-verb', action);
  set_attribute(
    line.action,
    'aria-label',
    `${ACTIONS[action]} ${action === 'reset' ? '' : (fault.robot ?? '')}`.trim(),
  );
}
