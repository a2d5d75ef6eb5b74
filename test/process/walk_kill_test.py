#!/usr/bin/env python3
"""kill -9 of the controller at random instants of a walk, in a simulator and behind the bridge: the source follows the stop plan,
nobody falls, and the controller that is started anew balances the robot where the plan has ended.  Word `others`: guard, planner,
viewer and recorder killed and stopped, and the simulator stopped, while the robot walks: it walks on.

    walk_kill_test.py [sim] [bridge] [others]

KILLS=N says how many of each (TWINBUS_FULL=1: 50, otherwise 2; of each of the others a fifth; as a rule four of them once).  The seed is printed; KILL_SEED=N repeats a run.
"""

import os
import random
import signal
import subprocess
import sys
import time

import harness
from harness import Bus, Checks, Stack
from switch_figures import tilt

SCENES = {"sim": ("walk_forward", "walk_rough", "walk_slope"), "bridge": ("walk_forward",)}
WALKS, BALANCES = 5, 4  # modes of CONTROLLER_STATUS
FALLEN = 20.0   # [degrees]
AFTER = 5.0     # watched after the kill [s]
UPRIGHT = 8.6   # of one that stands [degrees]
LOADED = 100.0  # of a foot [N]
OTHERS = ("guard", "planner", "viewer", "recorder")
BACK = 15.0     # a process that was killed is started again within [s]
DEVICE = 8      # reason of a stop: the robot behind the bridge was not heard for 50 ms


def one_kill(checks, kind, scene, rng):
    """A word for the table."""
    words = [scene, "--no-viewer", "--no-record"] + (["--stack", "bridge"] if kind == "bridge" else [])
    with Stack(*words) as stack:
        bus = Bus()
        what = f"{kind}, {scene}"
        walking = bus.wait_for("CONTROLLER_STATUS", lambda c: c.mode == WALKS, 30.0)[1]
        if not checks.that(walking is not None, f"{what}: the robot walks"):
            return "does not walk"
        time.sleep(2.5 + 5.0 * rng.random())
        bus.forget()
        time.sleep(0.1)
        killed = time.monotonic_ns()
        os.kill(stack.pid("twinbus_controller"), signal.SIGKILL)
        time.sleep(AFTER)
        states = [s for _, s in bus.messages("STATE", killed)]
        most = max((tilt(s) for s in states), default=99.0)
        fell = most > FALLEN or any(t.fell for _, t in bus.messages("TRUTH", killed))
        led = any(s.plan_number for s in states)
        last = states[-1] if states else None
        feet = min(abs(last.wrench[foot][2]) for foot in (0, 1)) if last else 0.0
        stands = last is not None and tilt(last) < UPRIGHT and feet > LOADED
        taken = bus.newest("CONTROLLER_STATUS")[1]
        good = checks.that(not fell, f"{what}: nobody falls, tilt {most:.1f} degrees")
        failed = bus.newest("SOURCE_STATUS", lambda m: m.stop_reason == DEVICE)[1] is not None  # then it is held at once
        good = checks.that(led or failed, f"{what}: the stop plan is followed") and good
        good = checks.that(stands, f"{what}: it stands on both feet, the lighter one with {feet:.0f} N") and good
        again = last is not None and last.stop_kind == 0 and taken is not None and taken.mode == BALANCES
        if not good:
            print("".join(stack.lines[-6:]) + "\n".join(harness.story_of_a_stop(bus)), flush=True)
        bus.close()
        return f"{'good' if good else 'BAD'}, tilt {most:.1f} degrees, {'balances again' if again else 'held'}"


def walks_on(checks, stack, bus, what, fault):
    """A fault in the middle of a walk; true when it goes on."""
    bus.forget()
    time.sleep(0.1)
    began = time.monotonic_ns()
    fault()
    time.sleep(1.5)
    most = max((tilt(s) for _, s in bus.messages("STATE", began)), default=99.0)
    fell = most > FALLEN or any(t.fell for _, t in bus.messages("TRUTH", began))
    state, status = bus.newest("STATE")[1], bus.newest("CONTROLLER_STATUS")[1]
    good = checks.that(not fell, f"{what}: nobody falls, tilt {most:.1f} degrees")
    good = checks.that(state is not None and state.stop_kind == 0, f"{what}: nothing is stopped") and good
    places = [t.base_position[:2] for _, t in bus.messages("TRUTH", time.monotonic_ns() - 1_000_000_000)][::10]
    way = sum(((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5 for a, b in zip(places, places[1:]))
    good = checks.that(status is not None and status.mode == WALKS and way > 0.1, f"{what}: it walks on, {way:.2f} m in a second") and good
    if not good:
        print("".join(stack.lines[-6:]) + "\n".join(harness.story_of_a_stop(bus)), flush=True)
    return good


def others(checks, count, rng):
    """Each of them `count` times, a few in each walk: `up` starts a process again at most 5 times."""
    def stopped(program, ms):
        pid = stack.pid(program, BACK)
        os.kill(pid, signal.SIGSTOP)
        time.sleep(1e-3 * ms)
        os.kill(pid, signal.SIGCONT)

    os.environ["TWINBUS_RECORD"] = "1"  # the recorder is one of them
    table = {}
    for left in range(count, 0, -4):
        with Stack("stand", "--for", "900") as stack:
            bus = Bus()
            time.sleep(3.0)
            harness.cli("mode", "walk")
            time.sleep(1.0)
            for _ in range(min(left, 4)):
                faults = [(f"{name} killed", lambda name=name: os.kill(stack.pid("twinbus_" + name, BACK), signal.SIGKILL))
                          for name in OTHERS]
                faults += [(f"{name} stopped for a while", lambda name=name: stopped("twinbus_" + name, rng.choice((20, 50, 200, 1000))))
                           for name in OTHERS]
                faults += [(f"simulator stopped for {ms} ms", lambda ms=ms: stopped("twinbus_simulator", ms)) for ms in (20, 50, 100, 200)]
                rng.shuffle(faults)
                if not (harness.FULL or "KILLS" in os.environ):
                    faults = faults[:4]
                for name, fault in faults:
                    if not stack.pids("twinbus_recorder"):  # nothing else starts it again
                        harness.cli("restart", "recorder")
                    words = ["walk", "0.4", "0", rng.choice(("0.2", "0", "-0.2")), "--for", "20"]
                    steers = subprocess.Popen([harness.BIN / "twinbus", *words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    time.sleep(2.0 + rng.random())
                    good = walks_on(checks, stack, bus, name, fault)
                    steers.kill()
                    steers.wait()
                    if not good:
                        harness.cli("clear")
                        harness.cli("mode", "balance")
                        time.sleep(1.0)
                        harness.cli("mode", "walk")
                    row = table.setdefault(name, [0, 0])
                    row[0] += good
                    row[1] += 1
            bus.close()
    for name, (good, of) in sorted(table.items()):
        print(f"{name}: {good} of {of} walk on", flush=True)


def main():
    harness.require(*harness.STACK, "twinbus_bridge",
                    "emulated_robot")
    seed = int(os.environ.get("KILL_SEED", random.randrange(1 << 30)))
    print(f"KILL_SEED={seed}", flush=True)
    rng = random.Random(seed)
    count = int(os.environ.get("KILLS", 50 if harness.FULL else 2))
    checks = Checks()
    words = sys.argv[1:] or [*SCENES, "others"]
    if "others" in words:
        others(checks, max(1, count // 5), rng)
    for kind in [word for word in words if word in SCENES]:
        good = 0
        for number in range(count):
            scene = SCENES[kind][number % len(SCENES[kind])]
            word = one_kill(checks, kind, scene, rng)
            good += word.startswith("good")
            print(f"{kind} {number}, {scene}: {word}", flush=True)
        print(f"{kind}: {good} of {count} stand", flush=True)
    checks.exit()


if __name__ == "__main__":
    main()
