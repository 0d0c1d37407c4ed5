import { element, set_hidden } from '../dom/element';
import type { Sensor } from '../protocol/scene_file';

const PERIOD = 1000; // ms, at most one request a second of each camera

/** The pictures of the scene's cameras. A camera without a picture is hidden. Hooks: `[data-camera]`. */
export function camera_pictures(sensors: Sensor[]): { node: HTMLElement } {
  const node = element('div', { class: 'pictures' });
  const cameras = new Set(sensors.flatMap((sensor) => (sensor.camera ? [sensor.camera] : [])));
  for (const camera of cameras) node.append(picture(camera));
  return { node };
}

function picture(camera: string): HTMLElement {
  const image = element('img', { alt: `Picture of the camera ${camera}` });
  const figure = element('figure', { 'data-camera': camera }, image, element('figcaption', {}, camera));
  figure.hidden = true;
  let failures = 0;
  const request = () => {
    if (document.hidden) setTimeout(request, PERIOD);
    else image.src = `pictures/${encodeURIComponent(camera)}.png?${Date.now()}`;
  };
  image.addEventListener('load', () => {
    failures = 0;
    set_hidden(figure, false);
    setTimeout(request, PERIOD);
  });
  image.addEventListener('error', () => {
    set_hidden(figure, true);
    if (++failures < 5) setTimeout(request, 5 * PERIOD);
  });
  request();
  return figure;
}
