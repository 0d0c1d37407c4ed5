// Whatever separates the operator from the robot ends a jog: at the latest 0.2 s after the last one, the arm brakes.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { hash_of, hash_of_repetition, LiveRun, STOPPED } from './support/live_run.mjs';
import { column_speeds, ticks_of } from './support/motion.mjs';
import { PRESS } from './support/packages.mjs';
import { assert_no_problems, await_shown, launch, launch_process, open_panel } from './support/panel_page.mjs';
import { renderers_of } from './support/processes.mjs';

const VALIDITY = 100; // ticks, 0.2 s
const BRAKING = 200; // ticks from 0.3 rad/s with the axis' acceleration and jerk, and some more
const MOVING = 0.05; // rad/s
const AT_REST = 0.01; // rad/s
const LASTS = 250; // ticks: the page has then repeated the jog
const STOP = 800; // ticks for which a process is stopped
const LAST_WORDS = 300; // ticks: what a page has sent before the end arrives within them, on a busy machine, too

const run = new LiveRun();
const [noted, recording, motion] = ['noted.toml', 'live.mcap', 'motion'].map((name) => run.path(name));
const series = []; // of jogs: how each ended, and its ticks
let direction = '-';

before(() =>
  run.start(PRESS, '--hold', '--clock', 'paced', '--note-events', noted, '--record', recording, '--motion', motion),
);
after(() => run.clear());

/** Small, so that the picture costs little. */
const open = (browser, url = run.url) => open_panel(browser, url, { viewport: { width: 1024, height: 700 } });

/** Presses and holds the column's button; the velocity is 0.3 rad/s. */
async function begin_jog(page) {
  await page.fill('input[data-velocity="arm"]', '75');
  for (let attempt = 0; attempt < 60; ++attempt) {
    direction = direction === '+' ? '-' : '+'; // the column stays in its range
    const button = page.locator(`[data-verb="jog"][data-axis="column"][data-sign="${direction}"]`);
    await button.scrollIntoViewIfNeeded();
    const box = await button.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    const from = (await run.status()).tick;
    await page.mouse.down();
    await run.pass_ticks(LASTS);
    const shown = (await page.locator('.jog.active').count()) > 0;
    if (shown && ticks_of('jog', noted).at(-1) > from + LASTS - VALIDITY) return from;
    await page.mouse.up(); // a busy machine has kept the page from its timer: that ends a jog, too
    console.log(`jog ended early: ${await page.textContent('#answer')}`);
    await run.pass_ticks(400);
  }
  throw new Error('no jog lasts');
}

/**
 * Jogs, calls `end`, and waits for a second of the run. The last jog comes at least `silent` ticks before the end of
 * `end`. `held`: the page itself ends the jog with `hold`.
 */
async function jog_until(name, page, end, { silent = -LAST_WORDS, held = false } = {}) {
  const from = await begin_jog(page);
  await end();
  const to = (await run.status()).tick;
  await run.pass_ticks(600);
  series.push({ name, from, to, silent, held });
}

/** Stops the processes for a while. */
async function stop_for_a_while(pids) {
  for (const pid of pids) process.kill(pid, 'SIGSTOP');
  await run.pass_ticks(STOP);
  for (const pid of pids) process.kill(pid, 'SIGCONT');
}

test('ReleaseEndsTheJog', async () => {
  const browser = await launch();
  const page = await open(browser);
  await jog_until('release', page, () => page.mouse.up(), { held: true });
  assert_no_problems(page);
  await jog_until('Escape', page, () => page.keyboard.press('Escape'), { held: true });
  await page.mouse.up();
  const blur = () => page.evaluate(() => void window.dispatchEvent(new Event('blur')));
  await jog_until('window without focus', page, blur, { held: true });
  await page.mouse.up();
  await browser.close();
});

test('AFrozenPageEndsTheJogAndDoesNotBeginAnotherOne', async () => {
  const { browser, pid, kill } = await launch_process();
  const page = await open(browser);
  await jog_until('busy page', page, () =>
    page.evaluate(() => {
      const begin = performance.now();
      while (performance.now() - begin < 1500);
    }),
  );
  await await_shown(page, '#answer', 'jog ended');
  await page.mouse.up();
  const renderers = renderers_of(pid);
  assert.ok(renderers.length > 0);
  await jog_until('stopped renderer', page, () => stop_for_a_while(renderers), { silent: STOP - LAST_WORDS });
  await await_shown(page, '#answer', 'jog ended');
  await page.mouse.up();
  await browser.close();
  await kill();
});

test('ClosingTheTabEndsTheJog', async () => {
  const browser = await launch();
  const page = await open(browser);
  await jog_until('closed tab', page, () => page.close());
  await browser.close();
});

test('KillingTheBrowserEndsTheJog', async () => {
  const { browser, kill } = await launch_process();
  const page = await open(browser);
  await jog_until('killed browser', page, kill);
});

test('AStoppedServerEndsTheJogAndQueuedRequestsMoveNothing', async () => {
  const browser = await launch();
  const page = await open(browser);
  const stop = () => stop_for_a_while([run.panel_pid()]);
  await jog_until('stopped server', page, stop, { silent: STOP - LAST_WORDS });
  await page.mouse.up();
  await browser.close();
});

test('AKilledServerEndsTheJog', async () => {
  const browser = await launch();
  const page = await open(browser);
  await jog_until('killed server', page, () => process.kill(run.panel_pid(), 'SIGKILL'));
  await await_shown(page, '#gone', 'lost');
  assert.match(await page.getAttribute('[data-axis="column"][data-sign="+"]', 'title'), /lost/);
  await browser.close();
});

test('EverySeriesOfJogsEndsAtRestInTime', async () => {
  run.command('stop');
  assert.equal(await run.exit, STOPPED);
  const speeds = column_speeds(motion);
  const [jogs, holds] = ['jog', 'hold'].map((command) => ticks_of(command, noted));
  for (const { name, from, to, silent, held } of series) {
    const [mine, hold] = [jogs, holds].map((ticks) => ticks.filter((tick) => tick >= from && tick < to + 600));
    assert.ok(mine.length > 0, `${name}: no jogs`);
    const last = mine.at(-1);
    assert.ok(last <= to - silent, `${name}: a jog at tick ${last}, the series ended at ${to}`);
    if (held) assert.ok(last <= hold[0], `${name}: the page holds at the ticks ${hold}, and jogs at ${last}`);
    // on a busy machine there are few jogs, and one may come so late that the arm has braked and begins once more
    let fastest = 0;
    for (let tick = mine[0]; tick < last + VALIDITY; ++tick) fastest = Math.max(fastest, speeds.get(tick) ?? 0);
    assert.ok(fastest > MOVING, `${name}: the column does not move with the jogs at the ticks ${mine}`);
    for (let tick = last + VALIDITY + BRAKING; tick < Math.min(last, to) + 600; ++tick)
      assert.ok(
        (speeds.get(tick) ?? 0) < AT_REST,
        `${name}: ${speeds.get(tick)} rad/s ${tick - last} ticks after the last jog`,
      );
    const after = [...Array(Math.min(last, to) + 600 - last).keys()];
    const rest = after.filter((i) => (speeds.get(last + i) ?? 0) >= AT_REST).at(-1) + 1;
    console.log(`${name}: ${mine.length} jogs, at rest ${rest} ticks after the last one`);
  }
  assert.equal(hash_of(recording), hash_of_repetition(run, PRESS, noted, STOPPED));
});
