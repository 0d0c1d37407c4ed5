// Several browsers: one commands, the others watch; questions; the emergency stop by button and space bar.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PRESS, QUESTIONS, TRANSFER } from './support/packages.mjs';
import {
  assert_no_problems,
  await_answer,
  await_shown,
  await_task_shown,
  open_panel,
  press_verb,
} from './support/panel_page.mjs';
import { with_run } from './support/with_run.mjs';

test('OneOfThreeBrowsersCommandsATwoArmTask', () =>
  with_run(TRANSFER, async (run, browser) => {
    await run.await_task('held');
    await run.slow_down();
    const [holder, second] = [await open_panel(browser, run.url), await open_panel(browser, run.url)];
    const watcher = await open_panel(browser, run.watch_url);
    await holder.click('#take');
    await await_shown(holder, '#holder', 'this browser');
    const { commander } = await run.status();
    assert.match(commander, /mrroc_panel/);
    for (const page of [second, watcher]) await page.waitForSelector(`#holder[title="${commander}"]`);

    await second.waitForSelector('header [data-verb="start"][aria-disabled]');
    assert.match(await second.getAttribute('header [data-verb="start"]', 'title'), /holds command/);
    await second.click('header [data-verb="start"]', { force: true });
    await await_answer(second, 'holds command');
    assert.equal((await run.status()).task, 'held');
    await second.click('#take');
    await await_answer(second, `${commander} holds command`);
    await await_shown(holder, '#wanted', 'asks for command');
    await holder.click('#wanted >> text=Keep');

    for (const verb of ['start', 'stop', 'estop'])
      assert.match(await watcher.getAttribute(`header [data-verb="${verb}"]`, 'title'), /watching only/);
    await watcher.keyboard.press('Space');
    await await_answer(watcher, 'may watch only');
    assert.equal((await run.status()).emergency_stop, false);

    await press_verb(holder, 'start');
    for (const page of [holder, second, watcher]) await await_task_shown(page, 'running');
    await holder.click('#release');
    await await_shown(second, '#holder', 'free');
    await press_verb(second, 'pause');
    await await_task_shown(holder, 'paused');
    for (const page of [holder, second, watcher]) assert_no_problems(page);
  }));

test('QuestionsAreAnsweredInTheirDialog', () =>
  with_run(QUESTIONS, async (run, browser) => {
    const page = await open_panel(browser, run.url);
    await press_verb(page, 'start');
    await await_shown(page, '#question', 'How many parts');
    await page.fill('#answer-number', '100');
    await page.press('#answer-number', 'Enter');
    await await_shown(page, '#answer-problem', 'above 10');
    await page.keyboard.press('Escape');
    await await_shown(page, '#question-bar', 'How many parts');
    await page.click('#question-bar button');
    await page.fill('#answer-number', '1');
    await page.press('#answer-number', 'Enter');
    await await_shown(page, '#question', 'weigh');
    await page.fill('#answer-number', '2.5');
    await page.click('[data-answer="number"]');
    await await_answer(page, 'the answer is given');
    await page.waitForSelector('#question', { state: 'hidden' });
    assert_no_problems(page);
  }, '# a person answers\n'));

test('EmergencyStopByButtonAndSpaceBarIsResetAndRecovered', () =>
  with_run(PRESS, async (run, browser) => {
    const page = await open_panel(browser, run.url);
    for (const stop of [
      () => page.click('header [data-verb="estop"]'),
      () => page.press('[data-verb="hold"]', 'Space'),
    ]) {
      await stop();
      await page.waitForSelector('#emergency:not([hidden])');
      await await_shown(page, '[data-fault="arm"]', 'Reset');
      assert.equal((await run.status()).emergency_stop, true);
      await press_verb(page, 'reset');
      await await_shown(page, '[data-fault="arm"] .advice', 'Recover');
      assert.equal((await run.status()).emergency_stop, false);
      await page.click('[data-fault="arm"] [data-verb="recover"]');
      await await_answer(page, 'the drives are on');
      await page.waitForSelector('#faults', { state: 'hidden' });
    }
    await page.click('#tab-messages');
    await page.fill('#filter', 'space bar');
    await page.press('#filter', 'Space');
    assert.equal((await run.status()).emergency_stop, false); // in a field for text, space is a character
    assert_no_problems(page);
  }));
