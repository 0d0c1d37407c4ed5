// A task is started, paused, resumed and stopped by the page's controls, and is then the same run in lockstep.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hash_of, hash_of_repetition, LiveRun, STOPPED } from './support/live_run.mjs';
import { PRESS } from './support/packages.mjs';
import {
  assert_no_problems,
  await_answer,
  await_shown,
  await_task_shown,
  launch,
  open_panel,
  press_verb,
} from './support/panel_page.mjs';

test('TaskIsStartedPausedResumedAndStoppedByThePage', async () => {
  const run = new LiveRun();
  const [noted, recording] = [run.path('noted.toml'), run.path('live.mcap')];
  const browser = await launch();
  try {
    const outputs = ['--note-events', noted, '--record', recording, '--black-box=boxes'];
    await run.start(PRESS, '--hold', '--clock', 'paced', ...outputs);
    const page = await open_panel(browser, run.url);
    await await_task_shown(page, 'held');
    assert.equal(await page.getAttribute('header [data-verb="pause"]', 'title'), 'The task has not started.');

    await run.slow_down();
    await press_verb(page, 'start');
    await await_task_shown(page, 'running');
    await page.click('#tab-processes');
    await await_shown(page, '[data-process="arm"] [data-column="instruction"]', 'JointLine');
    await press_verb(page, 'pause');
    await await_task_shown(page, 'paused');
    assert.equal(run.status_by_command().task, 'paused');
    await page.click('#tab-messages');
    await page.click('[data-verb="record"]:not([aria-disabled])');
    await await_answer(page, `black box: ${run.folder}/press_`);
    const [, recorded] = /black box: (\S+\.mcap)/.exec(await page.textContent('#answer'));
    await await_shown(page, '#messages .hint', recorded);
    assert.match(run.command('trace', 'check', recorded).text, /rules hold/);
    await press_verb(page, 'resume');
    await await_answer(page, 'the task continues');
    await await_task_shown(page, 'running');
    assert.equal(run.status_by_command().task, 'running');
    await press_verb(page, 'stop');
    assert.equal(await run.exit, STOPPED);
    await await_task_shown(page, 'ended');
    await await_shown(page, '#gone', 'exit code 5');
    await page.waitForFunction(() =>
      [...document.querySelectorAll('button[data-verb]:not([aria-disabled])')].every(
        (button) => !button.checkVisibility(),
      ),
    );
    assert_no_problems(page);

    assert.equal(hash_of(recording), hash_of_repetition(run, PRESS, noted, STOPPED));
  } finally {
    await browser.close();
    await run.clear();
  }
});
