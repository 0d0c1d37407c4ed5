// Who may use the panel: only with a token, only pages that the server has sent, only this machine without TLS.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { get } from 'node:https';
import { networkInterfaces } from 'node:os';
import { after, before, test } from 'node:test';
import { LiveRun } from './support/live_run.mjs';
import { PRESS } from './support/packages.mjs';
import { open_socket, RawBrowser, socket_url } from './support/raw_browser.mjs';
import { raw_get, raw_request } from './support/raw_http.mjs';

const run = new LiveRun();
before(async () => {
  await run.start(PRESS, '--hold', '--clock', 'paced');
  await run.await_task('held');
});
after(() => run.clear());

const token_path = (url = run.url) => new URL(url).pathname; // "/TOKEN/"

test('ThePageComesWithItsHeaders', async () => {
  const answer = await raw_get(run.url, token_path());
  assert.equal(answer.code, 200);
  assert.match(answer.text, /Content-Security-Policy: default-src 'self'/);
  assert.match(answer.text, /frame-ancestors 'none'/);
  assert.match(answer.text, /Referrer-Policy: no-referrer/);
  assert.equal((await raw_get(run.url, token_path().slice(0, -1))).code, 308);
  assert.equal((await raw_get(run.watch_url, token_path(run.watch_url))).code, 200);
});

test('WithoutATokenNothingIsServed', async () => {
  const wrong = token_path().replace(/^\/./, (start) => (start === '/0' ? '/1' : '/0'));
  for (const path of ['/', '/index.html', '/scene.json', '/socket', wrong, `${wrong}panel.js`])
    assert.ok([403, 404].includes((await raw_get(run.url, path)).code), path);
});

test('PathsLeadNowhereElse', async () => {
  const token = token_path();
  const paths = [
    '../../etc/passwd',
    '..%2f..%2fetc%2fpasswd',
    '%2e%2e/%2e%2e/etc/passwd',
    '....//etc/passwd',
    'index.html/../../../etc/passwd',
    'pictures/../../../etc/passwd',
    'no_such_file',
    '%',
    '?',
    '\\..\\..\\etc\\passwd',
  ];
  for (const path of paths) {
    const { code, text } = await raw_get(run.url, token + path);
    assert.ok(code === 0 || code >= 400 || path === '?', `${path}: ${code}`);
    assert.doesNotMatch(text, /root:/, path);
  }
});

test('OtherHostsAndMethodsAreRefused', async () => {
  for (const host of ['evil.example', 'localhost.evil.example:80', `evil.example:${new URL(run.url).port}`])
    assert.equal((await raw_get(run.url, token_path(), host)).code, 403, host);
  const { host } = new URL(run.url);
  for (const method of ['POST', 'PUT', 'DELETE', 'OPTIONS', 'TRACE', 'PROPFIND']) {
    const lines = [`${method} ${token_path()} HTTP/1.1`, `Host: ${host}`, 'Content-Length: 0', 'Connection: close'];
    const { code } = await raw_request(run.url, lines);
    assert.ok(code >= 400 || code === 0, `${method}: ${code}`);
  }
});

test('SocketsOfForeignPagesAreRefused', async () => {
  const address = socket_url(run.url);
  const { port } = new URL(run.url);
  const origins = [
    'http://evil.example',
    'null',
    'http://127.0.0.1',
    `http://127.0.0.1:${Number(port) + 1}`,
    `https://127.0.0.1:${port}`,
    `http://127.0.0.1:${port}.evil.example`,
    null,
  ];
  for (const origin of origins) {
    const { socket, code } = await open_socket(address, { origin });
    socket?.terminate();
    assert.notEqual(code, 101, `origin ${origin}`);
  }
  const { code } = await open_socket(address, { headers: { Host: 'evil.example' } });
  assert.notEqual(code, 101);
  const wrong = address.replace(/\/[0-9a-f]+\/socket/, '/00000000000000000000000000000000/socket');
  assert.notEqual((await open_socket(wrong)).code, 101);
});

test('ReadOnlyBrowsersMayOnlyReadTheStatus', async () => {
  const watcher = await RawBrowser.open(run.watch_url);
  const hello = await watcher.first((frame) => frame.event === 'hello');
  assert.equal(hello.may_command, false);
  const requests = [
    { verb: 'stop' },
    { verb: 'estop' },
    { verb: 'start' },
    { verb: 'command' },
    { verb: 'record', file: 'watched.mcap' },
    { verb: 'jog', robot: 'arm', axis: 'column', velocity: 0.1, beat: watcher.beat ?? 0 },
  ];
  for (const request of requests) assert.equal((await watcher.request(request)).reason, 'read_only', request.verb);
  assert.equal((await watcher.request({ verb: 'status' })).ok, true);
  assert.equal((await run.status()).task, 'held');
  watcher.close();
});

test('BadRequestsAreAnsweredWithAReason', async () => {
  const browser = await RawBrowser.open(run.url);
  const refused = async (text) => {
    const reply = browser.next((frame) => frame.ok === false);
    browser.send(text);
    return reply;
  };
  assert.equal((await refused('no JSON')).reason, 'malformed');
  assert.equal((await refused('[1, 2]')).reason, 'malformed');
  assert.equal((await refused('{"verb":"paus","id":3}')).reason, 'unknown_verb');
  assert.match((await refused('{"verb":"paus"}')).text, /did you mean 'pause'/);
  assert.equal((await refused('{"verb":"jog","robot":"arm","axis":"column","velocity":0.1}')).reason, 'stale');
  assert.equal((await refused('{"verb":"jog","robot":"arm","axis":"column","velocity":0.1,"beat":1}')).reason, 'stale');
  assert.match((await refused('{"verb":"record","file":"/tmp/a.mcap"}')).text, /cannot choose the folder/);
  assert.match((await refused('{"verb":"record","file":"../a.mcap"}')).text, /cannot choose the folder/);
  assert.equal((await refused(JSON.stringify({ verb: 'x'.repeat(20_000) })))?.reason ?? 'malformed', 'malformed');
  assert.equal((await run.status()).task, 'held');
  browser.close();
});

test('OtherMachinesAreServedOnlyWithACertificate', async () => {
  const addresses = Object.values(networkInterfaces())
    .flat()
    .filter((address) => address.family === 'IPv4');
  const outer = addresses.find((address) => !address.internal);
  if (outer) {
    const refused = run.command('panel', '--interface', outer.address);
    assert.equal(refused.code, 2, refused.text);
    assert.match(refused.text, /certificate/);
  }
  const address = (outer ?? addresses[0]).address;
  const [key, certificate, both] = ['key.pem', 'certificate.pem', 'both.pem'].map((name) => run.path(name));
  execFileSync(
    'openssl',
    [
      'req',
      '-x509',
      '-newkey',
      'ec',
      '-pkeyopt',
      'ec_paramgen_curve:prime256v1',
      '-nodes',
      '-days',
      '1',
      '-subj',
      `/CN=${address}`,
      '-addext',
      `subjectAltName=IP:${address}`,
      '-keyout',
      key,
      '-out',
      certificate,
    ],
    { stdio: 'ignore' },
  );
  execFileSync('sh', ['-c', 'cat "$0" "$1" > "$2"', key, certificate, both]);
  const panel = await run.start_panel('--interface', address, '--certificate', both);
  assert.match(panel.url, new RegExp(`^https://${address.replaceAll('.', '\\.')}:`));
  const code = await new Promise((resolve, reject) => {
    get(panel.url, { rejectUnauthorized: false }, (answer) => resolve(answer.statusCode)).on('error', reject);
  });
  assert.equal(code, 200);
  const browser = await RawBrowser.open(panel.url, { rejectUnauthorized: false });
  assert.equal((await browser.request({ verb: 'status' })).ok, true);
  browser.close();
});
