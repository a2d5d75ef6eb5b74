"""Left and right of a robot: which joints are each other's mirror image, and whether an angle changes its sign between them."""
from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from .robot import Robot

SIDES = (('left', 'right'), ('Left', 'Right'), ('LEFT', 'RIGHT'))
SHORT = re.compile(r'(^|_)([FRHfrh]?)([Ll])(?=_|LEG|ARM|leg|arm|hand|HAND)')


@dataclass
class Pair:
    left: str
    right: str
    sign: float   # q of the right one in the mirrored posture is sign * q of the left one


def _other(name: str) -> str | None:
    for left, right in SIDES:
        if left in name:
            return name.replace(left, right)
    found = SHORT.search(name)
    if found is None:
        return None
    letter = 'R' if found[3] == 'L' else 'r'
    return name[:found.start(3)] + letter + name[found.end(3):]


def pairs(robot: Robot) -> list[Pair]:
    """Joints on the bus that have a mirror image by name and by axis."""
    zero = np.zeros(len(robot.bus))
    found = []
    for joint in robot.bus:
        name = _other(joint.name)
        twin = robot.by_name.get(name) if name is not None else None
        if twin is None or twin.bus < 0 or twin.name == joint.name:
            continue
        axes = []
        for one in (joint, twin):
            there = robot.motion(one.parent, zero, zero)
            axes.append(there.rotation @ one.rotation @ one.axis)
        # an axis is a pseudovector: the mirror image across the plane of x and z turns x and z round
        image = axes[0] * np.array([-1.0, 1.0, -1.0])
        along = float(image @ axes[1])
        if abs(along) > 0.8:
            found.append(Pair(joint.name, twin.name, 1.0 if along > 0.0 else -1.0))
    return found
