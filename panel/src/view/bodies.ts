import {
  Box3,
  Color,
  Group,
  Mesh,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
  type BufferGeometry,
  type Material,
} from 'three';
import type { Geom, Scene } from '../protocol/scene_file';
import { geom_geometry, mesh_geometry } from './geometry';

const NUMBERS_OF_A_POSE = 7; // x y z qx qy qz qw

/** The bodies of the scene with their geoms, and a translucent copy of the robots at their desired positions. */
export class Bodies {
  readonly actual = new Group();
  readonly desired = new Group();
  private readonly floor = new MeshLambertMaterial();
  private readonly groups: Group[];
  private readonly ghosts = new Map<number, Group>();
  private readonly without_robot: boolean;
  private readonly seen_first: Mesh[] = [];

  constructor(scene: Scene) {
    const meshes = scene.meshes.map(mesh_geometry);
    const robots = new Set(scene.robots.flatMap((robot) => robot.bodies));
    this.without_robot = robots.size === 0;
    this.groups = scene.bodies.map(() => new Group());
    for (const group of this.groups) this.actual.add(group);
    for (const geom of scene.geoms) this.add_geom(geom, geom_geometry(geom, meshes), robots.has(geom.body));
  }

  /** `poses`: of every body in the world. */
  move(poses: number[]): void {
    this.groups.forEach((group, index) => place(group, poses, index));
  }

  /** Shows the ghosts at `poses`, but not of the bodies in `without`; without poses no ghost is shown. */
  move_ghosts(poses: number[] | undefined, without: Set<number>): void {
    for (const [index, ghost] of this.ghosts) {
      ghost.visible = poses !== undefined && !without.has(index);
      if (poses) place(ghost, poses, index);
    }
  }

  /** The present pose of a body. */
  body(index: number): Group | undefined {
    return this.groups[index];
  }

  set_floor(colour: string): void {
    this.floor.color = new Color(colour);
  }

  /** Where the robots are; everything but planes without a robot. */
  extent(): Box3 {
    this.actual.updateMatrixWorld(true);
    const box = new Box3();
    for (const mesh of this.seen_first) box.expandByObject(mesh);
    return box;
  }

  private add_geom(geom: Geom, geometry: BufferGeometry, of_robot: boolean): void {
    const group = this.groups[geom.body];
    if (!group) return;
    const mesh = placed(geom, geometry, is_floor(geom) ? this.floor : material_of(geom));
    group.add(mesh);
    if (of_robot || (this.without_robot && geom.type !== 'plane')) this.seen_first.push(mesh);
    if (!of_robot) return;
    let ghost = this.ghosts.get(geom.body);
    if (!ghost) {
      ghost = new Group();
      ghost.visible = false;
      this.ghosts.set(geom.body, ghost);
      this.desired.add(ghost);
    }
    ghost.add(placed(geom, geometry, GHOST));
  }
}

/** Behind the body itself, so that only a deviation is seen. */
const GHOST = new MeshLambertMaterial({
  color: 0x2f7fd6,
  transparent: true,
  opacity: 0.35,
  depthWrite: false,
  flatShading: true,
  polygonOffset: true,
  polygonOffsetFactor: 2,
  polygonOffsetUnits: 2,
});

function material_of(geom: Geom): Material {
  const [red, green, blue, alpha] = geom.colour;
  const material = new MeshLambertMaterial({ flatShading: geom.type === 'mesh' || geom.type === 'box' });
  material.color.setRGB(red, green, blue, 'srgb');
  material.transparent = alpha < 1;
  material.opacity = alpha;
  return material;
}

/** A large plane has the colour of the theme. */
function is_floor(geom: Geom): boolean {
  return geom.type === 'plane' && [0, 1].every((i) => !geom.size[i] || (geom.size[i] ?? 0) >= 1);
}

function placed(geom: Geom, geometry: BufferGeometry, material: Material): Mesh {
  const mesh = new Mesh(geometry, material);
  mesh.position.set(...geom.position);
  mesh.quaternion.set(...geom.quaternion);
  return mesh;
}

const position = new Vector3();
const rotation = new Quaternion();

function place(group: Group, poses: number[], index: number): void {
  const first = NUMBERS_OF_A_POSE * index;
  if (poses.length < first + NUMBERS_OF_A_POSE) return;
  position.fromArray(poses, first);
  rotation.fromArray(poses, first + 3);
  group.position.copy(position);
  group.quaternion.copy(rotation);
}
