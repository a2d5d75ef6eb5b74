#!/usr/bin/env python3
"""Every example does what its first lines say, on a bus of its own; those in Python and C++ do the same; none has over 60 lines."""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time

import harness
from harness import BIN, ROOT, Bus, Checks, Stack, cli

EXAMPLES = ROOT / "examples"
LONGEST = 60
ENVIRONMENT = dict(os.environ, LCM_DEFAULT_URL="udpm://239.255.76.67:17667?ttl=0&recv_buf_size=4194304")


def python(name):
    return [sys.executable, str(EXAMPLES / name)]


def example(checks, command, expected, timeout=60):
    """Runs one; its output must match expected. Gives the match."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=timeout, env=ENVIRONMENT,
                          stdin=subprocess.DEVNULL, cwd=ROOT)
    said = (done.stdout + done.stderr).strip()
    found = re.search(expected, said)
    name = " ".join(os.path.basename(str(part)) for part in command if str(part) not in (sys.executable, "sh"))
    checks.that(done.returncode == 0 and found is not None, f"{name}: status {done.returncode}, says: {said[-400:]}")
    print(f"{name}: {said.splitlines()[-1] if said else ''}", flush=True)
    return found


def lines(checks):
    for file in sorted(EXAMPLES.rglob("*")):
        if file.suffix in (".py", ".cpp", ".java", ".sh", ".yaml"):
            checks.at_most(len(file.read_text().splitlines()), LONGEST, f"{file.name}: lines")


def without_a_stack(checks):
    example(checks, [BIN / "twinbus", "run", "examples/11_scene.yaml"], r"\npassed")
    example(checks, [BIN / "twinbus", "check", "examples/12_robot"], r"suspicious: nothing")
    example(checks, [BIN / "twinbus", "run", "examples/12_robot/raise.yaml"], r"\npassed")
    if subprocess.run([sys.executable, "-c", "import numpy, twinbus; twinbus.home.native()"], cwd=EXAMPLES, env=ENVIRONMENT, capture_output=True).returncode == 0:
        example(checks, python("17_simulation.py"), r"hrp1s: 10.0 seconds without a fall")
    else:
        print("17_simulation.py: not run, no numpy or no compiled part of the Python package for this Python (test/python/wheel_test.py runs it)", flush=True)
    example(checks, ["sh", EXAMPLES / "14_engine_settings.sh", BIN / "twinbus"], r"(passed[^§]*){4}")


def learn(checks):
    """A round of learning, and what it writes holds the robot on a real stack."""
    python_of_it = os.environ.get("TWINBUS_LEARNING_PYTHON", sys.executable)
    there = subprocess.run([python_of_it, "-c", "import gymnasium, torch, onnx, onnxruntime, yaml, twinbus; twinbus.home.native()"], cwd=EXAMPLES,
                           env=ENVIRONMENT, capture_output=True, text=True)
    if there.returncode != 0:
        print(f"19_environment.py: not run: {(there.stderr.strip().splitlines() or ['?'])[-1]} (TWINBUS_LEARNING_PYTHON names a Python that has all)", flush=True)
        return
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([python_of_it, EXAMPLES / "19_environment.py", "--rounds", "1"], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True)
        checks.that(done.returncode == 0 and "learned: " in done.stdout, f"19_environment.py: {done.stdout[-300:]}{done.stderr[-600:]}")
        print(f"19_environment.py: {(done.stdout.strip().splitlines() or [''])[-1]}", flush=True)
        policy = subprocess.Popen([BIN / "twinbus", "policy", "balance.onnx", "--for", "3"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, env=dict(ENVIRONMENT, TWINBUS_POLICY_PYTHON=python_of_it))
        policy.stdout.readline()
        with Stack("stand_python", "--stack", "client", "--no-viewer", "--no-record"):
            said = policy.communicate(timeout=60)[0]
        checks.that(policy.returncode == 0 and "actions in 3.0 s" in said, f"what 19_environment.py wrote on the stack: {said}")


def operate(checks):
    with Stack("stand", "--stack", "both", "--no-viewer"):
        time.sleep(1.0)
        row = r"simulator, tick \d+, term \d+, 29 joints, q\[3\] ([-+.\d]+) rad, feet (\d+) N"
        heard = [example(checks, command, row) for command in (python("01_listen.py") + ["--for", "1"], [BIN / "example_listen", "1"])]
        if all(heard):
            checks.at_most(abs(float(heard[0][1]) - float(heard[1][1])), 1e-3, "Python and C++ hear another knee")
            checks.at_most(abs(float(heard[0][2]) / 1283.0 - 1.0), 0.05, "load of the feet beside the robot's weight")
        squat = example(checks, python("03_squat.py"), r"moved (\d+) mm up and down, (\d+) mm from side")
        if squat:
            checks.that(40 <= int(squat[1]) <= 80, f"squat: {squat[1]} mm")
        sway = example(checks, python("03_squat.py") + ["--sway"], r"moved (\d+) mm up and down, (\d+) mm from side")
        if sway:
            checks.that(40 <= int(sway[2]) <= 80, f"sway: {sway[2]} mm")
        example(checks, python("18_motion.py") + ["--twinbus", BIN / "twinbus"], r"motion: passed\n(.*\n)*motion: done")
        time.sleep(1.0)
        example(checks, python("05_reach.py") + ["left", "0.35", "0.25", "0.75"], r"the hand is there")
        example(checks, python("06_stop_and_clear.py"), r"stopped at tick \d+, nonce \d+\ngoes on at tick \d+")
        checks.that(cli("mode", "balance")[0] == 0, "balance after the stop")
        plug_in = subprocess.Popen(python("09_add_channel.py") + ["--for", "2"], env=ENVIRONMENT, stdout=subprocess.DEVNULL)
        camera = subprocess.Popen(python("13_camera.py") + ["--for", "1"], env=ENVIRONMENT)
        checks.that(plug_in.wait(10) == 0 and camera.wait(10) == 0, "the channel and the camera end well")
        time.sleep(1.0)
        example(checks, python("07_switch.py") + ["bridge"], r"bridge is active: tick \d+, term \d+")
        time.sleep(2.0)
        example(checks, python("07_switch.py") + ["sim"], r"sim is active: tick \d+, term \d+")
        time.sleep(1.0)
        walked = example(checks, python("04_walk.py") + ["0.2", "0", "0", "--for", "4"], r"walked ([-+.\d]+) m along x")
        if walked:
            checks.at_least(float(walked[1]), 0.4, "metres walked in 4 s at 0.2 m/s")
    return harness.newest_run_folder() / "run.log"


def look_into(checks, log):
    example(checks, python("08_read_log.py") + [log], r"(?s)CAMERA .*POWER +\d+.*STATE +\d+.*runs or terms.*mrad on average")
    with tempfile.TemporaryDirectory() as folder:
        example(checks, ["sh", EXAMPLES / "15_chart.sh", log, folder, BIN / "twinbus"], "")
        for name in ("knee.svg", "balance.csv"):
            checks.that(os.path.getsize(os.path.join(folder, name)) > 1000, f"15_chart.sh writes {name}")


def beside_another_controller(checks):
    """Whoever is not obeyed is told, in each language."""
    with Stack("stand", "--no-viewer"):
        time.sleep(1.0)
        for command in (python("02_command_joints.py"), [str(BIN / "example_command_joints")]):
            client = subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True)
            time.sleep(1.5)
            client.send_signal(signal.SIGTERM)
            said = client.communicate()[0]
            checks.that(said.count("NOT OBEYED") == 1, f"{os.path.basename(command[-1])} beside our controller says: {said}")


def move_a_joint(checks, command, stack, joint):
    """A controller of one's own moves a joint by 0.2 rad, and brings it to rest when it is asked to stop."""
    client = subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True)
    said = ""
    try:
        client.stdout.readline()
        bus = Bus()
        with Stack("stand_python", "--stack", stack, "--no-viewer"):
            time.sleep(4.5)
            cli("stop")
            time.sleep(1.0)
        flags = [command.flags for _, command in bus.messages("COMMAND")]
        checks.at_least(flags.count(1), 10, "commands that bring the robot to rest after a balanced stop")
        checks.that(flags[0] == flags[-1] == 0, f"neither before the stop nor when it rests: {flags[0]}, {flags[-1]}")
        q = [state.q[joint] for _, state in bus.messages("STATE")]
        stops = {state.stop_kind for _, state in list(bus.messages("STATE"))[:1500]}
        bus.close()
        stack = os.path.basename(stack)
        name = " ".join(map(os.path.basename, command))
        checks.that(stops == {0}, f"{name} on {stack}: stops {stops}")
        checks.that(0.15 <= max(q, default=0.0) - min(q, default=0.0) <= 0.21,
                    f"{name} on {stack}: the joint moved {max(q, default=0.0) - min(q, default=0.0):.3f} rad")
        print(f"{name} on {stack}: {max(q) - min(q):.3f} rad", flush=True)
    finally:
        client.send_signal(signal.SIGTERM)
        said = client.communicate()[0]
    checks.that("NOT OBEYED" not in said, f"it is obeyed, and says nothing else: {said}")


def main():
    harness.require(*harness.STACK, "twinbus_bridge",
                    "emulated_robot", "twinbus_recorder", "example_listen", "example_command_joints")
    os.environ["TWINBUS_RECORD"] = "1"
    checks = Checks()
    lines(checks)
    without_a_stack(checks)
    learn(checks)
    look_into(checks, operate(checks))
    beside_another_controller(checks)
    for stack in ("client", str(EXAMPLES / "10_adaptor/stack.yaml")):
        move_a_joint(checks, python("02_command_joints.py") + ["--joint", "9", "--by", "0.2"], stack, 9)
        move_a_joint(checks, [str(BIN / "example_command_joints"), "9", "0.2"], stack, 9)
    checks.exit()


if __name__ == "__main__":
    main()
