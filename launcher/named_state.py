#!/usr/bin/env python3
"""STATE with the robot's own joint names, for lcm-spy: a message type made for this robot, published on STATE_NAMED at 50 Hz.

    named_state.py --make FOLDER     writes the type's .lcm, its Python module and, with javac, FOLDER/named.jar
    named_state.py --run FOLDER      publishes until it is ended

A field of the spy is then LEFT_KNEE.q instead of q[16].  Nobody in control listens to it.
"""
import argparse
import glob
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
PERIOD = 0.02  # [s]
PARTS = ("q", "qd", "tau")
FEET = ("left_foot", "right_foot", "foot_2", "foot_3", "foot_4", "foot_5")  # rows of wrench


def type_name(robot):
    return re.sub(r"[^A-Za-z0-9]", "_", robot).lower() + "_state_t"


def joint_names(twinbus, robot):
    """Of the joints on the bus, in the bus's order."""
    said = subprocess.run([twinbus, "check", robot, "--json"], capture_output=True, text=True)
    if said.returncode != 0:
        raise SystemExit(f"named_state: {said.stderr.strip()}")
    joints = [joint for joint in json.loads(said.stdout)["joints"] if joint["bus"] is not None and joint["bus"] >= 0]
    names = [re.sub(r"\W", "_", joint["name"]) for joint in sorted(joints, key=lambda joint: joint["bus"])]
    return [name if name[0].isalpha() else "j_" + name for name in names]


def schema(robot, names):
    lines = ["package twinbus;", "", f"// {robot}: STATE with a field per joint, made by named_state.py.",
             f"struct {type_name(robot)} {{", "  int64_t tick, time_ns, run_id;", "  int32_t term;",
             "  int8_t source, role, stop_kind;"]
    for part in PARTS:
        lines += [f"  {'double' if part == 'q' else 'float'} {name}_{part};" for name in names]
    for foot in FEET:
        lines += [f"  float {foot}_f{axis};" for axis in "xyz"]
    lines += ["  float roll, pitch;", "}", ""]
    return "\n".join(lines)


def make(folder, robot, twinbus):
    folder.mkdir(parents=True, exist_ok=True)
    names = joint_names(twinbus, robot)
    robot = pathlib.Path(robot).name
    (folder / "robot.txt").write_text("\n".join([robot, *names]) + "\n")
    text = schema(robot, names)
    file = folder / f"{type_name(robot)}.lcm"
    jar = folder / "named.jar"
    if file.exists() and file.read_text() == text and jar.exists():
        return
    file.write_text(text)
    subprocess.run(["lcm-gen", "-p", "--ppath", str(folder / "python"), str(file)], check=True, stdout=subprocess.DEVNULL)
    lcm_jar = next((f for f in ("/usr/share/java/lcm.jar", "/usr/local/share/java/lcm.jar") if os.path.exists(f)), None)
    if shutil.which("javac") is None or lcm_jar is None:
        return
    subprocess.run(["lcm-gen", "-j", "--jpath", str(folder / "java"), str(file)], check=True, stdout=subprocess.DEVNULL)
    classes = folder / "classes"
    classes.mkdir(exist_ok=True)
    sources = glob.glob(str(folder / "java/twinbus/*.java"))
    subprocess.run(["javac", "-nowarn", "-Xlint:none", "-cp", lcm_jar, "-d", str(classes), *sources], check=True)
    subprocess.run(["jar", "cf", str(jar), "-C", str(classes), "."], check=True)


def run(folder, url, prefix):
    import math
    robot, *names = (folder / "robot.txt").read_text().split("\n")[:-1]
    sys.path.insert(0, str(ROOT / "python"))
    import twinbus
    module = {}
    exec((folder / "python/twinbus" / f"{type_name(robot)}.py").read_text(), module)
    kind = module[type_name(robot)]
    bus = twinbus.Bus(url, prefix)
    bus.listen("STATE")
    due = time.monotonic()
    print("named_state: ready", flush=True)
    while True:
        state = twinbus.newest_state(bus.receive(1.0))
        if state is not None and state.joint_count == len(names):
            message = kind()
            for field in ("tick", "time_ns", "run_id", "term", "source", "role", "stop_kind"):
                setattr(message, field, getattr(state, field))
            for i, name in enumerate(names):
                for part in PARTS:
                    setattr(message, f"{name}_{part}", getattr(state, part)[i])
            for row, foot in enumerate(FEET):
                for axis in range(3):
                    setattr(message, f"{foot}_f{'xyz'[axis]}", state.wrench[row][axis])
            w, x, y, z = state.attitude
            message.roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
            message.pitch = math.asin(max(-1.0, min(1.0, 2 * (w * y - z * x))))
            bus.send("STATE_NAMED", message)
        due = max(due + PERIOD, time.monotonic())
        time.sleep(max(0.0, due - time.monotonic()))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--make", type=pathlib.Path, metavar="FOLDER")
    what.add_argument("--run", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--robot", default="hrp1s")
    parser.add_argument("--twinbus", default=str(ROOT / "build/release/bin/twinbus"), help="the program")
    parser.add_argument("--url")
    parser.add_argument("--prefix", default="")
    arguments = parser.parse_args()
    if arguments.make:
        make(arguments.make, arguments.robot, arguments.twinbus)
    else:
        run(arguments.run, arguments.url, arguments.prefix)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        raise SystemExit(f"named_state: {error}")
