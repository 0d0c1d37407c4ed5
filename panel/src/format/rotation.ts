/**
 * Roll, pitch and yaw (rad) of a quaternion x y z w: rotations about x, then y, then z of the base frame. At a pitch of
 * 90 degrees only the difference of the other two is determined; the roll is then 0.
 */
export function roll_pitch_yaw(x: number, y: number, z: number, w: number): [number, number, number] {
  const sine = 2 * (w * y - z * x);
  if (Math.abs(sine) > 0.9999995) return [0, (Math.sign(sine) * Math.PI) / 2, -2 * Math.sign(sine) * Math.atan2(x, w)];
  return [
    Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    Math.asin(Math.max(-1, Math.min(1, sine))),
    Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  ];
}
