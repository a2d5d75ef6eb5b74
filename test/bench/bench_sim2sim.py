#!/usr/bin/env python3
"""./twinbus bench sim2sim [--robot R] [--scene S] [--seconds N] [--worlds W,...] [--csv F]: one controller in every engine, how far
they part and why.

    bench sim2sim                     our controller: hrp1s sways and walks, the G1 of $TWINBUS_DATA as `check --propose` writes it walks
    bench sim2sim --policy MODEL.onnx --spec FILE --robot R [--command VX VY WZ]      a policy instead (needs $TWINBUS_POLICY_PYTHON)

R is a name, a folder, or a URDF or MJCF file that is proposed first; S a scene that moves the robot (default: it walks at half of its
fastest speed, hrp1s walk_forward).  Worlds are an engine or engine/contact: articulated at each of its contacts, ode, and mujoco where
it is installed.  Of each world is printed, against the first one and against mujoco: where the base is, its heading, speed and tilt,
how far loaded soles have crept along the ground, the force of the left foot (root mean squares over the run); and of each run by itself
its mean speed and tilt, the creep, and how rough the force is.  From these follows which share of what mujoco and articulated part by is
MuJoCo's contact: articulated/soft has that contact and is ours in all else.  --csv F: everything over time.  Exit status 1 if a robot falls."""
import argparse
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
from dataclasses import dataclass

import programs
from bench_any_robot import walk_scene

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORLDS = ("articulated", "articulated/hunt_crossley", "articulated/patch", "articulated/soft", "ode", "mujoco")
G = 9.81
LOADED = 0.2   # of the weight: the sole stands [share]
EVERY = 0.1   # rows over time [s]
FIELDS = ("controller", "world", "time", "x", "y", "heading", "speed", "tilt", "creep", "force")
# What is compared: field, words, unit, factor.
QUANTITIES = (("place", "place", "mm", 1e3), ("heading", "heading", "degrees", math.degrees(1.0)), ("speed", "speed", "m/s", 1.0),
              ("tilt", "tilt", "degrees", math.degrees(1.0)), ("creep", "creep of soles", "mm", 1e3), ("force", "left foot", "% of weight", 100.0))


@dataclass
class Sample:
    time: float
    x: float
    y: float
    heading: float
    speed: float   # forward, in its heading [m/s]
    tilt: float
    creep: float   # sum over both soles, while they stand [m]
    force: float   # normal, of the left foot [share of the weight]
    aside: float   # to the left [m/s]


class Track:
    """What TRUTH says of one run."""

    def __init__(self, weight):
        self.samples, self.fell, self._weight, self._creep = [], False, weight, 0.0

    def add(self, time, position, attitude, velocity, forces, slips, fell):
        self.fell = self.fell or bool(fell)
        w, x, y, z = attitude
        heading = math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
        if self.samples:
            step = time - self.samples[-1].time
            self._creep += sum(step * slip for force, slip in zip(forces, slips) if force > LOADED * self._weight)
            turn = heading - self.samples[-1].heading
            heading -= 2.0 * math.pi * round(turn / (2.0 * math.pi))
        self.samples.append(Sample(time, position[0], position[1], heading, math.cos(heading) * velocity[0] + math.sin(heading) * velocity[1],
                                   math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (x * x + y * y)))), self._creep, forces[0] / self._weight,
                                   math.cos(heading) * velocity[1] - math.sin(heading) * velocity[0]))


def settings_of(world):
    engine, _, contact = world.partition("/")
    return engine, (f"contact={contact}",) if contact else ()


class Ours:
    """Our controller, in a scene."""

    def __init__(self, twinbus, name, robot, scene, seconds, weight):
        self.twinbus, self.name, self.robot, self.scene, self.seconds, self.weight = twinbus, name, robot, scene, seconds, weight

    def track(self, world, seed=1):
        """A Track, or why there is none."""
        engine, settings = settings_of(world)
        with tempfile.TemporaryDirectory() as folder:
            log, table = pathlib.Path(folder) / "run.log", pathlib.Path(folder) / "truth.csv"
            words = [self.twinbus, "run", self.scene, "--robot", self.robot, "--engine", engine, "--seed", seed, "--log", log,
                     *(["--for", str(self.seconds)] if self.seconds else [])]
            done = subprocess.run([*map(str, words), *(w for s in settings for w in ("--set", s))], capture_output=True, text=True, check=False)
            if not log.exists():
                return done.stderr.strip()
            subprocess.run([self.twinbus, "log", "csv", log, "TRUTH", table, "--numbers"], capture_output=True, check=True)
            track = Track(self.weight)
            with open(table, newline="", encoding="utf-8") as source:
                for row in csv.DictReader(source):
                    def some(name, count, row=row):
                        return [float(row[f"{name}[{k}]"]) for k in range(count)]
                    track.add(float(row["sim_time"]), some("base_position", 3), some("base_attitude", 4), some("base_velocity", 3),
                              [float(row[f"foot_force[{k}][2]"]) for k in (0, 1)], some("foot_slip", 2), int(row["fell"]))
            return track


class Foreign:
    """A policy, in lock-step.  PolicyError when it does not fit the robot."""

    def __init__(self, model, spec, folder, command, seconds, weight, scene="stand_python"):
        sys.path.insert(0, str(ROOT / "python"))
        from twinbus.policy import find, network, robot, trial  # pylint: disable=import-outside-toplevel
        self._trial, self.folder, self.command, self.seconds, self.weight = trial, folder, tuple(command), seconds or 12.0, weight
        self.scene, self.robot, self.network = scene, robot.from_folder(str(folder)), network.Network(pathlib.Path(model))
        self.spec = find.find(self.network, self.robot, spec)
        path = pathlib.Path(model)
        kind = path.stem if path.stem != "policy" else next((p.name for p in path.absolute().parents if p.name != "exported"), path.stem)
        self.name = f"{kind} {command[0]:g} {command[1]:g} {command[2]:g}"

    def track(self, world, seed=1):
        engine, settings = settings_of(world)
        track = Track(self.weight)

        def look(_, truth):
            track.add(truth.sim_time, truth.base_position, truth.base_attitude, truth.base_velocity, [f[2] for f in truth.foot_force],
                      truth.foot_slip, truth.fell)
        from twinbus.policy.errors import PolicyError  # pylint: disable=import-outside-toplevel
        try:
            end = self._trial.run(self.network, self.spec, self.robot, str(self.folder), self.command, self.seconds, seed, engine, settings,
                                  scene=str(self.scene), look=look)
        except PolicyError as error:
            return str(error)
        track.fell = track.fell or bool(end.stopped)
        return track


# Of one run by itself, from 2 s on: two walks that bounce are soon in other phases, and then no instant is like the other.
FIGURES = (("speed", "mean speed", "m/s"), ("tilt", "mean tilt", "degrees"), ("creep", "creep of soles", "mm/s"),
           ("rough", "change of the left foot's force in a tick, rms", "% of weight"))


def figures_of(track):
    late = [s for s in track.samples if s.time > 2.0] or track.samples
    count, span = len(late), max(1e-9, late[-1].time - late[0].time)
    changes = [(b.force - a.force) ** 2 for a, b in zip(late, late[1:])]
    return {"speed": sum(s.speed for s in late) / count, "tilt": math.degrees(sum(s.tilt for s in late) / count),
            "creep": 1e3 * (late[-1].creep - late[0].creep) / span, "rough": 100.0 * math.sqrt(sum(changes) / max(1, len(changes)))}


def apart(quantity, one, other):
    """Root mean square over the time that both have."""
    pairs = list(zip(one.samples, other.samples))
    if quantity == "place":
        squares = [(a.x - b.x) ** 2 + (a.y - b.y) ** 2 for a, b in pairs]
    else:
        squares = [(getattr(a, quantity) - getattr(b, quantity)) ** 2 for a, b in pairs]
    return math.sqrt(sum(squares) / max(1, len(squares)))


def compared(controller, tracks):
    """Prints the tables; the share of MuJoCo's contact by quantity."""
    for other in [next(iter(tracks))] + (["mujoco"] if "mujoco" in tracks else []):
        print(f"| {controller}: apart from {other}, rms | " + " | ".join(f"{words} [{unit}]" for _, words, unit, _ in QUANTITIES) + " | fell |", flush=True)
        for world, track in tracks.items():
            row = [f"{factor * apart(q, track, tracks[other]):.3g}" for q, _, _, factor in QUANTITIES]
            print(f"| {world} | " + " | ".join(row) + f" | {'yes' if track.fell else 'no'} |", flush=True)
    runs = {world: figures_of(track) for world, track in tracks.items()}
    print(f"| {controller}: each run | " + " | ".join(f"{words} [{unit}]" for _, words, unit in FIGURES) + " |", flush=True)
    for world, run in runs.items():
        print(f"| {world} | " + " | ".join(f"{run[figure]:.3g}" for figure, *_ in FIGURES) + " |", flush=True)
    if not {"articulated", "articulated/soft", "mujoco"} <= tracks.keys():
        return {}
    shares = {}
    for figure, *_ in FIGURES:
        all_of_it, rest = (abs(runs[world][figure] - runs["mujoco"][figure]) for world in ("articulated", "articulated/soft"))
        shares[figure] = 1.0 - rest / all_of_it if all_of_it > 0.0 else 0.0
    print(f"{controller}: share of MuJoCo's contact in what articulated and mujoco part by: "
          + ", ".join(f"{words} {100.0 * shares[figure]:.0f} %" for figure, words, _ in FIGURES), flush=True)
    return shares


def rows_over_time(controller, tracks):
    for world, track in tracks.items():
        due = 0.0
        for s in track.samples:
            if s.time >= due - 1e-9:
                due += EVERY
                yield dict(zip(FIELDS, (controller, world, f"{s.time:.3f}", *(f"{v:.6g}" for v in (s.x, s.y, s.heading, s.speed, s.tilt, s.creep, s.force)))))


def measured(controller, worlds):
    tracks = {}
    for world in worlds:
        track = controller.track(world)
        if isinstance(track, Track) and track.samples:
            tracks[world] = track
        else:
            print(f"{controller.name}: {world} is left out: {track if isinstance(track, str) else 'nothing was logged'}", flush=True)
    return tracks


def proposed(twinbus, file, folder):
    """The folder of a robot, its mass and half of its fastest speed."""
    done = subprocess.run([twinbus, "check", file, *(["--propose", folder] if pathlib.Path(file).is_file() else []), "--json"],
                          capture_output=True, text=True, check=False)
    try:
        report = json.loads(done.stdout)
    except ValueError:
        sys.exit(f"bench sim2sim: {file}: {done.stderr.strip()}")
    speed = 0.5 * (((report.get("trial") or {}).get("walk") or {}).get("fastest_m_s") or 0.0)
    return (folder if pathlib.Path(file).is_file() else file), report["mass_kg"], speed


def controllers(twinbus, words, scratch):
    """What is asked for."""
    robots = [words.robot] if words.robot else ["hrp1s"]
    g1 = pathlib.Path(os.environ.get("TWINBUS_DATA", ROOT.parent / "shared/data")) / "robots/g1/g1_29dof_rev_1_0.urdf"
    if not words.robot and g1.is_file():
        robots.append(str(g1))
    if not words.robot and not words.scene and not words.policy:
        yield Ours(twinbus, "hrp1s sways", "hrp1s", "sway", words.seconds, proposed(twinbus, "hrp1s", "")[1] * G)
    for number, robot in enumerate(robots):
        folder, mass, speed = proposed(twinbus, robot, str(scratch / f"robot{number}"))
        if words.policy:
            yield Foreign(words.policy, words.spec, folder, words.command, words.seconds, mass * G)
            continue
        scene, name = words.scene, pathlib.Path(robot).stem
        if not scene and robot == "hrp1s":
            scene = "walk_forward"
        elif not scene:
            if not speed > 0.0:
                sys.exit(f"bench sim2sim: check says of no speed at which {robot} walks; name a --scene")
            scene = scratch / f"walk{number}.yaml"
            scene.write_text(walk_scene(13.5, 10, speed, 5, 20))
        yield Ours(twinbus, f"{name} {pathlib.Path(str(scene)).stem if words.scene else 'walks'}", folder, scene, words.seconds, mass * G)


def main(arguments):
    if {"-h", "--help"} & set(arguments):
        print(__doc__)
        return 0
    parser = argparse.ArgumentParser(prog="bench sim2sim")
    for option in ("--robot", "--scene", "--policy", "--spec", "--csv"):
        parser.add_argument(option, default="")
    parser.add_argument("--seconds", type=float, default=0.0)
    parser.add_argument("--command", type=float, nargs=3, default=(0.5, 0.0, 0.0))
    parser.add_argument("--worlds", default=",".join(WORLDS))
    words = parser.parse_args(arguments)
    if words.policy and not words.robot:
        parser.error("--policy needs the --robot that it drives")
    other = os.environ.get("TWINBUS_POLICY_PYTHON")
    if words.policy and other and not os.environ.get("TWINBUS_POLICY_RUNS"):
        os.execve(other, [other, __file__, *arguments], dict(os.environ, TWINBUS_POLICY_RUNS="1"))
    twinbus = str(programs.folder_of("twinbus", "bench sim2sim", *(programs.POLICY_RUNS if words.policy else ())) / "twinbus")
    rows, fell = [], 0
    with tempfile.TemporaryDirectory() as scratch:
        for controller in controllers(twinbus, words, pathlib.Path(scratch)):
            tracks = measured(controller, [w for w in words.worlds.split(",") if w])
            if not tracks:
                return 1
            compared(controller.name, tracks)
            fell += sum(track.fell for track in tracks.values())
            rows += rows_over_time(controller.name, tracks)
    if words.csv:
        with open(words.csv, "w", newline="", encoding="utf-8") as out:
            writer = csv.DictWriter(out, FIELDS)
            writer.writeheader()
            writer.writerows(rows)
    return 1 if fell else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
