import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Ring } from '../../../panel/src/plots/ring';
import { PlotWindow } from '../../../panel/src/plots/window';

test('TheOldestSamplesAreOverwritten', () => {
  const ring = new Ring(2, 4);
  for (let i = 1; i <= 10; ++i) ring.push(i, [i, 10 * i]);
  assert.equal(ring.length, 4);
  assert.equal(ring.last, 10);
  assert.deepEqual(ring.window(0, 100, [0, 1], 100), {
    times: [7, 8, 9, 10],
    values: [
      [7, 8, 9, 10],
      [70, 80, 90, 100],
    ],
  });
});

test('AWindowContainsItsEnds', () => {
  const ring = new Ring(1, 10);
  for (let i = 0; i < 8; ++i) ring.push(i, [i]);
  assert.deepEqual(ring.window(2, 5, [0], 100).times, [2, 3, 4, 5]);
  assert.deepEqual(ring.window(20, 30, [0], 100).times, []);
});

test('SamplesThatAreNotNewerAreLeftOut', () => {
  const ring = new Ring(1, 10);
  ring.push(1, [1]);
  ring.push(1, [2]);
  ring.push(0.5, [3]);
  assert.deepEqual(ring.window(0, 9, [0], 10), { times: [1], values: [[1]] });
});

test('MissingValuesAreGaps', () => {
  const ring = new Ring(2, 10);
  ring.push(1, [null]);
  ring.push(2, [5, 6]);
  assert.deepEqual(ring.window(0, 9, [0, 1], 10).values, [
    [null, 5],
    [null, 6],
  ]);
});

test('ManySamplesAreThinned', () => {
  const ring = new Ring(1, 1000);
  for (let i = 0; i < 1000; ++i) ring.push(i, [i]);
  const { times } = ring.window(0, 999, [0], 100);
  assert.ok(times.length <= 100 && times.length > 50);
});

test('APausedWindowStaysWhileTheRunContinues', () => {
  const window = new PlotWindow(20);
  assert.deepEqual(window.interval(50), [30, 50]);
  window.pause(50);
  assert.deepEqual(window.interval(80), [30, 50]);
  window.zoom(0.5, 80);
  assert.deepEqual(window.interval(90), [35, 45]);
  window.move(0.5, 90);
  assert.deepEqual(window.interval(90), [40, 50]);
  window.follow();
  assert.deepEqual(window.interval(90), [70, 90]);
});
