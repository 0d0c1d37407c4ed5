"""The elements of a description: links in a chain, each with its joint, mass and shapes. Lengths in m, angles in rad."""

from dataclasses import dataclass, field
from math import pi

# A link's frame in its parent's: as MJCF and as URDF write it.
STRAIGHT = ((1, 0, 0, 0), (0, 0, 0))
ELBOW = ((0.5**0.5, 0, 0.5**0.5, 0), (0, pi / 2, 0))  # the upper arm's zero is at right angles to the lower arm
FLANGE_ACROSS = ((0.5, -0.5, -0.5, -0.5), (0, -pi / 2, -pi / 2))  # z across the wrist, x up
FLANGE_ALONG = ((0, 0.5**0.5, 0, 0.5**0.5), (0, -pi / 2, pi))  # z along the wrist, x up


@dataclass
class Shape:
    name: str
    size: tuple  # box: half edges; cylinder: radius, half length
    centre: tuple = (0, 0, 0)
    axis: str = "z"  # of a cylinder
    colour: str = "orange"

    @property
    def is_box(self):
        return len(self.size) == 3


def cylinder_between(name, radius, start, end, axis, colour="orange"):
    """A cylinder on a coordinate axis from `start` to `end`."""
    middle = (start + end) / 2
    centre = tuple(middle if each == axis else 0 for each in "xyz")
    return Shape(name, (radius, (end - start) / 2), centre, axis, colour)


@dataclass
class Joint:
    name: str
    axis: tuple
    slides: bool
    low: float
    high: float
    stop_margin: float  # by which the mechanical stops lie beyond these limits
    speed: float
    effort: float  # N m or N
    armature: float
    damping: float


@dataclass
class Link:
    name: str
    position: tuple
    rotation: tuple
    shapes: list
    joint: Joint | None = None  # without one it is fixed to its parent
    mass: float = 0
    centre: tuple = (0, 0, 0)
    inertia: tuple = (0, 0, 0)
    sites: dict = field(default_factory=dict)  # name: position
