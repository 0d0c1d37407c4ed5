// Builds the panel: npm run build -- --outdir=DIR. Writes index.html, panel.js and panel.css, each also with gzip.
import { build } from 'esbuild';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const LARGEST_BUNDLE = 400e3; // bytes, compressed
const here = dirname(fileURLToPath(import.meta.url));

function output_folder() {
  const given = process.argv.find((argument) => argument.startsWith('--outdir='));
  if (!given) throw new Error('the folder is missing: npm run build -- --outdir=DIR');
  return given.slice('--outdir='.length);
}

/** The licences of the bundled libraries, as a comment at the end of panel.js. */
function licences() {
  return ['three', 'uplot']
    .map((name) => `/*! ${name}\n${readFileSync(join(here, 'node_modules', name, 'LICENSE'), 'utf8').trim()}\n*/`)
    .join('\n');
}

function write(folder, name, content) {
  const compressed = gzipSync(content, { level: 9 });
  writeFileSync(join(folder, name), content);
  writeFileSync(join(folder, `${name}.gz`), compressed);
  console.log(`${name.padEnd(12)} ${content.length} bytes, compressed ${compressed.length}`);
  return compressed.length;
}

async function bundle(folder) {
  execFileSync(process.execPath, [join(here, 'node_modules/typescript/bin/tsc'), '--noEmit', '-p', here], {
    stdio: 'inherit',
  });
  const result = await build({
    absWorkingDir: here,
    entryPoints: { panel: 'src/main.ts' },
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2022',
    legalComments: 'eof',
    footer: { js: licences() },
    outdir: folder,
    write: false,
  });
  mkdirSync(folder, { recursive: true });
  let size = write(folder, 'index.html', readFileSync(join(here, 'src/index.html')));
  for (const file of result.outputFiles)
    size += write(folder, file.path.endsWith('.css') ? 'panel.css' : 'panel.js', Buffer.from(file.contents));
  console.log(`in all       compressed ${size}, at most ${LARGEST_BUNDLE}`);
  if (size > LARGEST_BUNDLE) throw new Error('the bundle is too large');
}

bundle(output_folder()).catch((error) => {
  console.error(error.message);
  process.exitCode = 1;
});
