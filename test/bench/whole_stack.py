"""A standing and swaying robot with its controller, for choices of the whole stack: error and cost of each.

Each choice is a scene file of its own for `twinbus run`.  Cost is the CPU time of what a long run has more than a short one, the least of
several; error is how far the base is, at two ends of a run, from where it is with the finest choice: of the same contact law with engine
articulated, of spring_damper with ode.
"""

import json
import math
import pathlib
import re
import resource
import shutil
import subprocess
import tempfile

from physics_lab import ROOT

ENDS = (2.5, 3.0)  # [s], both while it sways
SHORT, LONG = 1.0, 9.0  # [s], of which the difference is the cost
ROUNDS = 3
SCENE = """about: Standing, the body sways from side to side.
modes:
  - {at: 0, mode: balance}
  - {at: 1, mode: balance, motion: sway, amplitude: 0.03, frequency: 0.4}
"""
NOISE = {"sensor.noise.encoder": 1e-5, "sensor.noise.velocity": 0.01, "sensor.noise.attitude": 0.002, "sensor.noise.gyro": 0.01,
         "sensor.noise.force": 5, "sensor.noise.moment": 0.5}
PERIOD = 0.002  # [s], of the robot as it is

# (name, engine, contact, order, period, noise) and the steps [s].
STACKS = (
    ("articulated, order 1", "articulated", "spring_damper", 1, PERIOD, False, (2e-3, 1e-3, 5e-4, 2.5e-4)),
    ("articulated, order 2", "articulated", "spring_damper", 2, PERIOD, False, (2e-3, 1e-3, 5e-4)),
    ("articulated, order 3", "articulated", "spring_damper", 3, PERIOD, False, (2e-3, 1e-3)),
    ("order 1, hunt_crossley", "articulated", "hunt_crossley", 1, PERIOD, False, (2e-3, 1e-3, 5e-4, 2.5e-4)),
    ("order 2, hunt_crossley", "articulated", "hunt_crossley", 2, PERIOD, False, (2e-3, 1e-3, 5e-4)),
    ("order 1, patch", "articulated", "patch", 1, PERIOD, False, (2e-3, 1e-3, 5e-4, 2.5e-4)),
    ("order 2, patch", "articulated", "patch", 2, PERIOD, False, (2e-3, 1e-3, 5e-4)),
    ("ode, patch", "ode", "patch", 1, PERIOD, False, (2e-3, 1e-3, 5e-4)),
    ("ode", "ode", "spring_damper", 1, PERIOD, False, (2e-3, 1e-3, 5e-4)),
    ("ode, rigid contact", "ode", "rigid", 1, PERIOD, False, (2e-3, 1e-3)),
    ("order 1, control at 1 kHz", "articulated", "spring_damper", 1, 0.001, False, (1e-3, 5e-4)),
    ("order 1, control at 250 Hz", "articulated", "spring_damper", 1, 0.004, False, (4e-3, 2e-3, 1e-3)),
    ("order 1, noisy sensors", "articulated", "spring_damper", 1, PERIOD, True, (2e-3, 1e-3, 5e-4)),
)


def robot_of(period, folder):
    """A copy of hrp1s whose controller has that period."""
    target = folder / f"hrp1s_{1e3 * period:g}ms"
    if not target.exists():
        shutil.copytree(ROOT / "config/robots/hrp1s", target)
        sheet = target / "robot.yaml"
        sheet.write_text(re.sub(r"(?m)^period: .*$", f"period: {period}", sheet.read_text()))
    return target


def run(program, stack, step, end, folder):
    """(base x, y, yaw; CPU of the whole process [s]), or None if it fails."""
    _, engine, contact, order, period, noise, _ = stack
    settings = dict(NOISE) if noise else {}
    if order > 1:
        settings["solver.order"] = order
    scene = folder / "scene.yaml"
    scene.write_text(SCENE + f"engine: {engine}\ncontact: {contact}\nstep: {step}\n" + (f"settings: {json.dumps(settings)}\n" if settings else ""))
    report = folder / "report.json"
    words = [program, "run", scene, "--for", f"{end}", "--report", report]
    if period != PERIOD:
        words += ["--robot", robot_of(period, folder)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        return None
    return json.loads(report.read_text())["base_final_xyyaw"], after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(lab):
    program = pathlib.Path(lab.bin) / "twinbus"
    if not program.exists():
        raise SystemExit("chart physics system: twinbus is not built; run ./twinbus once")
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        finest = {}
        for stack in STACKS:
            law = stack[2] if stack[1] == "articulated" else "spring_damper"  # a law's own answer
            if law not in finest:
                finest[law] = [run(program, ("", "articulated", law, 3, PERIOD, False, ()), 2.5e-4, end, folder)[0] for end in ENDS]
            for step in stack[-1]:
                ends = [run(program, stack, step, end, folder) for end in ENDS]
                row = {"stack": stack[0], "step_s": step, "cpu_ms_per_s": "", "error_m": "failed"}
                if all(ends):
                    off = max(math.dist(at[:2], exact[:2]) for (at, _), exact in zip(ends, finest[law]))
                    long, short = (min(run(program, stack, step, end, folder)[1] for _ in range(ROUNDS)) for end in (LONG, SHORT))
                    row.update(cpu_ms_per_s=f"{1e3 * (long - short) / (LONG - SHORT):.5g}", error_m=f"{off:.4g}")
                yield row
            print(f"system: {stack[0]}", flush=True)
