// Runs the unit tests of the page's functions: npm test. They are TypeScript in tests/panel/unit.
import { buildSync } from 'esbuild';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const tests = join(here, '../tests/panel/unit');
const folder = mkdtempSync(join(tmpdir(), 'mrroc-panel-'));
try {
  const names = readdirSync(tests).filter((name) => name.endsWith('.test.ts'));
  buildSync({
    absWorkingDir: here,
    entryPoints: names.map((name) => join(tests, name)),
    outdir: folder,
    outExtension: { '.js': '.mjs' },
    bundle: true,
    platform: 'node',
    format: 'esm',
    target: 'node18',
  });
  const files = names.map((name) => join(folder, name.replace(/ts$/, 'mjs')));
  process.exitCode = spawnSync(process.execPath, ['--test', ...files], { stdio: 'inherit' }).status ?? 1;
} finally {
  rmSync(folder, { recursive: true });
}
