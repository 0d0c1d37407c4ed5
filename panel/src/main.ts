import './css/panel.css';
import { element } from './dom/element';
import { make_page } from './page';
import { load_scene } from './protocol/scene_file';
import type { Socket } from './protocol/connection';

/** The socket beside the page, with the token of the page's own address. */
function open_socket(): Socket {
  const address = new URL('socket', location.href);
  address.protocol = address.protocol === 'https:' ? 'wss:' : 'ws:';
  return new WebSocket(address) as unknown as Socket;
}

load_scene('scene.json').then(
  (scene) => make_page(scene, open_socket),
  (error: unknown) => {
    const text = error instanceof Error ? error.message : String(error);
    document.body.append(
      element(
        'main',
        { class: 'failed' },
        element('h1', {}, "Operator's panel"),
        element('p', { role: 'alert' }, `The scene of the run cannot be loaded: ${text}`),
      ),
    );
  },
);
