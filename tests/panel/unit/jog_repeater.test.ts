import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  JOG_PERIOD,
  JogRepeater,
  LONGEST_GAP,
  LONGEST_SILENCE,
  type JogOrder,
} from '../../../panel/src/jog/jog_repeater';

const ORDER: JogOrder = { robot: 'arm', axis: 'column', velocity: 0.1, in: 'axes' };

/** A page whose time passes only when the test says so. */
class Page {
  time = 1000;
  silence = 0;
  readonly calls: string[] = [];
  private timer: (() => void) | null = null;
  readonly repeater = new JogRepeater({
    now: () => this.time,
    every: (call, period) => {
      assert.equal(period, JOG_PERIOD);
      this.timer = call;
      return () => {
        this.timer = null;
      };
    },
    silence: () => this.silence,
    jog: (order) => this.calls.push(`jog ${order.axis} ${order.velocity}`),
    hold: (robot) => this.calls.push(`hold ${robot}`),
    ended: (reason) => this.calls.push(`ended ${reason}`),
  });

  pass(milliseconds: number): void {
    this.time += milliseconds;
    this.timer?.();
  }
}

test('RepeatsTheJogWhilePressedAndHoldsAtRelease', () => {
  const page = new Page();
  assert.ok(page.repeater.press(ORDER));
  page.pass(JOG_PERIOD);
  page.pass(JOG_PERIOD);
  page.repeater.release();
  page.pass(JOG_PERIOD);
  assert.deepEqual(page.calls, ['jog column 0.1', 'jog column 0.1', 'jog column 0.1', 'hold arm', 'ended ']);
  assert.equal(page.repeater.active, null);
});

test('AGapOfTheTimerEndsTheJogWithoutAnotherOne', () => {
  const page = new Page();
  page.repeater.press(ORDER);
  page.pass(LONGEST_GAP + 1);
  assert.deepEqual(page.calls.slice(0, 2), ['jog column 0.1', 'hold arm']);
  assert.match(page.calls[2] ?? '', /frozen for 201 ms/);
  page.pass(JOG_PERIOD);
  assert.equal(page.calls.length, 3);
});

test('AGapThatIsJustShortEnoughDoesNotEndTheJog', () => {
  const page = new Page();
  page.repeater.press(ORDER);
  page.pass(LONGEST_GAP);
  assert.deepEqual(page.calls, ['jog column 0.1', 'jog column 0.1']);
});

test('ASecondPressBeginsNothingAndEveryReleaseEnds', () => {
  const page = new Page();
  page.repeater.press(ORDER);
  assert.equal(page.repeater.press({ ...ORDER, axis: 'lower_arm' }), false);
  page.repeater.release('Escape');
  page.repeater.release();
  assert.deepEqual(page.calls, ['jog column 0.1', 'hold arm', 'ended Escape']);
});

test('ASilentServerEndsTheJog', () => {
  const page = new Page();
  page.repeater.press(ORDER);
  page.silence = LONGEST_SILENCE;
  page.pass(JOG_PERIOD);
  assert.equal(page.calls.at(-1), 'jog column 0.1');
  page.silence += 1;
  page.pass(JOG_PERIOD);
  assert.equal(page.calls.at(-1), 'ended the panel is silent');
});

test('APressAfterAGapBeginsANewJog', () => {
  const page = new Page();
  page.repeater.press(ORDER);
  page.pass(5000);
  assert.ok(page.repeater.press({ ...ORDER, velocity: -0.1 }));
  page.pass(JOG_PERIOD);
  assert.equal(page.calls.at(-1), 'jog column -0.1');
});
