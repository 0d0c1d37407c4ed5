import assert from 'node:assert/strict';
import { test } from 'node:test';
import { roll_pitch_yaw } from '../../../panel/src/format/rotation';
import { count_text, fixed, from_shown, position_text, time_text, to_shown } from '../../../panel/src/format/units';

test('PositionsAreShownInDegreesAndMillimetres', () => {
  assert.equal(position_text(Math.PI / 2, 'rad'), '90.00 °');
  assert.equal(position_text(-0.0123, 'm'), '−12.3 mm');
  assert.equal(position_text(null, 'm'), '–');
  assert.equal(position_text(undefined, 'rad'), '–');
});

test('AValueThatRoundsToZeroHasNoSign', () => {
  assert.equal(fixed(-0.0001, 2), '0.00');
  assert.equal(fixed(-0.006, 2), '−0.01');
  assert.equal(fixed(Number.NaN, 2), '–');
});

test('UnitsConvertBothWays', () => {
  for (const unit of ['rad', 'm'] as const)
    assert.ok(Math.abs(from_shown(to_shown(0.321, unit), unit) - 0.321) < 1e-12);
  assert.equal(from_shown(10, 'm'), 0.01);
});

test('TimesHaveMinutesAndHours', () => {
  assert.equal(time_text(3.042), '3.04 s');
  assert.equal(time_text(185.2), '3:05.20');
  assert.equal(time_text(3723.4), '1:02:03.4');
});

test('CountsHaveThinSpaces', () => {
  assert.equal(count_text(999), '999');
  assert.equal(count_text(1234567), '1\u202f234\u202f567');
});

test('RollPitchYawOfSingleRotations', () => {
  const half = Math.SQRT1_2;
  const close = (a: number[], b: number[]) => a.forEach((value, i) => assert.ok(Math.abs(value - (b[i] ?? 0)) < 1e-6));
  close(roll_pitch_yaw(0, 0, 0, 1), [0, 0, 0]);
  close(roll_pitch_yaw(half, 0, 0, half), [Math.PI / 2, 0, 0]);
  close(roll_pitch_yaw(0, half, 0, half), [0, Math.PI / 2, 0]);
  close(roll_pitch_yaw(0, 0, half, half), [0, 0, Math.PI / 2]);
});
