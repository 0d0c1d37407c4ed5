import assert from 'node:assert/strict';
import { test } from 'node:test';
import { jog_velocity, moved_axes, TOOL_VELOCITY } from '../../../panel/src/jog/jog_velocity';
import type { Robot } from '../../../panel/src/protocol/scene_file';

const ROBOT: Robot = {
  name: 'arm',
  type: 'irb6',
  hardware: 'mujoco',
  motors: ['one', 'two'],
  postures: [],
  bodies: [],
  force_sensor: false,
  tool_frame: null,
  digital_outputs: 0,
  analogue_outputs: 0,
  axes: [{ name: 'column', unit: 'rad', minimum: -1, maximum: 1, velocity: 0.4 }],
};

test('TheVelocityIsAPartOfTheLimitWithTheSignOfTheButton', () => {
  const [column] = moved_axes(ROBOT, 'axes');
  assert.ok(column);
  assert.equal(jog_velocity(column, 50, -1), -0.2);
  assert.equal(jog_velocity(column, 200, 1), 0.4);
  assert.equal(jog_velocity(column, -5, 1), 0);
});

test('TheToolHasThreeTranslationsAndThreeRotations', () => {
  const axes = moved_axes(ROBOT, 'tool');
  assert.deepEqual(
    axes.map((axis) => axis.name),
    ['x', 'y', 'z', 'rx', 'ry', 'rz'],
  );
  assert.deepEqual(
    axes.map((axis) => axis.unit),
    ['m', 'm', 'm', 'rad', 'rad', 'rad'],
  );
  assert.equal(axes[0]?.velocity, TOOL_VELOCITY);
});

test('MotorsHaveNoLimitsOfPosition', () => {
  const motors = moved_axes(ROBOT, 'motors');
  assert.deepEqual(
    motors.map((motor) => motor.name),
    ['one', 'two'],
  );
  assert.equal(motors[0]?.minimum, undefined);
});
