import assert from 'node:assert/strict';
import { test } from 'node:test';
import { black_box_of, MessageBuffer } from '../../../panel/src/messages/message_buffer';
import { check_number } from '../../../panel/src/questions/question_form';
import { process_advice, robot_advice } from '../../../panel/src/state/advice';
import { refusal_of, type Situation } from '../../../panel/src/state/permissions';
import { Store } from '../../../panel/src/state/store';

const SITUATION: Situation = {
  connected: true,
  ended: false,
  may_command: true,
  client: 'panel 1',
  commander: null,
  task: 'running',
  emergency_stop: false,
};

const QUESTION = {
  from: 'mp',
  number: 1,
  text: '?',
  kind: 'number' as const,
  expected: '0 to 5',
  minimum: 0,
  maximum: 5,
};

test('StopsAreEverybodysAndOtherVerbsTheHolders', () => {
  const watched = { ...SITUATION, commander: 'panel 2' };
  assert.equal(refusal_of('estop', watched), '');
  assert.equal(refusal_of('stop', watched), '');
  assert.match(refusal_of('pause', watched), /panel 2 holds command/);
  assert.equal(refusal_of('pause', { ...SITUATION, commander: 'panel 1' }), '');
});

test('TheLastStepsAreRecordedWithoutCommand', () => {
  assert.equal(refusal_of('record', { ...SITUATION, commander: 'panel 2' }), '');
  assert.match(refusal_of('record', { ...SITUATION, task: 'held' }), /No task has made a step/);
  assert.match(refusal_of('record', { ...SITUATION, may_command: false }), /watching only/);
  assert.equal(black_box_of('record: 90 steps of arm; black box: /home/lab/press_120.mcap'), '/home/lab/press_120.mcap');
});

test('VerbsOfTheTaskDependOnItsState', () => {
  assert.equal(refusal_of('start', { ...SITUATION, task: 'held' }), '');
  assert.match(refusal_of('start', SITUATION), /has started/);
  assert.match(refusal_of('resume', SITUATION), /not paused/);
  assert.equal(refusal_of('resume', { ...SITUATION, task: 'paused' }), '');
  assert.match(refusal_of('trigger', { ...SITUATION, task: 'held' }), /not started/);
  assert.match(refusal_of('jog', { ...SITUATION, task: 'stopping' }), /ends/);
});

test('WatchersAndEndedRunsHaveNoVerbs', () => {
  assert.match(refusal_of('estop', { ...SITUATION, may_command: false }), /watching only/);
  assert.match(refusal_of('stop', { ...SITUATION, ended: true }), /ended/);
  assert.match(refusal_of('stop', { ...SITUATION, connected: false }), /lost/);
});

test('TheAdviceIsTheFirstNecessaryStep', () => {
  const robot = { synchronised: true, enabled: true };
  const error = { code: 113, text: 'the emergency stop is pressed', detail: '' };
  assert.equal(robot_advice({ ...robot, error }, true)?.action, 'reset');
  assert.equal(robot_advice({ ...robot, enabled: false, error }, false)?.action, 'recover');
  assert.equal(robot_advice({ ...robot, error: { ...error, code: 100 } }, false)?.action, 'recover');
  assert.equal(robot_advice({ ...robot, synchronised: false }, false)?.action, 'synchronise');
  assert.equal(robot_advice({ ...robot, enabled: false }, false)?.action, 'recover');
  assert.equal(robot_advice(robot, false), null);
  assert.match(process_advice({ ...error, code: 200 }).text, /again/);
});

test('TheStoreKeepsTheTickOfTheFirstReportOfAnError', () => {
  const store = new Store();
  const reading = { event: 'reading' as const, name: 'gate', values: {} };
  const error = { code: 12, text: 'the sensor has no reading yet', detail: '' };
  store.apply({ ...reading, tick: 10, error });
  store.apply({ ...reading, tick: 20, error });
  assert.equal(store.error_ticks.get('gate'), 10);
  store.apply({ ...reading, tick: 30 });
  assert.equal(store.error_ticks.get('gate'), undefined);
});

test('TheEndOfTheRunDisablesEverything', () => {
  const store = new Store();
  store.apply({ event: 'end', exit_code: 3, reason: 'the drive has failed' });
  store.apply({ event: 'gone', text: 'the run has ended' });
  assert.equal(store.task, 'ended');
  assert.match(store.end_text, /exit code 3: the drive has failed/);
});

test('WhatIsReadAfterTheEndOfTheRunChangesNothing', () => {
  const store = new Store();
  store.apply({ event: 'end', exit_code: 5, reason: '' });
  store.apply_status({
    deployment: 'press',
    clock: 'paced',
    servo_period: 0.002,
    tick: 7,
    task: 'stopping',
    emergency_stop: false,
    commander: null,
    processes: [],
    questions: [QUESTION],
  });
  store.apply({ event: 'command', command: 'pause', tick: 8, by: 'panel 1', task: 'paused' });
  store.apply({ event: 'question', ...QUESTION });
  assert.equal(store.task, 'ended');
  assert.deepEqual(store.questions, []);
});

test('MessagesAreFilteredByEveryWordAndBounded', () => {
  const buffer = new MessageBuffer(100);
  for (let i = 0; i < 1000; ++i) buffer.add(i, 'message', `line ${i} of ${i % 2 === 0 ? 'arm' : 'belt'}`);
  assert.equal(buffer.newest('', 1e6).length, 100);
  assert.deepEqual(
    buffer.newest('ARM 998', 10).map((message) => message.tick),
    [998],
  );
  assert.equal(buffer.newest('arm', 3).at(-1)?.tick, 998);
  assert.equal(buffer.last, 999);
});

test('TheFileOfABlackBoxIsFound', () => {
  assert.equal(black_box_of('[tick 3]; black box: mrroc-black-box/swing-arm.mcap'), 'mrroc-black-box/swing-arm.mcap');
  assert.equal(black_box_of('the black box is not written'), '');
});

test('TypedNumbersAreCheckedAgainstTheRange', () => {
  assert.deepEqual(check_number(QUESTION, ' 2.5 '), { value: 2.5 });
  assert.deepEqual(check_number(QUESTION, '2,5'), { value: 2.5 });
  assert.ok('problem' in check_number(QUESTION, '7'));
  assert.ok('problem' in check_number(QUESTION, '-1'));
  assert.ok('problem' in check_number(QUESTION, 'two'));
  assert.ok('problem' in check_number(QUESTION, ''));
  assert.deepEqual(check_number({ ...QUESTION, minimum: null, maximum: null }, '1e6'), { value: 1e6 });
});
