#!/usr/bin/env python3
"""Every door of the product attacked with mutated input: robot folders, scenes, settings, logs, bus, page, stack files, command lines.

    attack_test.py [TIMES]      # 1: the short fixed count; 10: ten times as many.  ATTACK_SEED=N repeats a run, ATTACK_DOORS=robots,logs

A failure is a crash or a report of a sanitizer, an exit status other than 0, 1 and 2, one input that takes more than 20 s, an
error of more than 4 kB, and a program that does not end within a second of Ctrl-C.  With a sanitizer build: TWINBUS_BIN=build/asan/bin.
"""

import json
import os
import pathlib
import random
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

import harness
from harness import BIN, Bus, Checks, Stack

sys.path.insert(0, str(harness.ROOT / "test/viewer"))
from web_socket import WebSocket  # noqa: E402

TIMES = int(sys.argv[1]) if len(sys.argv) > 1 else 1
SEED = int(os.environ.get("ATTACK_SEED", "1"))
SLOWEST = 20.0 * (5.0 if "asan" in str(BIN) else 1.0)  # [s]; sanitizers are slow
REPORT = re.compile(r"AddressSanitizer|LeakSanitizer|runtime error:|terminate called|Segmentation|Assertion")
NUMBERS = ("nan", "inf", "-inf", "0", "-0", "1e308", "-1e308", "1e-308", "1e39", "-1", "2147483648", "9223372036854775807",
           "-9223372036854775809", "0x10", "1,5", "", "1e", "--1", "3&45", "\u0661")


def with_other_number(text, rng):
    found = list(re.finditer(r"-?\d+\.?\d*(?:e-?\d+)?", text))
    for _ in range(rng.choice((1, 1, 3))):
        if not found:
            return text
        one = rng.choice(found)
        other = rng.choice(NUMBERS) if rng.random() < 0.5 else f"{float(one[0]) * rng.choice((-1, 0.1, 10, 1e3, 1e6, 1e9)):g}"
        text = text[:one.start()] + other + text[one.end():]
        found = list(re.finditer(r"-?\d+\.?\d*(?:e-?\d+)?", text))
    return text


def with_other_lines(text, rng):
    lines = text.splitlines(keepends=True)
    for _ in range(rng.choice((1, 2, 5))):
        if not lines:
            return text
        i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
        kind = rng.randrange(5)
        if kind == 0:
            del lines[i]
        elif kind == 1:
            lines.insert(j, lines[i])
        elif kind == 2:
            lines[i], lines[j] = lines[j], lines[i]
        elif kind == 3:
            lines[i] = " " * rng.randrange(12) + lines[i].lstrip(" ")
        else:
            lines[i] = lines[i][:rng.randrange(len(lines[i]) + 1)] + rng.choice(("\x1b[31m", "\0", "é" * 200, "*a", "&a ", "<", "]]>", "\n")) + lines[i][-3:]
    return "".join(lines)


def with_other_word(text, rng):
    found = list(re.finditer(r"[A-Za-z_]{3,}", text))
    if not found:
        return text
    one, other = rng.choice(found), rng.choice(found)
    word = one[0]
    at = rng.randrange(len(word))
    new = rng.choice((word[:at] + word[at + 1:], word[:at] + rng.choice("xq_") + word[at:], other[0], word * 3000))
    return text[:one.start()] + new + text[one.end():]


def with_other_bytes(data, rng):
    data = bytearray(data)
    for _ in range(rng.choice((1, 1, 4, 30))):
        if not data:
            break
        i = rng.randrange(len(data))
        kind = rng.randrange(5)
        if kind == 0:
            data[i] = rng.randrange(256)
        elif kind == 1:
            data[i] ^= 1 << rng.randrange(8)
        elif kind == 2:
            del data[i:i + rng.randrange(1, 64)]
        elif kind == 3:
            data[i:i] = bytes(rng.choice((b"\0", b"\xff", b"\x7f"))) * rng.choice((1, 8, 64))
        else:
            data[i:i + 8] = rng.choice((b"\x7f" + b"\xff" * 7, b"\x80" + b"\0" * 7, b"\xff" * 8))
    return bytes(data)


def mutated(data, rng):
    if rng.random() < 0.15:
        return with_other_bytes(data, rng)
    if rng.random() < 0.05:
        return data[:rng.randrange(len(data) + 1)]
    text = data.decode("utf-8", "replace")
    return rng.choice((with_other_number, with_other_number, with_other_lines, with_other_word))(text, rng).encode("utf-8", "replace")


class Attack:
    def __init__(self, checks, folder):
        self.checks, self.folder = checks, pathlib.Path(folder)
        self.counts, self.slowest = {}, (0.0, "")

    def run(self, door, words, keep=None, binary="twinbus", timeout=SLOWEST, env=None):
        """One program that ends by itself."""
        self.counts[door] = self.counts.get(door, 0) + 1
        begin = time.monotonic()
        try:
            done = subprocess.run([BIN / binary, *map(str, words)], capture_output=True, timeout=timeout + 20, stdin=subprocess.DEVNULL,
                                  cwd=self.folder, env=dict(os.environ, TWINBUS_RUNS=str(self.folder / "runs"), **(env or {})))
        except subprocess.TimeoutExpired:
            return self.fail(door, words, keep, f"does not end in {timeout + 20:.0f} s")
        took = time.monotonic() - begin
        self.slowest = max(self.slowest, (took, f"{door}: {' '.join(map(str, words))[:100]}"))
        said = (done.stdout + done.stderr).decode("utf-8", "replace")
        if done.returncode not in (0, 1, 2) or REPORT.search(said):
            self.fail(door, words, keep, f"exit {done.returncode}: {said[-1500:]}")
        elif took > timeout:
            self.fail(door, words, keep, f"takes {took:.1f} s")
        elif len(done.stderr) > 4096:
            self.fail(door, words, keep, f"an error of {len(done.stderr)} bytes")
        elif re.search(rb"[\x00-\x08\x0b-\x1f\x7f]", done.stderr):
            self.fail(door, words, keep, f"control bytes in an error: {done.stderr[:200]!r}")
        return done.returncode

    def fail(self, door, words, keep, why):
        kept = ""
        if keep is not None:
            kept = pathlib.Path(tempfile.gettempdir()) / f"attack_{door}_{len(list(pathlib.Path(tempfile.gettempdir()).glob('attack_*')))}"
            (shutil.copytree if pathlib.Path(keep).is_dir() else shutil.copy)(keep, kept)
        self.checks.that(False, f"{door}: {' '.join(map(str, words))[:200]}: {why} {kept}")
        return -1

    def interrupted(self, door, words, after):
        """A long command ends within a second of Ctrl-C."""
        self.counts[door] = self.counts.get(door, 0) + 1
        child = subprocess.Popen([BIN / "twinbus", *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL,
                                 cwd=self.folder, start_new_session=True)
        time.sleep(after)
        if child.poll() is not None:
            return
        begin = time.monotonic()
        child.send_signal(signal.SIGINT)
        try:
            child.wait(20)
        except subprocess.TimeoutExpired:
            child.kill()
        took = time.monotonic() - begin
        self.checks.at_most(took, 1.0 * (SLOWEST / 20.0), f"{door}: {' '.join(map(str, words))[:80]} ends after Ctrl-C [s]")


def robots(attack, rng, count):
    for i in range(count):
        name = rng.choice(("hrp1s", "biped12", "four_bar", "pendulum"))
        folder = attack.folder / f"robot{i}"
        shutil.copytree(harness.ROOT / "config/robots" / name, folder)
        files = [f for f in folder.rglob("*") if f.suffix in (".urdf", ".srdf", ".yaml")]
        target = rng.choice(files)
        target.write_bytes(mutated(target.read_bytes(), rng))
        if rng.random() < 0.2:
            urdf = next(iter(folder.glob("*.urdf")))
            attack.run("robots", ["check", urdf, "--propose", attack.folder / f"proposed{i}"], keep=folder)
            shutil.rmtree(attack.folder / f"proposed{i}", ignore_errors=True)
        else:
            attack.run("robots", ["check", folder] + (["--json"] if rng.random() < 0.3 else []), keep=folder)
        shutil.rmtree(folder)


def scenes(attack, rng, count):
    names = sorted((harness.ROOT / "config/scenes").glob("*.yaml"))
    for i in range(count):
        file = attack.folder / "scene.yaml"
        file.write_bytes(mutated(rng.choice(names).read_bytes(), rng))
        attack.run("scenes", ["run", file, "--for", "0.05"], keep=file)
    keys = re.findall(r"^\| `([a-z_.]+)` \| [-\d]", (harness.ROOT / "doc/scenes.md").read_text().split("## Settings")[1], re.MULTILINE)
    for _ in range(count // 4):
        attack.run("settings", ["run", "stand", "--for", "0.02", "--set", f"{rng.choice(keys)}={rng.choice(NUMBERS)}"])


def logs(attack, rng, count):
    good = attack.folder / "good.log"
    attack.run("logs", ["run", "walk_forward", "--for", "0.6", "--log", good])
    if not good.exists():
        attack.checks.that(False, "no log to mutate")
        return
    data = good.read_bytes()
    for i in range(count):
        bad = attack.folder / "bad.log"
        piece = data[:rng.choice((2_000, 60_000, len(data)))]
        bad.write_bytes(with_other_bytes(piece, rng))
        out = attack.folder / "out"
        words = rng.choice((["info", bad, "--check"], ["info", bad], ["events", bad], ["cut", bad, out, "--from", "0", "--to", "1"], ["csv", bad, "STATE"],
                            ["csv", bad, "COMMAND"], ["mcap", bad, out], ["compare", bad, good], ["compare", good, bad], ["rerun", bad], ["filter", bad, out, "STATE"]))
        attack.run("logs", ["log", *words], keep=bad)
        shutil.rmtree(out, ignore_errors=True) if out.is_dir() else out.unlink(missing_ok=True)
    bad.write_bytes(with_other_bytes(data * 1, random.Random(3)))
    for tool in (["rerun"], ["info", "--check"], ["compare", good]):
        attack.interrupted("logs", ["log", tool[0], *([good, good] if tool[0] == "compare" else [bad, *tool[1:]])], 0.05)
    attack.interrupted("long", ["run", "stand", "--for", "3600"], 1.0)
    attack.interrupted("long", ["view", good, "--no-open", "--port", "0"], 1.0)


TYPES = dict(harness.CHANNEL_TYPES, WALK="walk_command_t", STEPS="step_list_t", MOTION="motion_t", GAMEPAD="gamepad_t", OBSTACLES="obstacles_t", HELD="obstacles_t", JOURNAL="journal_t",
             STOP_PLAN="stop_plan_t", SIM_REQUEST="sim_request_t", MODEL_TEXT="model_text_t", TERRAIN="obstacles_t", LOOSE="obstacles_t", FOOTSTEPS="obstacles_t")


def bus_and_page(attack, rng, count):
    """Datagrams of every channel, most of them true ones with other bytes, and messages and requests to the page's server."""
    checks = attack.checks
    with Stack("stand", "--stack", "both", "--no-record") as stack:
        bus = Bus()
        time.sleep(2.0)
        address = next((harness.address_of(line) for line in stack.lines if harness.address_of(line)), None)
        heard = {}
        for _, channel, body in bus.records[-4000:]:
            heard.setdefault(channel, body)
        names = sorted(set(TYPES) | set(heard))
        for _ in range(count * 40):
            channel = rng.choice(names)
            body = heard.get(channel) or getattr(harness.twinbus, TYPES[channel])().encode()
            bus.send_raw(channel if rng.random() < 0.98 else rng.choice(("STATE\x1b[31m", "X" * 300, "")), with_other_bytes(body, rng))
            if rng.random() < 0.01:
                time.sleep(0.01)
        attack.counts["bus"] = count * 40
        if address:
            port = int(re.search(r":(\d+)/", address)[1])
            token = re.search(r"token=(\w+)", address)[1]
            page(attack, rng, count, port, token)
        for words in (["status"], ["switch", "bridge"], ["clear"], ["mode", "balance"], ["pose", "half_sitting"], ["reach", "left", "0.3", "0.2", "0.9"]):
            attack.run("commands", words)
        time.sleep(1.0)
        checks.that(stack.process.poll() is None, "the stack still runs: " + "".join(stack.lines[-3:]))
        said = "".join(stack.lines)
        checks.that(not REPORT.search(said), "the stack reports: " + "".join(line for line in stack.lines if REPORT.search(line))[:500])
        for program in ("twinbus_simulator", "twinbus_bridge", "twinbus_controller", "twinbus_guard", "twinbus_planner", "twinbus_viewer"):
            checks.that(len(stack.pids(program)) == 1, f"{program} still runs")
        checks.that("started again" not in said, "and none was started again: " + "".join(l for l in stack.lines if "started again" in l)[:300])
        begin = time.monotonic()
        stack.process.send_signal(signal.SIGINT)
        stack.process.wait(20)
        print(f"  up ends {time.monotonic() - begin:.2f} s after Ctrl-C", flush=True)
        bus.close()


REQUESTS = [{"do": "hello"}, {"do": "mode", "mode": "balance"}, {"do": "walk", "vx": 0.1, "vy": 0, "wz": 0}, {"do": "goal", "side": "left", "position": [0.3, 0.2, 0.9]},
            {"do": "cancel"}, {"do": "clear"}, {"do": "source", "action": "switch", "run": 1}, {"do": "pose", "pose": "half_sitting"}, {"do": "push", "link": 1, "force": [1, 2, 3]},
            {"do": "log"}, {"do": "event", "text": "x"}]


def page(attack, rng, count, port, token):
    for _ in range(count * 4):
        line = rng.choice((f"GET /?token={token} HTTP/1.1", "GET /robot.urdf HTTP/1.1", "GET /../../etc/passwd HTTP/1.1", "GET /ws HTTP/1.1", "POST / HTTP/1.1"))
        body = with_other_bytes(f"{line}\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n".encode(), rng)
        try:
            with socket.create_connection(("127.0.0.1", port), timeout=5) as s:
                s.sendall(body)
                s.settimeout(0.02)
                try:
                    s.recv(4096)
                except OSError:
                    pass
        except OSError:
            pass
    attack.counts["http"] = count * 4
    sent = 0
    while sent < count * 8:
        try:
            web = WebSocket(port, f"/ws?token={token}")
            for _ in range(40):
                text = with_other_bytes(json.dumps(rng.choice(REQUESTS)).encode(), rng) if rng.random() < 0.8 else bytes(rng.randrange(256) for _ in range(40))
                web.send(text.decode("latin-1"), opcode=rng.choice((1, 1, 1, 2)))
                sent += 1
            web.close()
        except (OSError, TypeError, ValueError, IndexError):
            sent += 5
    attack.counts["page"] = sent


def files_and_words(attack, rng, count):
    stacks = sorted((harness.ROOT / "config/stacks").glob("*.yaml"))
    for _ in range(count // 2):
        file = attack.folder / "stack.yaml"
        text = rng.choice(stacks).read_bytes()
        file.write_bytes(mutated(text, rng))
        attack.run("stacks", ["up", "stand", "--stack", file, "--for", "0.2", "--no-viewer", "--no-record"], keep=file, timeout=60.0)
    words = ["run", "check", "scenes", "log", "status", "walk", "pose", "push", "reach", "mode", "stop", "switch", "--help", "--version", "bench", "doctor", "info", "cut", "--for",
             "--set", "--stack", "stand", "hrp1s", "-1", "nan", "1e999", "", "\x1b[31m", "é", "x" * 5000, "=", "LARM_ELBOW=1", "--url", "udpm://239.255.76.67:7667?ttl=9", "--prefix", "%s%n"]
    for _ in range(count):
        attack.run("words", [rng.choice(words[:17])] + [rng.choice(words).replace("\0", "") for _ in range(rng.randrange(4))], timeout=30.0)
    steps = (harness.ROOT / "config/scenes/walk_steps.yaml").read_bytes()
    for _ in range(count // 4):
        file = attack.folder / "steps.yaml"
        file.write_bytes(mutated(steps, rng))
        attack.run("steps", ["walk", "--steps", file, "--for", "0.1"], keep=file, timeout=30.0)


DOORS = {"robots": (robots, 60), "scenes": (scenes, 60), "logs": (logs, 60), "bus": (bus_and_page, 60), "words": (files_and_words, 20)}


def main():
    harness.require("twinbus", "twinbus_simulator")
    checks = Checks()
    wanted = os.environ.get("ATTACK_DOORS", ",".join(DOORS)).split(",")
    with tempfile.TemporaryDirectory() as folder:
        attack = Attack(checks, folder)
        for name, (door, count) in DOORS.items():
            if name in wanted:
                begin = time.monotonic()
                door(attack, random.Random(f"{SEED} {name}"), count * TIMES)
                print(f"{name}: {time.monotonic() - begin:.0f} s", flush=True)
        print("inputs: " + ", ".join(f"{door} {count}" for door, count in attack.counts.items()))
        print(f"slowest: {attack.slowest[0]:.1f} s, {attack.slowest[1]}")
    checks.that(attack.counts, "something was attacked")
    checks.exit()


if __name__ == "__main__":
    main()
