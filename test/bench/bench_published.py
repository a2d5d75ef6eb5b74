#!/usr/bin/env python3
"""./twinbus bench published [TEST...] [--data DIR] [--csv F]: the tests of SimBenchmark in our engines and in MuJoCo, beside RaiSim.

Tests: stand, drop, momentum (ANYmal), atlas, balls, rolling, bouncing (default: all).  DIR: a checkout of leggedrobotics/SimBenchmark
(default $TWINBUS_DATA/SimBenchmark), which has the robots and what RaiSim and the MuJoCo of its time reached; without it ANYmal and
Atlas, and the comparison, are left out.  MuJoCo: of the running Python (pip install mujoco), with the same bodies as `export` writes them.
For every engine the whole front of error against cost is printed, and at each error that RaiSim reached what our cost is to MuJoCo's in
this run, beside what RaiSim's was to its MuJoCo's.  Cost: CPU time of one thread, scaled to the length of the published run.
Exit status 1 if a comparison falls short; below it stands what one step of MuJoCo cost then and costs now.
"""

import argparse
import csv
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree

import programs
from physics_lab import cost_at, error as distance

programs.help_is(__doc__)
TESTS = ("stand", "drop", "momentum", "atlas", "balls", "rolling", "bouncing")
ROBOT = {"stand": "ANYmal-PD-benchmark", "drop": "ANYmal-PD-benchmark", "momentum": "ANYmal-PD-benchmark", "atlas": "Atlas-contact-benchmark"}
TABLE = {"stand": "anymal-stand", "drop": "anymal-energy", "momentum": "anymal-momentum", "atlas": "atlas", "balls": "666",
         "rolling": "rolling", "bouncing": "bouncing"}
UNIT = {"stand": "m", "drop": "J^2", "momentum": "(kg m/s)^2", "atlas": "m", "balls": "m^2", "rolling": "(m/s)^2", "bouncing": "J^2"}
SECONDS = {"stand": 250.0, "drop": 3.0, "momentum": 10.0, "atlas": 25.0, "balls": 10.0, "rolling": 4.0, "bouncing": 20.0}  # as published
STEPS = {"stand": (2e-2, 1e-2, 5e-3, 2e-3, 1e-3), "drop": (1e-1, 4e-2, 1e-2, 4e-3, 1e-3), "momentum": (2e-2, 1e-2, 4e-3, 1e-3, 4e-4),
         "atlas": (2e-3, 1e-3, 5e-4, 2e-4), "balls": (1e-2, 4e-3, 1e-3, 4e-4), "rolling": (1e-2, 4e-3, 1e-3), "bouncing": (1e-2, 4e-3, 1e-3, 4e-4, 1e-4)}
FINEST = {"stand": 2e-4, "atlas": 5e-5}  # what errors are measured against, of each engine itself [s]
COLUMNS = {"drop": (4, 5, 6), "momentum": (4, 5, 6), "balls": (6, 7, 8), "rolling": (8, 9, 10), "bouncing": (6, 7, 8)}  # step, error, time of sample.csv
PUBLISHED_STEP = {"stand": 5e-3, "atlas": 5e-4}  # of which only the time was published
METHODS = ("articulated", "articulated2", "articulated3", "ode")
CHEAP = ("articulated", "ode")  # of the heap, where higher orders take minutes


class Ours:
    def __init__(self, program, method, folder):
        self.program, self.method, self.folder, self.label = program, method, folder, method

    def run(self, test, step):
        words = [str(self.program), test, self.method, repr(step), *([str(self.folder[test])] if test in ROBOT else [])]
        try:
            done = subprocess.run(words, capture_output=True, text=True, timeout=240)
        except subprocess.TimeoutExpired:
            return None
        if done.returncode != 0:
            return None
        words = done.stdout.split()
        return {"us": float(words[1]), "error": float(words[3]), "at": [float(word) for word in words[7:]]}


class Mujoco:
    """The same bodies in MuJoCo: robots as `export` writes them, with the gains of the test."""

    def __init__(self, library, numpy, integrator, models):
        self.lib, self.numpy, self.integrator, self.models = library, numpy, integrator, models
        self.label = f"MuJoCo {library.__version__} {integrator}"

    def model(self, test, step):
        model = self.lib.MjModel.from_xml_string(self.models[test])
        model.opt.timestep = step
        model.opt.integrator = getattr(self.lib.mjtIntegrator, "mjINT_" + self.integrator.upper())
        return model

    def run(self, test, step):
        model, costs = self.model(test, step), []
        try:
            run = self.go(model, test, DURATION[test], True)
            begun = time.thread_time()
            while not costs or time.thread_time() - begun < 0.2:
                costs.append(self.go(model, test, DURATION[test], False)["us"])
        except FloatingPointError:
            return None
        return {"us": statistics.median(costs), **run}

    def go(self, model, test, seconds, measured):
        lib, data = self.lib, self.lib.MjData(model)
        if model.nkey:
            lib.mj_resetDataKeyframe(model, data, 0)
        mass = sum(model.body_mass)
        steps, total = round(seconds / model.opt.timestep), 0.0
        first, begun = {"e": None}, time.thread_time()
        if test == "drop":
            data.xfrc_applied[1, 2] = 2.0 * mass * 9.81
        if test == "rolling":
            data.xfrc_applied[1, :2] = 150.0 * 0.5, 150.0 * math.sqrt(0.75)
        changes = round(1.0 / model.opt.timestep) if test == "drop" else steps
        if not measured:
            lib.mj_step(model, data, nstep=min(changes, steps))
            if steps > changes:
                data.xfrc_applied[:] = 0.0
                lib.mj_step(model, data, nstep=steps - changes)
            self.check(data)
            return {"us": 1e6 * (time.thread_time() - begun) / steps}
        for i in range(steps):
            t = i * model.opt.timestep
            if i == changes:
                data.xfrc_applied[:] = 0.0
            total += self.error(model, data, test, t, i >= changes, first, mass)
            lib.mj_step(model, data)
        self.check(data)
        return {"error": total / steps, "at": list(data.xpos[1:].flatten())}

    def check(self, data):
        if not self.numpy.isfinite(data.qpos).all() or data.warning[self.lib.mjtWarning.mjWARN_BADQACC].number:
            raise FloatingPointError("diverged")

    def error(self, model, data, test, t, dropped, first, mass):
        lib, numpy = self.lib, self.numpy
        if test in ("stand", "atlas") or test == "drop" and not dropped:
            return 0.0
        if test == "rolling":
            along = numpy.array([0.5, math.sqrt(0.75), 0.0])
            under = 0.4 * 35.0 * 9.81
            on_ball = (150.0 - under) / 10.0 / (3.5 + 2.5)
            of_box = (150.0 - under - 25.0 * on_ball) / 10.0
            return float(numpy.sum((data.qvel[0:3] - of_box * t * along) ** 2) + numpy.sum((data.qvel[6:9] - on_ball * t * along) ** 2))
        if test == "balls":
            at = data.qpos.reshape(-1, 7)[:, :3]
            apart = numpy.sqrt(((at[:, None, :] - at[None, :, :]) ** 2).sum(-1))
            depth = numpy.clip(0.2 - apart[numpy.triu_indices(len(at), 1)], 0.0, None)
            return float((depth ** 2).sum() + (numpy.clip(0.1 - at[:, 2], 0.0, None) ** 2).sum())
        if test == "momentum":
            lib.mj_fwdPosition(model, data)
            lib.mj_fwdVelocity(model, data)
            lib.mj_subtreeVel(model, data)
            return float(((mass * data.subtree_linvel[0] - numpy.array([0.0, 50.0, 0.0])) ** 2).sum())
        lib.mj_forward(model, data)
        lib.mj_energyPos(model, data)
        lib.mj_energyVel(model, data)
        e = float(data.energy[0] + data.energy[1])
        if first["e"] is None:
            first["e"] = e
        return (e - first["e"]) ** 2 * (1.5 if test == "drop" else 1.0)


DURATION = {test: min(SECONDS[test], 2.0) if test in ("stand", "atlas", "balls") else SECONDS[test] for test in TESTS}


def spheres(test):
    """balls and bouncing, and rolling with its box, for MuJoCo."""
    bodies, friction = [], "0 0 0"
    if test == "balls":
        import random
        draw = random.Random(42)
        bodies = [(0.1, 10.0, [0.21 * k + 1e-3 * draw.random() + (0.101 if axis == 2 else 0.0) for axis, k in enumerate((i // 36, i // 6 % 6, i % 6))])
                  for i in range(216)]
    elif test == "bouncing":
        bodies = [(0.1, 10.0, [2.0 * (i // 7), 2.0 * (i % 7), 5.0]) for i in range(49)]
    else:
        bodies = [(0.5, 1.0, [2.0 * (i // 5) - 4.0, 2.0 * (i % 5) - 4.0, 1.5]) for i in range(25)]
    text = "<mujoco><option cone='elliptic'/><worldbody>"
    text += f"<geom type='plane' size='200 200 5' friction='{'0.4 0 0' if test == 'rolling' else friction}'/>"
    if test == "rolling":
        text += ("<body pos='0 0 0.5'><freejoint/><geom type='box' size='10 10 0.5' mass='10' friction='0.4 0 0'/></body>")
    for radius, mass, at in bodies:
        # e = 1 has no damping: the reference in its negative, direct form.
        solref = " solref='-1e7 0'" if test == "bouncing" else ""
        text += (f"<body pos='{at[0]} {at[1]} {at[2]}'><freejoint/><geom type='sphere' size='{radius}' mass='{mass}' condim='3' "
                 f"friction='{'0.8 0 0' if test == 'rolling' else friction}'{solref}/></body>")
    return text + "</worldbody></mujoco>"


def exported(program, robot, test, work):
    """The robot as `export` writes it, begun and driven as the test says."""
    folder = pathlib.Path(work) / test
    subprocess.run([program.parent / "twinbus", "export", "stand", "--robot", robot, "--to", "mjcf", "--out", folder], check=True, capture_output=True)
    root = ElementTree.parse(folder / "scene.xml").getroot()
    root.find("compiler").set("meshdir", str(folder / "meshes"))
    for tag in ("sensor", "keyframe"):
        found = root.find(tag)
        if found is not None:
            root.remove(found)
    for joint in root.iter("joint"):
        for key in ("range", "actuatorfrcrange", "frictionloss", "damping", "armature"):
            joint.attrib.pop(key, None)
    height = {"stand": 0.54, "atlas": 1.0}.get(test, 2.0)
    lines = subprocess.run([program, test, "gains", "0", robot], check=True, capture_output=True, text=True).stdout.splitlines()
    of = {name: tuple(map(float, numbers)) for name, *numbers in map(str.split, lines)}
    joints = [joint.get("name") for joint in root.iter("joint")]
    q = [of[name][0] for name in joints]
    actuators = root.find("actuator")
    for servo in list(actuators):
        actuators.remove(servo)
    for name in joints:
        _, kp, kd = of[name]
        if kp:
            ElementTree.SubElement(actuators, "position", name=name, joint=name, kp=repr(kp), kv=repr(kd))
    base = root.find("worldbody/body")
    base.set("pos", f"0 0 {height}")
    base.set("quat", "1 0 0 0")
    world, qpos, qvel = root.find("worldbody"), f"0 0 {height} 1 0 0 0 " + " ".join(map(repr, q)), ""
    if test == "momentum":
        for geom in world.findall("geom"):
            world.remove(geom)
        ball = ElementTree.SubElement(world, "body", pos="0 -5 2")
        ElementTree.SubElement(ball, "freejoint")
        ElementTree.SubElement(ball, "geom", type="sphere", size="0.2", mass="10", friction="0.8 0.005 0.0001")
        qpos += " 0 -5 2 1 0 0 0"
        qvel = " ".join(["0"] * (6 + len(joints))) + " 0 5 0 0 0 0"
    for element in world.iter("geom"):
        element.attrib.pop("name", None)
    contact = ElementTree.SubElement(root, "contact")  # a robot does not touch itself
    names = [body.get("name") for body in base.iter("body")]
    for k, one in enumerate(names):
        for other in names[k + 1:]:
            ElementTree.SubElement(contact, "exclude", body1=one, body2=other)
    key = ElementTree.SubElement(ElementTree.SubElement(root, "keyframe"), "key", qpos=qpos, ctrl=" ".join(
        repr(of[name][0]) for name in joints if of[name][1]))
    if qvel:
        key.set("qvel", qvel)
    if test == "momentum":
        root.find("option").set("gravity", "0 0 0")
    return ElementTree.tostring(root, encoding="unicode")


def published(data, test):
    """{engine: [(error, seconds)]} of RaiSim and the best of MuJoCo's; times alone (error None) where no error was published.
    And, where it was, {step: {engine: [(seconds, error)]}}."""
    found, of_step = {"RAI": [], "MUJOCO": []}, {}
    for row in csv.reader(open(data / "data" / TABLE[test] / "sample.csv", newline="")):
        if row[0] not in found:
            continue
        if test == "stand":
            if row[4] == "1":
                found[row[0]].append((None, float(row[5])))
        elif test == "atlas":
            if row[4] == "1":
                found[row[0]].append((None, float(row[6])))
        elif test in ("drop", "momentum") or row[4] == "0" and (test != "rolling" or row[5] == "1") and (test != "bouncing" or row[5] == "1"):
            step, error, seconds = (float(row[column]) for column in COLUMNS[test])
            found[row[0]].append((error, seconds))
            of_step.setdefault(step, {}).setdefault(row[0], []).append((seconds, error))
    return found, of_step


def front(engine, test, rows):
    points, finest = [], None
    if test in FINEST:
        finest = engine.run(test, FINEST[test])
    for step in STEPS[test]:
        run = engine.run(test, step)
        if run is None:
            print(f"{test:9s} {engine.label:24s} {1e3 * step:7g} ms: failed")
            continue
        error = run["error"] if finest is None and test not in FINEST else distance(run, finest) if finest else math.nan
        points.append((error, run["us"] * SECONDS[test] / step * 1e-6, step))
        rows.append({"test": test, "engine": engine.label, "step_s": step, "error": error, "unit": UNIT[test], "us_per_step": run["us"],
                     "cpu_s": points[-1][1]})
        print(f"{test:9s} {engine.label:24s} {1e3 * step:7g} ms: {run['us']:9.2f} us a step, {points[-1][1]:9.4f} s, error {error:.3g} {UNIT[test]}", flush=True)
    return points


def say_cause(test, error, fronts, of_step):
    """Beside a comparison that falls short, step by step: a ratio of costs moves when MuJoCo does, whoever is over it."""
    step = next(step for step, runs in of_step.items() if any(e == error for _, e in runs.get("RAI", [])))
    per_step = 1e6 * step / SECONDS[test]
    rai, old = (min(of_step[step].get(name, [(math.nan, math.nan)])) for name in ("RAI", "MUJOCO"))
    new = min(((c, e) for label, points in fronts.items() if label.startswith("MuJoCo") for e, c, h in points if h == step), default=None)
    mine = min(((c, e, 1e3 * h) for label, points in fronts.items() if not label.startswith("MuJoCo") for e, c, h in points if e <= error), default=None)
    print(f"{test:9s}   published, steps of {1e3 * step:g} ms: RaiSim {per_step * rai[0]:.3g} us, error {rai[1]:.3g}; MuJoCo {per_step * old[0]:.3g} us, error {old[1]:.3g}")
    if new:
        print(f"{test:9s}   of this run, the same steps: MuJoCo {per_step * new[0]:.3g} us, error {new[1]:.3g}; "
              f"it took then {old[0] / new[0]:.3g} times the time for {old[1] / new[1]:.3g} times the error")
    if mine:
        print(f"{test:9s}   whole run of that error: RaiSim {rai[0]:.3g} s then, ours {mine[0]:.3g} s at {mine[2]:g} ms with error {mine[1]:.3g}")


def compare(test, fronts, them, of_step):
    """What our cost is to MuJoCo's where RaiSim's is to its MuJoCo's; True if no comparison falls short."""
    ours = [point for label, points in fronts.items() if not label.startswith("MuJoCo") for point in points]
    theirs = [point for label, points in fronts.items() if label.startswith("MuJoCo") for point in points]
    if not theirs or not ours or not them["MUJOCO"]:
        print(f"{test:9s} no MuJoCo {'here' if not theirs else 'was published'}: only the fronts")
        return True
    if test in PUBLISHED_STEP:
        step = PUBLISHED_STEP[test]
        best = [min((p[1] for p in side if p[2] == step), default=None) for side in (ours, theirs)]
        if None in best:
            print(f"{test:9s} at {1e3 * step:g} ms: failed")
            return False
        before = statistics.median(t for _, t in them["RAI"]) / min(t for _, t in them["MUJOCO"])
        good = best[0] / best[1] < before
        print(f"{test:9s} at {1e3 * step:g} ms: our cost over MuJoCo's {best[0] / best[1]:.3g}, RaiSim's over its {before:.3g}{'' if good else '   SHORT'}")
        return good
    if len({e for e, _ in them["MUJOCO"]}) < 2 or min(e for e, _ in them["MUJOCO"]) > 100.0 * max(e for e, _ in them["RAI"]):
        print(f"{test:9s} the MuJoCo that was published never came near RaiSim's accuracy: only the fronts")
        return True
    good = True
    for error, seconds in sorted(set(them["RAI"]), reverse=True):
        old, old_beyond = cost_at(them["MUJOCO"], error)
        new, new_beyond = cost_at([(e, c) for e, c, _ in theirs], error)
        mine, mine_beyond = cost_at([(e, c) for e, c, _ in ours], error)
        if None in (old, new, mine) or mine_beyond:
            continue
        fine = mine / new < seconds / old
        good = good and fine
        beyond = [name for name, was in (("its", old_beyond), ("MuJoCo's", new_beyond)) if was]
        print(f"{test:9s} at {error:9.3g} {UNIT[test]}: our cost over MuJoCo's {mine / new:.3g}, RaiSim's over its {seconds / old:.3g}"
              f"{' (' + ' and '.join(beyond) + ' front extended)' if beyond else ''}{'' if fine else '   SHORT'}")
        if not fine:
            say_cause(test, error, fronts, of_step)
    return good


def main(words):
    parser = argparse.ArgumentParser(prog="bench published", add_help=False)
    parser.add_argument("tests", nargs="*", metavar="TEST")
    parser.add_argument("--data", type=pathlib.Path, default=pathlib.Path(os.environ.get("TWINBUS_DATA", ".")) / "SimBenchmark")
    parser.add_argument("--csv", type=pathlib.Path)
    asked = parser.parse_args(words)
    wrong = [test for test in asked.tests if test not in TESTS]
    if wrong:
        parser.error(f"no test '{wrong[0]}'; there are {' '.join(TESTS)}")
    asked.data = asked.data.resolve()
    there = (asked.data / "res/benchmark").is_dir()
    if not there:
        print(f"{asked.data}: no checkout of SimBenchmark, so without ANYmal, Atlas and RaiSim; git clone https://github.com/leggedrobotics/SimBenchmark, then --data")
    program = programs.folder_of("published_cases", "bench published").resolve() / "published_cases"
    table = asked.csv.resolve() if asked.csv else None
    twinbus = program.parent / "twinbus"
    try:
        import mujoco
        import numpy
    except ImportError:
        mujoco = None
        print("MuJoCo: not installed for this Python, left out (pip install mujoco)")
    good, rows = True, []
    here = os.getcwd()
    with tempfile.TemporaryDirectory() as work:
        os.chdir(work)  # where MuJoCo leaves its log
        folders = {}
        for test in asked.tests or TESTS:
            if test in ROBOT and there and ROBOT[test] not in folders.values():
                robot = pathlib.Path(work) / ROBOT[test]
                done = subprocess.run([twinbus, "check", asked.data / "res/benchmark" / ROBOT[test] / "ode-rai-dart/robot.urdf", "--propose", robot],
                                      capture_output=True, text=True)
                if not (robot / "robot.yaml").exists():
                    sys.exit(f"bench published: {ROBOT[test]} cannot be proposed: {done.stderr.strip() or done.stdout.strip()[-300:]}")
            if test in ROBOT:
                folders[test] = pathlib.Path(work) / ROBOT[test]
        for test in asked.tests or TESTS:
            if test in ROBOT and not there:
                continue
            models = {test: exported(program, folders[test], test, work) if test in ROBOT else spheres(test)} if mujoco else {}
            engines = [Ours(program, method, folders) for method in (CHEAP if test == "balls" else METHODS)]
            if mujoco:
                engines += [Mujoco(mujoco, numpy, name, models) for name in (("euler", "rk4") if test in ("drop", "momentum", "bouncing") else ("euler", "implicitfast"))]
            fronts = {engine.label: front(engine, test, rows) for engine in engines}
            if there:
                good = compare(test, fronts, *published(asked.data, test)) and good
        os.chdir(here)
    if table and rows:
        with open(table, "w", newline="") as out:
            writer = csv.DictWriter(out, rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
