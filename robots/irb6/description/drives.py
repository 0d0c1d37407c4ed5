"""The transmission at home: the source of armature, damping and effort of the joints."""

from math import cos, pi, sin, sqrt


def screw_ratio(screw, angle):
    """d motor / d arm angle; see robots/irb6/transmission.hpp."""
    length = sqrt(screw["squares"] + screw["cosine"] * cos(angle) - screw["sine"] * sin(angle))
    return -screw["gear"] * (screw["cosine"] * sin(angle) + screw["sine"] * cos(angle)) / (2 * length)


def transmission_at_home(robot):
    """G at home: rows are motors, columns joints."""
    geometry, home = robot["geometry"], robot["home"]
    count = len(home)
    first = 1 if "track" in robot else 0  # the column's number
    lower_arm = home[first + 1]
    upper_arm = lower_arm + home[first + 2] + pi / 2
    g = [[0.0] * count for _ in range(count)]
    if first:
        g[0][0] = robot["track"]["gear"]
    g[first][first] = geometry["column_gear"]
    g[first + 1][first + 1] = screw_ratio(geometry["lower_arm_screw"], lower_arm)
    for joint in (1, 2):
        g[first + 2][first + joint] = screw_ratio(geometry["upper_arm_screw"], upper_arm)
    for joint in (1, 2, 3):  # the wrist roll turns along with the pitch motor
        g[first + 3][first + joint] = g[first + 4][first + joint] = geometry["wrist_pitch_gear"]
    g[first + 4][first + 4] = geometry["wrist_roll_gear"]
    if "tool_roll_gear" in geometry:
        g[first + 5][first + 5] = geometry["tool_roll_gear"]
    return g


def reflected(robot, joint, key):
    """Diagonal of G^T diag(key) G."""
    g = transmission_at_home(robot)
    return sum(axis[key] * g[motor][joint] ** 2 for motor, axis in enumerate(robot["axes"]))


def effort(robot, joint):
    axis = robot["axes"][joint]
    return axis["current_max"] * axis["torque_constant"] * abs(transmission_at_home(robot)[joint][joint])
