#!/usr/bin/env python3
"""./twinbus bench python [--seconds S] [--rounds N] [--worlds N] [--threads N] [--csv F]: what a step costs from Python.

  built-in    Simulation.step of hrp1s standing under our controller, beside the same loop of `./twinbus run` (asked: at most 1.3 times)
  numpy       the same robot held by numpy, joint by joint, with gains and limits (asked: at least 20 times real time)
  worlds      Worlds of hrp1s holding its posture, beside MuJoCo's mujoco.rollout of the exported scene with as many threads (asked: at
              least 2 times the steps a second); left out, aloud, where this Python has no mujoco

Contenders take turns, a figure is the median over the rounds.  Needs the compiled part of the package for this Python, or for
$TWINBUS_POLICY_PYTHON.  Exit status 1 if a figure falls short.
"""

import argparse
import csv
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

import programs

programs.help_is(__doc__)
PERIOD = 0.002  # of hrp1s [s]
SLOWER, FASTER, MORE = 1.3, 20.0, 2.0
ROBOT, SCENE = "hrp1s", "stand"


def package():
    sys.path.insert(0, str(programs.ROOT / "python"))
    try:
        import numpy
        import twinbus
        twinbus.home.native()
    except ImportError as problem:
        other = os.environ.get("TWINBUS_POLICY_PYTHON")
        if other and pathlib.Path(other) != pathlib.Path(sys.executable):
            os.execv(other, [other, *sys.argv])
        sys.exit(f"bench python: {problem}")
    return twinbus, numpy


def loop_in_cpp(twinbus_program, seconds):
    """CPU time has the start of the program in it: two lengths, one difference [s of a simulated second]."""
    took = []
    for length in (1.0, 1.0 + seconds):
        said = subprocess.run([twinbus_program, "run", SCENE, "--robot", ROBOT, "--for", str(length)], capture_output=True, text=True, check=False)
        found = re.search(r"simulated in ([\d.]+) s", said.stdout)
        if found is None:
            sys.exit(f"bench python: run {SCENE}: {said.stdout}{said.stderr}")
        took.append(float(found[1]))
    return (took[1] - took[0]) / seconds


def built_in(twinbus, seconds):
    simulation = twinbus.Simulation(SCENE, ROBOT)
    for _ in range(round(1.0 / PERIOD)):
        simulation.step()
    start = time.perf_counter()
    for _ in range(round(seconds / PERIOD)):
        simulation.step()
    if simulation.truth.fell:
        sys.exit("bench python: the robot fell")
    return (time.perf_counter() - start) / seconds


def held_by_numpy(twinbus, np, seconds):
    simulation = twinbus.Simulation(SCENE, ROBOT, control=None)
    state, command, robot = simulation.state, simulation.command, simulation.robot
    posture, most = np.array(state.q), 0.8 * robot.effort
    command.kp[:] = command.kd[:] = 0.0
    integral = np.array(state.tau, dtype=np.float64)
    kp, kd = robot.kp, robot.kd
    start = time.perf_counter()
    for _ in range(round(seconds / PERIOD)):
        error = posture - state.q
        integral += 0.02 * kp * error
        command.q[:] = posture
        command.kp[:], command.kd[:] = kp, kd
        command.tau[:] = np.clip(integral, -most, most)
        simulation.step()
    took = (time.perf_counter() - start) / seconds
    if simulation.truth.fell:
        sys.exit("bench python: the robot held by numpy fell")
    return took


def worlds(twinbus, count, threads, steps):
    many = twinbus.Worlds(SCENE, ROBOT, count=count, threads=threads)
    start = time.perf_counter()
    many.step(steps)
    took = time.perf_counter() - start
    if many.failed.any() or many.truth.fallen.any():
        sys.exit("bench python: a world fell")
    return count * steps / took


def rollout_of(program, folder, np, count, threads, steps):
    """A function that measures MuJoCo's steps a second; None without mujoco."""
    try:
        import mujoco
        from mujoco import rollout
    except ImportError:
        return None
    subprocess.run([program, "export", SCENE, "--robot", ROBOT, "--to", "mjcf", "--out", folder], check=True, stdout=subprocess.DEVNULL)
    model = mujoco.MjModel.from_xml_path(str(pathlib.Path(folder) / "scene.xml"))
    model.opt.timestep = PERIOD
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
    state = np.zeros(mujoco.mj_stateSize(model, kind))
    mujoco.mj_getState(model, data, state, kind)
    start, control = np.tile(state, (count, 1)), np.tile(data.ctrl, (count, steps, 1))
    pool = rollout.Rollout(nthread=threads)
    of_threads = [mujoco.MjData(model) for _ in range(threads)]

    def measure():
        begin = time.perf_counter()
        end, _ = pool.rollout(model, of_threads, start, control)
        took = time.perf_counter() - begin
        if not end[:, -1, 3].min() > 0.5 * state[3]:
            sys.exit("bench python: a world of MuJoCo fell")
        return count * steps / took
    return measure


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--worlds", type=int, default=64)
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--csv")
    asked = parser.parse_args()
    folder = programs.folder_of("twinbus", "bench python")
    os.environ.setdefault("TWINBUS_BIN", str(folder))
    twinbus, np = package()
    steps = max(50, round(0.05 * asked.seconds / PERIOD))
    found = {name: [] for name in ("cpp", "built-in", "numpy", "worlds", "mujoco")}
    with tempfile.TemporaryDirectory() as scratch:
        mujoco_rollout = rollout_of(folder / "twinbus", scratch, np, asked.worlds, asked.threads, steps)
        for _ in range(asked.rounds):
            found["cpp"].append(loop_in_cpp(folder / "twinbus", asked.seconds))
            found["built-in"].append(built_in(twinbus, asked.seconds))
            found["numpy"].append(held_by_numpy(twinbus, np, asked.seconds))
            found["worlds"].append(worlds(twinbus, asked.worlds, asked.threads, steps))
            if mujoco_rollout is not None:
                found["mujoco"].append(mujoco_rollout())
    ratio = statistics.median(b / a for a, b in zip(found["cpp"], found["built-in"]))
    fast = 1.0 / statistics.median(found["numpy"])
    rows = [("built-in", "times the loop of run", ratio, SLOWER, ratio <= SLOWER), ("numpy", "times real time", fast, FASTER, fast >= FASTER)]
    print(f"run {1.0 / statistics.median(found['cpp']):.0f} times real time, Simulation.step {1.0 / statistics.median(found['built-in']):.0f}")
    if mujoco_rollout is None:
        print("worlds: left out, no mujoco for this Python: pip install mujoco")
    else:
        more = statistics.median(a / b for a, b in zip(found["worlds"], found["mujoco"]))
        print(f"{asked.worlds} worlds, {asked.threads} threads: {statistics.median(found['worlds']):.0f} steps a second, "
              f"MuJoCo's rollout {statistics.median(found['mujoco']):.0f}")
        rows.append(("worlds", "times the steps of mujoco.rollout", more, MORE, more >= MORE))
    for name, unit, value, limit, holds in rows:
        print(f"{name:10} {value:7.2f} {unit}; asked {limit:g}: {'holds' if holds else 'FALLS SHORT'}")
    if asked.csv:
        with open(asked.csv, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([("bench", "case", "unit", "median", "asked"), *(("python", n, u, v, a) for n, u, v, a, _ in rows)])
    sys.exit(0 if all(holds for *_, holds in rows) else 1)


if __name__ == "__main__":
    main()
