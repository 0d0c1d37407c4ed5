// The processes of a browser.
import { readdirSync, readFileSync } from 'node:fs';

function children_of(pid) {
  return readdirSync('/proc')
    .filter((name) => /^\d+$/.test(name))
    .flatMap((name) => {
      try {
        const fields = readFileSync(`/proc/${name}/stat`, 'utf8')
          .replace(/^.*\) /, '')
          .split(' ');
        return Number(fields[1]) === pid ? [Number(name), ...children_of(Number(name))] : [];
      } catch {
        return [];
      }
    });
}

/** The processes that run pages. */
export function renderers_of(pid) {
  return children_of(pid).filter((child) => readFileSync(`/proc/${child}/cmdline`, 'utf8').includes('--type=renderer'));
}
