// The test packages of panel/package.json, and what the command line of a test names:
// node TEST_FILE MRROC_BINARY SOURCE_FOLDER
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

export const MRROC = resolve(process.argv[2] ?? 'build/bin/mrroc');
export const SOURCE = resolve(process.argv[3] ?? '.');
export const PRESS = join(SOURCE, 'tasks/press/press.toml');
export const TRANSFER = join(SOURCE, 'tasks/cooperative_transfer/cooperative_transfer.toml');
export const POLISH = join(SOURCE, 'tasks/polish/polish.toml');
export const INSPECT = join(SOURCE, 'tasks/inspect/inspect.toml');
export const QUESTIONS = join(SOURCE, 'sensors/operator_input/demo.toml');

const require = createRequire(join(SOURCE, 'panel/package.json'));
export const { chromium } = require('playwright-core');
export const WebSocket = require('ws');
export const axe_source = () => readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
