import { Color, Vector3, type Object3D } from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';

const POINTS = 3000;
const SHORTEST = 0.002; // m between two points
const WIDTH = 2; // pixels

/** The path of a tool frame, as a line. */
export class ToolTrail {
  readonly line: Line2;
  private positions: number[] = [];
  private readonly last = new Vector3(NaN);
  private readonly here = new Vector3();
  private changed = false;

  constructor(
    private readonly tool: Object3D,
    colour: number,
  ) {
    this.line = new Line2(new LineGeometry(), new LineMaterial({ color: new Color(colour), linewidth: WIDTH }));
    this.line.frustumCulled = false;
    this.line.visible = false;
  }

  /** Takes the tool's position. Call it after the bodies have moved. */
  update(): void {
    this.tool.getWorldPosition(this.here);
    if (this.here.distanceTo(this.last) < SHORTEST) return;
    this.last.copy(this.here);
    if (this.positions.length >= 3 * POINTS) this.positions.splice(0, 3 * (POINTS / 4));
    this.positions.push(this.here.x, this.here.y, this.here.z);
    this.changed = true;
  }

  /** Before a picture: the line has all points that were taken. */
  prepare(): void {
    if (!this.changed) return;
    this.changed = false;
    this.line.visible = this.positions.length >= 6;
    if (!this.line.visible) return;
    this.line.geometry.dispose();
    this.line.geometry = new LineGeometry();
    this.line.geometry.setPositions(this.positions);
  }

  clear(): void {
    this.positions = [];
    this.changed = true;
  }
}
