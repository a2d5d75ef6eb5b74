#!/usr/bin/env python3
"""Two operators with a pad each, through SDL: pads appear, vanish and reappear in the middle of a motion.

A pad that vanishes or is let go sends zeros within 20 ms, and the robot comes back; who holds on while another drives gets
nothing until he lets go and takes hold anew; a pad that reappears drives nothing by itself.  TWINBUS_FULL=1: 100 times,
otherwise 5.  The seed is printed; PADS_SEED=N repeats a run.
"""

import os
import random
import subprocess
import time

import harness
from harness import BIN, Bus, Checks, Stack

ROUNDS = 100 if harness.FULL else 5
HOLD = 512  # left bumper
FULL_STICK = -32768
FORWARD, LEFT = 1, 0  # axes of the pad; the centre of mass goes along x and y
LEANS = 0.008  # then a stick drives the robot [m]
STILL = 0.002  # then it does not [m]
ZERO_WITHIN = 0.020  # [s]

harness.CHANNEL_TYPES.setdefault("GAMEPAD", "gamepad_t")


class Pad:
    """A pad that exists in SDL only, in a gamepad process of its own."""

    def __init__(self, identity):
        self.identity = identity
        self.child = subprocess.Popen([BIN / "twinbus", "gamepad", "--virtual", "--id", str(identity)],
                                      stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, bufsize=0)

    def say(self, *lines):
        """Gives the instant on the wall clock at which the pad was told [us]."""
        self.child.stdin.write("".join(line + "\n" for line in lines).encode())
        return 1e6 * time.time()

    def hold(self):
        self.say(f"press {HOLD}")

    def let_go(self):
        return self.say(f"release {HOLD}")

    def stick(self, axis, value):
        self.say(f"axis {axis} {value}")

    def close(self):
        self.child.stdin.close()
        return self.child.wait(5)


class Operators:
    def __init__(self, bus, checks):
        self.bus, self.checks = bus, checks
        self.home = bus.newest("CONTROLLER_STATUS")[1].com_reference
        self.late = []  # from letting go or vanishing to zeros [s]

    def until(self, axis, accept, what, seconds=3.0):
        """Waits for the commanded centre of mass along an axis of the pad."""
        xy = 1 - axis
        found = self.bus.wait_for("CONTROLLER_STATUS", lambda s: accept(s.com_reference[xy] - self.home[xy]), seconds)[1]
        self.checks.that(found is not None, what)

    def leans(self, axis, what):
        self.until(axis, lambda x: x > LEANS, f"{what} leans the robot")

    def returns(self, axis, what):
        self.until(axis, lambda x: abs(x) < STILL / 4, f"{what}: the robot comes back")

    def seen(self, pad, accept, what):
        found = self.bus.wait_for("GAMEPAD", lambda g: g.sender_id == pad.identity and accept(g), 2.0)[1]
        self.checks.that(found is not None, what)

    def moves_nothing(self, axis, what, seconds=0.15):
        since = time.monotonic_ns()
        time.sleep(seconds)
        xy = 1 - axis
        most = max((abs(s.com_reference[xy] - self.home[xy]) for _, s in self.bus.messages("CONTROLLER_STATUS", since)),
                   default=float("nan"))
        self.checks.at_most(most, STILL, f"{what}: metres moved along axis {axis}")

    def zeros(self, pad, told_us, what):
        """How long after the pad was told its first message without a grip went out, and none with a grip follows."""
        time.sleep(0.06)
        mine = [g for _, g in self.bus.messages("GAMEPAD") if g.sender_id == pad.identity and g.utime >= told_us]
        free = [g for g in mine if not g.deadman]
        took = 1e-6 * (free[0].utime - told_us) if free else float("inf")
        self.late.append(took)
        self.checks.at_most(took, ZERO_WITHIN, f"{what}: seconds to zeros")
        self.checks.that(all(g.left_x == g.left_y == g.right_x == g.right_y == 0 for g in free), f"{what}: every axis is zero")
        self.checks.that(free and all(not g.deadman for g in mine[mine.index(free[0]):]), f"{what}: and it stays so")

    def one_round(self, number, first, second, vanishes):
        self.bus.forget()
        tell = f"round {number}"
        first.hold()
        self.seen(first, lambda g: g.deadman, f"{tell}: the first operator takes hold")
        first.stick(FORWARD, FULL_STICK)
        self.leans(FORWARD, f"{tell}: the first operator")
        second.hold()
        self.seen(second, lambda g: g.deadman, f"{tell}: the second operator presses his button")
        second.stick(LEFT, FULL_STICK)
        self.seen(second, lambda g: g.left_x > 0.9, f"{tell}: the second holds on too")
        self.moves_nothing(LEFT, f"{tell}: the second while the first drives")
        told = first.say("unplug") if vanishes else first.let_go()
        self.zeros(first, told, f"{tell}: the first pad {'vanishes' if vanishes else 'is let go'}")
        self.returns(FORWARD, f"{tell}: the first is gone")
        if vanishes:
            first.say("plug", f"axis {FORWARD} {FULL_STICK}")
            self.seen(first, lambda g: g.connected, f"{tell}: the first pad is there again")
        else:
            first.stick(FORWARD, 0)
        self.moves_nothing(LEFT, f"{tell}: the second, who only held on")
        self.moves_nothing(FORWARD, f"{tell}: the first pad, which nobody holds")
        second.let_go()
        second.stick(LEFT, 0)
        self.seen(second, lambda g: not g.deadman, f"{tell}: the second lets go")
        second.hold()
        self.seen(second, lambda g: g.deadman, f"{tell}: and takes hold anew")
        second.stick(LEFT, FULL_STICK)
        self.leans(LEFT, f"{tell}: the second, who took hold anew,")
        self.zeros(second, second.say("unplug"), f"{tell}: the second pad vanishes")
        self.returns(LEFT, f"{tell}: the second is gone")
        second.say("plug", f"axis {LEFT} 0")
        first.stick(FORWARD, 0)
        self.seen(second, lambda g: g.connected, f"{tell}: the second pad is there again")


def one_stack(checks, rng, rounds):
    """Gives how long each pad took to send zeros [s]."""
    bus = Bus()
    time.sleep(1.0)
    operators = Operators(bus, checks)
    pads = [Pad(1001), Pad(1002)]
    for pad in pads:
        pad.say("plug")
        checks.that(bus.wait_for("GAMEPAD", lambda g, pad=pad: g.sender_id == pad.identity and g.connected, 10)[1]
                    is not None, f"pad {pad.identity} appears")
    time.sleep(0.5)
    for number in rounds:
        rng.shuffle(pads)
        operators.one_round(number, *pads, vanishes=rng.random() < 0.7)
        if bus.newest("STATE")[1].stop_kind != 0:
            break
    if not checks.that(bus.newest("STATE")[1].stop_kind == 0, "the robot was never stopped"):
        print("\n".join(harness.story_of_a_stop(bus)))
    checks.that(not any(t.fell for _, t in bus.messages("TRUTH")), "nobody falls")
    checks.that(all(pad.close() == 0 for pad in pads), "both pads end well")
    bus.close()
    return operators.late


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard", "twinbus_gamepad")
    seed = int(os.environ.get("PADS_SEED", random.randrange(1 << 30)))
    print(f"PADS_SEED={seed}")
    rng = random.Random(seed)
    checks = Checks()
    with Stack("stand", "--no-viewer"):
        late = one_stack(checks, rng, range(ROUNDS))
    print(f"{ROUNDS} rounds, {len(late)} times let go or vanished: zeros after {1e3 * sorted(late)[len(late) // 2]:.1f} ms "
          f"(median), {1e3 * max(late):.1f} ms at the latest")
    checks.exit()


if __name__ == "__main__":
    main()
