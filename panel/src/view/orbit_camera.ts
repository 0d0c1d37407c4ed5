import { Box3, MathUtils, PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const TURN = MathUtils.degToRad(7.5);
const ZOOM = 1.15;
const MOVE = 0.06; // of the distance

/** A camera around a point: mouse, touch, and the keys arrows, Shift with arrows, +, − and Home. */
export class OrbitCamera {
  readonly camera = new PerspectiveCamera(40, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private readonly home = new Vector3(2, -2, 1.5);
  private readonly home_target = new Vector3();

  constructor(
    canvas: HTMLCanvasElement,
    private readonly changed: () => void,
  ) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.changed());
    canvas.addEventListener('keydown', (event) => this.handle_key(event));
  }

  /** Looks at `box` from the front and above. */
  fit(box: Box3): void {
    if (box.isEmpty()) box.set(new Vector3(-1, -1, 0), new Vector3(1, 1, 1));
    const centre = box.getCenter(this.home_target);
    const distance = (1.05 * box.getSize(new Vector3()).length()) / (2 * Math.tan(MathUtils.degToRad(20)));
    this.home.set(0.62, -0.68, 0.4).normalize().multiplyScalar(distance).add(centre);
    this.reset();
  }

  reset(): void {
    this.camera.position.copy(this.home);
    this.controls.target.copy(this.home_target);
    this.controls.update();
    this.changed();
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
  }

  zoom(factor: number): void {
    const target = this.controls.target;
    this.camera.position.sub(target).multiplyScalar(factor).add(target);
    this.controls.update();
    this.changed();
  }

  private handle_key(event: KeyboardEvent): void {
    const arrows: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) this.move(...arrow);
    else if (arrow) this.turn(...arrow);
    else if (event.key === '+' || event.key === '=') this.zoom(1 / ZOOM);
    else if (event.key === '-') this.zoom(ZOOM);
    else if (event.key === 'Home') this.reset();
    else return;
    event.preventDefault();
  }

  /** The sphere of three.js has its pole along y: x, z, -y of the world are its x, y, z. */
  private turn(right: number, up: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const sphere = new Spherical().setFromCartesianCoords(offset.x, offset.z, -offset.y);
    sphere.theta += right * TURN;
    sphere.phi = MathUtils.clamp(sphere.phi - up * TURN, 0.02, Math.PI - 0.02);
    const turned = new Vector3().setFromSpherical(sphere);
    this.camera.position.set(turned.x, -turned.z, turned.y).add(this.controls.target);
    this.controls.update();
    this.changed();
  }

  private move(right: number, up: number): void {
    const distance = this.camera.position.distanceTo(this.controls.target) * MOVE;
    const step = new Vector3(right * distance, up * distance, 0).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(step);
    this.controls.target.add(step);
    this.controls.update();
    this.changed();
  }
}
