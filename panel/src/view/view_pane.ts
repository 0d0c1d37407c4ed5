import { button, element, set_attribute } from '../dom/element';
import type { Session } from '../session';
import { OrbitCamera } from './orbit_camera';
import { Renderer } from './renderer';
import { WorldView, type Layer } from './world';

const LAYERS: [Layer, string, string][] = [
  ['grid', 'Grid', 'Squares of 250 mm'],
  ['ghost', 'Desired', 'Translucent robots at their desired positions'],
  ['trail', 'Trail', "The tools' paths"],
  ['frames', 'Frames', 'x red, y green, z blue'],
  ['forces', 'Forces', '5 mm per newton'],
];
const LABEL =
  '3D view of the world. Arrow keys turn the camera, Shift with arrow keys moves it, plus and minus zoom, ' +
  'Home resets it.';

/** The 3D view with its switches. Hooks: `#view`, `#canvas` (`data-tick` of its picture), `[data-layer]`, `#no-webgl`. */
export function view_pane(session: Session): { node: HTMLElement; update(): void; set_theme(): void } {
  const canvas = element('canvas', { id: 'canvas', tabindex: 0, role: 'application', 'aria-label': LABEL });
  const stage = element('div', { class: 'stage' }, canvas);
  const toolbar = element('div', { class: 'toolbar', role: 'group', 'aria-label': '3D view' });
  const node = element('section', { id: 'view', 'aria-label': '3D view' }, toolbar, stage);
  try {
    return { node, ...drawn_view(session, canvas, stage, toolbar) };
  } catch {
    toolbar.remove();
    stage.replaceChildren(
      element(
        'p',
        { id: 'no-webgl', class: 'hint' },
        'This browser has no WebGL: the 3D view is missing. Everything else works.',
      ),
    );
    return { node, update: () => undefined, set_theme: () => undefined };
  }
}

function drawn_view(
  session: Session,
  canvas: HTMLCanvasElement,
  stage: HTMLElement,
  toolbar: HTMLElement,
): { update(): void; set_theme(): void } {
  const renderer = new Renderer(canvas, (target) => {
    view.prepare();
    if (shown) canvas.dataset['tick'] = String(shown.tick);
    target.render(view.world, camera.camera);
  });
  const view = new WorldView(session.scene);
  const camera = new OrbitCamera(canvas, () => renderer.ask());
  for (const [layer, text, title] of LAYERS) toolbar.append(layer_button(view, renderer, session, layer, text, title));
  toolbar.append(
    button('Clear', { class: 'plain', 'aria-label': 'Clear the trail', title: 'Clear the trail' }, () => {
      view.clear_trails();
      renderer.ask();
    }),
    element('span', { class: 'spacer' }),
    button('−', { class: 'plain', 'aria-label': 'Zoom out' }, () => camera.zoom(1.2)),
    button('+', { class: 'plain', 'aria-label': 'Zoom in' }, () => camera.zoom(1 / 1.2)),
    button('Reset', { class: 'plain', id: 'reset-view', 'aria-label': 'Reset the view' }, () => camera.reset()),
  );
  new ResizeObserver(() => {
    const { clientWidth, clientHeight } = stage;
    if (clientWidth === 0 || clientHeight === 0) return;
    camera.resize(clientWidth, clientHeight);
    renderer.resize(clientWidth, clientHeight);
  }).observe(stage);
  camera.fit(view.bodies.extent());
  let shown = session.store.poses;
  const update = () => {
    if (session.store.poses === shown) return;
    const first = shown === null;
    shown = session.store.poses;
    view.update(session.store);
    if (first) camera.fit(view.bodies.extent());
    renderer.ask();
  };
  return { update, set_theme: () => set_theme(view, renderer) };
}

function layer_button(
  view: WorldView,
  renderer: Renderer,
  session: Session,
  layer: Layer,
  text: string,
  title: string,
): HTMLButtonElement {
  const made = button(text, { title, 'data-layer': layer, 'aria-pressed': String(view.is_shown(layer)) });
  made.addEventListener('click', () => {
    view.show(layer, !view.is_shown(layer));
    set_attribute(made, 'aria-pressed', String(view.is_shown(layer)));
    view.update(session.store);
    renderer.ask();
  });
  return made;
}

function set_theme(view: WorldView, renderer: Renderer): void {
  const style = getComputedStyle(document.documentElement);
  const colour = (name: string) => style.getPropertyValue(name).trim();
  view.set_theme(colour('--view'), colour('--view-floor'), colour('--view-grid'), colour('--view-axis'));
  renderer.ask();
}
