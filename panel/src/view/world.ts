import { Color, DirectionalLight, GridHelper, Group, HemisphereLight, Scene as World } from 'three';
import type { Robot, Scene } from '../protocol/scene_file';
import type { Store } from '../state/store';
import { Bodies } from './bodies';
import { ForceArrows } from './force_arrows';
import { FrameAxes } from './frame_axes';
import { ToolTrail } from './tool_trail';

export type Layer = 'grid' | 'ghost' | 'trail' | 'frames' | 'forces';

const TRAIL_COLOURS = [0x0c8f62, 0xa855f7, 0xdb2777, 0x2563eb];
const GRID_SIZE = 10; // m
const GRID_STEP = 0.25; // m

/** All that the 3D view draws. */
export class WorldView {
  readonly world = new World();
  readonly bodies: Bodies;
  private readonly frames: FrameAxes;
  private readonly forces: ForceArrows;
  private readonly trails: ToolTrail[] = [];
  private readonly trail_lines = new Group();
  private readonly robots: Robot[];
  private grid: GridHelper | null = null;
  private readonly shown: Record<Layer, boolean> = {
    grid: true,
    ghost: true,
    trail: true,
    frames: false,
    forces: true,
  };

  constructor(scene: Scene) {
    this.robots = scene.robots;
    this.bodies = new Bodies(scene);
    this.frames = new FrameAxes(scene.frames, this.bodies);
    this.frames.show(false);
    this.forces = new ForceArrows(scene, this.frames.anchors);
    scene.robots.forEach((robot, index) => {
      const tool = this.frames.anchors[robot.tool_frame ?? -1];
      if (tool) this.trails.push(new ToolTrail(tool, TRAIL_COLOURS[index % TRAIL_COLOURS.length] ?? 0));
    });
    for (const trail of this.trails) this.trail_lines.add(trail.line);
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(2, -3, 5);
    const lamp = new DirectionalLight(0xffffff, 0.5);
    lamp.position.set(-4, 2, 1);
    const sky = new HemisphereLight(0xffffff, 0x8a8f98, 1.4);
    sky.position.set(0, 0, 1);
    this.world.add(sky, sun, lamp, this.bodies.actual, this.bodies.desired, this.trail_lines);
  }

  update(store: Store): void {
    const poses = store.poses;
    if (poses) {
      this.bodies.move(poses.bodies);
      this.bodies.move_ghosts(this.shown.ghost ? poses.desired : undefined, this.unsynchronised(store));
      this.world.updateMatrixWorld();
      for (const trail of this.trails) trail.update();
    }
    this.forces.update(store, this.shown.forces);
  }

  /** Bodies of robots whose desired positions have no meaning so far. */
  private unsynchronised(store: Store): Set<number> {
    const robots = this.robots.filter((robot) => store.robots.get(robot.name)?.synchronised === false);
    return new Set(robots.flatMap((robot) => robot.bodies));
  }

  is_shown(layer: Layer): boolean {
    return this.shown[layer];
  }

  show(layer: Layer, visible: boolean): void {
    this.shown[layer] = visible;
    if (layer === 'frames') this.frames.show(visible);
    if (layer === 'trail') this.trail_lines.visible = visible;
    if (layer === 'grid' && this.grid) this.grid.visible = visible;
  }

  /** Before a picture. */
  prepare(): void {
    for (const trail of this.trails) trail.prepare();
  }

  clear_trails(): void {
    for (const trail of this.trails) trail.clear();
  }

  set_theme(background: string, floor: string, line: string, centre: string): void {
    this.world.background = new Color(background);
    this.bodies.set_floor(floor);
    if (this.grid) {
      this.world.remove(this.grid);
      this.grid.dispose();
    }
    this.grid = new GridHelper(GRID_SIZE, GRID_SIZE / GRID_STEP, new Color(centre), new Color(line));
    this.grid.rotateX(Math.PI / 2);
    this.grid.position.z = 0.001;
    this.grid.visible = this.shown.grid;
    this.world.add(this.grid);
  }
}
