// The pictures of a task's camera in the page: they show what the camera sees, and cost nothing while they are hidden.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { LiveRun, STOPPED, eventually, hash_of, hash_of_repetition } from './support/live_run.mjs';
import { INSPECT, PRESS, axe_source } from './support/packages.mjs';
import {
  assert_no_problems,
  await_shown,
  await_task_shown,
  await_tick_shown,
  launch,
  open_panel,
  press_verb,
} from './support/panel_page.mjs';
import { raw_get } from './support/raw_http.mjs';
import { with_run } from './support/with_run.mjs';

const PICTURES = process.env.PANEL_PICTURES;
const SHOWN = '[data-camera="eye"] img[data-tick]';
const LATE_PICTURE = /\b503\b/; // a busy machine draws a picture too slowly: the page shows that, and the next one

/** The picture that the page shows: its size, the number of its colours, and a sum of its bytes. */
const picture_of = (page) =>
  page.evaluate((selector) => {
    const image = document.querySelector(selector);
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
    const sum = pixels.reduce((hash, pixel) => (Math.imul(hash, 31) + pixel) | 0, 0);
    return { width: canvas.width, height: canvas.height, colours: new Set(pixels).size, sum };
  }, SHOWN);

/** The next picture of a later tick than `tick`; the result is its tick. */
async function next_picture(page, tick = -1) {
  const later = ([selector, last]) => Number(document.querySelector(selector)?.dataset.tick ?? -1) > last;
  await page.waitForFunction(later, [SHOWN, tick]);
  return page.evaluate((selector) => Number(document.querySelector(selector).dataset.tick), SHOWN);
}

/** Counts the page's requests for pictures in the page itself, where they come in order with its clicks. */
async function count_requests(page) {
  await page.evaluate(() => {
    const { fetch } = window;
    window.asked = 0;
    window.fetch = (address, ...options) => {
      if (String(address).includes('pictures/')) ++window.asked;
      return fetch(address, ...options);
    };
  });
  return () => page.evaluate(() => window.asked);
}

/** The page shows a later state of the run, `ticks` from now. */
async function pass_shown_ticks(run, page, ticks) {
  const { tick } = await run.status();
  await await_tick_shown(page, tick + ticks);
}

test('APictureFollowsTheCameraOfTheTask', async () => {
  const run = new LiveRun();
  const [noted, recording] = [run.path('noted.toml'), run.path('live.mcap')];
  const browser = await launch();
  try {
    await run.start(INSPECT, '--hold', '--clock', 'paced', '--note-events', noted, '--record', recording);
    const page = await open_panel(browser, run.url);
    const asked = await count_requests(page);
    await await_task_shown(page, 'held');
    await pass_shown_ticks(run, page, 500);
    assert.equal(await asked(), 0, 'the pane is hidden');
    await page.click('#tab-cameras');
    const first = await next_picture(page);
    const before = await picture_of(page);
    assert.deepEqual([before.width, before.height], [320, 240]);
    assert.ok(before.colours > 50, `${before.colours} colours`);
    assert.equal(await page.getAttribute(SHOWN, 'alt'), 'Picture of the camera eye');
    await await_shown(page, '[data-camera="eye"] figcaption', 'tick');

    await press_verb(page, 'start');
    await run.await_task('running');
    await run.pass_ticks(2000);
    await run.request({ verb: 'pause' }); // the task does not end before the page has been looked at
    const { tick } = await run.status();
    await next_picture(page, Math.max(first, tick));
    const after = await picture_of(page);
    assert.notEqual(after.sum, before.sum, 'the arm has moved its camera');
    assert.ok(after.colours > 50, `${after.colours} colours`);
    await page.evaluate(axe_source());
    const found = await page.evaluate(() => window.axe.run('#cameras'));
    assert.deepEqual(found.violations.map((rule) => rule.id), []);
    if (PICTURES) {
      mkdirSync(PICTURES, { recursive: true });
      await page.screenshot({ path: join(PICTURES, 'camera.png') });
    }

    await page.click('#tab-plots');
    const hidden = await asked();
    assert.ok(hidden > 0);
    await pass_shown_ticks(run, page, 1000);
    assert.equal(await asked(), hidden, 'the pane is hidden again');
    assert_no_problems(page, LATE_PICTURE);
    await press_verb(page, 'stop');
    assert.equal(await run.exit, STOPPED);
    assert.equal(hash_of(recording), hash_of_repetition(run, INSPECT, noted, STOPPED));
  } finally {
    await browser.close();
    await run.clear();
  }
});

test('AWatcherSeesThePicturesAndAForeignerDoesNot', () =>
  with_run(INSPECT, async (run, browser) => {
    const page = await open_panel(browser, run.watch_url);
    await page.click('#tab-cameras');
    await next_picture(page);
    assert.ok((await picture_of(page)).colours > 50);
    assert_no_problems(page, LATE_PICTURE);
    const path = new URL(run.watch_url).pathname;
    const get = async (name) => (await raw_get(run.url, name)).code;
    const code = await eventually(
      () => get(`${path}pictures/eye.png`),
      (seen) => seen !== 503,
      'a picture in time',
    );
    assert.equal(code, 200);
    assert.equal(await get(`${path}pictures/ear.png`), 404);
    assert.equal(await get(`${path}pictures/.png`), 404);
    assert.equal(await get(`${path}pictures/../eye.png`), 404);
    assert.equal(await get('/pictures/eye.png'), 403);
    assert.equal(await get(`${path.replace(/^\/./, (start) => (start === '/0' ? '/1' : '/0'))}pictures/eye.png`), 403);
  }));

test('ADeploymentWithoutCamerasHasNoPane', () =>
  with_run(PRESS, async (run, browser) => {
    const page = await open_panel(browser, run.url);
    assert.equal(await page.locator('#tab-cameras').count(), 0);
    assert_no_problems(page);
  }));
