#!/usr/bin/env python3
"""Programs that others wrote for Unitree robots, unchanged, on the face; the source is switched under them.

    face_programs_test.py [PROGRAM ...]     default: those whose files are there, but for deploy_real_untouched

| program | what it is | needs |
| holosoma | holosoma-inference, its own G1 policy, walks at 0.3 m/s | pip: holosoma-inference far-unitree-sdk |
| falcon | sim2real/rl_policy/dec_loco of FALCON, its own G1 policy, walks at 0.3 m/s | pip: unitree-sdk2py-dimos loop-rate-limiters |
| deploy_real | deploy/deploy_real of unitree_rl_gym, its own G1 policy, walks at 0.4 m/s by the wireless remote | pip: unitree-sdk2py-dimos torch |
| deploy_real_untouched | the same without our sitecustomize, which stops Python's garbage collector: on a busy machine its pauses fell it now
and then.  Of three full runs beside builds two passed; in the third it tottered after a pause of 92 ms, and the guard stopped it | the same |
| go2_stand | example/go2/low_level/go2_stand_example.py of unitree_sdk2_python: lies, stands, lies down | pip: unitree-sdk2py-dimos |

$TWINBUS_UNITREE_PYTHON: a Python with those packages.  $TWINBUS_PROGRAMS: a folder with FALCON, unitree_rl_gym and unitree_sdk2_python,
and for go2_stand a go2.urdf.  $TWINBUS_DATA: robots/g1.  TWINBUS_FULL=1: 60 s, 50 switches standing and 10 walking; else 15 s, 2 and 2.
"""
import fcntl
import math
import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile
import termios
import threading
import time

import harness
from harness import Bus, Checks, Stack, cli, text_of, type_of

harness.CHANNEL_TYPES.setdefault("GAMEPAD", "gamepad_t")
harness.CHANNEL_TYPES.setdefault("SIM_REQUEST", "sim_request_t")

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = pathlib.Path(os.environ.get("TWINBUS_DATA", "/nowhere"))
PROGRAMS = pathlib.Path(os.environ.get("TWINBUS_PROGRAMS", "/nowhere"))
PYTHON = os.environ.get("TWINBUS_UNITREE_PYTHON", sys.executable)
SECONDS, STANDING, WALKING = (60.0, 50, 10) if harness.FULL else (15.0, 2, 2)
FEWER_STATES = ("--face-rate", "100", "--face-patience", "0.3")  # for Python: 500 readings a second leave it no time, a first inference takes 0.1 s
G1 = DATA / "robots/g1/g1_29dof_rev_1_0.urdf"
# deploy_real holds a waist with 300 N m/rad and 3 N m s/rad, a tenth of critical damping: a waist that bends lets the torso rock, and its
# policy, which was trained without one, falls for it in MuJoCo alone too.  Its G1 is the one whose waist is locked.
G1_LOCKED = PROGRAMS / "unitree_rl_gym/resources/robots/g1_description/g1_29dof_lock_waist_rev_1_0.urdf"
FALLEN, TOTTERS = math.radians(40.0), math.radians(15.0)


class Typed:
    """A program in a terminal of its own, for which keys are typed.  path: where it finds its modules."""

    def __init__(self, *words, folder=None, path=""):
        ours, theirs = pty.openpty()
        self.terminal = ours
        fcntl.fcntl(ours, fcntl.F_SETFL, fcntl.fcntl(ours, fcntl.F_GETFL) | os.O_NONBLOCK)
        self.said = ""
        attributes = termios.tcgetattr(theirs)
        attributes[3] &= ~(termios.ECHO | termios.ICANON)
        termios.tcsetattr(theirs, termios.TCSANOW, attributes)
        self.process = subprocess.Popen([PYTHON, *map(str, words)], stdin=theirs, stdout=theirs, stderr=theirs, cwd=folder, start_new_session=True,
                                        preexec_fn=harness.go_ahead, env=dict(os.environ, PYTHONPATH=str(path)))
        os.close(theirs)

    def read(self):
        try:
            while data := os.read(self.terminal, 65536):
                self.said = (self.said + data.decode(errors="replace"))[-20000:]
        except OSError:
            pass
        return self.said

    def wait_for(self, words, timeout=60.0):
        end = time.monotonic() + timeout
        while words not in self.read():
            assert self.process.poll() is None and time.monotonic() < end, f"'{words}' is not said: {self.said[-1500:]}"
            time.sleep(0.01)

    def type(self, keys, pause=0.15):
        for key in keys:
            os.write(self.terminal, key.encode())
            time.sleep(pause)
            self.read()

    def end(self):
        self.process.kill()
        self.process.wait()
        os.close(self.terminal)


class Robot:
    """What a robot does while a program drives it."""

    def __init__(self, bus):
        self.bus, self.most_tilt, self.looked_ns, self.stop = bus, 0.0, time.monotonic_ns(), 0

    def look(self):
        """At what has come since the last look; whether the robot is upright and obeys."""
        since, self.looked_ns = self.looked_ns, time.monotonic_ns()
        heard = [body for at, channel, body in self.bus.records if channel == "STATE" and at >= since]
        for body in heard[::-10]:  # all of them would take the program's time
            state = type_of("STATE").decode(body)
            self.stop = max(self.stop, state.stop_kind)
            self.most_tilt = max(self.most_tilt, 2.0 * math.asin(min(1.0, math.hypot(state.attitude[1], state.attitude[2]))))
        if len(self.bus.records) > 50000:
            del self.bus.records[:-20000]
        return self.stop == 0 and self.most_tilt < FALLEN

    def watch(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end and self.look():
            time.sleep(0.25)
        return self.look()

    def in_words(self):
        return f"tilt {math.degrees(self.most_tilt):.0f} degrees at most, stop {self.stop}"

    def place(self):
        truth = self.bus.newest("TRUTH")[1]
        return truth.base_position[:2] if truth else (math.nan, math.nan)


def told(running, bus):
    """What the stack says of stops, of the face and of collisions."""
    return "".join(line for line in running.lines if re.search("face:|stop|guard:", line))[:1500] + str(
        [text_of(event) for _, event in bus.messages("EVENT") if text_of(event).startswith("face")][:6])


def switches(robot, count, checks, what):
    done = 0
    for number in range(count):
        status, out, err = cli("switch", "sim", "--policy", "now", timeout=60)
        if not robot.watch(1.0) or status != 0:
            print(f"{what}: switch {number}: exit status {status}, {(out + err).strip()}, {robot.in_words()}", flush=True)
            break
        done += 1
    print(f"{what}: {done} of {count} switches", flush=True)
    checks.that(done == count, f"{what}: every switch is passed upright")


def proposed(description, folder):
    status, out, err = cli("check", description, "--propose", folder, timeout=600)
    assert folder.is_dir(), f"{status}: {out[-400:]}{err[-400:]}"
    return folder


def in_posture(robot, angles):
    """The pose "theirs" of this robot, for up: zero but for these joints of the legs."""
    srdf = next(robot.glob("*.srdf"))
    text = srdf.read_text()
    zero = re.search(r'<group_state name="zero".*?</group_state>', text, re.S).group(0).replace('"zero"', '"theirs"')
    for joint, angle in angles.items():
        zero = re.sub(rf'(name="(?:left|right)_{joint}_joint" value=)"[^"]*"', rf'\1"{angle}"', zero)
    srdf.write_text(text.replace("</robot>", f"  {zero}\n</robot>"))
    return ["--start-pose", "theirs"]


def keys(words, pause=0.15):
    def typed(program):
        time.sleep(0.2)
        program.type(words, pause)
    return typed


# The same key sooner counts as one that is held.
def slow_keys(words):
    return keys(words, pause=1.2)


class Remote:
    """The wireless remote: a gamepad on the bus, 50 messages a second."""

    BUTTONS = {"A": 0, "start": 6}  # bits of GAMEPAD

    def __init__(self):
        self.bus, self.message, self.ended = Bus(), type_of("GAMEPAD")(), threading.Event()
        self.message.sender_id, self.message.connected = os.getpid(), 1
        self.thread = threading.Thread(target=self._send)
        self.thread.start()

    def _send(self):
        while not self.ended.wait(0.02):
            self.message.utime, self.message.sequence = time.time_ns() // 1000, self.message.sequence + 1
            self.bus.send("GAMEPAD", self.message)

    def world(self, action):
        """Asks the simulator that is active; at once, where a command takes half a second to start."""
        request = type_of("SIM_REQUEST")()
        request.utime, request.sender_id, request.sequence = time.time_ns() // 1000, os.getpid(), self.message.sequence + 1
        request.run_id, request.action, request.pace = self.bus.newest("STATE")[1].run_id, {"pause": 1, "go": 2}[action], 1.0
        self.bus.send("SIM_REQUEST", request)

    def press(self, *names):
        self.message.buttons = sum(1 << self.BUTTONS[name] for name in names)

    def end(self):
        self.ended.set()
        self.thread.join()
        self.bus.close()


def walks(name, words, folder, path, ready, start, faster, checks, work, face=(), description=G1, posture=None):
    """A policy of theirs on a G1: stands while two simulators take each other's place, walks while two engines do.  An engine in
    which it falls or totters without a switch is left out."""
    robot = proposed(description, work / "g1")
    face = [*face, *(in_posture(robot, posture) if posture else [])]
    engines = work / "engines.yaml"
    text = (ROOT / "config/stacks/client_mujoco.yaml").read_text()
    engines.write_text(text.replace('"--engine", "mujoco"', '"--engine", "ode"'))
    pairs = {"ode": engines, "mujoco": "client_mujoco"} if os.environ.get("TWINBUS_MUJOCO") else {"ode": engines}
    walking = "client_twosims"
    for engine, stack in pairs.items():
        alone = ["--stack", stack, "--engine", engine, *face]
        tilt = drive(f"{name} in {engine} alone", robot, alone, words, folder, path, ready, start, faster, 0, SECONDS, checks.tentative())
        if tilt < TOTTERS:
            walking = stack
            break
    drive(f"{name} stands", robot, ["--stack", "client_twosims", *face], words, folder, path, ready, start, None, STANDING, SECONDS, checks)
    print(f"{name} walks in {walking}", flush=True)
    drive(f"{name} walks", robot, ["--stack", walking, *face], words, folder, path, ready, start, faster, WALKING, SECONDS, checks)


def drive(name, robot, options, words, folder, path, ready, start, faster, count, seconds, checks):
    """The most tilt while the program drives the robot for these seconds [rad], switches among them; start and faster, which makes it
    walk, are given the program."""
    bus, program = Bus(), None
    try:
        with Stack("stand_python", "--robot", robot, "--face", "unitree_hg", *options, "--no-viewer", "--no-record") as running:
            watched = Robot(bus)
            program = Typed(*words, folder=folder, path=path)
            program.wait_for(ready)
            start(program)  # until then it lets the robot sink
            time.sleep(2.0)
            if faster:
                faster(program)
                watched.watch(3.0)
                place = watched.place()
            began = time.monotonic()
            switches(watched, count, checks, name)
            watched.watch(seconds - (time.monotonic() - began))
            story = watched.in_words()
            print(f"{name} {time.monotonic() - began:.0f} s: {story}", flush=True)
            checks.that(watched.look(), f"{name}: {story}: {told(running, bus)} {program.read()[-600:]}")
            if faster:
                speed = math.dist(watched.place(), place) / (time.monotonic() - began)
                print(f"{name}: {speed:.3f} m/s", flush=True)
                checks.at_least(speed, 0.1, f"{name}: speed [m/s]")
            return watched.most_tilt
    finally:
        bus.close()
        if program is not None:
            program.end()


def holosoma(checks, work):
    words = ("-m", "holosoma_inference.run_policy", "inference:g1-29dof-loco", "--task.interface", "lo", "--secondary", "None")
    walks("holosoma", words, None, "", "Press the appropriate", keys("]"), slow_keys("=www"), checks, work)


def falcon(checks, work):
    words = ("rl_policy/dec_loco/dec_loco.py", "--config", "config/g1/g1_29dof.yaml", "--model_path", "models/dec_loco/g1_29dof.onnx")
    walks("falcon", words, PROGRAMS / "FALCON/sim2real", PROGRAMS / "FALCON", "Keyboard Listener Initialized", keys("]"), slow_keys("=www"), checks, work,
          FEWER_STATES)


def without_collector(work):
    """A folder for PYTHONPATH.  Some 20 s after its start a full collection of all that torch holds stands deploy_real still for 0.14 s here: its
    last LowCmd goes on, the robot totters, and its knees then come through one another (52 mm), for which the guard rightly stops it."""
    folder = work / "without_collector"
    folder.mkdir()
    (folder / "sitecustomize.py").write_text("import gc\ngc.disable()\n")
    return folder


def deploy_real(checks, work, name="deploy_real"):
    remote = Remote()
    path = PROGRAMS / "unitree_rl_gym"
    if name == "deploy_real":
        path = f"{without_collector(work)}:{path}"
    posture = {"hip_pitch": -0.1, "knee": 0.3, "ankle_pitch": -0.2}  # of its g1.yaml

    def start(program):  # the start button was held until now; A begins.  A real robot hangs from a gantry meanwhile, in the program's posture
        time.sleep(0.3)  # the fade of its first command: until then our gains hold the robot
        remote.world("pause")
        remote.message.left_y = 0.0
        remote.press()
        program.wait_for("Waiting for the Button A")
        time.sleep(0.2)
        remote.press("A")
        remote.world("go")
        time.sleep(0.3)  # nothing is read of the remote while the world is paused
        remote.press("start")

    def faster(_program):
        remote.message.left_y = 0.5

    try:
        remote.press("start")
        walks(name, ("deploy_real.py", "lo", "g1.yaml"), PROGRAMS / "unitree_rl_gym/deploy/deploy_real", path,
              "Moving to default pos", start, faster, checks, work, FEWER_STATES, G1_LOCKED, posture)
    finally:
        remote.end()


def deploy_real_untouched(checks, work):
    deploy_real(checks, work, "deploy_real_untouched")


def go2_stand(checks, work):
    robot = proposed(PROGRAMS / "go2.urdf", work / "go2")
    bus = Bus()
    try:
        with Stack("stand_python", "--robot", robot, "--face", "unitree_go", "--stack", "client_twosims", "--no-viewer", "--no-record"):
            watched = Robot(bus)
            program = Typed("go2_stand_example.py", "lo", folder=PROGRAMS / "unitree_sdk2_python/example/go2/low_level")
            try:
                program.wait_for("Press Enter")
                program.type("\n")
                time.sleep(3.0)
                switches(watched, 4, checks, "go2_stand")
                program.wait_for("Done!", 30.0)
                checks.that(watched.most_tilt < FALLEN, f"go2_stand: {watched.in_words()}")
            finally:
                program.end()
    finally:
        bus.close()


def why_not(name):
    """What a program lacks here, or ''."""
    modules = {"holosoma": ("holosoma_inference", "unitree_interface"), "falcon": ("unitree_sdk2py", "loop_rate_limiters"),
               "deploy_real": ("unitree_sdk2py", "torch"), "deploy_real_untouched": ("unitree_sdk2py", "torch"),
               "go2_stand": ("unitree_sdk2py",)}[name]
    files = {"holosoma": [G1], "falcon": [G1, PROGRAMS / "FALCON/sim2real"],
             "deploy_real": [G1_LOCKED], "deploy_real_untouched": [G1_LOCKED],
             "go2_stand": [PROGRAMS / "go2.urdf", PROGRAMS / "unitree_sdk2_python/example"]}[name]
    missing = [str(path) for path in files if not path.exists()]
    if missing:
        return f"{', '.join(missing)}: not there"
    for module in modules:
        if subprocess.run([PYTHON, "-c", f"import {module}"], capture_output=True).returncode != 0:
            return f"no {module} in {PYTHON}"
    return ""


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_bridge", "emulated_robot", "twinbus_face")
    programs = {"holosoma": holosoma, "falcon": falcon, "deploy_real": deploy_real, "deploy_real_untouched": deploy_real_untouched,
                "go2_stand": go2_stand}
    checks, ran = Checks(), 0
    for name in sys.argv[1:] or [one for one in programs if one != "deploy_real_untouched"]:
        why = why_not(name)
        if why:
            print(f"{name}: skipped: {why}", flush=True)
            continue
        ran += 1
        with tempfile.TemporaryDirectory() as work:
            programs[name](checks, pathlib.Path(work))
    if ran == 0:
        sys.exit(harness.SKIPPED)
    checks.exit()


if __name__ == "__main__":
    main()
