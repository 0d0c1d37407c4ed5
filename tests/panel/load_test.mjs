// Ten browsers, a flood of messages and a browser that never reads: the run is the same, and the server stays small.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { connect } from 'node:net';
import { test } from 'node:test';
import { hash_of, hash_of_repetition, LiveRun, sleep } from './support/live_run.mjs';
import { PRESS } from './support/packages.mjs';
import { RawBrowser, socket_url } from './support/raw_browser.mjs';

const MESSAGES = 1_000_000;
const MOST = 150e3; // kB by which the memory of mrroc_panel grows; a sanitizer has much from the beginning
const PASS = 200; // messages that a browser sends at once
const JUNK = [
  '{"verb":"frobnicate"}',
  'no JSON',
  '{"verb":"status"}',
  '{"verb":"jog","beat":0}',
  `"${'x'.repeat(300)}"`,
];

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

/** A browser that sends messages as fast as the server takes them, and comes again when it is disconnected. */
class Flood {
  sent = 0;
  connections = 1;
  #ended = false;

  constructor(url) {
    this.url = url;
    this.done = this.#send();
  }

  end() {
    this.#ended = true;
    return this.done;
  }

  async #send() {
    let browser = await RawBrowser.open(this.url);
    while (!this.#ended) {
      if (browser.closed) {
        const next = await RawBrowser.open(this.url).catch(() => null);
        if (!next) {
          await sleep(20); // the run has ended, or a busy server has not yet let the last connections go
          continue;
        }
        browser = next;
        ++this.connections;
      }
      if (browser.socket.bufferedAmount < PASS * 1000)
        for (let i = 0; i < PASS; ++i, ++this.sent) browser.send(JUNK[this.sent % JUNK.length]);
      await sleep(0);
    }
    browser.close();
  }
}

test('BrowsersAndAMillionMessagesChangeNothing', async () => {
  const run = new LiveRun();
  const [noted, recording] = [run.path('noted.toml'), run.path('live.mcap')];
  try {
    await run.start(PRESS, '--hold', '--clock', 'paced', '--note-events', noted, '--record', recording);
    await run.await_task('held');
    const missed = async () =>
      (await run.status()).processes.reduce((sum, process) => sum + process.missed_ticks + process.late_commands, 0);
    const before = await missed();
    const pid = run.panel_pid();
    const deaf = open_deaf(run.url);
    const browsers = await Promise.all(
      Array.from({ length: 10 }, (_, i) => RawBrowser.open(i % 2 === 0 ? run.url : run.watch_url)),
    );
    const begin = memory_of(pid);
    let largest = 0;
    const watch = setInterval(() => {
      try {
        largest = Math.max(largest, memory_of(pid));
      } catch {
        clearInterval(watch); // the panel has ended with the run
      }
    }, 50);
    const floods = Array.from({ length: 10 }, () => new Flood(run.url));
    const sent = () => floods.reduce((sum, flood) => sum + flood.sent, 0);
    while (sent() < MESSAGES) await sleep(20);
    assert.equal(await missed(), before);
    assert.equal(run.command('start').code, 0); // the flood continues while the task runs
    assert.equal(await run.exit, 0);
    clearInterval(watch);
    await Promise.all(floods.map((flood) => flood.end()));
    deaf.destroy();
    const connections = floods.reduce((sum, flood) => sum + flood.connections, 0);
    console.log(`${sent()} messages through ${connections} connections, ${begin} to ${largest} kB of memory`);
    assert.ok(begin > 0 && largest - begin < MOST, `${begin} to ${largest} kB`);
    for (const browser of browsers)
      assert.ok(browser.frames.some((frame) => frame.event === 'hello' || frame.event === 'robot'));
    assert.equal(hash_of(recording), hash_of_repetition(run, PRESS, noted, 0));
  } finally {
    await run.clear();
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
