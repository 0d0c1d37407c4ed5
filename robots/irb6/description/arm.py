"""The IRb-6's family as chains of links. Shapes are for the eye and for contacts: the lengths that matter come from
[geometry], their thickness is the IRb-6's times `girth`."""

from description.drives import effort, reflected
from description.links import ELBOW, FLANGE_ACROSS, FLANGE_ALONG, STRAIGHT, Joint, Link, Shape, cylinder_between


def chain(robot):
    """All links from the base to the tool; each one's parent is the one before it."""
    geometry, drawing = robot["geometry"], robot["description"]
    g = drawing["girth"]
    links = [*_stand(robot, g), _column(g), _lower_arm(geometry, g), _upper_arm(geometry, g)]
    links += _wrist_of_three(geometry, g) if "tool_roll_gear" in geometry else _wrist_of_two(geometry, g)
    links.append(_tool(geometry["tool_translation"][2], links[-1].name == "wrist_roll", g))
    for number, (axis, link) in enumerate(zip(robot["axes"], [link for link in links if link.joint])):
        link.joint = _joint(robot, number, axis["name"], link.joint)
    for link in links[1:]:
        body = drawing[link.name]
        link.mass, link.centre, link.inertia = body["mass"], tuple(body["centre"]), tuple(body["inertia"])
    return links


def _joint(robot, number, name, axis):
    data = robot["axes"][number]
    margin = robot["description"]["track_stop_margin" if name == "track" else "stop_margin"]
    return Joint(name, axis, name == "track", data["position_min"], data["position_max"], margin,
                 data["velocity_max"], effort(robot, number), reflected(robot, number, "rotor_inertia"),
                 reflected(robot, number, "viscous_friction"))


def _scaled(g, name, size, centre=(0, 0, 0), axis="z", colour="orange"):
    return Shape(name, tuple(g * x for x in size), tuple(g * x for x in centre), axis, colour)


def _post(floor, g):
    return [cylinder_between("post", 0.15 * g, floor + 0.03 * g, -0.27 * g, "z"),
            _scaled(g, "bearing", (0.17, 0.02), (0, 0, -0.25), colour="dark")]


def _stand(robot, g):
    floor = -robot["description"]["shoulder_height"]
    if "track" not in robot:
        foot = Shape("foot", (0.24 * g, 0.24 * g, 0.015 * g), (0, 0, floor + 0.015 * g), colour="dark")
        return [Link("base", (0, 0, 0), STRAIGHT, [foot, *_post(floor, g)])]
    track = robot["axes"][0]
    low, high = track["position_min"] - 0.4, track["position_max"] + 0.4
    long, middle = (high - low) / 2, (high + low) / 2
    rails = [Shape(f"rail_{side}", (0.035, long, 0.06), (x, middle, floor + 0.07), colour="metal")
             for side, x in (("front", 0.16), ("back", -0.16))]
    beds = [Shape(f"bed_{i + 1}", (0.26, 0.04, 0.005), (0, low + 0.1 + i * (high - low - 0.2) / 3, floor + 0.005),
                  colour="dark") for i in range(4)]
    ends = [Shape(f"stop_{end}", (0.2, 0.02, 0.05), (0, y, floor + 0.18), colour="dark")
            for end, y in (("right", low + 0.02), ("left", high - 0.02))]
    screw = Shape("track_screw", (0.012, long - 0.04), (0, middle, floor + 0.09), "y", "metal")
    carriage = Shape("carriage", (0.25, 0.25, 0.03), (0, 0, floor + 0.165), colour="dark")
    return [Link("base", (0, 0, 0), STRAIGHT, [*rails, *beds, *ends, screw]),
            Link("track", (0, 0, 0), STRAIGHT, [carriage, *_post(floor + 0.165, g)], (0, 1, 0))]


def _column(g):
    return Link("column", (0, 0, 0), STRAIGHT, [
        _scaled(g, "turntable", (0.165, 0.035), (0, 0, -0.195)),
        _scaled(g, "cheek_left", (0.085, 0.018, 0.13), (0, 0.085, -0.04)),
        _scaled(g, "cheek_right", (0.085, 0.018, 0.13), (0, -0.085, -0.04)),
        _scaled(g, "shoulder", (0.055, 0.115), axis="y", colour="dark"),
        _scaled(g, "wrist_motors", (0.07, 0.12, 0.06), (-0.17, 0, -0.1), colour="dark"),
    ], (0, 0, 1))


def _lower_arm(geometry, g):
    length = geometry["lower_arm"]
    plate = (length / 2 + 0.0025 * g, 0.012 * g, 0.055 * g)
    return Link("lower_arm", (0, 0, 0), STRAIGHT, [
        Shape("lower_arm_left", plate, (length / 2, 0.05 * g, 0)),
        Shape("lower_arm_right", plate, (length / 2, -0.05 * g, 0)),
        Shape("lower_arm_web", (length / 2 - 0.0675 * g, 0.04 * g, 0.02 * g), (length / 2, 0, 0)),
        Shape("elbow", (0.05 * g, 0.075 * g), (length, 0, 0), "y", "dark"),
    ], (0, 1, 0))


def _upper_arm(geometry, g):
    length = geometry["upper_arm"]
    return Link("upper_arm", (geometry["lower_arm"], 0, 0), ELBOW, [
        _scaled(g, "counterweight", (0.075, 0.06, 0.055), (-0.19, 0, 0), colour="dark"),
        _scaled(g, "upper_arm_root", (0.16, 0.036, 0.06), (0.045, 0, 0)),
        cylinder_between("upper_arm_tube", 0.045 * g, 0.2 * g, length - 0.05 * g, "x"),
        Shape("fork_left", (0.05 * g, 0.01 * g, 0.035 * g), (length - 0.02 * g, 0.048 * g, 0)),
        Shape("fork_right", (0.05 * g, 0.01 * g, 0.035 * g), (length - 0.02 * g, -0.048 * g, 0)),
    ], (0, 1, 0))


def _wrist_pitch(geometry, g, end):
    return Link("wrist_pitch", (geometry["upper_arm"], 0, 0), STRAIGHT, [
        _scaled(g, "pitch_hub", (0.038, 0.062), axis="y", colour="dark"),
        cylinder_between("pitch_body", 0.036 * g, 0.02 * g, end, "x"),
    ], (0, 1, 0))


def _wrist_of_three(geometry, g):
    """Pitch, roll about the wrist, roll about the tool's axis at right angles to it."""
    length = geometry["wrist"]
    return [
        _wrist_pitch(geometry, g, length - 0.07 * g),
        Link("wrist_roll", (length, 0, 0), STRAIGHT, [
            _scaled(g, "roll_body", (0.034, 0.034), (-0.034, 0, 0), "x", "dark"),
            _scaled(g, "roll_head", (0.04, 0.04), axis="y"),
        ], (1, 0, 0)),
        Link("flange", (0, 0, 0), FLANGE_ACROSS, [
            _scaled(g, "flange", (0.032, 0.022), (0, 0, 0.06), colour="metal"),
        ], (0, 0, 1)),
    ]


def _wrist_of_two(geometry, g):
    """Pitch and roll about the tool's axis, which is the wrist's own."""
    length = geometry["wrist"]
    return [
        _wrist_pitch(geometry, g, length - 0.02 * g),
        Link("wrist_roll", (length, 0, 0), FLANGE_ALONG, [
            _scaled(g, "roll_body", (0.034, 0.012), (0, 0, -0.008), colour="dark"),
            _scaled(g, "flange", (0.032, 0.012), (0, 0, 0.016), colour="metal"),
        ], (0, 0, 1)),
    ]


def _tool(reach, five_axes, g):
    """A presser whose tip is at the default tool frame, beyond a force/torque sensor."""
    start = (0.036 if five_axes else 0.09) * g
    tip = reach - start
    return Link("tool", (0, 0, start), STRAIGHT, [
        _scaled(g, "force_torque", (0.038, 0.014), (0, 0, 0.006), colour="dark"),
        cylinder_between("rod", 0.016 * g, 0.02 * g, tip - 0.02 * g, "z", "metal"),
        cylinder_between("presser", 0.03 * g, tip - 0.02 * g, tip, "z", "dark"),
    ], sites={"wrist": (0, 0, 0), "tool": (0, 0, tip)})
