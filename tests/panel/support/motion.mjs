// What a run has written about its jogs and its motion.
import { readFileSync } from 'node:fs';

const NAME = 1; // fields of a line of the motion file
const COLUMN_SPEED = 9;

/** Speed of the arm's column in rad/s, by tick. */
export function column_speeds(file) {
  const speeds = new Map();
  for (const line of readFileSync(file, 'utf8').split('\n')) {
    const fields = line.split(' ');
    if (fields[NAME] === 'arm') speeds.set(Number(fields[0]), Math.abs(Number(fields[COLUMN_SPEED])));
  }
  return speeds;
}

/** Ticks of a command in a file of noted events. */
export function ticks_of(command, file) {
  const events = readFileSync(file, 'utf8').split('[[events]]');
  return events.filter((text) => text.includes(`"${command}"`)).map((text) => Number(/tick = (\d+)/.exec(text)[1]));
}
