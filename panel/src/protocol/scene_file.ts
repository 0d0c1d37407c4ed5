/** `scene.json` of the panel's server: what does not change while the run lasts. z is up; metres and radians. */

export type Vector = [number, number, number];
export type Quaternion = [number, number, number, number]; // x, y, z, w

export interface Axis {
  name: string;
  unit: 'rad' | 'm';
  minimum: number | null; // null: the axis turns without end
  maximum: number | null;
  velocity: number;
}

export interface Robot {
  name: string;
  type: string;
  hardware: string;
  axes: Axis[];
  motors: string[];
  postures: string[];
  tools?: string[];
  bodies: number[];
  force_sensor: boolean;
  tool_frame: number | null;
  digital_outputs: number;
  analogue_outputs: number;
  digital_inputs?: number;
}

export interface Sensor {
  name: string;
  type: string;
  robot: string | null;
  channels: string[];
  frame: number | null;
}

export interface Camera {
  name: string; // of the sensor
  width: number; // pixels
  height: number;
  reason: string | null; // why it has no picture
}

export interface Body {
  name: string;
  parent: number;
}

export type GeomType = 'plane' | 'box' | 'sphere' | 'capsule' | 'cylinder' | 'ellipsoid' | 'mesh';

export interface Geom {
  body: number;
  type: GeomType;
  size: number[];
  position: Vector;
  quaternion: Quaternion;
  colour: [number, number, number, number];
  mesh?: number;
}

export interface Mesh {
  vertices: string; // base64 of float32, little endian: x y z
  triangles: string; // base64 of uint32, little endian
}

export interface Frame {
  name: string;
  body: number;
  position: Vector;
  quaternion: Quaternion;
}

export interface Scene {
  deployment: string;
  clock: string;
  servo_period: number;
  robots: Robot[];
  sensors: Sensor[];
  cameras: Camera[];
  bodies: Body[];
  geoms: Geom[];
  meshes: Mesh[];
  frames: Frame[];
}

const EMPTY: Scene = {
  deployment: '',
  clock: '',
  servo_period: 0.002,
  robots: [],
  sensors: [],
  cameras: [],
  bodies: [],
  geoms: [],
  meshes: [],
  frames: [],
};

/** The scene at `url`. A run whose world the server cannot compose has none: the rest of the page works without it. */
export async function load_scene(url: string): Promise<Scene> {
  const response = await fetch(url);
  if (response.status === 404) return EMPTY;
  if (!response.ok) throw new Error(`${url}: the server answers ${response.status}`);
  return { ...EMPTY, ...(await response.json()) } as Scene;
}
