import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Geom, GeomType } from '../../../panel/src/protocol/scene_file';
import { geom_geometry, mesh_geometry } from '../../../panel/src/view/geometry';
import { floats_of, integers_of } from '../../../panel/src/view/mesh_data';

function geom(type: GeomType, size: number[]): Geom {
  return { body: 0, type, size, position: [0, 0, 0], quaternion: [0, 0, 0, 1], colour: [1, 1, 1, 1] };
}

/** Half of the extent along each axis. */
function half_extent(geometry: ReturnType<typeof geom_geometry>): number[] {
  geometry.computeBoundingBox();
  const box = geometry.boundingBox;
  assert.ok(box);
  return [box.max.x, box.max.y, box.max.z].map((value) => Math.round(value * 1000) / 1000);
}

function base64(array: Float32Array | Uint32Array): string {
  return Buffer.from(array.buffer).toString('base64');
}

test('SizesAreThoseOfMujoco', () => {
  assert.deepEqual(half_extent(geom_geometry(geom('box', [0.1, 0.2, 0.3]), [])), [0.1, 0.2, 0.3]);
  assert.deepEqual(half_extent(geom_geometry(geom('cylinder', [0.1, 0.4, 0]), [])), [0.1, 0.1, 0.4]);
  assert.deepEqual(half_extent(geom_geometry(geom('capsule', [0.1, 0.4, 0]), [])), [0.1, 0.1, 0.5]);
  assert.deepEqual(half_extent(geom_geometry(geom('ellipsoid', [0.1, 0.2, 0.3]), [])), [0.1, 0.2, 0.3]);
  assert.deepEqual(half_extent(geom_geometry(geom('plane', [2, 3, 0.1]), [])), [2, 3, 0]);
});

test('APlaneOfSizeZeroIsLarge', () => {
  const [x = 0, y = 0] = half_extent(geom_geometry(geom('plane', [0, 0, 0.1]), []));
  assert.ok(x >= 5 && y >= 5);
});

test('ArraysOfMeshesAreDecoded', () => {
  assert.deepEqual([...floats_of(base64(new Float32Array([0.5, -2, 3])))], [0.5, -2, 3]);
  assert.deepEqual([...integers_of(base64(new Uint32Array([0, 1, 4294967295])))], [0, 1, 4294967295]);
});

test('AGeomWithAMeshHasItsTriangles', () => {
  const mesh = mesh_geometry({
    vertices: base64(new Float32Array([0, 0, 0, 1, 0, 0, 0, 2, 0])),
    triangles: base64(new Uint32Array([0, 1, 2])),
  });
  const geometry = geom_geometry({ ...geom('mesh', []), mesh: 0 }, [mesh]);
  assert.deepEqual(half_extent(geometry), [1, 2, 0]);
  assert.equal(geometry.index?.count, 3);
  assert.equal(geom_geometry({ ...geom('mesh', []), mesh: 7 }, [mesh]).index, null);
});
