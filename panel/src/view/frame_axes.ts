import { AxesHelper, Color, Group } from 'three';
import type { Frame } from '../protocol/scene_file';
import type { Bodies } from './bodies';

const LENGTH = 0.1; // m
const [RED, GREEN, BLUE] = [new Color(0xd62828), new Color(0x15923f), new Color(0x2f6bff)];

/** The scene's frames on their bodies: red x, green y, blue z. */
export class FrameAxes {
  private readonly axes: AxesHelper[];
  readonly anchors: Group[];

  constructor(frames: Frame[], bodies: Bodies) {
    this.anchors = frames.map((frame) => {
      const anchor = new Group();
      anchor.name = frame.name;
      anchor.position.set(...frame.position);
      anchor.quaternion.set(...frame.quaternion);
      bodies.body(frame.body)?.add(anchor);
      return anchor;
    });
    this.axes = this.anchors.map((anchor) => {
      const axes = new AxesHelper(LENGTH);
      axes.setColors(RED, GREEN, BLUE);
      anchor.add(axes);
      return axes;
    });
  }

  show(visible: boolean): void {
    for (const axes of this.axes) axes.visible = visible;
  }
}
