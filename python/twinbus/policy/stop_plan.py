"""The stop plan of a policy, one piece on STOP_PLAN: if its program falls silent, the source brings the joints to the policy's default posture
and holds them there (doc/protocol.md section 5).

A policy has soft servos, so the source waits for the command timeout before it follows, and then takes the servos of a stop."""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .. import messages
from .acting import Acting
from .robot import Robot

Array = NDArray[np.float64]
EVERY = 0.04          # [s]
LENGTH = 0.25         # from the first knot to the last; the posture is the same in both [s]
UNIT = 2e-4           # of q [rad or m]
SOFT = 0.5            # of the robot's own stiffness: below, set-points are not where the joints go
NEAR = 0.12           # a stiff policy's targets are so near to the posture, or there is no plan [rad or m]


class StopPlan:
    """Of one policy on one robot."""

    def __init__(self, controller: Acting) -> None:
        robot: Robot = controller.robot
        index = controller.observation.index
        self._posture = np.clip(controller.posture(np.zeros(len(robot.bus))), [joint.lower for joint in robot.bus],
                                [joint.upper for joint in robot.bus])
        self._index, self._period = index, robot.period
        self._mask = sum(1 << int(joint) for joint in index)
        self._own = np.array([joint.kp for joint in robot.bus])[index]
        self._next_ns, self._number = 0, 0

    def due(self, time_ns: int, target: Array, kp: Array) -> bool:
        """Whether one is to be sent now; target, kp: of this tick [joints on the bus]."""
        if 0 <= self._next_ns - time_ns <= 1e9 * EVERY:
            return False
        self._next_ns = time_ns + round(1e9 * EVERY)
        soft = bool(np.any(kp[self._index] < SOFT * self._own))
        return soft or float(np.abs(target - self._posture)[self._index].max()) < NEAR

    def message(self, command: messages.joint_command_t) -> messages.stop_plan_t:
        """Behind this command."""
        plan = messages.stop_plan_t()
        self._number += 1
        plan.run_id, plan.model_hash, plan.controller_id = command.run_id, command.model_hash, command.controller_id
        plan.tick, plan.term, plan.joint_count, plan.joints = command.tick, command.term, command.joint_count, self._mask
        plan.number, plan.piece, plan.pieces, plan.knot_count = self._number, 0, 1, 2
        plan.spacing = max(1, round(LENGTH / self._period))
        row = np.zeros(len(plan.q[0]), dtype=np.int16)
        row[:len(self._posture)] = np.clip(np.round(self._posture / UNIT), -32767, 32767).astype(np.int16)
        for knot in range(2):
            plan.q[knot][:] = row
        return plan
