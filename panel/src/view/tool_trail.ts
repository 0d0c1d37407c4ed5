import { BufferAttribute, BufferGeometry, Line, LineBasicMaterial, Vector3, type Object3D } from 'three';

const POINTS = 3000;
const SHORTEST = 0.001; // m between two points

/** The path of a tool frame, as a line. */
export class ToolTrail {
  readonly line: Line;
  private readonly positions = new Float32Array(3 * POINTS);
  private readonly attribute = new BufferAttribute(this.positions, 3);
  private count = 0;
  private readonly last = new Vector3(NaN);
  private readonly here = new Vector3();

  constructor(private readonly tool: Object3D, colour: number) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.attribute);
    geometry.setDrawRange(0, 0);
    this.line = new Line(geometry, new LineBasicMaterial({ color: colour }));
    this.line.frustumCulled = false;
  }

  /** Call it after the bodies have moved. */
  update(): void {
    this.tool.getWorldPosition(this.here);
    if (this.here.distanceTo(this.last) < SHORTEST) return;
    this.last.copy(this.here);
    if (this.count === POINTS) {
      this.positions.copyWithin(0, 3 * (POINTS / 4));
      this.count -= POINTS / 4;
    }
    this.here.toArray(this.positions, 3 * this.count++);
    this.attribute.needsUpdate = true;
    this.line.geometry.setDrawRange(0, this.count);
  }

  clear(): void {
    this.count = 0;
    this.line.geometry.setDrawRange(0, 0);
  }
}
