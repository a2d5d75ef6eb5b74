#!/usr/bin/env python3
"""./twinbus bench walkers [--seeds N] [--seconds S] [--worlds W,...] [--courses C,...] [--csv F] [--policy MODEL.onnx [--spec FILE] ...]: our walker
beside learned policies on one robot, over the same courses, with the same pushes, in every engine, with equal seeds.

The robot is G1 as `check --propose` writes it from $TWINBUS_DATA (or --robot FILE), every walker is asked for 0.5 m/s forward (--speed).
Courses: flat; pushed (all round: every 2 s an impulse that changes the speed of the robot by 0.3 m/s forward or back, 0.2 m/s sideways);
tiles (of 30 mm).  Without --policy: the G1 policy of $TWINBUS_DATA.  Sensors are noisy, so seeds differ.  Printed per course, world and walker:
how much of the time it walked, falls, and how wrong its mean velocity was.  Specifications that are not named are looked for as by
./twinbus policy (--spec - for one of several).  Policies need $TWINBUS_POLICY_PYTHON.
Exit status 1 if our walker falls more often than a policy."""
import argparse
import csv
import itertools
import math
import os
import pathlib
import sys
import tempfile

import programs
from bench_any_robot import NOISE
from bench_sim2sim import G, Foreign, Ours, Track, proposed

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORLDS = ("articulated", "articulated/soft", "ode", "mujoco")
BEGIN = 3.0   # from here on the velocity counts, and pushes come [s]
COURSES = {"flat": "",
           "pushed": "push_round: {at: 3, every: 2, count: 64, phase: 0.6, forward: 0.3, back: 0.3, sideways: 0.2}\n",
           "tiles": "terrain: {tile: 0.4, height: 0.03, slope_deg: 0, from: 0.8, length: 12, width: 2.4}\n"}
FIELDS = ("course", "world", "walker", "runs", "falls", "completed", "vx", "vy", "wz", "error")


def scene_of(course, seconds, vx, ours):
    """Of our controller it has the requests too."""
    text = f"duration: {seconds:g}\n{COURSES[course]}settings:\n" + "".join(f"  sensor.noise.{key}: {value}\n" for key, value in NOISE.items())
    if ours:
        text += (f"modes:\n  - {{at: 0, mode: balance}}\n  - {{at: 0.5, mode: walk}}\nwalks:\n  - {{at: 1, for: {seconds:g}, vx: {vx:g}}}\n")
    return text


def judged(track, seconds, vx):
    """Share of the time that it walked, and its mean velocity."""
    samples = track.samples
    end = next((s.time for s in samples if s.tilt > 1.0), samples[-1].time)
    kept = [s for s in samples if BEGIN <= s.time <= end]
    if len(kept) < 2:
        return end / seconds, [0.0, 0.0, 0.0], abs(vx)
    forward = sum(s.speed for s in kept) / len(kept)
    left = sum(s.aside for s in kept) / len(kept)
    turn = (kept[-1].heading - kept[0].heading) / (kept[-1].time - kept[0].time)
    return min(1.0, end / seconds), [forward, left, turn], math.dist((forward, left), (vx, 0.0))


def row_of(course, world, walker, seconds, vx, seeds):
    """A row of the table, or None where the world is not there."""
    falls, shares, velocities, errors = 0, [], [], []
    for seed in range(1, seeds + 1):
        track = walker.track(world, seed)
        if not isinstance(track, Track) or not track.samples:
            print(f"{walker.name}: {world} is left out: {track if isinstance(track, str) else 'nothing was logged'}", flush=True)
            return None
        share, velocity, error = judged(track, seconds, vx)
        falls += track.fell or share < 0.99
        shares.append(share)
        velocities.append(velocity)
        errors.append(error)
    means = [sum(v[k] for v in velocities) / seeds for k in range(3)]
    return dict(zip(FIELDS, (course, world, walker.name, seeds, falls, f"{sum(shares) / seeds:.3f}", *(f"{m:.3f}" for m in means), f"{sum(errors) / seeds:.3f}")))


def main(arguments):
    if {"-h", "--help"} & set(arguments):
        print(__doc__)
        return 0
    parser = argparse.ArgumentParser(prog="bench walkers")
    parser.add_argument("--robot", default="")
    parser.add_argument("--policy", action="append", default=[])
    parser.add_argument("--spec", action="append", default=[])
    parser.add_argument("--worlds", default=",".join(WORLDS))
    parser.add_argument("--courses", default=",".join(COURSES))
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--speed", type=float, default=0.5)
    parser.add_argument("--csv", default="")
    words = parser.parse_args(arguments)
    unknown = [c for c in words.courses.split(",") if c not in COURSES]
    if unknown:
        parser.error(f"no course {unknown[0]}; there are {', '.join(COURSES)}")
    if len(words.spec) > len(words.policy):
        parser.error("more --spec than --policy")
    other = os.environ.get("TWINBUS_POLICY_PYTHON")
    if other and not os.environ.get("TWINBUS_POLICY_RUNS"):
        os.execve(other, [other, __file__, *arguments], dict(os.environ, TWINBUS_POLICY_RUNS="1"))
    data = pathlib.Path(os.environ.get("TWINBUS_DATA", ROOT.parent / "shared/data"))
    robot = words.robot or str(data / "robots/g1/g1_29dof_rev_1_0.urdf")
    policies = [(model, "" if spec == "-" else spec) for model, spec in itertools.zip_longest(words.policy, words.spec, fillvalue="")]
    if not words.robot and not policies:
        policies = [(str(data / "policies/g1_policy.onnx"), str(ROOT / "test/python/policies/g1_playground.spec.yaml"))]
    if not words.robot and not pathlib.Path(robot).is_file():
        print("skipped: $TWINBUS_DATA has no robots/g1; name a --robot")
        return 77
    twinbus, rows, fallen = str(programs.folder_of("twinbus", "bench walkers", *(programs.POLICY_RUNS if policies else ())) / "twinbus"), [], {}
    with tempfile.TemporaryDirectory() as scratch:
        folder, mass, _ = proposed(twinbus, robot, f"{scratch}/robot")
        for course in words.courses.split(","):
            files = {ours: pathlib.Path(scratch) / f"{course}{int(ours)}.yaml" for ours in (True, False)}
            for ours, file in files.items():
                file.write_text(scene_of(course, words.seconds, words.speed, ours))
            walkers = [Ours(twinbus, "ours", folder, files[True], words.seconds, mass * G)]
            try:
                walkers += [Foreign(model, spec, folder, (words.speed, 0.0, 0.0), words.seconds, mass * G, files[False]) for model, spec in policies]
            except ImportError as error:
                print(f"policies are left out: {error.name} is missing; set TWINBUS_POLICY_PYTHON", flush=True)
            for world in words.worlds.split(","):
                for walker in walkers:
                    row = row_of(course, world, walker, words.seconds, words.speed, words.seeds)
                    if row is None:
                        continue
                    rows.append(row)
                    fallen[walker.name] = fallen.get(walker.name, 0) + row["falls"]
                    print("| " + " | ".join(str(row[field]) for field in FIELDS) + " |", flush=True)
    if words.csv and rows:
        with open(words.csv, "w", newline="", encoding="utf-8") as out:
            writer = csv.DictWriter(out, FIELDS)
            writer.writeheader()
            writer.writerows(rows)
    print("falls: " + ", ".join(f"{name} {count}" for name, count in fallen.items()))
    return 1 if not rows or any(fallen.get("ours", 0) > count for count in fallen.values()) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
