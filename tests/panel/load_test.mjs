// Ten browsers, a flood of messages and a browser that never reads: the run is the same, and the server stays small.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { test } from 'node:test';
import { LiveRun, sleep, trace_hash } from './support/live_run.mjs';
import { PRESS } from './support/packages.mjs';
import { RawBrowser, socket_url } from './support/raw_browser.mjs';

const START = 60_000; // tick at which the task starts: the browsers have joined
const LARGEST = 200e3; // kB of memory of mrroc_panel
const PASS = 200; // messages between two looks at the run

/** A run in lockstep that starts its task at a tick, so that two runs can be compared. */
async function start_run(run, ...options) {
  const events = run.path('start.toml');
  writeFileSync(events, `[[events]]\ntick = ${START}\ncommand = "start"\n`);
  await run.start(PRESS, '--hold', '--clock', 'lockstep', '--events', events, '--trace', run.path('trace'), ...options);
}

function memory_of(pid) {
  return Number(/VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))?.[1] ?? 0);
}

/** Opens a socket by hand and then reads nothing: its buffers fill. */
function open_deaf(url) {
  const { hostname, port, pathname, host, origin } = new URL(socket_url(url));
  const socket = connect(Number(port), hostname);
  socket.on('error', () => undefined);
  socket.pause();
  socket.write(
    [
      `GET ${pathname} HTTP/1.1`,
      `Host: ${host}`,
      `Origin: ${origin.replace('ws', 'http')}`,
      'Upgrade: websocket',
      'Connection: Upgrade',
      'Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==',
      'Sec-WebSocket-Version: 13',
      '',
      '',
    ].join('\r\n'),
  );
  return socket;
}

/** Sends messages as fast as the server takes them until the run ends; the result is their number. */
async function flood(run, url) {
  let sent = 0;
  let browser = await RawBrowser.open(url);
  const junk = [
    '{"verb":"frobnicate"}',
    'no JSON',
    '{"verb":"status"}',
    '{"verb":"jog","beat":0}',
    `"${'x'.repeat(3000)}"`,
  ];
  while (run.process.exitCode === null) {
    if (browser.closed) {
      browser = await RawBrowser.open(url).catch(() => null);
      if (!browser) break;
    }
    if (browser.socket.bufferedAmount < 1e6)
      for (let i = 0; i < PASS; ++i, ++sent) browser.send(junk[sent % junk.length]);
    await sleep(0);
  }
  browser?.close();
  return sent;
}

test('BrowsersAndFloodsChangeNothing', async () => {
  const [plain, loaded] = [new LiveRun(), new LiveRun()];
  try {
    await start_run(plain);
    assert.equal(await plain.exit, 0);

    await start_run(loaded);
    const pid = loaded.panel_pid();
    const deaf = open_deaf(loaded.url);
    const browsers = await Promise.all(
      Array.from({ length: 10 }, (_, i) => RawBrowser.open(i % 2 === 0 ? loaded.url : loaded.watch_url)),
    );
    let largest = 0;
    const watch = setInterval(() => {
      try {
        largest = Math.max(largest, memory_of(pid));
      } catch {
        clearInterval(watch); // the panel has ended with the run
      }
    }, 50);
    const sent = await flood(loaded, loaded.url);
    assert.equal(await loaded.exit, 0);
    clearInterval(watch);
    deaf.destroy();
    console.log(`${sent} messages, ${largest} kB of memory`);
    assert.ok(sent > 1000);
    assert.ok(largest > 0 && largest < LARGEST, `${largest} kB`);
    for (const browser of browsers)
      assert.ok(browser.frames.some((frame) => frame.event === 'hello' || frame.event === 'robot'));
    assert.equal(trace_hash(loaded.path('trace')), trace_hash(plain.path('trace')));
  } finally {
    await plain.clear();
    await loaded.clear();
  }
});

test('ARunUnderTheRealLoadMissesNoTick', async () => {
  const run = new LiveRun();
  try {
    await run.start(PRESS, '--hold', '--clock', 'paced');
    const missed = async () =>
      (await run.status()).processes.reduce((sum, process) => sum + process.missed_ticks + process.late_commands, 0);
    await run.await_task('held');
    const before = await missed();
    const browsers = await Promise.all(Array.from({ length: 10 }, () => RawBrowser.open(run.url)));
    const end = Date.now() + 5000;
    for (let i = 0; Date.now() < end; ++i) {
      for (const browser of browsers)
        if (browser.socket.bufferedAmount < 1e5) browser.send(`{"verb":"frobnicate","id":${i}}`);
      if (i % 50 === 0) await sleep(1);
    }
    await run.pass_ticks(500);
    assert.equal(await missed(), before);
    for (const browser of browsers) browser.close();
  } finally {
    await run.clear();
  }
});
