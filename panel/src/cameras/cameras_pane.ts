import { element } from '../dom/element';
import type { Session } from '../session';
import { CameraView } from './camera_view';

const PERIOD = 250; // ms from one picture to the request for the next one

/**
 * The pictures of the deployment's cameras; null without a camera. While the pane is not visible no picture is asked
 * for, and the server draws none. Hook: `#cameras`.
 */
export function cameras_pane(session: Session): { node: HTMLElement; update(): void } | null {
  const cameras = session.scene.cameras.map((camera) => new CameraView(session, camera));
  if (cameras.length === 0) return null;
  const views = cameras.map((camera) => camera.node);
  const node = element('div', { id: 'cameras', class: 'pane cameras scroll', tabindex: 0 }, ...views);
  const asked = new Set<CameraView>();
  const ask = async (camera: CameraView) => {
    asked.add(camera);
    await camera.update();
    setTimeout(() => asked.delete(camera), PERIOD);
  };
  const update = () => {
    if (node.hidden || document.hidden || !session.store.connected || session.store.ended) return;
    for (const camera of cameras) if (camera.shown && !asked.has(camera)) void ask(camera);
  };
  return { node, update };
}
