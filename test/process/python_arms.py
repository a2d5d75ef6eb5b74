#!/usr/bin/env python3
"""The package's Arm on the robot of named_arms_test.py, in a program of its own: the test's process has the message types of lcm-gen under
the same name.  Prints what each call says, one line each."""

import pathlib
import sys
import time
import types

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
import twinbus  # noqa: E402

ARMS = {"east": 3, "north": 4, "west": 5}
JOINTS = [f"{arm}_{part}" for arm in ARMS for part in ("turn", "pitch", "elbow")] + ["north_slide"]
# As twinbus.Robot(FOLDER).info has it (test/python/compiled_test.py), without the compiled part.
INFO = types.SimpleNamespace(hands=ARMS, grippers={"north": {"north_slide": (0.0, 0.05)}}, joints=JOINTS)


def say(what, ask):
    try:
        ask()
        print(f"{what}: done", flush=True)
    except (ValueError, TimeoutError) as error:
        print(f"{what}: {error}", flush=True)


def main():
    with twinbus.Bus() as bus:
        north, west = (twinbus.Arm(bus, name, INFO) for name in ("north", "west"))
        say("reach west", lambda: west.reach((-0.6, 0.15, 0.75)))
        say("reach far", lambda: west.reach((-3.0, 0.0, 0.7)))
        say("attach north", lambda: north.attach("sphere", (0.03,), (0.1, 0.0, 0.0)))
        time.sleep(0.3)
        say("release north", north.release)
        say("grip north", lambda: north.grip(0.2))
        say("grip west", lambda: west.grip(1.0))
        say("south", lambda: twinbus.Arm(bus, "south", INFO))
        say("north alone", lambda: twinbus.Arm(bus, "north"))
        say("ninth", lambda: twinbus.Arm(bus, 9))
        say("left", lambda: west.reach((0.0, 0.0, 0.0), speed=0.0))
        say("cone", lambda: west.attach("cone", (1.0,)))
        say("edges", lambda: west.attach("box", (1.0,)))


if __name__ == "__main__":
    main()
