import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Connection, type Socket } from '../../../panel/src/protocol/connection';

class FakeSocket implements Socket {
  readyState = 1;
  readonly sent: string[] = [];
  onopen: (() => void) | null = null;
  onmessage: ((message: { data: unknown }) => void) | null = null;
  onclose: (() => void) | null = null;
  send(text: string): void {
    this.sent.push(text);
  }
  close(): void {
    this.readyState = 3;
    this.onclose?.();
  }
  receive(frame: unknown): void {
    this.onmessage?.({ data: typeof frame === 'string' ? frame : JSON.stringify(frame) });
  }
}

function rig() {
  const sockets: FakeSocket[] = [];
  const events: string[] = [];
  const waits: { call: () => void; time: number }[] = [];
  const open = () => {
    const socket = new FakeSocket();
    sockets.push(socket);
    return socket;
  };
  const listener = {
    event: (event: { event: string }) => events.push(event.event),
    opened: () => events.push('opened'),
    lost: () => events.push('lost'),
  };
  const connection = new Connection(open, listener, (call, time) => waits.push({ call, time }));
  connection.connect();
  return { connection, sockets, events, waits };
}

test('RepliesBelongToTheirRequestsInAnyOrder', async () => {
  const { connection, sockets } = rig();
  const first = connection.request({ verb: 'go', robot: 'arm', posture: 'home' });
  const second = connection.request({ verb: 'pause' });
  sockets[0]?.receive({ id: 2, ok: true, text: 'second' });
  sockets[0]?.receive({ id: 1, ok: false, text: 'first' });
  assert.equal((await second).text, 'second');
  assert.equal((await first).text, 'first');
  assert.deepEqual(JSON.parse(sockets[0]?.sent[1] ?? ''), { verb: 'pause', id: 2 });
});

test('BeatsAreKeptAndOtherEventsPassedOn', () => {
  const { connection, sockets, events } = rig();
  sockets[0]?.receive({ event: 'beat', number: 41 });
  sockets[0]?.receive({ event: 'beat', number: 42 });
  sockets[0]?.receive({ event: 'commander', commander: null });
  sockets[0]?.receive('not JSON');
  assert.equal(connection.beat, 42);
  assert.deepEqual(events, ['commander']);
});

test('ALossAnswersOpenRequestsAndTheConnectionIsMadeAgain', async () => {
  const { connection, sockets, events, waits } = rig();
  const reply = connection.request({ verb: 'pause' });
  sockets[0]?.close();
  assert.equal((await reply).reason, 'lost');
  assert.deepEqual(events, ['lost']);
  assert.equal(waits.length, 1);
  waits[0]?.call();
  assert.equal(sockets.length, 2);
  sockets[1]?.close();
  assert.ok((waits[1]?.time ?? 0) > (waits[0]?.time ?? 0));
});

test('AfterTheEndThereIsNoFurtherAttempt', () => {
  const { connection, sockets, waits } = rig();
  connection.end();
  sockets[0]?.close();
  assert.equal(waits.length, 0);
});
