"""Prints the MJCF of an ultrasonic sensor's beam: a fan of rays in its body's x-y plane, the x axis in the middle.

Usage: fan.py SENSOR RAYS BEAM_ANGLE    the deployment's name of the sensor, its keys `rays` and `beam_angle` (rad)
"""

import math
import sys


def main():
    sensor, rays, opening = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])
    if not (1 <= rays <= 16 and 0 <= opening <= 3):
        sys.exit(f"{rays} rays over {opening} rad, expected 1 to 16 over 0 to 3")
    angles = [opening * (i / (rays - 1) - 0.5) if rays > 1 else 0.0 for i in range(rays)]
    print("<!-- in the sensor's body -->")
    for i, angle in enumerate(angles):
        print(f'<site name="{sensor}_{i}" zaxis="{math.cos(angle):.9f} {math.sin(angle):.9f} 0" size="0.004"/>')
    print("<!-- in <sensor> -->")
    for i in range(rays):
        print(f'<rangefinder name="{sensor}/{i}" site="{sensor}_{i}"/>')


main()
