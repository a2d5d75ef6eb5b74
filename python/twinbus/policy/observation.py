"""The observation of a policy: named terms of what the robot measures, clipped, scaled and kept for as many ages as each wants."""
from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .errors import PolicyError
from .follower import Follower
from .robot import Robot
from .rotation import rotation_of
from .spec import Spec, Term

Array = NDArray[np.float64]
REST = 0.01  # a command below counts as zero [m/s, rad/s]


@dataclass
class Measured:
    """What one tick says.  Arrays of joints are in the order of STATE."""
    q: Array                   # [rad or m]
    qd: Array                  # [rad/s or m/s]
    attitude: Array            # w x y z, IMU in world
    gyro: Array                # [rad/s], axes of the IMU
    base_velocity: Array | None = None  # of the origin of the base link, axes of the base link [m/s]; None: nobody says it


class Observation:
    """Of one policy on one robot.  PolicyError when a joint or a frame of the specification is not there."""

    def __init__(self, spec: Spec, robot: Robot) -> None:
        self.spec, self.robot = spec, robot
        bus = {name: number for number, name in enumerate(robot.names())}
        missing = [name for name in spec.names() if name not in bus]
        if missing:
            raise PolicyError(f'{spec.source or spec.name}: {robot.name} has no joint {", ".join(missing[:3])}'
                              f'{" and %d more" % (len(missing) - 3) if len(missing) > 3 else ""}; it has {", ".join(robot.names()[:3])}, ...')
        self.index = np.array([bus[name] for name in spec.names()], dtype=np.intp)  # in STATE, per joint of the policy
        self.default = np.array([joint.default for joint in spec.joints])
        own = {name: number for number, name in enumerate(spec.names())}
        self._chosen = [np.array([own[name] for name in term.joints] or range(len(own)), dtype=np.intp) for term in spec.observations]
        self._scale = [np.array(term.scale) for term in spec.observations]
        for term in spec.observations:
            if term.frame not in ('base', 'imu'):
                robot.chain(term.frame)
        self.needs_velocity = any(term.term == 'base_linear_velocity' for term in spec.observations)
        if spec.follows:
            robot.chain(spec.anchor)
        self.follower: Follower | None = None
        self.reset()

    def reset(self) -> None:
        """Forgets the past, as at the first tick."""
        count = len(self.spec.joints)
        self.last_action = np.zeros(count)
        phase = self.spec.phase
        self.phase = np.array(phase.start if phase is not None else [], dtype=np.float64)
        self._resting = False
        self._clock = 0.0  # of gait_phase, in turns
        self._past: list[deque[Array]] = [deque(maxlen=term.history) for term in self.spec.observations]
        if self.follower is not None:
            self.follower.reset()

    def _turn_phase(self, command: Array) -> None:
        phase = self.spec.phase
        if phase is None:
            return
        if phase.rest is not None and float(np.abs(command).max()) < REST:
            self.phase, self._resting = np.full(len(phase.start), phase.rest), True
            return
        if self._resting:
            self.phase, self._resting = np.array(phase.start, dtype=np.float64), False
            return
        turned = self.phase + 2.0 * math.pi * phase.frequency * self.spec.period
        self.phase = np.mod(turned + math.pi, 2.0 * math.pi) - math.pi

    def build(self, measured: Measured, command: Array) -> Array:
        """The observation of this tick [observation_size]; command: vx, vy [m/s], wz [rad/s].

        PolicyError when the policy wants the velocity of the base and nobody says it."""
        if self.spec.phase is not None and self.spec.phase.advance == 'before':
            self._turn_phase(command)
        ages: list[list[Array]] = []
        for number, term in enumerate(self.spec.observations):
            value = self._value(term, self._chosen[number], measured, command)
            if term.clip is not None:
                value = np.clip(value, term.clip[0], term.clip[1])
            value = value * self._scale[number]
            past = self._past[number]
            if not past:
                first = value if self.spec.history_begin == 'repeat' else np.zeros_like(value)
                past.extend([first] * (term.history - 1))
            past.append(value)
            ages.append(list(past) if self.spec.history_order == 'oldest_first' else list(past)[::-1])
        if self.spec.history_by == 'term':
            return np.concatenate([value for of_term in ages for value in of_term])
        return np.concatenate([of_term[age] for age in range(len(ages[0])) for of_term in ages])

    def done(self, action: Array, command: Array) -> None:
        """After the action of this tick: what the next observation remembers of it."""
        self.last_action = action
        if self.spec.phase is not None and self.spec.phase.advance == 'after':
            self._turn_phase(command)
        if self.follower is not None:
            self.follower.advance()

    def _value(self, term: Term, chosen: NDArray[np.intp], measured: Measured, command: Array) -> Array:
        name = term.term
        if name == 'joint_position':
            value = measured.q[self.index] - (self.default if term.relative else 0.0)
            return np.asarray(value[chosen])
        if name == 'joint_velocity':
            return np.asarray(measured.qd[self.index][chosen])
        if name == 'last_action':
            return np.asarray(self.last_action[chosen])
        if name == 'velocity_command':
            return command
        if name == 'command_linear_velocity':
            return command[:2]
        if name == 'command_angular_velocity':
            return command[2:]
        if name == 'phase_sin':
            return np.sin(self.phase)
        if name == 'phase_cos':
            return np.cos(self.phase)
        if name == 'gait_phase':
            self._clock = (self._clock + self.spec.period / term.period) % 1.0
            return np.array([math.sin(2.0 * math.pi * self._clock), math.cos(2.0 * math.pi * self._clock)])
        if name == 'constant':
            return np.array(term.values)
        if name.startswith('motion_'):
            return self._of_motion(name, measured)
        return self._framed(term, measured)

    def _of_motion(self, name: str, measured: Measured) -> Array:
        if self.follower is None:
            raise PolicyError(f'{self.spec.source or self.spec.name}: the policy follows a motion, and none was given to it')
        if name == 'motion_joints':
            return self.follower.joints()
        imu = self.robot.motion(self.robot.imu, measured.q, measured.qd).rotation
        there = self.robot.motion(self.spec.anchor, measured.q, measured.qd).rotation
        return self.follower.orientation(rotation_of(measured.attitude) @ imu.T @ there)

    def _framed(self, term: Term, measured: Measured) -> Array:
        """Of the base link or another: seen from where the IMU is, through the joints between."""
        down = rotation_of(measured.attitude).T @ np.array([0.0, 0.0, -1.0])  # axes of the IMU
        imu = self.robot.motion(self.robot.imu, measured.q, measured.qd)
        turning = imu.rotation @ measured.gyro - imu.turning  # of the base, axes of the base
        frame = self.robot.imu if term.frame == 'imu' else self.robot.base if term.frame == 'base' else term.frame
        there = self.robot.motion(frame, measured.q, measured.qd)
        if term.term == 'projected_gravity':
            return np.asarray(there.rotation.T @ imu.rotation @ down)
        if term.term == 'base_angular_velocity':
            return np.asarray(there.rotation.T @ (turning + there.turning))
        if measured.base_velocity is None:
            raise PolicyError('the policy reads the velocity of the base, and neither ESTIMATE nor TRUTH has come; '
                              './twinbus status says who sends them')
        return np.asarray(there.rotation.T @ (measured.base_velocity + np.cross(turning, there.place) + there.moving))
