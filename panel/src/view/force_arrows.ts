import { ArrowHelper, Vector3, type Object3D } from 'three';
import type { Scene } from '../protocol/scene_file';
import type { Store } from '../state/store';

export const METRES_PER_NEWTON = 0.005;
const LONGEST = 0.6; // m
const SMALLEST = 0.5; // N
const COLOUR = 0xd97706;

interface Arrow {
  helper: ArrowHelper;
  force(store: Store): (number | null | undefined)[];
}

/** The forces of the force sensors, in their frames: what the environment exerts on the tool. */
export class ForceArrows {
  private readonly arrows: Arrow[] = [];
  private readonly direction = new Vector3();

  constructor(scene: Scene, anchors: Object3D[]) {
    for (const robot of scene.robots) {
      const anchor = anchors[robot.tool_frame ?? -1];
      if (robot.force_sensor && anchor) this.add(anchor, (store) => store.robots.get(robot.name)?.wrench ?? []);
    }
    for (const sensor of scene.sensors) {
      const anchor = anchors[sensor.frame ?? -1];
      const of_robot = scene.robots.some((robot) => robot.name === sensor.robot && robot.force_sensor);
      if (!anchor || of_robot || !sensor.channels.includes('force_x')) continue;
      this.add(anchor, (store) => {
        const values = store.readings.get(sensor.name)?.values ?? {};
        return [values['force_x'], values['force_y'], values['force_z']];
      });
    }
  }

  update(store: Store, visible: boolean): void {
    for (const arrow of this.arrows) {
      const [x, y, z] = arrow.force(store);
      this.direction.set(x ?? 0, y ?? 0, z ?? 0);
      const newtons = this.direction.length();
      arrow.helper.visible = visible && newtons >= SMALLEST;
      if (!arrow.helper.visible) continue;
      const length = Math.min(LONGEST, newtons * METRES_PER_NEWTON);
      arrow.helper.setDirection(this.direction.normalize());
      arrow.helper.setLength(length, Math.min(0.03, 0.4 * length), Math.min(0.02, 0.3 * length));
    }
  }

  private add(anchor: Object3D, force: Arrow['force']): void {
    const helper = new ArrowHelper(new Vector3(0, 0, 1), new Vector3(), 0.1, COLOUR);
    helper.visible = false;
    anchor.add(helper);
    this.arrows.push({ helper, force });
  }
}
