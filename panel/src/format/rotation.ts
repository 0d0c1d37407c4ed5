/** Roll, pitch and yaw (rad) of a quaternion x y z w: rotations about x, then y, then z of the base frame. */
export function roll_pitch_yaw(x: number, y: number, z: number, w: number): [number, number, number] {
  const sine = 2 * (w * y - z * x);
  return [
    Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    Math.asin(Math.max(-1, Math.min(1, sine))),
    Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  ];
}
