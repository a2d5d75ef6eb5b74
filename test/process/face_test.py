#!/usr/bin/env python3
"""A robot's face on DDS: frames beside another implementation, a program that drives, programs that send rubbish.

    face_test.py [frames] [drive] [attack] [example]      default all

The other implementation is the vendor's Python SDK: a Python with the package unitree-sdk2py-dimos, this one or the one that
$TWINBUS_UNITREE_PYTHON names.  TWINBUS_FULL=1: 10,000 frames each way and family, and longer drives; otherwise 1,000.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import harness
import unitree_robots
from harness import BIN, Bus, Checks, Stack, cli, text_of

FRAMES = 10000 if harness.FULL else 1000
DRIVE = 20.0 if harness.FULL else 12.0  # longer than two switches take
PEER = pathlib.Path(__file__).with_name("unitree_peer.py")
PYTHON = os.environ.get("TWINBUS_UNITREE_PYTHON", sys.executable)
# What the programs that send rubbish do, and a word of the line that must name it.
RUBBISH = {"crc": "wrong CRC", "nan": "not finite", "mode_machine": "mode_machine is", "motor_mode": "has mode 7", "other": "second program"}
LEAST, MOST = -0.15, 0.15  # of motor 3, which the program moves by 0.1 rad; all rubbish wants it at 0.7 [rad]


def skip(why):
    print(f"skipped: {why}")
    sys.exit(harness.SKIPPED)


def peer(*words, **options):
    return subprocess.Popen([PYTHON, str(PEER), *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            preexec_fn=harness.go_ahead, **options)


def output_of(process, timeout):
    try:
        return process.communicate(timeout=timeout)[0].strip()
    except subprocess.TimeoutExpired:
        process.kill()
        return process.communicate()[0].strip() + " (did not end)"


def frames(checks):
    """Every byte of every frame, both ways: our struct is what the SDK packs, and its fields are ours."""
    for kind in ("unitree_hg", "unitree_go"):
        begin = time.monotonic()
        other = peer("frames", kind, FRAMES, "lo", 3)
        ours = subprocess.Popen([BIN / "unitree_probe", kind, str(FRAMES), "lo", "3"], stdout=subprocess.PIPE, text=True)
        here, there = output_of(ours, 120 + 0.1 * FRAMES), output_of(other, 60)
        print(f"{kind}: {here}; {there}; {time.monotonic() - begin:.1f} s", flush=True)
        checks.that(ours.returncode == 0, f"{kind}: every command is byte for byte the one expected: {here}")
        checks.that(other.returncode == 0, f"{kind}: every state has the fields and the CRC expected: {there}")


class Driven:
    """A stack with a face, whose lines and commands are recorded."""

    def __init__(self, kind, *words):
        self.kind = kind
        self.folder = tempfile.TemporaryDirectory()
        robot = unitree_robots.write_robot(pathlib.Path(self.folder.name), kind)
        self.stack = Stack("stand", "--robot", robot, "--face", kind, "--no-viewer", *words)
        self.joint = unitree_robots.JOINTS[kind].index(unitree_robots.MOVED[kind])

    def __enter__(self):
        self.bus = Bus()
        self.stack.__enter__()
        return self

    def __exit__(self, *unused):
        self.stack.__exit__(*unused)
        self.bus.close()
        self.folder.cleanup()

    def lines(self, since_ns):
        return [t for t in (text_of(e) for _, e in self.bus.messages("EVENT", since_ns)) if t.startswith("face: ")]

    def commands(self, since_ns):
        return [m.q[self.joint] for _, m in self.bus.messages("COMMAND", since_ns)]

    def measured(self, since_ns):
        return [m.q[self.joint] for _, m in self.bus.messages("STATE", since_ns)]

    def stopped(self):
        state = self.bus.newest("STATE")[1]
        return state is None or state.stop_kind != 0

    def clear(self):
        return cli("clear")[0] == 0


def drives(checks):
    for kind in ("unitree_hg", "unitree_go"):
        with Driven(kind, "--stack", "client_both") as robot:
            released = peer("released", "lo")
            said = output_of(released, 30)
            checks.that(released.returncode == 0, f"{kind}: the motion service is released: {said}")
            begin = time.monotonic_ns()
            program = peer("drive", kind, "lo", DRIVE)
            program.stdout.readline()
            time.sleep(1.5)
            for target in ("bridge", "sim"):
                status, out, err = cli("switch", target, "--policy", "now", timeout=40)
                checks.that(status == 0, f"{kind}: switch to {target} under the program: {(out + err).strip()}")
                time.sleep(1.2)
            checks.that(not robot.stopped(), f"{kind}: not stopped while the program drives")
            moved = robot.measured(begin)
            said = output_of(program, DRIVE + 30)
            checks.that(program.returncode == 0, f"{kind}: the program: {said}")
            checks.at_least(max(moved), 0.07, f"{kind}: motor 3 moves as asked [rad]")
            checks.at_most(max(robot.commands(begin)), MOST, f"{kind}: largest command for motor 3 [rad]")
            # The program has ended: that is silence.
            time.sleep(0.5)
            checks.that(robot.stopped(), f"{kind}: silence is a stop")
            lines = robot.lines(begin)
            checks.that(sum("no good LowCmd" in line for line in lines) == 1, f"{kind}: silence is told once: {lines}")
            # Cleared without a program: held where it is.
            checks.that(robot.clear(), f"{kind}: clear")
            time.sleep(1.0)
            checks.that(not robot.stopped(), f"{kind}: held by the face after the clear")
            print(f"{kind}: {said}; motor 3 {min(moved):.3f} to {max(moved):.3f} rad", flush=True)


def attacks(checks):
    """A good program drives; beside it others send rubbish, one kind after another: nothing of theirs is obeyed."""
    kind = "unitree_hg"
    with Driven(kind) as robot:
        good = peer("drive", kind, "lo", 60)
        good.stdout.readline()
        time.sleep(1.0)
        for what, words in RUBBISH.items():
            begin = time.monotonic_ns()
            output_of(peer(what, kind, "lo", 2.0), 40)
            # A good program that this machine held up may write too fast while it catches up: that is said too.
            lines, commands = [line for line in robot.lines(begin) if "times a second" not in line], robot.commands(begin)
            checks.that(len(lines) == 1 and words in lines[0], f"{what}: one line that says so: {lines}")
            checks.that(bool(commands) and LEAST <= min(commands) and max(commands) <= MOST,
                        f"{what}: motor 3 was never commanded elsewhere: {min(commands):.3f} to {max(commands):.3f} of {len(commands)}")
            checks.that(not robot.stopped(), f"{what}: the good program goes on")
            print(f"{what}: {lines}", flush=True)
            robot.bus.forget()
        begin = time.monotonic_ns()
        good.kill()  # silence, in mid-motion
        good.communicate()
        time.sleep(1.0)
        lines = robot.lines(begin)
        checks.that(robot.stopped(), "silence: the robot is held by its stop")
        checks.that(len([line for line in lines if "no good LowCmd" in line]) == 1, f"silence: one line: {lines}")
        # Alone, rubbish moves nothing either.
        checks.that(robot.clear(), "clear")
        for what in ("crc", "nan", "mode_machine", "motor_mode"):
            robot.bus.forget()
            begin = time.monotonic_ns()
            output_of(peer(what, kind, "lo", 1.0), 40)
            commands = robot.commands(begin)
            checks.that(bool(commands) and LEAST <= min(commands) and max(commands) <= MOST, f"{what} alone: motor 3 is held")
        # Too fast: obeyed, at the robot's rate.
        robot.bus.forget()
        begin = time.monotonic_ns()
        said = output_of(peer("fast", kind, "lo", 4.0), 40)
        lines, states = robot.lines(begin), len(robot.measured(begin))
        commands = len(robot.commands(begin))
        checks.that(commands <= states + 2, f"fast: {commands} commands to {states} states: one a tick at most")
        print(f"fast: {said}; {commands} commands, {states} states, {lines}", flush=True)
        if "too slow" not in said:
            written = int(said.split("wrote ")[1].split()[0])
            if written > 4.0 * 900:  # where this machine could write so fast
                checks.that(sum("times a second" in line for line in lines) == 1, f"fast: one line: {lines}")


def example(checks):
    """examples/20_face.py bends an elbow."""
    with Driven("unitree_hg") as robot:
        done = subprocess.run([PYTHON, str(harness.ROOT / "examples/20_face.py"), "--for", "4"], capture_output=True, text=True, timeout=60)
        said = re.search(r"the elbow bent by ([.\d]+) rad and is ([-+.\d]+) rad", done.stdout)
        checks.that(done.returncode == 0 and said is not None, f"20_face.py: {done.returncode}, {done.stdout[-300:]}{done.stderr[-600:]}")
        if said:
            checks.at_least(float(said[1]), 0.2, "20_face.py: the elbow bends [rad]")
            checks.at_most(abs(float(said[2])), 0.05, "20_face.py: and comes back [rad]")
            print(f"20_face.py: {said[0]}", flush=True)
        checks.that(len(robot.commands(0)) > 100, "20_face.py: its commands are COMMAND")


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_bridge", "emulated_robot")
    if not (BIN / "twinbus_face").exists():
        status, _, err = cli("face", "unitree_hg")
        if status == 0 or "cyclonedds-dev" not in err:
            print(f"FAILED: twinbus face does not name its package: {err}")
            sys.exit(1)
        skip("CycloneDDS was not there when twinbus was built (apt-get install cyclonedds-dev cyclonedds-tools); its absence is told")
    if subprocess.run([PYTHON, "-c", "import unitree_sdk2py"], capture_output=True).returncode != 0:
        skip("no Python with unitree_sdk2py (pip install unitree-sdk2py-dimos into a venv; TWINBUS_UNITREE_PYTHON names its python)")
    checks = Checks()
    parts = {"frames": frames, "drive": drives, "attack": attacks, "example": example}
    for part in sys.argv[1:] or parts:
        parts[part](checks)
    checks.exit()


if __name__ == "__main__":
    main()
