import { choice } from '../dom/choice';
import { element, set_text } from '../dom/element';
import { fixed, from_shown, shown_unit, to_shown } from '../format/units';
import { roll_pitch_yaw } from '../format/rotation';
import type { Numbers, RobotState } from '../protocol/messages';
import type { Robot } from '../protocol/scene_file';
import type { Session } from '../session';
import { refusal_of } from '../state/permissions';
import { jog_row, type JogRow } from './jog_rows';
import type { JogSession } from './jog_session';
import type { JogFrame } from './jog_repeater';
import { jog_velocity, moved_axes, type MovedAxis } from './jog_velocity';

const FRAMES: [JogFrame, string][] = [
  ['axes', 'Axes'],
  ['motors', 'Motors'],
  ['base', 'Base'],
  ['tool', 'Tool'],
];
const STEPS: [string, string][] = [
  ['held', 'While held'],
  ['0.1', '0.1'],
  ['1', '1'],
  ['10', '10'],
];

/**
 * Jog and steps of one robot. Hooks: `[data-choice="frame"]`, `[data-choice="motion"]`, `input[data-velocity]`, the
 * buttons of jog_button.ts.
 */
export function jog_pane(session: Session, jog: JogSession, robot: Robot): { node: HTMLElement; update(): void } {
  const rows = element('div', { class: 'jog-rows' });
  let axes: MovedAxis[] = [];
  let shown: JogRow[] = [];
  const frame = choice('Move', 'frame', FRAMES, () => fill());
  const motion = choice('Motion', 'motion', STEPS, () => show_velocity());
  const slider = element('input', {
    type: 'range',
    min: 1,
    max: 100,
    value: 10,
    id: `velocity-${robot.name}`,
    'data-velocity': robot.name,
  });
  const velocity = element('output', { class: 'figure', for: slider.id });
  const in_frame = () => frame.value() as JogFrame;

  const actions_of = (axis: MovedAxis) => ({
    stepwise: () => motion.value() !== 'held',
    step: (sign: 1 | -1) => {
      const distance = sign * from_shown(Number(motion.value()), axis.unit);
      void session.request({ verb: 'step', robot: robot.name, axis: axis.name, distance, in: in_frame() });
    },
    press: (sign: 1 | -1) =>
      jog.press({
        robot: robot.name,
        axis: axis.name,
        in: in_frame(),
        velocity: jog_velocity(axis, Number(slider.value), sign),
      }),
    release: (reason: string) => jog.release(reason),
    refused: (reason: string) => session.announce(`jog ${robot.name}: ${reason}`, true),
  });
  const show_velocity = () => {
    const first = axes[0];
    if (!first) return;
    const kinds = in_frame() === 'base' || in_frame() === 'tool' ? [axes[0], axes[3]] : [first];
    const texts = kinds.map((axis) =>
      axis
        ? `${fixed(to_shown((axis.velocity * Number(slider.value)) / 100, axis.unit), 1)} ${shown_unit(axis.unit)}/s`
        : '',
    );
    set_text(velocity, `${slider.value} % · ${texts.join(', ')}`);
  };
  const fill = () => {
    jog.release();
    axes = moved_axes(robot, in_frame());
    shown = axes.map((axis) => jog_row(robot.name, axis, actions_of(axis)));
    rows.replaceChildren(...shown.map((row) => row.node));
    show_velocity();
    session.scheduler.ask_now();
  };
  slider.addEventListener('input', show_velocity);
  jog.watch((order) =>
    shown.forEach((row, index) => {
      const mine = order?.robot === robot.name && order.axis === axes[index]?.name;
      row.set_active(mine ? Math.sign(order.velocity) : 0);
    }),
  );
  fill();
  const node = element(
    'section',
    { class: 'jog-pane', 'aria-label': `Jog ${robot.name}` },
    element('h3', {}, 'Jog'),
    element('div', { class: 'choices' }, frame.node, motion.node, element('span', { class: 'quiet' }, 'step: mm or °')),
    element('div', { class: 'slider' }, element('label', { for: slider.id }, 'Velocity'), slider, velocity),
    rows,
  );
  const update = () => {
    const state = session.store.robots.get(robot.name);
    const values = state ? values_in(state, in_frame()) : [];
    const reason = refusal_of('jog', session.store.situation) || unsynchronised(state, in_frame());
    shown.forEach((row, index) => {
      row.show(values[index]);
      row.refuse(reason);
    });
  };
  return { node, update };
}

function unsynchronised(state: RobotState | undefined, frame: JogFrame): string {
  if (!state || state.synchronised || frame === 'motors') return '';
  return 'The robot is not synchronised: only its motors can be jogged.';
}

/**
 * Positions of the rows. In the base frame they are the tool's pose; in its own axes the tool has none, and a robot that
 * is not synchronised has those of its motors only.
 */
function values_in(state: RobotState, frame: JogFrame): Numbers {
  if (frame === 'motors') return state.motors;
  if (!state.synchronised) return [];
  if (frame === 'axes') return state.joints;
  if (frame === 'tool') return [];
  const [x = null, y = null, z = null, qx, qy, qz, qw] = state.pose;
  return [x, y, z, ...roll_pitch_yaw(qx ?? 0, qy ?? 0, qz ?? 0, qw ?? 1)];
}
