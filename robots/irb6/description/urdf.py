"""A chain of links as URDF."""

from math import pi

COLOURS = {"orange": "0.93 0.42 0.08 1", "dark": "0.16 0.16 0.18 1", "metal": "0.72 0.73 0.76 1"}
CYLINDER_TURN = {"x": (0, pi / 2, 0), "y": (pi / 2, 0, 0), "z": (0, 0, 0)}


def numbers(values):
    """The shortest text of each number that reads back the same, without the noise of sums."""
    tidy = (round(x, 12) if abs(x - round(x, 12)) < 1e-15 else x for x in values)
    return " ".join(repr(x + 0.0).removesuffix(".0") for x in tidy)


def text(robot, links):
    name = robot["type"]
    lines = [
        '<?xml version="1.0"?>',
        f"<!-- Written by robots/irb6/describe.py from {name}.toml: change that file. Link \"base\" is the base frame at",
        '     shoulder height, link "tool_frame" the tool frame. Effort is current_max times torque constant times gear at home.',
        f'     {robot["description"]["note"]} -->',
        f'<robot name="{name}">',
    ]
    lines += [f'  <material name="{colour}"><color rgba="{rgba}"/></material>' for colour, rgba in COLOURS.items()]
    lines.append("")
    for link in links:
        lines += _link(link)
    lines += ['  <link name="tool_frame"/>', ""]
    for parent, link in zip(links, links[1:]):
        lines += _joint(parent, link)
    tip = numbers(links[-1].sites["tool"])
    lines += ['  <joint name="tool_frame" type="fixed">', f'    <parent link="{links[-1].name}"/>',
              '    <child link="tool_frame"/>', f'    <origin xyz="{tip}" rpy="0 0 0"/>', "  </joint>", "</robot>", ""]
    return "\n".join(lines)


def _link(link):
    lines = [f'  <link name="{link.name}">']
    if link.mass:
        x, y, z = (numbers([value]) for value in link.inertia)
        lines += ["    <inertial>", f'      <origin xyz="{numbers(link.centre)}"/>',
                  f'      <mass value="{numbers([link.mass])}"/>',
                  f'      <inertia ixx="{x}" iyy="{y}" izz="{z}" ixy="0" ixz="0" iyz="0"/>', "    </inertial>"]
    for shape in link.shapes:
        if shape.is_box:
            solid, turn = f'<box size="{numbers([2 * x for x in shape.size])}"/>', (0, 0, 0)
        else:
            radius, length = numbers([shape.size[0]]), numbers([2 * shape.size[1]])
            solid, turn = f'<cylinder radius="{radius}" length="{length}"/>', CYLINDER_TURN[shape.axis]
        lines += ["    <visual>", f'      <origin xyz="{numbers(shape.centre)}" rpy="{numbers(turn)}"/>',
                  f"      <geometry>{solid}</geometry>", f'      <material name="{shape.colour}"/>', "    </visual>"]
    return lines + ["  </link>"]


def _joint(parent, link):
    joint = link.joint
    kind = "fixed" if joint is None else "prismatic" if joint.slides else "revolute"
    lines = [f'  <joint name="{joint.name if joint else "wrist"}" type="{kind}">',
             f'    <parent link="{parent.name}"/>', f'    <child link="{link.name}"/>',
             f'    <origin xyz="{numbers(link.position)}" rpy="{numbers(link.rotation[1])}"/>']
    if joint:
        lines += [f'    <axis xyz="{numbers(joint.axis)}"/>',
                  f'    <limit lower="{numbers([joint.low])}" upper="{numbers([joint.high])}"'
                  f' effort="{joint.effort:.3g}" velocity="{numbers([joint.speed])}"/>']
    return lines + ["  </joint>"]
