"""The figures of one switch, from what was on the bus around it; also what `./twinbus bench switch` prints.

Everything is measured from outside: ticks and terms of STATE, ticks of COMMAND, torque and foot force, the ZMP margin that
the controller measures, TRUTH.fell.  The steps in torque and force are those of one body, the one that takes over: its own
channel before, STATE after.  Two robots of different mass stand with different torques, and no motor feels that difference;
it is printed as "across".
"""

import math

PERIOD_NS = 2_000_000
WEIGHT = 130.8 * 9.81  # [N] of hrp1s
BEFORE_NS = 200_000_000
AFTER_NS = 500_000_000
# The step is judged where the sources meet: the last tick of the one against the first ticks of the other.
STEP_TICKS = 5
OWN_CHANNELS = ("STATE_SIM", "STATE_BRIDGE", "STATE_REPLAY")


class SwitchFigures:
    def __init__(self):
        self.ticks_without_command = 0
        self.unanswered = []        # of each of them, one line
        self.gap_ticks = 0          # tick numbers that no source published
        self.gap_ms = 0.0           # longest time between two states around the switch
        self.double_ticks = 0       # tick numbers that two sources published on STATE
        self.two_obeying = 0        # states of the old source, still active, after the tick it granted
        self.torque_step = 0.0      # largest change per tick, share of the joint's limit
        self.torque_joint = -1
        self.force_step = 0.0       # of one foot, share of weight
        self.across_torque = 0.0    # old source against new one
        self.across_force = 0.0
        self.background_torque_step = 0.0  # the same before the switch
        self.background_force_step = 0.0
        self.zmp_margin_mm = math.inf
        self.tilt_deg = 0.0
        self.fell = False
        self.from_ns = self.to_ns = 0  # what was looked at, steady clock

    def row(self):
        return (f"missed {self.ticks_without_command}, gap {self.gap_ticks} ticks {self.gap_ms:.1f} ms, "
                f"torque step {100 * self.torque_step:.2f} % (before: {100 * self.background_torque_step:.2f} %), "
                f"foot force step {100 * self.force_step:.2f} % (before: {100 * self.background_force_step:.2f} %), "
                f"across {100 * self.across_torque:.1f} % and {100 * self.across_force:.1f} %, "
                f"ZMP margin {self.zmp_margin_mm:.1f} mm, fell {self.fell}")


def foot_force(state, foot):
    return math.sqrt(sum(state.wrench[foot][axis] ** 2 for axis in range(3)))


def tilt(state):
    w, x, y, z = state.attitude
    return math.degrees(math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (x * x + y * y)))))


def steps(states, efforts):
    """(largest torque step as share of a joint's limit, that joint, largest foot force step as share of weight)"""
    torque, joint, force = 0.0, -1, 0.0
    for (_, a), (_, b) in zip(states, states[1:]):
        for k in range(b.joint_count):
            step = abs(b.tau[k] - a.tau[k]) / efforts[k]
            if step > torque:
                torque, joint = step, k
        for foot in (0, 1):
            force = max(force, abs(foot_force(b, foot) - foot_force(a, foot)) / WEIGHT)
    return torque, joint, force


def line_of(states, i, at_ns):
    """When a STATE came, and how long before and after it the next ones."""
    near = states[max(0, i - 2):i + 4]
    gaps = ", ".join(f"{(b[0] - a[0]) * 1e-6:.2f}" for a, b in zip(near, near[1:]))
    at, state = states[i]
    return f"tick {state.tick} of run {state.run_id}, {(at - at_ns) * 1e-6:.1f} ms after the switch, STATEs around it {gaps} ms apart"


def figures(bus, new_run, at_ns, efforts):
    """at_ns: steady clock of the first STATE of new_run."""
    f = SwitchFigures()
    f.from_ns, f.to_ns = at_ns - BEFORE_NS, at_ns + AFTER_NS
    states = list(bus.messages("STATE", at_ns - BEFORE_NS, at_ns + AFTER_NS))
    commands = {message.tick for _, message in bus.messages("COMMAND", at_ns - BEFORE_NS, at_ns + AFTER_NS + 50_000_000)}
    ticks = [message.tick for _, message in states]
    first = next(i for i, (_, message) in enumerate(states) if message.run_id == new_run)
    # The newest ticks may still be on their way.
    unanswered = [i for i, tick in enumerate(ticks[:-3]) if tick not in commands]
    f.ticks_without_command = len(unanswered)
    f.unanswered = [line_of(states, i, at_ns) for i in unanswered]
    f.gap_ticks = max(0, states[first][1].tick - states[first - 1][1].tick - 1) if first else 0
    near = states[max(0, first - 10):first + 10]
    f.gap_ms = max(((b[0] - a[0]) * 1e-6 for a, b in zip(near, near[1:])), default=0.0)
    granted = states[first][1].tick
    f.double_ticks = sum(1 for _, message in states if message.run_id != new_run and message.tick > granted + 3)
    f.two_obeying = sum(1 for _, message in states if message.run_id != new_run and message.tick > granted
                        and message.role == 2)

    own = []
    for channel in OWN_CHANNELS:
        own += [(at, m) for at, m in bus.messages(channel, at_ns - BEFORE_NS, at_ns) if m.run_id == new_run]
    own += [(at, m) for at, m in states if m.run_id == new_run]
    own.sort(key=lambda pair: pair[0])
    begin = next(i for i, (at, _) in enumerate(own) if at >= at_ns)

    f.torque_step, f.torque_joint, f.force_step = steps(own[max(0, begin - 1):begin + STEP_TICKS], efforts)
    f.background_torque_step, _, f.background_force_step = steps(own[max(0, begin - 60):max(0, begin - 1)], efforts)
    if first:
        f.across_torque, _, f.across_force = steps(states[first - 1:first + 1], efforts)
    for _, status in bus.messages("CONTROLLER_STATUS", at_ns, at_ns + AFTER_NS):
        f.zmp_margin_mm = min(f.zmp_margin_mm, 1e3 * status.zmp_margin)
    f.tilt_deg = max(tilt(message) for _, message in states)
    f.fell = f.tilt_deg > 20.0 or any(truth.fell for _, truth in bus.messages("TRUTH", at_ns - BEFORE_NS))
    return f


def judge_continuity(f, checks, what):
    """Of ticks and balance, whatever the body feels."""
    checks.that(f.ticks_without_command == 0, f"{what}: {f.ticks_without_command} ticks without a command "
                f"{'; '.join(f.unanswered)}")
    checks.at_most(f.gap_ticks, 1, f"{what}: ticks nobody published")
    checks.that(f.double_ticks == 0 and f.two_obeying == 0,
                f"{what}: two sources at once ({f.double_ticks} late states, {f.two_obeying} active states of the old one)")
    checks.at_least(f.zmp_margin_mm, 10.0, f"{what}: ZMP margin of the next 0.5 s [mm]")
    checks.that(not f.fell, f"{what}: nobody falls")


def judge(f, checks, what):
    judge_continuity(f, checks, what)
    checks.at_most(f.torque_step, 0.05, f"{what}: torque step of joint {f.torque_joint} as share of its limit")
    checks.at_most(f.force_step, 0.10, f"{what}: foot force step as share of weight")
