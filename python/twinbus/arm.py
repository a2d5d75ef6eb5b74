"""An arm on the bus: sent to places, told what it holds, its fingers opened and closed; of any robot, by the name of the arm."""
from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any, Sequence

from . import messages
from .bus import Bus, new_id, padded

if TYPE_CHECKING:
    from .simulation import RobotInfo

MOST_ARMS = 8
SIDES = {'left': 1, 'right': 2}  # numbers of arm_goal_t.side
SHAPES = {'box': (1, 3), 'sphere': (2, 1), 'cylinder': (3, 2)}  # number in obstacles_t, how many sizes
POSITION, POSE = 2, 3  # kinds of an arm_goal_t
POSE_MODE = 3
DONE, STOPPED = 2, 3  # arm_state of CONTROLLER_STATUS
WHY_NOT = {1: 'the hand cannot get there', 2: 'the arm touches something already', 3: 'the arm would touch something there',
           4: 'no way found in time', 5: 'cancelled', 6: 'not a goal for this robot'}
REPEATS, APART = 5, 0.05  # of what may be lost [s]


class Arm:
    """An arm of the robot that is heard on a bus.

    hand: 'left', 'right', or with `robot` any name of robot.hands (those of robot.yaml), or the number that arm_goal_t gives it (1 left,
    2 right, 3 to 8 the further ones).  robot: twinbus.Robot(FOLDER).info; grip() needs it.  ValueError for an arm that is not there."""

    def __init__(self, bus: Bus, hand: str | int, robot: RobotInfo | None = None) -> None:
        known = dict(robot.hands) if robot is not None else SIDES
        if isinstance(hand, str) and hand in SIDES and known and hand not in known:  # a robot with one hand uses it for either
            hand = next((name for name in SIDES if name in known), next(iter(known)))
        if isinstance(hand, str) and hand not in known:
            names = ', '.join(known) or 'none'
            raise ValueError(f'no arm called {hand}; there are: {names}' + ('' if robot else ' (of another name: give robot, twinbus.Robot(FOLDER).info)'))
        self.side = known[hand] if isinstance(hand, str) else hand
        if not 1 <= self.side <= MOST_ARMS:
            raise ValueError(f'arm {self.side}: 1 left, 2 right, 3 to {MOST_ARMS} the further ones')
        self.bus, self.robot = bus, robot
        self.name = next((name for name, side in known.items() if side == self.side), str(self.side))
        bus.listen('STATE', 'ARM_PATH', 'CONTROLLER_STATUS')

    def reach(self, position: Sequence[float], orientation: Sequence[float] | None = None, speed: float = 0.4, timeout: float = 30.0) -> None:
        """Brings the hand to a place of the ground frame [3], m, with an orientation [4], w x y z, if one is given, and returns when it is
        there.  speed: share of the joints' velocity limits, up to 1.  ValueError: there is no path, or the guard stopped the arm;
        TimeoutError: nobody answers, or it is not there in timeout [s]."""
        goal = messages.arm_goal_t()
        goal.goal_id, goal.side, goal.speed = new_id(), self.side, speed
        goal.kind = POSITION if orientation is None else POSE
        goal.position[:] = [float(x) for x in position]
        goal.orientation[:] = [1.0, 0.0, 0.0, 0.0] if orientation is None else [float(x) for x in orientation]
        path = None
        for _ in range(20):  # any datagram may be lost; the same goal_id is planned once
            self.bus.ask('ARM_GOAL', goal, self.bus.wait('STATE'))
            try:
                path = self.bus.wait('ARM_PATH', lambda piece: piece.goal_id == goal.goal_id, 0.5)
                break
            except TimeoutError:
                continue
        if path is None:
            raise TimeoutError('no planner answers; is one running? (./twinbus status)')
        if path.status != 0:
            raise ValueError(f'no path for arm {self.name}: {WHY_NOT.get(path.status, path.status)}'
                             + (f', by {path.miss:.3f} m' if path.status == 1 else ''))
        path_id = path.path_id
        self.bus.wait('CONTROLLER_STATUS', lambda status: status.arm_path_id == path_id)  # until it follows it; then it names none
        end = self.bus.wait('CONTROLLER_STATUS', lambda status: status.arm_state in (DONE, STOPPED) or status.arm_path_id not in (0, path_id), timeout)
        if end.arm_path_id not in (0, path_id):
            raise ValueError(f'another goal took the place of that of arm {self.name}')
        if end.arm_state == STOPPED:
            raise ValueError(f'the guard stopped arm {self.name}')

    def attach(self, shape: str, size: Sequence[float], position: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """Tells planner, controller and guard that the hand holds a 'box' (size: edges [3]), a 'sphere' (radius [1]) or a 'cylinder'
        (radius, length [2]), m, with its middle at `position` in the hand's frame.  They keep to it until release(); a program that
        starts later does not know of it: say it again then."""
        if shape not in SHAPES:
            raise ValueError(f'shape: {", ".join(SHAPES)}, not {shape!r}')
        number, sizes = SHAPES[shape]
        if len(size) != sizes or not all(0.001 <= x <= 3.0 for x in size):
            raise ValueError(f'size of a {shape}: {sizes} numbers from 0.001 to 3 m')
        piece = self._held()
        piece.count = 1
        piece.shape[0] = number
        piece.size[0][:] = [float(x) for x in size] + [0.0] * (3 - sizes)
        piece.position[0][:] = [float(x) for x in position]
        piece.attitude[0][:] = [1.0, 0.0, 0.0, 0.0]
        self._say(piece)

    def release(self) -> None:
        """Tells them that the hand is empty."""
        self._say(self._held())

    def grip(self, share: float, seconds: float = 0.5) -> None:
        """Asks for the fingers of the hand so far open: 0 closed, 1 open, in so many seconds.  Returns when the controller has taken it;
        fingers stop at what they grip.  ValueError of an arm without a gripper (robot.yaml, grippers)."""
        if not 0.0 <= share <= 1.0:
            raise ValueError(f'share of the opening: 0 (closed) to 1 (open), not {share:g}')
        if self.robot is None:
            raise ValueError('grip: give robot, twinbus.Robot(FOLDER).info, to Arm')
        if self.name not in self.robot.grippers:
            raise ValueError(f'arm {self.name} has no gripper; there is one on: {", ".join(self.robot.grippers) or "none"}')
        request, q, mask = messages.mode_request_t(), [0.0] * len(self.robot.joints), 0
        for joint, (closed, opened) in self.robot.grippers[self.name].items():
            k = self.robot.joints.index(joint)
            q[k] = closed + share * (opened - closed)
            mask |= 1 << k
        request.mode, request.duration, request.joint_mask, request.q = POSE_MODE, seconds, mask, padded(q)
        for _ in range(20):
            self.bus.ask('MODE_REQUEST', request, self.bus.wait('STATE'))
            try:
                self.bus.wait('CONTROLLER_STATUS', lambda status: status.mode_sequence == request.sequence, 0.5)
                return
            except TimeoutError:
                continue
        raise TimeoutError('the controller does not take the pose; is one running? (./twinbus status)')

    def _held(self) -> Any:
        piece = messages.obstacles_t()
        piece.scene_id = new_id()  # of this change; what is said again changes nothing
        piece.piece, piece.pieces = self.side - 1, 2 if self.side <= 2 else MOST_ARMS
        for row in range(len(piece.attitude)):
            piece.attitude[row][:] = [1.0, 0.0, 0.0, 0.0]
        return piece

    def _say(self, piece: Any) -> None:
        for _ in range(REPEATS):
            piece.utime = time.time_ns() // 1000
            self.bus.send('HELD', piece)
            time.sleep(APART)
