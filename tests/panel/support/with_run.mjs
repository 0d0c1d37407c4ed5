import { LiveRun } from './live_run.mjs';
import { launch } from './panel_page.mjs';

/** Starts a run that waits for its start and a browser, calls `use(run, browser)`, and ends both. */
export async function with_run(file, use) {
  const run = new LiveRun();
  const browser = await launch();
  try {
    await run.start(file, '--hold', '--clock', 'paced');
    await use(run, browser);
  } catch (error) {
    console.log(run.text());
    throw error;
  } finally {
    await browser.close();
    await run.clear();
  }
}
