"""A policy bound to a robot: observation in, targets of its joints out.  It knows no bus and no clock."""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import followed
from .errors import PolicyError
from .follower import Follower
from .network import Network
from .observation import Measured, Observation
from .robot import Robot
from .spec import Spec

Array = NDArray[np.float64]


class Controller:
    """PolicyError when specification, network and robot do not fit one another."""

    def __init__(self, spec: Spec, robot: Robot, network: Network) -> None:
        self.spec, self.robot, self.network = spec, robot, network
        self.observation = Observation(spec, robot)
        self.follower = Follower(followed.load(spec, robot, network), spec.period) if spec.follows else None
        self.observation.follower = self.follower
        if network.observation_size != spec.observation_size():
            parts = ', '.join(f'{term.term} {spec.term_size(term)}{" x %d" % term.history if term.history > 1 else ""}'
                              for term in spec.observations)
            raise PolicyError(f'{spec.source or spec.name}: its observations are {spec.observation_size()} numbers ({parts}), '
                              f'the network reads {network.observation_size}')
        if network.action_size != len(spec.joints):
            raise PolicyError(f'{spec.source or spec.name}: it has {len(spec.joints)} joints, the network moves {network.action_size}')
        joints = spec.joints
        self._scale = np.array([joint.scale for joint in joints])
        self._offset = np.array([joint.default if joint.offset is None else joint.offset for joint in joints])
        self._low = np.array([-np.inf if joint.clip is None else joint.clip[0] for joint in joints])
        self._high = np.array([np.inf if joint.clip is None else joint.clip[1] for joint in joints])
        count = len(robot.names())
        self.kp, self.kd = np.zeros(count), np.zeros(count)  # per joint on the bus
        for number, joint in enumerate(robot.bus):
            self.kp[number], self.kd[number] = joint.kp, joint.kd
        index = self.observation.index
        self.kp[index], self.kd[index] = [joint.kp for joint in joints], [joint.kd for joint in joints]
        ranges = [spec.commands.get(key, (-2.0, 2.0)) for key in ('vx', 'vy', 'wz')]
        self._least, self._most = np.array([r[0] for r in ranges]), np.array([r[1] for r in ranges])

    @property
    def needs_velocity(self) -> bool:
        """Whether it reads the velocity of the base."""
        return self.observation.needs_velocity

    @property
    def playing(self) -> bool:
        """Whether it follows a motion now."""
        return self.follower is not None

    @property
    def ended(self) -> bool:
        """Whether that has come to its last frame, which is held."""
        return self.follower is not None and self.follower.ended

    @property
    def has_motion_beside(self) -> bool:
        """Whether play() changes anything (repertoire.py)."""
        return False

    def play(self, asked: bool) -> None:
        """A motion is wanted, or none; of one policy alone nothing changes."""

    def reset(self) -> None:
        """As at the first tick."""
        self.observation.reset()
        self.network.reset()

    def limited(self, command: Array) -> Array:
        """A velocity that the policy was trained for; zero stays zero."""
        return np.where(command == 0.0, 0.0, np.clip(command, self._least, self._most))

    def posture(self, q: Array) -> Array:
        """The policy's default posture; joints that it does not have stay as in q [joints on the bus]."""
        target = np.array(q, dtype=np.float64)
        target[self.observation.index] = self.observation.default
        return target

    def act(self, observation: Array) -> tuple[Array, Array]:
        """observation -> action as the network says it, and target per joint of the policy [rad].

        PolicyError when numbers are missing or are none."""
        if not np.all(np.isfinite(observation)):
            raise PolicyError(f'number {int(np.argmin(np.isfinite(observation)))} of the observation is not finite')
        self.network.time_step = 0 if self.follower is None else self.follower.frame
        action = self.network.run(observation)
        if action.shape != (len(self.spec.joints),):
            raise PolicyError(f'the network gave {action.size} numbers, {len(self.spec.joints)} joints are moved')
        if not np.all(np.isfinite(action)):
            joint = self.spec.joints[int(np.argmin(np.isfinite(action)))].name
            raise PolicyError(f'the action of {joint} is not a finite number')
        if self.spec.action_clip is not None:
            action = np.clip(action, self.spec.action_clip[0], self.spec.action_clip[1])
        with np.errstate(over='ignore'):
            target = np.clip(self._offset + self._scale * action, self._low, self._high)
        if not np.all(np.isfinite(target)):
            joint = self.spec.joints[int(np.argmin(np.isfinite(target)))].name
            raise PolicyError(f'the target of {joint} is not a finite number')
        return action, target

    def step(self, measured: Measured, command: Array) -> Array:
        """Observation, action, memory of one tick: the target per joint of the policy [rad]."""
        command = self.limited(command)
        action, target = self.act(self.observation.build(measured, command))
        self.observation.done(action, command)
        return target
