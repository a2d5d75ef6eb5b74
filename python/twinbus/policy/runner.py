"""The process: STATE in, COMMAND out, as any other controller.

It answers every STATE; a new action comes every period of the policy, and until then the last target holds.  A balanced stop brings the
velocity to zero, says "stopping" (flag 1) until the robot rests, 2 s at most, and then falls silent, so that the source holds.  An action
that is no number, the wrong number of them, an inference that fails: the robot is stopped (hold), with that reason.  An inference that is
late still balances: the stop is a balanced one, until it takes too long for that.  Beside commands goes a stop plan (stop_plan.py)."""
from __future__ import annotations

import math
import os
import time
from dataclasses import dataclass, field
from typing import Any, Callable, NoReturn

import numpy as np
from numpy.typing import NDArray

from .. import messages
from ..bus import Bus, decode, new_id
from ..channels import TYPES
from ..home import as_typed
from .acting import Acting
from .binding import Binding
from .errors import PolicyError
from .inference import Inference
from .observation import Measured
from .operator import PLAYED, Operator
from .robot import Robot
from .stop_plan import StopPlan

Array = NDArray[np.float64]
STOPPING, NOT_FADED = 1, 2       # flags of joint_command_t
BALANCED, HOLD = 1, 2            # kinds of stop_t
BY_CONTROLLER, COMMAND_TIMEOUT = 6, 7  # reasons of it
CONTROLLER, ALARM, NOTE = 4, 2, 0  # kind of a process, severities
LOCK_STEP, FREE_RUN, PAUSED = 2, 3, 4  # paces of SOURCE_STATUS
STOP_TIME = 1.9                  # longest time in which a balanced stop is answered [s]
AT_REST = 0.05                   # slower the base rests [m/s]
RECENT = 50                      # ticks after which a velocity is nobody's
FADE = 0.3                       # from a posture that was held before the policy was known to the policy's own [s]
BACK = 0.5                       # how fast joints go back that only a motion moves [rad/s, m/s]
FAR = 1.0                        # of the policy's posture: a robot that is found so is brought there gently [rad]
FAR_SLIDE = 0.3                  # the same of a joint that slides [m]
FIRST_ESTIMATE = 0.1             # in which the velocity of the base must have come for the first time [s]
TOO_LATE = 0.1                   # an inference that balances nothing any more [s]
ASKS_EVERY = 0.02                # a stop, until STATE shows it [s]
PATIENCE = 2.0                   # for an inference while the robot's time stands still [s]
FIRST_GUARD, GUARD = 10.0, 1.0   # for the first report of a guard that is waited for, and for the next ones [s]
LISTENED = ('STATE', 'SOURCE_STATUS', 'MODEL_TEXT', 'WALK', 'GAMEPAD', 'MODE_REQUEST', 'ESTIMATE', 'TRUTH')


class Stopped(Exception):
    """The policy itself asked for the stop: why."""


class Ended(Exception):
    """The stop that ends an orderly run has come to its end."""


@dataclass
class Options:
    """Of a run."""
    command: tuple[float, float, float] = (0.0, 0.0, 0.0)  # vx, vy [m/s], wz [rad/s], while nobody says another
    wait: float = 0.3            # in which the default posture is held at the beginning [s]
    fade: bool | None = None     # False: flag 2, the first command is not faded in; None: faded in where a joint is FAR away
    duration: float = float('inf')  # of the robot's time [s]
    fifo: bool = False           # has FIFO priority; HEARTBEAT tells
    guarded: bool = False        # a STATE is answered once GUARD has judged it: a lock-step waits for no guard
    say: Callable[[str], None] = field(default=lambda sentence: print(f'policy: {sentence}', flush=True))


class Runner:
    """bind: makes the controller for a robot; called when the robot is known.  robot: known before; else it comes from the bus, and bind is
    called in a thread (binding.py).  A STATE that comes between is answered by the posture that it found, with the robot's own gains."""

    def __init__(self, bus: Bus, bind: Callable[[Robot], Acting], options: Options, robot: Robot | None = None) -> None:
        self.bus, self.options, self.id = bus, options, new_id()
        self.controller = bind(robot) if robot is not None else None
        self.truth: messages.sim_truth_t | None = None
        self.on_truth: Callable[[messages.sim_truth_t], None] | None = None
        self.on_state: Callable[[messages.robot_state_t], None] | None = None
        self.on_guard: Callable[[messages.guard_report_t], None] | None = None
        self.ticks, self.actions, self.elapsed = 0, 0, 0.0
        self.inference_times: list[float] = []   # of the last second [s]
        self._ended = False                      # the motion that it follows
        self._binding, self._inference = Binding(bind), Inference()
        self._held: tuple[Array, Array, Array] | None = None  # posture, kp, kd, held before the policy was known
        self._fresh = True                       # nothing was cleared since the world began
        self._unfaded: tuple[int, int, float] | None = None  # run, term and until when [ns] its commands are not faded in
        self._kp, self._kd = np.zeros(0), np.zeros(0)         # that belong to the target
        self._rest = np.zeros(0)                 # where joints are that the policy does not move
        self._fade_ns: int | None = None         # since when it goes from there to its own
        self._told_stopped = False
        self._failing = ''                       # why a balanced stop was asked here
        self._ending = False                     # it is the end of an orderly run
        self._asked_at = 0.0                     # the stop, the last time
        self._plan: StopPlan | None = None
        self._estimate: Any = None
        self._guard: Any = None
        self._state: messages.robot_state_t | None = None
        self._pace = 0
        self._begin_ns: int | None = None        # of this start; None: at the next state
        self._first_ns: int | None = None
        self._due_ns = self._submitted_ns = 0
        self._submitted_at = 0.0
        self._target: Array = np.zeros(0)        # per joint on the bus
        self._balanced_ns: int | None = None     # since when a balanced stop is asked
        self._rested = False
        self._said_truth = False
        self._event_sequence = 0
        self._beat = 0.0
        self._operator = Operator(np.array(options.command), -np.ones(3), np.ones(3))
        bus.listen(*[channel for channel in LISTENED if channel in TYPES], *(['GUARD'] if options.guarded else []))

    # -- what comes in -------------------------------------------------------------------------------------------------

    def run(self) -> None:
        """Until options.duration or Ctrl-C, then a balanced stop.  Stopped when the policy had to stop the robot."""
        try:
            try:
                while self.elapsed < self.options.duration:
                    self.receive(0.1)
            except KeyboardInterrupt:
                pass
            self._end()
        finally:
            self._inference.close()

    def _end(self) -> None:
        """A robot that is obeyed is brought to rest; a second Ctrl-C leaves it to the source at once."""
        if self._begin_ns is None or self._state is None or self._rested:
            return
        self._failing, self._ending = self._failing or 'the policy ends', True
        quiet_at = time.monotonic() + 1.0
        try:
            while time.monotonic() < quiet_at:
                if self.receive(0.1):
                    quiet_at = time.monotonic() + 1.0
        except (Ended, KeyboardInterrupt):
            pass

    def receive(self, timeout: float) -> bool:
        """Handles what came within timeout [s]; answers the newest STATE.  False: nothing came."""
        heard = self.bus.receive(timeout)
        newest: messages.robot_state_t | None = None
        for channel, body in heard:
            message = decode(channel, body)
            if message is None:
                continue
            if channel == 'STATE':
                if newest is None or message.tick > newest.tick or message.term > newest.term:
                    newest = message
            else:
                self._hear(channel, message)
        if newest is not None:
            self._answer(newest)
        return bool(heard)

    def _hear(self, channel: str, message: Any) -> None:
        if channel in ('ESTIMATE', 'TRUTH') and self._state is not None and message.run_id != self._state.run_id:
            return  # of a source that stands by
        if channel == 'ESTIMATE':
            self._estimate = message
        elif channel == 'GUARD':
            self._guard = message
            if self.on_guard is not None:
                self.on_guard(message)
        elif channel == 'TRUTH':
            self.truth = message
            if self.on_truth is not None:
                self.on_truth(message)
        elif channel == 'MODEL_TEXT':
            if self.controller is None:
                self._binding.hear(message)
        elif channel == 'SOURCE_STATUS':
            if self._state is not None and message.run_id == self._state.run_id:
                self._pace = message.pace
                if message.stop_kind >= HOLD:
                    self._tell_of_stop(message)
        elif self._state is not None:
            self._operator.hear(channel, message, self._state.run_id)
            if self._operator.plays and (self.controller is None or not self.controller.has_motion_beside):
                self._operator.plays = False
                self._operator.complaint = as_typed('controller: this policy has no motion to play: ./twinbus policy WALK.onnx --play TRACK.onnx')
            if self._operator.complaint:
                self.event(self._operator.complaint, NOTE)
                self._operator.complaint = ''

    # -- a tick --------------------------------------------------------------------------------------------------------

    def _answer(self, state: messages.robot_state_t) -> None:
        previous, self._state = self._state, state
        if self.on_state is not None:
            self.on_state(state)
        if self.options.guarded:
            self._await_guard(state)
        if self.controller is None and not self._bind_from_bus(state):
            self._hold(state)
            return
        assert self.controller is not None
        if state.joint_count != len(self.controller.robot.names()):
            self.stop(f'STATE has {state.joint_count} joints, {self.controller.robot.name} has {len(self.controller.robot.names())}: '
                      'another robot runs; --robot says which')
        if state.stop_kind >= HOLD:  # obeys nobody until it is cleared; then everything begins anew
            self._begin_ns, self._fresh, self._operator.plays = None, False, False
            if self._ending:
                raise Ended
            if self._failing:
                raise Stopped(self._failing)
            return
        if self._failing and state.stop_kind == 0:
            self._ask_for_stop(BALANCED)
        if previous is not None and previous.run_id == state.run_id and state.tick < previous.tick:
            self._begin_ns, self._fresh, self._operator.plays = None, True, False    # the world was reset
        if self._begin_ns is None:
            self._begin(state)
        assert self._begin_ns is not None and self._first_ns is not None
        self.ticks += 1
        if not self._ending:
            self.elapsed = 1e-9 * (state.time_ns - self._first_ns)
        stopping = self._follow_balanced_stop(state)
        if self._rested:
            return
        since = 1e-9 * (state.time_ns - self._begin_ns) - self.options.wait
        blind = self.controller.needs_velocity and self._velocity(state) is None and since < FIRST_ESTIMATE
        if since >= 0.0 and not blind:
            self._think(state, stopping)
        if not self._inference.running:
            self._lead_back(state)
        self._send(state, stopping, *self._faded(state))

    def _bind_from_bus(self, state: messages.robot_state_t) -> bool:
        self.controller = self._binding.look(state.model_hash)[1]
        return self.controller is not None

    def _hold(self, state: messages.robot_state_t) -> None:
        """The posture that was found, until the policy is known; silence for the command timeout would be a stop."""
        robot = self._binding.look(state.model_hash)[0]
        if robot is None or state.stop_kind >= HOLD or state.joint_count != len(robot.bus):
            self._held = None
            return
        if self._held is None:
            self._held = (np.array(state.q[:state.joint_count], dtype=np.float64), np.array([joint.kp for joint in robot.bus]),
                          np.array([joint.kd for joint in robot.bus]))
        self._send(state, False, *self._held)

    def _tell_of_stop(self, status: messages.source_status_t) -> None:
        """A stop that was there before this policy: nobody obeys it, and it says so once."""
        if self._told_stopped or self._first_ns is not None:
            return
        self._told_stopped = True
        why = 'no command came for the command timeout' if status.stop_reason == COMMAND_TIMEOUT else 'status says why'
        self.options.say(f'the robot is stopped already ({why}); ./twinbus clear lets the policy begin')

    def _begin(self, state: messages.robot_state_t) -> None:
        assert self.controller is not None
        self._begin_ns = self._due_ns = state.time_ns
        self._due_ns += round(1e9 * self.options.wait)
        self._first_ns = state.time_ns if self._first_ns is None else self._first_ns
        self._balanced_ns, self._rested = None, False
        if self._inference.running and self._inference.wait(PATIENCE):
            self._inference.take()
        self.controller.reset()
        self._plan = StopPlan(self.controller)
        q = np.array(state.q[:state.joint_count], dtype=np.float64)
        self._target = self.controller.posture(q)
        most = self.controller.limited(np.full(3, 1e3))
        self._operator.least, self._operator.most = self.controller.limited(np.full(3, -1e3)), most
        self._rest, self._kp, self._kd = self._target.copy(), self.controller.kp, self.controller.kd
        off = np.abs(self._target - q)
        # What was cleared, and a source that takes over later, fade as with every client.
        far = np.array([FAR_SLIDE if joint.kind == 'prismatic' else FAR for joint in self.controller.robot.bus])
        near = self._fresh and bool(np.all(off <= far))
        fades = self.options.fade if self.options.fade is not None else not near
        until = math.inf if self.options.fade is not None else state.time_ns + 1e9 * (self.options.wait + FADE)
        self._unfaded, self._fresh = None if fades else (state.run_id, state.term, until), False
        self._held, self._fade_ns = (self._held, state.time_ns) if self._held is not None and fades else (None, None)
        if float(off.max()) > 0.1 and self.options.wait == 0.0:
            joint = self.controller.robot.bus[int((off / far).argmax())]
            self.options.say(f'{joint.name} is {float(off[joint.bus]):.2f} {"m" if joint.kind == "prismatic" else "rad"} away from the posture of the '
                             'policy, which begins at once: ./twinbus up --start-pose, or --wait 0.3')

    def _follow_balanced_stop(self, state: messages.robot_state_t) -> bool:
        if state.stop_kind != 1:
            self._balanced_ns, self._rested = None, False
            return False
        self._operator.plays = False  # who wants it after the stop asks again
        if self._balanced_ns is None:
            self._balanced_ns = state.time_ns
        since, velocity = 1e-9 * (state.time_ns - self._balanced_ns), self._velocity(state)
        if since > STOP_TIME or since > 0.3 and velocity is not None and float(np.linalg.norm(velocity[:2])) < AT_REST and self._feet_stand():
            self._rested = True
        return True

    def _feet_stand(self) -> bool:
        if self._estimate is None:
            return False
        count = int(self._estimate.foot_count)
        return count > 0 and all(int(stands) == 1 for stands in self._estimate.foot_stands[:count])

    def _think(self, state: messages.robot_state_t, stopping: bool) -> None:
        """Begins an inference when one is due, and takes what has come out."""
        controller = self.controller
        assert controller is not None
        world_waits = self._pace in (0, LOCK_STEP, FREE_RUN, PAUSED)
        if not self._inference.running and state.time_ns >= self._due_ns:
            late = state.time_ns - self._due_ns
            period_ns = round(1e9 * controller.spec.period)
            self._due_ns += period_ns * (1 + late // period_ns)
            measured = self._measured(state)
            command = np.zeros(3) if stopping else self._operator.command()
            controller.play(self._operator.plays and not stopping)
            self._submitted_ns, self._submitted_at = state.time_ns, time.monotonic()
            self._inference.submit(lambda: self._step(controller, measured, command))
        if not self._inference.running:
            return
        if not self._inference.wait(PATIENCE if world_waits else 0.0004):
            took = 1e-9 * (state.time_ns - self._submitted_ns)
            if world_waits or took >= controller.spec.period and not self._inference.wait(0.002):
                spent = 1e3 * (time.monotonic() - self._submitted_at)
                self._late(f'the inference takes longer than {spent:.0f} ms; the policy wants a new action every '
                           f'{1e3 * controller.spec.period:.0f} ms', world_waits or took >= TOO_LATE)
            if not self._inference.wait(0.0):
                return
        spent = 1e-9 * (state.time_ns - self._submitted_ns)
        try:
            targets = self._inference.take()
        except PolicyError as error:
            self.stop(str(error))
        if not world_waits and spent > controller.spec.period:
            self._late(f'the inference took {1e3 * spent:.0f} ms; the policy wants a new action every {1e3 * controller.spec.period:.0f} ms', False)
        self._target[controller.observation.index] = targets
        self._kp, self._kd = controller.kp, controller.kd
        self.actions += 1
        if controller.ended != self._ended:
            self._ended = controller.ended
            if self._ended:
                self._operator.plays = False
                self.event('policy: the motion has come to its end', NOTE)

    def _late(self, reason: str, lost: bool) -> None:
        """lost: so late that it balances nothing any more."""
        if lost:
            self.stop(reason)
        if not self._failing:
            self._failing = reason
            self.event(f'policy: {reason}: balanced stop', ALARM)

    def _step(self, controller: Acting, measured: Measured, command: Array) -> Array:
        begin = time.perf_counter()
        targets = controller.step(measured, command)
        self.inference_times.append(time.perf_counter() - begin)
        del self.inference_times[:-100]
        return targets

    def _measured(self, state: messages.robot_state_t) -> Measured:
        assert self.controller is not None
        count = state.joint_count
        measured = Measured(np.array(state.q[:count], dtype=np.float64), np.array(state.qd[:count], dtype=np.float64),
                            np.array(state.attitude, dtype=np.float64), np.array(state.gyro, dtype=np.float64))
        if self.controller.needs_velocity:
            self._await_estimate(state)
            measured.base_velocity = self._velocity(state)
        return measured

    def _await_estimate(self, state: messages.robot_state_t) -> None:
        """The ESTIMATE of this tick comes just behind its STATE: for a short while."""
        end = time.monotonic() + (0.05 if self._pace in (0, LOCK_STEP, FREE_RUN) else 0.0005)
        while self._estimate is not None and self._estimate.run_id == state.run_id and self._estimate.tick < state.tick \
                and time.monotonic() < end:
            for channel, body in self.bus.receive(0.0002):
                message = decode(channel, body)
                if message is not None and channel != 'STATE':
                    self._hear(channel, message)

    def _await_guard(self, state: messages.robot_state_t) -> None:
        end = time.monotonic() + (FIRST_GUARD if self._guard is None else GUARD)
        while self._guard is None or (self._guard.run_id, self._guard.tick) != (state.run_id, state.tick):
            if time.monotonic() > end:
                self.stop(f'no guard judged tick {state.tick}')
            for channel, body in self.bus.receive(0.05):
                message = decode(channel, body)
                if message is not None and channel != 'STATE':
                    self._hear(channel, message)

    def _velocity(self, state: messages.robot_state_t) -> Array | None:
        """Of the origin of the base link, in its axes [m/s]; ticks go on across a switch, so the last of the old source still counts."""
        estimate = self._estimate
        if estimate is not None and state.tick - estimate.tick <= RECENT and estimate.velocity_from != 0:
            return np.array(estimate.velocity_in_base, dtype=np.float64)
        truth = self.truth
        if truth is None or state.tick - truth.tick > RECENT:
            return None
        if not self._said_truth:
            self._said_truth = True
            self.options.say('ESTIMATE does not come; the velocity of the base is that of TRUTH, which only a simulator has')
            self.event('policy: the velocity of the base is TRUTH, for there is no ESTIMATE; no robot has that', NOTE)
        from .rotation import rotation_of
        return rotation_of(np.array(truth.base_attitude)).T @ np.array(truth.base_velocity)

    # -- what goes out -------------------------------------------------------------------------------------------------

    def _faded(self, state: messages.robot_state_t) -> tuple[Array, Array, Array]:
        """Posture and gains of this tick.  Where a posture was held before and the policy is to be faded in, it is here."""
        controller = self.controller
        assert controller is not None
        share = 1.0 if self._fade_ns is None else 1e-9 * (state.time_ns - self._fade_ns) / FADE
        if self._held is None or share >= 1.0:
            self._held = self._fade_ns = None
            return self._target, self._kp, self._kd
        share = share * share * (3.0 - 2.0 * share)
        q, kp, kd = ((1.0 - share) * held + share * own for held, own in zip(self._held, (self._target, self._kp, self._kd)))
        return q, kp, kd

    def _is_unfaded(self, state: messages.robot_state_t) -> bool:
        if self._unfaded is None:
            return False
        run_id, term, until = self._unfaded
        return until == math.inf or (run_id, term) == (state.run_id, state.term) and state.time_ns < until

    def _lead_back(self, state: messages.robot_state_t) -> None:
        """Joints that a motion has moved and the policy that walks does not."""
        assert self.controller is not None
        others = np.ones(len(self._target), dtype=bool)
        others[self.controller.observation.index] = False
        most = BACK * 1e-9 * state.period_ns
        self._target[others] += np.clip(self._rest[others] - self._target[others], -most, most)

    def _send(self, state: messages.robot_state_t, stopping: bool, q: Array, kp: Array, kd: Array) -> None:
        count = state.joint_count
        command = messages.joint_command_t()
        command.tick, command.run_id, command.term = state.tick, state.run_id, state.term
        command.model_hash, command.joint_count, command.controller_id = state.model_hash, count, self.id
        command.flags = (STOPPING if stopping else 0) | (NOT_FADED if self._is_unfaded(state) else 0)
        command.q[:count], command.kp[:count], command.kd[:count] = q, kp, kd
        self.bus.send('COMMAND', command)
        if self._plan is not None and self._plan.due(state.time_ns, q, kp):
            self.bus.send('STOP_PLAN', self._plan.message(command))
        if self.ticks % 5 == 0:
            self._tell_status(state, stopping)
        if time.monotonic() - self._beat >= 0.1:
            self._heartbeat(state)

    def _tell_status(self, state: messages.robot_state_t, stopping: bool) -> None:
        status = messages.controller_status_t()
        status.tick, status.run_id, status.term, status.controller_id = state.tick, state.run_id, state.term, self.id
        status.mode, status.mode_sequence, status.walk_sequence = self._operator.mode, self._operator.mode_sequence, self._operator.walk_sequence
        status.motion = PLAYED if self.controller is not None and self.controller.playing and not self._ended else 0
        status.stopping = 1 if stopping else 0
        status.compute_ns = int(1e9 * self.inference_times[-1]) if self.inference_times else 0
        status.base_attitude[0] = 1.0
        if self._estimate is not None and self._estimate.run_id == state.run_id:
            status.base_position, status.base_attitude = self._estimate.base_position, self._estimate.base_attitude
            status.base_velocity = status.com_velocity = self._estimate.base_velocity
        self.bus.send('CONTROLLER_STATUS', status)

    def _heartbeat(self, state: messages.robot_state_t) -> None:
        beat, times = messages.heartbeat_t(), sorted(self.inference_times) or [0.0]
        now = time.monotonic()
        beat.utime, beat.process_id, beat.pid, beat.kind, beat.state = time.time_ns() // 1000, self.id, os.getpid(), CONTROLLER, 2
        beat.ticks = beat.messages_received = self.ticks
        beat.timer_missed = beat.allocations = -1
        beat.realtime = 1 if self.options.fifo else 0
        beat.rate = 1e9 / max(1, state.period_ns)
        beat.tick_median_us, beat.tick_p99_us = 1e6 * times[len(times) // 2], 1e6 * times[(99 * len(times)) // 100]
        beat.tick_max_us = 1e6 * times[-1]
        self._beat = now
        self.bus.send('HEARTBEAT', beat)

    def event(self, sentence: str, severity: int) -> None:
        """A sentence for people, in every log."""
        message = messages.event_t()
        self._event_sequence += 1
        message.utime, message.sender_id, message.sequence = time.time_ns() // 1000, self.id, self._event_sequence
        message.severity, message.kind = severity, CONTROLLER
        if self._state is not None:
            message.run_id, message.tick = self._state.run_id, self._state.tick
        data = sentence.encode()[:len(message.text) - 1]
        message.text[:len(data)] = np.frombuffer(data, dtype=np.int8)
        self.bus.send('EVENT', message)

    def stop(self, reason: str) -> NoReturn:
        """Stops the robot (hold) and says why, until STATE shows the stop; then throws Stopped."""
        self.event(f'policy: {reason}: stop', ALARM)
        end = time.monotonic() + 1.0
        while time.monotonic() < end:
            self._ask_for_stop(HOLD)
            for channel, body in self.bus.receive(0.02):
                state = decode(channel, body) if channel == 'STATE' else None
                if state is not None and state.stop_kind >= HOLD:
                    raise Stopped(reason)
        raise Stopped(f'{reason} (no STATE showed the stop within a second)')

    def _ask_for_stop(self, kind: int) -> None:
        now = time.monotonic()
        if now - self._asked_at < ASKS_EVERY:
            return
        self._asked_at = now
        message = messages.stop_t()
        message.utime, message.sender_id, message.sequence = time.time_ns() // 1000, self.id, kind  # the same stop, however often it is sent
        message.kind, message.reason = kind, BY_CONTROLLER
        self.bus.send('STOP', message)
