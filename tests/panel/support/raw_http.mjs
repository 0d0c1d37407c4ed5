// Requests byte by byte: a browser would correct them.
import { connect } from 'node:net';

/** The status code and text of the answer to `lines`; code 0: the server closes the connection without an answer. */
export function raw_request(url, lines) {
  return new Promise((resolve, reject) => {
    const { hostname, port } = new URL(url);
    const socket = connect(Number(port), hostname, () => socket.write(`${lines.join('\r\n')}\r\n\r\n`));
    let text = '';
    socket.setEncoding('utf8');
    socket.on('data', (data) => {
      text += data;
    });
    socket.on('error', reject);
    socket.on('close', () => resolve({ code: Number(/^HTTP\/1\.1 (\d+)/.exec(text)?.[1] ?? 0), text }));
  });
}

/** GET `path` of the server of `url`, as it is written. */
export const raw_get = (url, path, host = new URL(url).host) =>
  raw_request(url, [`GET ${path} HTTP/1.1`, `Host: ${host}`, 'Connection: close']);
