#!/usr/bin/env python3
"""Random requests to a stack of simulator and robot, standing and walking: no request makes the robot fall, and every one
that is refused is refused for its true reason.

    requests_test.py [COUNT]       # 60; REQUESTS_SEED=N repeats a run, REQUESTS_VERBOSE=1 tells each

Modes, poses, reaches, walks, footsteps, switches, balanced stops, hold and clear while it stands: valid and not, in any order.  `stop off` is
left out: it always acts.  A fall while the machine itself stood still (stalls.py, or the source says so) is counted apart.
"""

import math
import os
import random
import re
import sys
import threading
import time

import harness
from harness import Bus, Checks, Stack, text_of, twinbus
from stalls import Stalls

COUNT = int(sys.argv[1]) if len(sys.argv) > 1 else 60
VERBOSE = os.environ.get("REQUESTS_VERBOSE", "") != ""
PER_STACK = 60
KEPT = 15_000  # records, three seconds of them
IDLE, HOLD, POSE, BALANCE, WALK, STOP = 1, 2, 3, 4, 5, 6
MODES = {IDLE: "idle", HOLD: "hold", POSE: "pose", BALANCE: "balance", WALK: "walk", STOP: "stop"}
SENDER = random.SystemRandom().getrandbits(50)
STALL_MS = 40.0
FALLEN = math.cos(0.7)

# What a sentence of a refusal claims, as a function of what was so when the request came (Seen) and of the request.
TRUE_REASONS = (
    ("idle lets go", lambda seen, r: r.mode == IDLE and seen.upright),
    ("the robot is stopped", lambda seen, r: seen.stopped),
    ("the pose is not begun", lambda seen, r: r.mode == POSE),
    ("follows its stop plan", lambda seen, r: seen.plan),
    ("the pose would", lambda seen, r: r.mode == POSE),
    ("on the way to the pose", lambda seen, r: r.mode == POSE),
    ("walking begins on an upright robot", lambda seen, r: r.mode == WALK and not seen.on_both_feet),
    ("balance needs an upright robot", lambda seen, r: r.mode in (BALANCE, POSE) and not seen.on_both_feet),
    ("the robot falls", lambda seen, r: seen.tilted),
    ("footsteps are walked in mode walk", lambda seen, r: seen.mode != WALK or seen.stopping),
    ("footstep", lambda seen, r: True),
    ("squat", lambda seen, r: r.mode == BALANCE),
    ("knees", lambda seen, r: r.mode == BALANCE),
)


class Seen:
    """How the robot was at an instant."""

    def __init__(self, bus):
        _, state = bus.newest("STATE")
        _, status = bus.newest("CONTROLLER_STATUS")
        self.state, self.status = state, status
        self.stopped = state.stop_kind != 0
        self.plan = state.plan_number != 0
        self.mode = status.mode
        self.stopping = status.stopping != 0 or state.stop_kind != 0
        up = 1.0 - 2.0 * (state.attitude[1] ** 2 + state.attitude[2] ** 2)
        self.upright = up > FALLEN
        self.tilted = up < math.cos(0.1)
        forces = [state.wrench[foot][2] for foot in (0, 1)]
        self.on_both_feet = all(abs(f) > 50.0 for f in forces)


class Driver:
    """Asks, and says what came of it."""

    def __init__(self, bus, rng, walks):
        self.bus, self.rng, self.walks = bus, rng, walks
        self.sequence = 0
        self.word = None  # why the last request was refused
        self.joints = harness.bus_joints()
        self.wish = None  # velocity to walk at
        self.run = True
        self.thread = threading.Thread(target=self._stream, daemon=True)
        self.thread.start()

    def close(self):
        self.run = False
        self.thread.join()

    def _stamp(self, message, run_id):
        self.sequence += 1
        message.utime, message.sender_id = time.time_ns() // 1000, SENDER
        message.sequence, message.run_id = self.sequence, run_id
        return message

    def _stream(self):
        while self.run:
            wish = self.wish
            if wish is not None:
                _, state = self.bus.newest("STATE", look_back=2000)
                if state is not None:
                    walk = self._stamp(twinbus.walk_command_t(), state.run_id)
                    walk.vx, walk.vy, walk.wz, walk.timeout = *wish, 0.5
                    self.bus.send("WALK", walk)
            time.sleep(0.1)

    # Each gives (what was asked, a sentence or None).

    def mode(self, mode, **fields):
        seen = Seen(self.bus)
        request = self._stamp(twinbus.mode_request_t(), seen.state.run_id)
        request.mode = mode
        for name, value in fields.items():
            setattr(request, name, value)
        what = MODES[mode] + (f" {fields}" if mode == BALANCE and fields else "")
        since = time.monotonic_ns()
        for _ in range(3):
            self.bus.send("MODE_REQUEST", request)
            time.sleep(0.02)
        return what, lambda: self.mode_outcome(request, seen, since)

    def mode_outcome(self, request, seen, since):
        """None when it was obeyed or refused truly."""
        end = time.monotonic() + (8.0 if seen.mode == WALK else 1.5)
        while time.monotonic() < end:
            said = [text_of(e) for _, e in self.bus.messages("EVENT", since) if e.kind == CONTROLLER]
            for sentence in said:
                for part, holds in TRUE_REASONS:
                    if part in sentence:
                        now = Seen(self.bus)
                        self.word = sentence
                        return None if holds(seen, request) or holds(now, request) else f"untrue: {sentence}"
            _, status = self.bus.newest("CONTROLLER_STATUS", look_back=4000)
            # An obeyed stop of the robot, asked before, changes the mode by itself.
            if status.mode_sequence == request.sequence and (
                    status.mode == request.mode or request.mode == STOP or Seen(self.bus).stopped):
                return None
            time.sleep(0.05)
        said = [text_of(e) for _, e in self.bus.messages("EVENT", since)]
        return f"neither obeyed nor refused: mode {status.mode}, sequence {status.mode_sequence} of {request.sequence}; {said}"

    def pose(self):
        rng, seen = self.rng, Seen(self.bus)
        q, mask = list(seen.state.q), 0
        kind = rng.random()
        count = 1 if kind < 0.4 else rng.randrange(2, 8) if kind < 0.8 else len(self.joints)
        for k in rng.sample(range(len(self.joints)), count):
            limit = self.joints[k].find("limit")
            lower, upper = float(limit.get("lower", -3.1)), float(limit.get("upper", 3.1))
            q[k] += rng.gauss(0.0, rng.choice((0.05, 0.3, 1.0)))
            if rng.random() < 0.1:
                q[k] = rng.uniform(-4.0, 4.0)
            elif rng.random() < 0.8:
                q[k] = min(max(q[k], lower), upper)
            mask |= 1 << k
        what, outcome = self.mode(POSE, q=q, joint_mask=mask, duration=rng.choice((0.0, 0.1, 0.5, 2.0, 2.0, 4.0)))
        names = [f"{self.joints[k].get('name')}={q[k]:.2f}" for k in range(len(self.joints)) if mask >> k & 1]
        return "pose " + ",".join(names[:8]), outcome

    def reach(self):
        rng, seen = self.rng, Seen(self.bus)
        goal = self._stamp(twinbus.arm_goal_t(), seen.state.run_id)
        goal.goal_id, goal.side, goal.kind = rng.getrandbits(50), rng.choice((1, 2)), rng.choice((2, 2, 2, 0))
        left = 1.0 if goal.side == 1 else -1.0
        goal.position = [rng.uniform(0.0, 0.6), left * rng.uniform(-0.2, 0.6), rng.uniform(0.3, 1.5)]
        goal.orientation, goal.speed = [1.0, 0.0, 0.0, 0.0], rng.choice((0.2, 0.6, 1.0))
        start = len(self.bus.records)
        for _ in range(2):
            self.bus.send("ARM_GOAL", goal)
            time.sleep(0.02)
        what = f"reach {goal.kind} side {goal.side} " + " ".join(f"{p:.2f}" for p in goal.position)

        def outcome():
            if goal.kind == 0:
                return None
            _, path = self.bus.wait_for("ARM_PATH", lambda p: p.goal_id == goal.goal_id, timeout=8.0, start=start)
            return None if path is not None else "the planner answers nothing"
        return what, outcome

    def walk(self):
        rng = self.rng
        self.wish = rng.choice(((0.2, 0.0, 0.0), (0.1, 0.05, 0.1), (-0.1, 0.0, 0.0), (0.0, 0.0, 0.3), (5.0, 5.0, 5.0),
                                (0.4, 0.0, -0.2), (0.0, 0.0, 0.0)))
        what, outcome = self.mode(WALK)
        return f"walk {self.wish}", outcome

    def steps(self):
        rng, seen = self.rng, Seen(self.bus)
        request = self._stamp(twinbus.step_list_t(), seen.state.run_id)
        request.count, request.first_foot = rng.choice((0, 1, 4, 8, 32)), rng.choice((1, 2))
        for i in range(request.count):
            left = 1.0 if (request.first_foot == 1) == (i % 2 == 0) else -1.0
            wild = rng.random() < 0.1
            request.x[i] = rng.uniform(-1.0, 1.0) if wild else rng.uniform(-0.1, 0.2)
            request.y[i] = left * (rng.uniform(-0.5, 1.0) if wild else rng.uniform(0.15, 0.25))
            request.yaw[i] = rng.uniform(-3.0, 3.0) if wild else left * rng.uniform(0.0, 0.2)
        for _ in range(2):
            self.bus.send("STEPS", request)
            time.sleep(0.02)
        return f"steps {request.count}", lambda: None

    def switch(self):
        rng = self.rng
        status, policy = rng.choice(("sim", "bridge", "bridge", "sim", "replay")), rng.choice(("now", "when-safe"))
        before = Seen(self.bus)
        code, out, err = harness.cli("switch", status, "--policy", policy, timeout=40)

        def outcome():
            if code == 0:
                return None
            return None if (out + err).strip() else f"switch exits {code} without a word ({before.mode})"
        return f"switch {status} {policy}: {(out + err).strip()}", outcome

    def stop(self, kind):
        request = self._stamp(twinbus.stop_t(), 0) if hasattr(twinbus.stop_t(), "run_id") else twinbus.stop_t()
        self.sequence += 1
        request.utime, request.sender_id, request.sequence = time.time_ns() // 1000, SENDER, self.sequence
        request.kind, request.reason = kind, 1
        for _ in range(3):
            self.bus.send("STOP", request)
            time.sleep(0.02)

        def outcome():
            at, _ = self.bus.wait_for("STATE", lambda s: s.stop_kind >= kind, timeout=2.0)
            return None if at is not None else "the stop does not latch"
        return f"stop {kind}", outcome

    def clear(self):
        for _ in range(60):
            _, state = self.bus.newest("STATE", look_back=2000)
            if state.stop_kind == 0:
                return "clear", lambda: None
            if state.stop_kind == 1 and state.role == 2:
                pass  # the controller still makes it; a clear is allowed all the same
            request = twinbus.stop_t()
            self.sequence += 1
            request.utime, request.sender_id, request.sequence = time.time_ns() // 1000, SENDER, self.sequence
            request.stop_nonce = state.stop_nonce
            self.bus.send("STOP", request)
            time.sleep(0.05)
        return "clear", lambda: "the stop is not cleared in 3 s"

    def any(self):
        rng, seen = self.rng, Seen(self.bus)
        if seen.stopped and rng.random() < 0.6:
            return self.clear()
        if self.walks and seen.mode != WALK and not seen.stopped and rng.random() < 0.5:
            return self.walk()
        draw = rng.random()
        if draw < 0.20:
            return self.pose()
        if draw < 0.34:
            return self.reach()
        if draw < 0.40 or self.walks and draw < 0.50:
            return self.walk()
        if draw < 0.54:
            return self.steps()
        if draw < 0.64:
            return self.switch()
        if draw < 0.70:
            return self.stop(1)
        if draw < 0.76:
            # A hold of a walking robot is what stop plans are for; it is asked of a standing one here.
            return self.stop(2 if seen.mode != WALK and seen.on_both_feet else 1)
        if draw < 0.80:
            return self.clear()
        if draw < 0.88:
            return self.mode(BALANCE, motion=rng.choice((0, 1, 2)), amplitude=rng.choice((0.01, 0.03, 0.1, 1.0)),
                             frequency=rng.choice((0.1, 0.25, 1.0, 5.0)))
        return self.mode(rng.choice((IDLE, HOLD, BALANCE, WALK, STOP)))


CONTROLLER = None  # EVENT.kind of the controller, found out below


def controller_kind():
    text = (harness.ROOT / "lcmtypes/heartbeat_t.lcm").read_text()
    return int(re.search(r"(\d+) controller", text)[1])


class Story:
    """Falls, touches and words of the requests of a stack."""

    def __init__(self, checks):
        self.checks = checks
        self.asked = self.falls = self.touches = self.stalled = self.refused = self.refusals = self.walking = 0

    def fell(self, bus, stalls, since):
        """Why it fell, or None."""
        for at, event in bus.messages("EVENT", since):
            if "has fallen" in text_of(event) or "the robot falls" in text_of(event):
                return at, text_of(event)
        for at, state in list(bus.messages("STATE", since))[::25]:
            if 1.0 - 2.0 * (state.attitude[1] ** 2 + state.attitude[2] ** 2) < FALLEN:
                return at, "STATE shows a robot that lies"
        return None

    def touched(self, bus, since):
        for at, report in list(bus.messages("GUARD", since))[::5]:
            if report.verdict == 3:
                return at, f"links {report.link_a[0]} and {report.link_b[0]} at {1e3 * report.distance[0]:.1f} mm"
        return None


def one_stack(story, stalls, rng, count, walks):
    with Stack("stand", "--stack", "both", "--no-viewer", "--no-record") as stack:
        bus = Bus()
        driver = Driver(bus, rng, walks)
        try:
            time.sleep(2.5)
            history = []
            for _ in range(count):
                del bus.records[:-KEPT]
                since = time.monotonic_ns()
                what, outcome = driver.any()
                story.asked += 1
                story.walking += Seen(bus).mode == WALK
                driver.word = None
                wrong = outcome()
                story.refusals += driver.word is not None
                if VERBOSE:
                    print(f"  {MODES.get(Seen(bus).mode)}, stop {Seen(bus).state.stop_kind}: {what}: {driver.word or wrong or 'ok'}", flush=True)
                time.sleep(rng.choice((0.0, 0.1, 0.5, 1.0, 2.0)))
                history.append(what)
                fall, touch = story.fell(bus, stalls, since), story.touched(bus, since)
                stall = max(stalls.longest_ms(since - 3_000_000_000, time.monotonic_ns()), slept_ms(bus, since))
                if fall is not None:
                    if stall >= STALL_MS or "no time on its processor" in fall[1]:
                        story.stalled += 1
                        print(f"  not judged, the machine stood still for {stall:.0f} ms: {fall[1]}", flush=True)
                    else:
                        story.falls += 1
                        story.checks.that(False, f"request {story.asked}: {what}: {fall[1]}\n  after " + "\n  ".join(history[-8:]))
                        print("\n".join(harness.story_of_a_stop(bus, stalls=stalls)), flush=True)
                    return
                if touch is not None:
                    story.touches += 1
                    story.checks.that(False, f"request {story.asked}: {what}: touches, {touch[1]}\n  after " + "\n  ".join(history[-8:]))
                if wrong is not None:
                    story.refused += 1
                    hit = stall >= STALL_MS
                    print(f"  {'not judged, stall ' if hit else ''}request {story.asked}: {what}: {wrong}", flush=True)
                    if not hit:
                        story.checks.that(False, f"request {story.asked}: {what}: {wrong}")
        finally:
            driver.close()
            bus.close()


def slept_ms(bus, since):
    """The longest time without a STATE."""
    times = [at for at, _ in ((a, n) for a, n, _ in list(bus.records) if n == "STATE" and a >= since)]
    return max(((b - a) * 1e-6 for a, b in zip(times, times[1:])), default=0.0)


def main():
    global CONTROLLER
    harness.require("twinbus_simulator", "twinbus_bridge", "emulated_robot", "twinbus_controller", "twinbus_guard", "twinbus_planner")
    CONTROLLER = controller_kind()
    seed = int(os.environ.get("REQUESTS_SEED", "1"))
    checks, stalls = Checks(), Stalls()
    story, number = Story(checks), 0
    print(f"seed {seed}", flush=True)
    while story.asked < COUNT:
        one_stack(story, stalls, random.Random(seed * 1000 + number), min(PER_STACK, COUNT - story.asked), number % 2 == 1)
        number += 1
        print(f"{story.asked} requests ({story.walking} while it walked, {story.refusals} refused), {story.falls} falls, {story.touches} touches, "
              f"{story.refused} without an outcome or a true reason, {story.stalled} felled by stalls", flush=True)
    checks.at_most(story.falls, 0, "falls")
    checks.at_most(story.touches, 0, "touches")
    stalls.close()
    checks.exit()


if __name__ == "__main__":
    main()
