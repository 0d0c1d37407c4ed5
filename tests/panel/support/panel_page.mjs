// Chromium without a screen, and the panel's page in it.
import assert from 'node:assert/strict';
import { TIMEOUT } from './live_run.mjs';
import { chromium } from './packages.mjs';

const FLAGS = [
  '--no-sandbox',
  '--disable-gpu',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

const OPTIONS = {
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  headless: true,
  timeout: TIMEOUT,
  args: FLAGS,
  env: { ...process.env, LANG: 'C.UTF-8' },
};

export const launch = () => chromium.launch(OPTIONS);

/** A browser of its own process, which can be killed: `kill()`, `pid`. */
export async function launch_process() {
  const server = await chromium.launchServer(OPTIONS);
  const browser = await chromium.connect(server.wsEndpoint());
  return { browser, pid: server.process().pid, kill: () => server.kill() };
}

/** Opens the panel and waits for the first state of the run. `page.problems`: errors of the page. */
export async function open_panel(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(TIMEOUT);
  page.problems = [];
  page.on('pageerror', (error) => page.problems.push(error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') page.problems.push(message.text());
  });
  await page.goto(url);
  await page.waitForSelector('body[data-ready]');
  await page.waitForFunction(() => document.querySelector('#task').textContent !== 'starting');
  return page;
}

export async function await_shown(page, selector, text) {
  const shown = ([where, what]) => document.querySelector(where)?.textContent.includes(what);
  try {
    await page.waitForFunction(shown, [selector, text]);
  } catch (error) {
    const instead = await page.evaluate((where) => document.querySelector(where)?.textContent, selector);
    throw new Error(`${selector}: '${instead}', expected '${text}'`, { cause: error });
  }
}

export const await_task_shown = (page, task) => await_shown(page, '#task', task);

/** Presses a verb of the header as soon as the page allows it. */
export async function press_verb(page, verb) {
  await page.click(`header [data-verb="${verb}"]:not([aria-disabled])`);
}

/** The newest answer of the run to this page contains `text`. */
export const await_answer = (page, text) => await_shown(page, '#answer', text);

/** The page shows a state of the run at `tick` or later. */
export async function await_tick_shown(page, tick) {
  const later = (wanted) => Number(/\d+/.exec(document.querySelector('#tick').textContent)?.[0] ?? -1) >= wanted;
  await page.waitForFunction(later, tick);
}

/** `allowed`: a pattern of what is no problem in this test. */
export function assert_no_problems(page, allowed = /^$/) {
  assert.deepEqual(
    page.problems.filter((text) => !allowed.test(text)),
    [],
  );
}
