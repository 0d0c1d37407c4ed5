// A run with a panel, in a runtime folder of its own. Tests wait by its states and ticks, never by the wall's time.
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { closeSync, mkdtempSync, openSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { MRROC } from './packages.mjs';
import { RunSocket } from './run_socket.mjs';

export const STOPPED = 5; // exit code of a run that the operator has stopped
export const TIMEOUT = 120_000; // ms of a busy machine

export const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Calls `read` until `holds` is true of its result, and returns that. */
export async function eventually(read, holds, what) {
  const deadline = Date.now() + TIMEOUT;
  for (;;) {
    const value = await read();
    if (holds(value)) return value;
    if (Date.now() > deadline) throw new Error(`never ${what}: ${JSON.stringify(value)}`);
    await sleep(30);
  }
}

export class LiveRun {
  folder = mkdtempSync(join(tmpdir(), 'mrroc-panel-test-'));
  environment = { ...process.env, MRROC_RUNTIME_DIR: join(this.folder, 'mrroc') };
  others = []; // further processes: panels
  #socket;

  path(name) {
    return join(this.folder, name);
  }

  /** `mrroc run FILE ...` with a panel; its URLs are `this.url` and `this.watch_url`. */
  async start(file, ...options) {
    const black_boxes = options.some((option) => option.startsWith('--black-box')) ? [] : ['--black-box='];
    this.process = this.#spawn('run', ['run', file, '--panel', '0', ...black_boxes, ...options]);
    this.exit = new Promise((resolve) => this.process.once('exit', (code) => resolve(code)));
    [this.url, this.watch_url] = await this.#urls('run');
    return this;
  }

  /** `mrroc panel ...` for this run; the result has its process and URLs. */
  async start_panel(...options) {
    const name = `panel-${this.others.length}`;
    const process = this.#spawn(name, ['panel', ...options]);
    this.others.push(process);
    const [url, watch_url] = await this.#urls(name);
    return { process, url, watch_url };
  }

  /** `mrroc ARGUMENTS` in the run's folder: its exit code and everything that it has printed. */
  command(...args) {
    const done = spawnSync(MRROC, args, {
      env: this.environment,
      encoding: 'utf8',
      timeout: TIMEOUT,
      cwd: this.folder,
    });
    return { code: done.status, text: done.stdout + done.stderr };
  }

  /** The reply of the run to `request`, which it must accept. */
  async request(request) {
    this.#socket ??= new RunSocket(this.#socket_path());
    const reply = await this.#socket.request(request);
    if (!reply?.ok) throw new Error(`${request.verb}: ${JSON.stringify(reply)}\n${this.text()}`);
    return reply;
  }

  /** The state of the run. */
  async status() {
    return (await this.request({ verb: 'status' })).data;
  }

  /** The task lasts 100 times as long as programmed: on a busy machine, too, it runs for longer than a page needs. */
  slow_down() {
    return this.request({ verb: 'speed', value: 1 });
  }

  /** The same by `mrroc status --json`. */
  status_by_command() {
    const done = this.command('status', '--json');
    if (done.code !== 0) throw new Error(`no status: ${done.text}\n${this.text()}`);
    return JSON.parse(done.text);
  }

  await_status(holds, what) {
    return eventually(() => this.status(), holds, what);
  }

  await_task(task) {
    return this.await_status((status) => status.task === task, task);
  }

  async pass_ticks(ticks) {
    const begin = (await this.status()).tick;
    await this.await_status((status) => status.tick >= begin + ticks, `${ticks} ticks later`);
  }

  text(name = 'run') {
    return readFileSync(this.path(`${name}.out`), 'utf8');
  }

  /** The `mrroc_panel` that serves this run since its start. */
  panel_pid() {
    for (const name of readdirSync('/proc').filter((entry) => /^\d+$/.test(entry))) {
      try {
        const fields = readFileSync(`/proc/${name}/stat`, 'utf8')
          .replace(/^.*\) /, '')
          .split(' ');
        const command = readFileSync(`/proc/${name}/comm`, 'utf8').trim();
        if (command === 'mrroc_panel' && Number(fields[1]) === this.process.pid) return Number(name);
      } catch {
        // the process has ended meanwhile
      }
    }
    throw new Error('the run has no panel process');
  }

  /** Ends what still runs, and removes the folder. */
  async clear() {
    this.#socket?.close();
    for (const other of this.others) other.kill('SIGKILL');
    if (this.process && this.process.exitCode === null) {
      this.process.kill('SIGINT');
      this.process.kill('SIGINT');
      await this.exit;
    }
    rmSync(this.folder, { recursive: true, force: true });
  }

  #socket_path() {
    const folder = this.environment.MRROC_RUNTIME_DIR;
    const name = readdirSync(folder).find((entry) => entry.endsWith('.sock'));
    if (!name) throw new Error(`the run has no socket: ${this.text()}`);
    return join(folder, name);
  }

  #spawn(name, args) {
    const out = openSync(this.path(`${name}.out`), 'w');
    const made = spawn(MRROC, args, { env: this.environment, cwd: this.folder, stdio: ['ignore', out, out] });
    closeSync(out);
    return made;
  }

  async #urls(name) {
    const pattern = /panel: (\S+)\n(?:.*\n)*?panel, to watch only: (\S+)\n/;
    const text = await eventually(
      () => this.text(name),
      (shown) => pattern.test(shown),
      'a panel',
    );
    return pattern.exec(text).slice(1);
  }
}

/** The hash of the steps in a recording. */
export function hash_of(file) {
  return execFileSync(MRROC, ['trace', 'hash', file], { encoding: 'utf8' }).trim().split(/\s+/)[0];
}

/** Repeats a live run of `file` in lockstep from its noted events; the result is the hash of its steps. */
export function hash_of_repetition(run, file, noted, exit_code) {
  const recording = run.path('again.mcap');
  const done = run.command(
    'run',
    file,
    '--hold',
    '--clock',
    'lockstep',
    '--events',
    noted,
    '--record',
    recording,
    '--quiet',
    '--black-box=',
  );
  if (done.code !== exit_code) throw new Error(`the repetition ends with ${done.code}: ${done.text}`);
  return hash_of(recording);
}
