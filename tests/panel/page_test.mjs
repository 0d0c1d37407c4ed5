// The page for everyone: no serious violation of the rules for accessible pages, keyboard only, and its pictures.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { axe_source, POLISH, PRESS, TRANSFER } from './support/packages.mjs';
import {
  assert_no_problems,
  await_answer,
  await_shown,
  await_task_shown,
  open_panel,
  press_verb,
} from './support/panel_page.mjs';
import { with_run } from './support/with_run.mjs';

const LAPTOP = { width: 1440, height: 900 };
const TABLET = { width: 1024, height: 768 };
const PICTURES = process.env.PANEL_PICTURES;
const SMALLEST_TARGET = 44; // pixels, on a tablet

/** Serious and critical violations, as "rule: element". */
async function violations_of(page, part = 'body') {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(axe_source());
  const found = await page.evaluate((selector) => window.axe.run(selector), part);
  return found.violations
    .filter((rule) => ['serious', 'critical'].includes(rule.impact))
    .flatMap((rule) => rule.nodes.map((node) => `${rule.id}: ${node.html.slice(0, 120)}`));
}

/** Buttons, fields and the like whose target is smaller than a finger. */
const small_targets = (page) =>
  page.evaluate(
    (smallest) =>
      [...document.querySelectorAll('button, select, input, .choice label')]
        .filter((control) => control.checkVisibility() && !control.closest('.choice label'))
        .map((control) => [control.outerHTML.slice(0, 100), control.getBoundingClientRect()])
        .filter(([, box]) => box.height < smallest - 0.5 || (box.width < smallest - 0.5 && box.width > 0))
        .map(([html, box]) => `${Math.round(box.width)} x ${Math.round(box.height)}: ${html}`),
    SMALLEST_TARGET,
  );

test('NoSeriousViolationInAnyThemeSizeAndTab', () =>
  with_run(PRESS, async (run, browser) => {
    for (const viewport of [LAPTOP, TABLET]) {
      for (const colorScheme of ['light', 'dark']) {
        const page = await open_panel(browser, run.url, { viewport, colorScheme });
        for (const tab of ['plots', 'processes', 'messages']) {
          await page.click(`#tab-${tab}`);
          const part = tab === 'plots' ? 'body' : '#details'; // the rest of the page is the same
          assert.deepEqual(await violations_of(page, part), [], `${colorScheme} ${viewport.width} ${tab}`);
        }
        if (viewport === TABLET) assert.deepEqual(await small_targets(page), []);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(overflow <= 0, `${viewport.width}: ${overflow} pixels too wide`);
        assert_no_problems(page);
        await page.context().close();
      }
    }
    const page = await open_panel(browser, run.url);
    await page.keyboard.press('Space');
    await await_shown(page, '[data-fault="arm"]', 'Reset');
    assert.deepEqual(await violations_of(page), [], 'with an error');
  }));

/** Holds Enter on the column's button until the column moves: a page that is kept from its timer ends its jog. */
async function jog_by_key(run, page) {
  const value = '[data-value="column"]';
  await page.waitForFunction((selector) => /\d/.test(document.querySelector(selector).textContent), value);
  await page.focus('[data-axis="column"][data-sign="+"]');
  for (let attempt = 0; attempt < 50; ++attempt) {
    const before = await page.textContent(value);
    await page.keyboard.down('Enter');
    const moved_or_ended = ([selector, text]) =>
      document.querySelector(selector).textContent !== text || !document.querySelector('.jog.active');
    await page.waitForFunction(moved_or_ended, [value, before]);
    const after = await page.textContent(value);
    await page.keyboard.up('Enter');
    if (after !== before) return;
    console.log(`jog ended early: ${await page.textContent('#answer')}`);
    await run.pass_ticks(100);
  }
  throw new Error('no jog moves the column');
}

test('TheKeyboardReachesEverything', () =>
  with_run(PRESS, async (run, browser) => {
    const page = await open_panel(browser, run.url);
    await page.keyboard.press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.className), 'skip');
    const reached = new Set();
    for (let i = 0; i < 150; ++i) {
      await page.keyboard.press('Tab');
      const key = await page.evaluate(() => {
        const { dataset, id } = document.activeElement;
        return dataset.verb ? `${dataset.verb} ${dataset.sign ?? ''}`.trim() : (dataset.choice ?? dataset.layer ?? id);
      });
      if (key === '' && reached.has('theme')) break; // beyond the end of the page
      reached.add(key);
    }
    for (const wanted of [
      'start',
      'pause',
      'resume',
      'trigger',
      'stop',
      'estop',
      'reset',
      'take',
      'command',
      'hold',
      'recover',
      'synchronise',
      'frame',
      'motion',
      'jog +',
      'jog -',
      'go',
      'output',
      'canvas',
      'ghost',
      'tab-plots',
      'theme',
    ])
      assert.ok(reached.has(wanted) || (wanted === 'take' && reached.has('command')), `${wanted} of ${[...reached]}`);

    await jog_by_key(run, page);
    await run.pass_ticks(600); // the column is at rest: a step is refused during a motion
    await page.check('[data-choice="motion"][value="1"]');
    await page.focus('[data-axis="column"][data-sign="+"]');
    await page.keyboard.press('ArrowLeft');
    await await_answer(page, 'the robot has arrived');
    await page.focus('#tab-plots');
    await page.keyboard.press('ArrowRight');
    await page.waitForSelector('#processes:not([hidden])');
    assert_no_problems(page);
  }));

test('ThePageIsReadySoon', () =>
  with_run(PRESS, async (run, browser) => {
    const begin = Date.now();
    const page = await open_panel(browser, run.url);
    await page.waitForSelector('#canvas[data-tick]');
    console.log(`ready after ${Date.now() - begin} ms, first poses drawn`);
  }));

/** Pictures for the pages: the task in motion, with its tool trail. */
const SHOWN = [
  { name: 'press', file: PRESS, ticks: 2000, colorScheme: 'light', plots: ['arm/joints', 'wrist'] },
  {
    name: 'cooperative_transfer',
    file: TRANSFER,
    ticks: 8000,
    colorScheme: 'dark',
    plots: ['left/joints', 'left/error'],
  },
  { name: 'polish', file: POLISH, ticks: 6000, colorScheme: 'light', plots: ['arm/velocity', 'arm/wrench'] },
];

for (const { name, file, ticks, colorScheme, plots } of PICTURES ? SHOWN : []) {
  test(`PictureOf_${name}`, () =>
    with_run(file, async (run, browser) => {
      const page = await open_panel(browser, run.url, { viewport: LAPTOP, colorScheme });
      const selects = page.locator('[data-plot-quantity]');
      for (const [i, key] of plots.entries())
        if ((await selects.nth(i).locator(`option[value="${key}"]`).count()) > 0)
          await selects.nth(i).selectOption(key);
      await press_verb(page, 'start');
      await run.await_task('running');
      await run.pass_ticks(ticks);
      await run.request({ verb: 'pause' }); // not by the page: the picture does not depend on the machine's speed
      await await_task_shown(page, 'paused');
      const { tick } = await run.status();
      const drawn = (last) => Number(document.querySelector('#canvas').dataset.tick) > last;
      await page.waitForFunction(drawn, tick + 200);
      mkdirSync(PICTURES, { recursive: true });
      await page.screenshot({ path: join(PICTURES, `${name}.png`) });
      assert_no_problems(page);
    }));
}
