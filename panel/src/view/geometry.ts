import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  PlaneGeometry,
  SphereGeometry,
} from 'three';
import type { Geom, Mesh } from '../protocol/scene_file';
import { floats_of, integers_of } from './mesh_data';

/** An infinite plane is drawn this far from its centre, m. */
export const INFINITE = 10;

/** Bodies round about z as MuJoCo has them; three.js has them about y. */
const QUARTER = Math.PI / 2;

export function mesh_geometry(mesh: Mesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(floats_of(mesh.vertices), 3));
  geometry.setIndex(new BufferAttribute(integers_of(mesh.triangles), 1));
  geometry.computeVertexNormals();
  return geometry;
}

/** The surface of a geom in its own frame. `meshes` are those of the scene, in its order. */
export function geom_geometry(geom: Geom, meshes: BufferGeometry[]): BufferGeometry {
  const [a = 0, b = 0, c = 0] = geom.size;
  switch (geom.type) {
    case 'plane':
      return new PlaneGeometry(2 * (a || INFINITE), 2 * (b || INFINITE));
    case 'box':
      return new BoxGeometry(2 * a, 2 * b, 2 * c);
    case 'sphere':
      return new SphereGeometry(a, 24, 16);
    case 'ellipsoid':
      return new SphereGeometry(1, 24, 16).scale(a, b, c);
    case 'capsule':
      return new CapsuleGeometry(a, 2 * b, 6, 20).rotateX(QUARTER);
    case 'cylinder':
      return new CylinderGeometry(a, a, 2 * b, 28).rotateX(QUARTER);
    case 'mesh':
      return meshes[geom.mesh ?? -1] ?? new BufferGeometry();
    default:
      return new BufferGeometry();
  }
}
