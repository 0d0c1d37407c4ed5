"""A chain of links as MJCF for MuJoCo 2.2."""

from description.links import STRAIGHT
from description.urdf import COLOURS, numbers

AXES = {"x": "1 0 0", "y": "0 1 0"}


def text(robot, links):
    name = robot["type"]
    lines = [
        f"<!-- Written by robots/irb6/describe.py from {name}.toml: change that file. Root \"base\" is the base frame at",
        f'     shoulder height. {robot["description"]["note"]}',
        "     Armature and damping are the diagonals of G^T J G and G^T b G at home; the simulator replaces them by the",
        "     exact matrices of the present posture. The stops are stop_margin beyond the joint limits. -->",
        f'<mujoco model="{name}">',
        '  <compiler angle="radian"/>',
        "  <default>",
        f'    <default class="{name}">',
        f'      <geom rgba="{COLOURS["orange"]}" group="2"/>',
        '      <joint type="hinge" limited="true"/>',
        '      <site size="0.005" rgba="0.2 0.4 0.9 1" group="4"/>',
    ]
    for colour in ("dark", "metal"):
        lines += [f'      <default class="{name}_{colour}">', f'        <geom rgba="{COLOURS[colour]}"/>',
                  "      </default>"]
    lines += ["    </default>", "  </default>", "", "  <worldbody>"]
    for depth, link in enumerate(links):
        lines += ["    " + "  " * depth + line for line in _body(name, link, depth == 0)]
    for depth in reversed(range(len(links))):
        lines.append("    " + "  " * depth + "</body>")
    lines += ["  </worldbody>", "", "  <contact>",
              "    <!-- links near one another overlap by design; MuJoCo filters parent and child only, and not those of the",
              "         base -->"]
    lines += [f'    <exclude body1="{a}" body2="{b}"/>' for a, b in _touching(links)]
    lines += ["  </contact>", "", "  <actuator>", "    <!-- torque at the joint, N m; force, N, where it slides -->"]
    joints = [link.joint.name for link in links if link.joint]
    lines += [f'    <motor name="{joint}" joint="{joint}"/>' for joint in joints]
    return "\n".join(lines + ["  </actuator>", "</mujoco>", ""])


def _touching(links):
    names = [link.name for link in links]
    wrist = names.index("upper_arm")
    apart = {(0, 1)}
    for first in range(len(names)):
        for second in range(first + 2, min(first + (4 if first >= wrist else 3), len(names))):
            apart.add((first, second))
    return [(names[first], names[second]) for first, second in sorted(apart)]


def _body(robot, link, is_base):
    place = "" if not any(link.position) else f' pos="{numbers(link.position)}"'
    turn = "" if link.rotation == STRAIGHT else f' quat="{numbers(link.rotation[0])}"'
    lines = [f'<body name="{link.name}"{place}{turn}' + (f' childclass="{robot}">' if is_base else ">")]
    if link.mass:
        lines.append(f'  <inertial pos="{numbers(link.centre)}" mass="{numbers([link.mass])}"'
                     f' diaginertia="{numbers(link.inertia)}"/>')
    if link.joint:
        joint = link.joint
        lines.append(f'  <joint name="{joint.name}"' + (' type="slide"' if joint.slides else "") +
                     f' axis="{numbers(joint.axis)}" range="{numbers([joint.low - joint.stop_margin, joint.high + joint.stop_margin])}"'
                     f' armature="{joint.armature:.6g}" damping="{joint.damping:.6g}"/>')
    lines += [_site(name, place) for name, place in link.sites.items()]
    return lines + [_geom(robot, shape) for shape in link.shapes]


def _site(name, position):
    return f'  <site name="{name}"' + (f' pos="{numbers(position)}"' if any(position) else "") + "/>"


def _geom(robot, shape):
    colour = "" if shape.colour == "orange" else f' class="{robot}_{shape.colour}"'
    place = "" if not any(shape.centre) else f' pos="{numbers(shape.centre)}"'
    axis = "" if shape.is_box or shape.axis == "z" else f' zaxis="{AXES[shape.axis]}"'
    kind = "box" if shape.is_box else "cylinder"
    return f'  <geom name="{shape.name}"{colour} type="{kind}" size="{numbers(shape.size)}"{place}{axis}/>'
