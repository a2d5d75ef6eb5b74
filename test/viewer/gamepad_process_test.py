#!/usr/bin/env python3
"""The gamepad process: a virtual pad through SDL, the keyboard through a pseudo terminal, and every way of letting go.

    gamepad_process_test.py BIN_FOLDER        in a private network namespace
"""
import os
import pty
import signal
import subprocess
import sys
import tempfile
import time

from process_tools import Checks, Process, binary

LB, A, B, X, BACK, START = 512, 1, 2, 4, 16, 64
check = Checks()
bin_folder = sys.argv[1]
gamepad = binary(bin_folder, "twinbus_gamepad")
fake = Process(binary(bin_folder, "fake_robot"))
check(fake.wait_for("ready") is not None, "the fake stack runs")
ZERO = "lx 0.00 ly 0.00 rx 0.00 ry 0.00"


def count_after(line):
    return int(line.rsplit(" ", 1)[1])


class Pad(Process):
    def __init__(self, *arguments):
        super().__init__(gamepad, *arguments, stdin=subprocess.PIPE)
        self.ready = self.wait_for("ready", 10) is not None

    def say(self, *lines, pause=0.08):
        for line in lines:
            self.child.stdin.write((line + "\n").encode())
            self.child.stdin.flush()
            time.sleep(pause)


# --- pad ---
pad = Pad("--virtual")
check(pad.ready, "it starts without a pad, a display and a keyboard")
check(any("STOP" in line for line in pad.seen) and any("lean forward" in line for line in pad.seen), "and prints the cheat sheet")
check(fake.wait_for("connected 0 deadman 0") is not None, "no pad yet is said on the bus")
pad.say("plug")
check(fake.wait_for("connected 1 deadman 0") is not None, "plugged in later, it is seen")
pad.say("axis 1 -32768")
pad.say(f"press {LB}")
lines = fake.drain()
check(lines and all("deadman 0" in line and ZERO in line for line in lines), "an off-centre stick keeps it from arming")
pad.say("axis 1 0")
check(fake.wait_for("deadman 1") is not None, "centred, the held button arms")
pad.say("axis 1 -32768")
line = fake.wait_for("ly 1.00")
check(line is not None and "run 1001" in line, "the stick arrives, forward positive, addressed to the source")
time.sleep(1.0)
pad.say(f"release {LB}")
line = fake.wait_for("deadman 0")
check(line is not None and ZERO in line, "letting go sends zeros")
rate = count_after(line) / 1.1
check(85 < rate < 115, f"100 Hz though nothing moved ({rate:.0f})")
pad.say("axis 1 0", f"press {LB}")
fake.wait_for("deadman 1")
pad.say("axis 0 -20000")
fake.wait_for("lx 0.5")
pad.say("unplug")
line = fake.wait_for("connected 0")
check(line is not None and ZERO in line and "deadman 0" in line, "unplugging while held sends zeros")
pad.say("plug")
line = fake.wait_for("connected 1")
check(line is not None and "deadman 0" in line, "plugged in again it does not go on by itself")
pad.say(f"press {X}", f"release {X}")
check(fake.wait_for("mode", 0.4) is None, "a mode button without the dead-man does nothing")
pad.say(f"press {LB}", f"press {X}", f"release {X}")
check(fake.wait_for("mode 41 run 1001") is not None, "with it, the mode is asked for")
pad.say(f"press {B}", f"release {B}")
check(fake.wait_for("stop 1") is not None, "B stops")
check(pad.wait_for("rumble") is not None, "and the pad shakes when the robot has stopped")
pad.say("axis 1 -32768")
time.sleep(0.2)
lines = [line for line in fake.drain() if line.startswith("pad")]
check(lines and all("deadman 0" in line and ZERO in line for line in lines), "after a stop the sticks do nothing")
pad.say("axis 1 0", f"release {LB}", f"press {BACK}", f"press {START}")
check(fake.wait_for("clear 77") is not None, "back + start clears with the nonce of the source")
pad.say(f"release {BACK}", f"release {START}", f"press {LB}", "axis 1 -32768")
check(fake.wait_for("ly 1.00") is not None, "and the pad drives again")
pad.child.stdin.close()
line = fake.wait_for("connected 0")
check(line is not None and ZERO in line, "leaving sends zeros")
check(pad.child.wait(3) == 0, "end of input ends it cleanly")

pad = Pad("--virtual")
pad.say("plug", f"press {LB}", "axis 1 -32768")
fake.wait_for("ly 1.00")
code = pad.end()
line = fake.wait_for("connected 0")
check(code == 0 and line is not None and ZERO in line, "SIGTERM: zeros, then exit 0")

# --- a pad that is learned: its buttons stand in another order ---
kept = os.path.join(tempfile.mkdtemp(), "own.txt")
teacher = Process(gamepad, "--map", "--virtual", "--mappings", kept, stdin=subprocess.PIPE)


def answer(word, line, back):
    check(teacher.wait_for(word) is not None, f"it asks: {word}")
    for text in (line, back):
        teacher.child.stdin.write((text + "\n").encode())
        teacher.child.stdin.flush()
        time.sleep(0.1)


teacher.wait_for("plug in")
teacher.child.stdin.write(b"plug\n")
teacher.child.stdin.flush()
for word, bit in (("(A,", 8), ("(B,", 4), ("(X,", 2), ("(Y,", 1), ("dead-man", 1024), ("right shoulder", 512), ("back", 32),
                  ("press start", 64), ("press up", 2048), ("press down", 4096)):
    answer(word, f"press {bit}", f"release {bit}")
for word, axis, value, rest in (("left stick to the right", 2, 30000, 0), ("left stick towards", 3, -30000, 0),
                                ("right stick to the right", 0, 30000, 0), ("right stick towards", 1, 30000, 0),
                                ("left trigger", 4, 30000, -32768), ("right trigger", 5, 30000, -32768)):
    answer(word, f"axis {axis} {value}", f"axis {axis} {rest}")
check(teacher.wait_for("kept in") is not None and teacher.child.wait(5) == 0, "it keeps what it learned")
pad = Pad("--virtual", "--mappings", kept)
pad.say("plug", "press 1024")
check(fake.wait_for("deadman 1") is not None, "the learned dead-man button arms")
pad.say("axis 3 32767")
check(fake.wait_for("ly 1.00") is not None, "the learned stick leans forward, turned round as it was taught")
pad.say("axis 3 0", "press 4", "release 4")
check(fake.wait_for("stop 1") is not None, "the learned B stops")
pad.say("release 1024", "press 32", "press 64")
check(fake.wait_for("clear") is not None, "the learned back and start clear")
pad.child.stdin.close()
check(pad.child.wait(3) == 0, "it ends")


# --- keyboard ---
def keyboard():
    master, slave = pty.openpty()
    child = subprocess.Popen([gamepad, "--keyboard"], stdin=slave, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                             start_new_session=True)
    os.close(slave)
    fake.wait_for("connected 1")
    return master, child


master, child = keyboard()
os.write(master, b"ww")
line = fake.wait_for("ly 0.20")
check(line is not None and "deadman 1" in line, "keys move set points")
os.write(master, b"\x1b[D")
check(fake.wait_for("lx 0.10") is not None, "arrow keys too")
os.write(master, b"x")
check(fake.wait_for(ZERO) is not None, "x centres")
os.write(master, b"2")
check(fake.wait_for("mode 41") is not None, "2 sways")
os.write(master, b"w ")
check(fake.wait_for("stop 1") is not None, "space stops")
os.write(master, b"c")
check(fake.wait_for("clear 79") is not None, "c clears")
os.write(master, b"www")
fake.wait_for("ly 0.30")
os.close(master)
line = fake.wait_for("connected 0")
check(line is not None and ZERO in line, "closing the terminal sends zeros")
check(child.wait(3) == 0, "and ends it")

master, child = keyboard()
os.write(master, b"w")
fake.wait_for("ly 0.10")
child.send_signal(signal.SIGHUP)
line = fake.wait_for("connected 0")
check(line is not None and ZERO in line and child.wait(3) == 0, "SIGHUP does the same")
os.close(master)

master, child = keyboard()
os.write(master, b"w")
fake.wait_for("ly 0.10")
os.write(master, b"\x03")
line = fake.wait_for("connected 0")
check(line is not None and child.wait(3) == 0, "Ctrl-C does the same")
os.close(master)

for arguments in (["--what"], ["--keyboard", "--virtual"], ["--id", "x"]):
    bad = Process(gamepad, *arguments)
    check(bad.child.wait(5) == 2, f"{' '.join(arguments)} is bad arguments")
check(fake.end() == 0, "the fake stack ends")
check.finish()
