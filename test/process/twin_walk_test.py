#!/usr/bin/env python3
"""hrp2p walks in the simulator and behind the hardware bridge with the same controller, and both walks are much the same.

    twin_walk_test.py [--out FOLDER]

--out: the rows of `./twinbus chart walk twin snapshots` (the paper's Figs. 13, 16 and 17) as twin.csv and snapshots.csv.

How far apart they may be is not measured but follows from what every walk of ours is judged by: a source may miss the force
asked of a foot by 7 % of the weight and tilt by 2 degrees, so two may differ by twice that.
"""

import csv
import math
import pathlib
import sys

import harness
import twin_walk
from harness import Checks

ROBOT, SPEED, SECONDS = "hrp2p", 0.6, 6.0  # [m/s, s]
SETTLED = 2.0                              # the walk is steady then [s]
SHOWN = 5.0                                # what is drawn ends there [s]
FORCE, TILT, PACE = 0.07, math.radians(2.0), 0.1  # share of the weight, [rad], share of the speed
HALF_STEP, SNAPSHOTS = 0.28, 7             # [s]
DIGITS = {"N": 1, "N m": 2, "m": 5, "rad": 5}
WALKING = 5  # mode_request_t


def judge(checks, walks, rows, weight):
    ticks = range(round(SECONDS / twin_walk.PERIOD))
    steady = ticks[round(SETTLED / twin_walk.PERIOD):]
    for number, (source, walk) in enumerate(walks.items(), 1):
        states = [walk.states[tick] for tick in ticks if tick in walk.states]
        checks.that({int(state["source"]) for state in states} == {number}, f"{source}: STATE is its own")
        checks.that({int(state["stop_kind"]) for state in states} == {0}, f"{source}: nobody stopped it")
        checks.that(all(int(walk.status[tick]["mode"]) == WALKING for tick in ticks if tick in walk.status), f"{source}: it walks to the end")
        checks.at_most(walk.lost, 0, f"{source}: ticks lost")
        tilt = max(abs(row[f"{angle}_{source}"]) for row in rows for angle in ("roll", "pitch"))
        checks.at_most(math.degrees(tilt), math.degrees(TILT), f"{source}: tilt [degrees]")
        first, last = (float(walk.status[round(at / twin_walk.PERIOD)]["base_position[0]"]) for at in (SETTLED, SECONDS))
        speed = (last - first) / (SECONDS - SETTLED)
        checks.at_most(abs(speed / SPEED - 1.0), PACE, f"{source}: walks at {speed:.3f} m/s, off by the share")
        print(f"{source}: {walk.lifts(steady, weight)} steps of the left foot, {speed:.3f} m/s, tilt at most {math.degrees(tilt):.2f} degrees, "
              f"{sum(tick not in walk.status for tick in ticks)} ticks unanswered", flush=True)
    runs = {walk.states[0]["run_id"] for walk in walks.values()}
    checks.at_least(len(runs), 2, "runs")
    steps = {walk.lifts(steady, weight) for walk in walks.values()}
    checks.that(len(steps) == 1 and min(steps) >= 3, f"both step alike: {steps}")
    checks.at_least(len(rows), 0.99 * (SECONDS - SETTLED) / twin_walk.PERIOD, "ticks that both have")
    for name, unit in twin_walk.QUANTITIES.items():
        print(f"{name}: rms difference {twin_walk.rms_difference(rows, name):.4g} {unit}", flush=True)
    for foot in ("left", "right"):
        share = twin_walk.rms_difference(rows, foot) / weight
        checks.at_most(share, 2.0 * FORCE, f"{foot} foot: rms difference of the force, of the weight")
        checks.at_least(share, 1e-3, f"{foot} foot: the bodies are not the same, rms difference of the force, of the weight")
    for angle in ("roll", "pitch"):
        checks.at_most(twin_walk.rms_difference(rows, angle), 2.0 * TILT, f"rms difference of {angle} [rad]")


def write(file, rows):
    with open(file, "w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)


def snapshots(walks):
    for source, walk in walks.items():
        for k in range(SNAPSHOTS):
            time = SETTLED + k * HALF_STEP
            joints, base = walk.posture(round(time / twin_walk.PERIOD))
            yield {"source": source, "time": round(time, 3)} | {name: round(value, 5) for name, value in (base | joints).items()}


def main(words):
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard", "twinbus_bridge", "twinbus_recorder",
                    "emulated_robot")
    checks = Checks()
    walks = twin_walk.walk_on_both(ROBOT, SPEED, SECONDS + 1.0)
    rows = list(twin_walk.side_by_side(walks, SETTLED, SECONDS))
    judge(checks, walks, rows, 9.81 * sum(float(mass.get("value")) for mass in harness.urdf_of(ROBOT).iter("mass")))
    if words[:1] == ["--out"]:
        folder = pathlib.Path(words[1])
        write(folder / "twin.csv", [{key: round(value, DIGITS[twin_walk.QUANTITIES[key.rsplit("_", 1)[0]]]) if key != "time" else value
                                     for key, value in row.items()} for row in rows if row["time"] < SHOWN])
        write(folder / "snapshots.csv", list(snapshots(walks)))
    checks.exit()


if __name__ == "__main__":
    main(sys.argv[1:])
