"""The robot that a policy is bound to, by the names of its joints: from the texts on the bus (MODEL_TEXT) or from its folder.

Joints on the bus are the actuated ones that mimic nobody and that robot.yaml does not fix, in the order of the URDF."""
from __future__ import annotations

import math
import pathlib
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field
from typing import Any, Mapping

import numpy as np
from numpy.typing import NDArray

from .. import home
from .errors import PolicyError

Array = NDArray[np.float64]
IMU_PLACE = 'imu of robot.yaml'  # the link that robot.yaml describes
MOVING = ('revolute', 'continuous', 'prismatic')


@dataclass
class RobotJoint:
    """A joint of the URDF.  origin: rotation [3 x 3] and place [m] of its frame in the parent link; axis in its own frame."""
    name: str
    kind: str
    parent: str
    child: str
    rotation: Array
    place: Array
    axis: Array
    lower: float = -math.inf   # [rad or m]
    upper: float = math.inf
    effort: float = math.inf   # [N m or N]
    velocity: float = math.inf  # [rad/s or m/s]
    mimics: bool = False
    bus: int = -1              # index in STATE.q, -1 not on the bus
    kp: float = 0.0            # of robot.yaml [N m/rad]
    kd: float = 0.0            # [N m s/rad]
    armature: float = 0.0      # rotor inertia at the joint [kg m^2]


@dataclass
class Motion:
    """A link seen from the base link: rotation, place [m], turning and moving of it against the base, in the base's axes."""
    rotation: Array
    place: Array
    turning: Array
    moving: Array


@dataclass
class Robot:
    name: str
    joints: list[RobotJoint]        # all, in the order of the URDF
    base: str                       # the link that is nobody's child
    imu: str                        # link or frame of the IMU
    period: float = 0.002           # [s]
    poses: dict[str, dict[str, float]] = field(default_factory=dict)  # of the SRDF

    def __post_init__(self) -> None:
        self.bus = sorted((joint for joint in self.joints if joint.bus >= 0), key=lambda joint: joint.bus)
        self.by_name = {joint.name: joint for joint in self.joints}
        self._parent = {joint.child: joint for joint in self.joints}
        self._chains: dict[str, list[RobotJoint]] = {}

    def names(self) -> list[str]:
        """Of the joints on the bus, in the order of STATE.q."""
        return [joint.name for joint in self.bus]

    def chain(self, link: str) -> list[RobotJoint]:
        """The joints from the base to the link.  PolicyError when there is no such link."""
        if link not in self._chains:
            if link != self.base and link not in self._parent:
                raise PolicyError(f'{self.name}: no link {link!r}; a frame is base, imu or a link of its URDF')
            way: list[RobotJoint] = []
            at = link
            while at != self.base:
                way.append(self._parent[at])
                at = way[-1].parent
            self._chains[link] = way[::-1]
        return self._chains[link]

    def motion(self, link: str, q: Array, qd: Array) -> Motion:
        """Of the link against the base; q, qd [joints on the bus]."""
        rotation, place = np.eye(3), np.zeros(3)
        turning, moving = np.zeros(3), np.zeros(3)
        for joint in self.chain(link):
            step = rotation @ joint.place
            moving = moving + np.cross(turning, step)
            place = place + step
            rotation = rotation @ joint.rotation
            if joint.bus < 0 or joint.kind not in MOVING:
                continue
            axis = rotation @ joint.axis
            if joint.kind == 'prismatic':
                place = place + axis * q[joint.bus]
                moving = moving + axis * qd[joint.bus] + np.cross(turning, axis * q[joint.bus])
            else:
                rotation = rotation @ about(joint.axis, float(q[joint.bus]))
                turning = turning + axis * qd[joint.bus]
        return Motion(rotation, place, turning, moving)

    def breadth_first(self, wanted: set[str]) -> list[str]:
        """Those of the wanted joints, level by level from the base, as Isaac Lab numbers them; other joints count as rigid."""
        children: dict[str, list[RobotJoint]] = {}
        for joint in self.joints:
            children.setdefault(joint.parent, []).append(joint)

        def below(link: str) -> list[RobotJoint]:
            found: list[RobotJoint] = []
            for joint in children.get(link, []):
                found += [joint] if joint.name in wanted else below(joint.child)
            return found

        level, order = below(self.base), list[str]()
        while level:
            order += [joint.name for joint in level]
            level = [deeper for joint in level for deeper in below(joint.child)]
        return order


def about(axis: Array, angle: float) -> Array:
    """Rotation [3 x 3] about a unit axis by an angle [rad]."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    rotation: Array = np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross
    return rotation


def _from_rpy(roll: float, pitch: float, yaw: float) -> Array:
    rotation: Array = about(np.array([0.0, 0.0, 1.0]), yaw) @ about(np.array([0.0, 1.0, 0.0]), pitch) @ about(np.array([1.0, 0.0, 0.0]), roll)
    return rotation


def _numbers(text: str | None, default: str) -> Array:
    values = np.array([float(word) for word in (text or default).split()])
    if values.shape != (3,) or not np.all(np.isfinite(values)):
        raise PolicyError(f'URDF: {text!r} is not three numbers')
    return values


def _joint(element: xml.Element) -> RobotJoint:
    origin = element.find('origin')
    roll, pitch, yaw = _numbers(None if origin is None else origin.get('rpy'), '0 0 0')
    axis_element, limit = element.find('axis'), element.find('limit')
    axis = _numbers(None if axis_element is None else axis_element.get('xyz'), '1 0 0')
    length = float(np.linalg.norm(axis))
    joint = RobotJoint(
        name=element.get('name', ''), kind=element.get('type', ''), parent=_link(element, 'parent'), child=_link(element, 'child'),
        rotation=_from_rpy(roll, pitch, yaw), place=_numbers(None if origin is None else origin.get('xyz'), '0 0 0'),
        axis=axis / length if length > 0.0 else axis,
        mimics=element.find('mimic') is not None)
    if limit is not None:
        if joint.kind != 'continuous':
            joint.lower, joint.upper = float(limit.get('lower', '0')), float(limit.get('upper', '0'))
        joint.effort, joint.velocity = float(limit.get('effort', 'inf')), float(limit.get('velocity', 'inf'))
    return joint


def _link(element: xml.Element, which: str) -> str:
    found = element.find(which)
    return '' if found is None else found.get('link', '')


def _poses(srdf: str) -> dict[str, dict[str, float]]:
    poses: dict[str, dict[str, float]] = {}
    if srdf.strip():
        for state in xml.fromstring(srdf).iter('group_state'):
            angles = poses.setdefault(state.get('name', ''), {})
            angles.update({joint.get('name', ''): float(joint.get('value', '0').split()[0]) for joint in state.iter('joint')})
    return poses


def from_texts(urdf: str, srdf: str, settings: Mapping[str, Any]) -> Robot:
    """settings: robot.yaml as a map.  PolicyError when the texts are no robot."""
    try:
        root = xml.fromstring(urdf)
        joints = [_joint(element) for element in root.findall('joint')]
        poses = _poses(srdf)
    except (xml.ParseError, ValueError) as error:
        raise PolicyError(f'the URDF or SRDF of the robot cannot be read: {error}; ./twinbus check ROBOT says more') from None
    fixed = set(settings.get('fixed_joints') or [])
    number = 0
    for joint in joints:
        if joint.kind in MOVING and not joint.mimics and joint.name not in fixed:
            joint.bus = number
            number += 1
    by_name = {joint.name: joint for joint in joints}
    for servo in settings.get('servos') or []:
        for name in servo.get('joints') or []:
            if name in by_name:
                by_name[name].kp = float(servo.get('kp', by_name[name].kp))
                by_name[name].kd = float(servo.get('kd', by_name[name].kd))
                by_name[name].armature = float(servo.get('rotor_inertia', by_name[name].armature))
    imu = settings.get('imu')
    if isinstance(imu, Mapping):  # a place in a link: one more link there
        joints.append(RobotJoint('imu place', 'fixed', str(imu.get('frame', '')), IMU_PLACE, _from_rpy(*(float(v) for v in imu.get('rpy') or (0.0, 0.0, 0.0))),
                                 np.array([float(v) for v in imu.get('at') or (0.0, 0.0, 0.0)]), np.array([1.0, 0.0, 0.0])))
        imu = IMU_PLACE
    children = {joint.child for joint in joints}
    bases = [link.get('name', '') for link in root.findall('link') if link.get('name', '') not in children]
    base = bases[0] if bases else ''
    return Robot(root.get('name', 'robot'), joints, base, str(imu or base), float(settings.get('period', 0.002)), poses)


def folder_of(name: str) -> pathlib.Path:
    """The folder of a robot: a name under config/robots, or a path."""
    for folder in (pathlib.Path(name), home.config() / 'robots' / name):
        if (folder / 'robot.yaml').is_file():
            return folder
    raise PolicyError(f'no robot {name!r}: a folder with a robot.yaml, or a name under {home.config() / "robots"}')


def from_folder(name: str) -> Robot:
    """The robot of a folder, or of a name under config/robots."""
    from .yaml_file import load_map
    folder = folder_of(name)
    settings = load_map(folder / 'robot.yaml')
    srdf = str(settings.get('srdf') or '')
    try:
        return from_texts((folder / str(settings.get('urdf'))).read_text(), (folder / srdf).read_text() if srdf else '', settings)
    except OSError as error:
        raise PolicyError(f'{folder}: {error.strerror}: {error.filename}') from None
