import { writeFileSync } from 'node:fs';
import { LiveRun } from './live_run.mjs';
import { launch } from './panel_page.mjs';

/**
 * Starts a run that waits for its start and a browser, calls `use(run, browser)`, and ends both. `events`: the text of
 * a file of events instead of the deployment's own.
 */
export async function with_run(file, use, events) {
  const run = new LiveRun();
  const browser = await launch();
  try {
    const options = ['--hold', '--clock', 'paced'];
    if (events !== undefined) {
      writeFileSync(run.path('events.toml'), events);
      options.push('--events', run.path('events.toml'));
    }
    await run.start(file, ...options);
    await use(run, browser);
  } catch (error) {
    console.log(run.text());
    throw error;
  } finally {
    await browser.close();
    await run.clear();
  }
}
