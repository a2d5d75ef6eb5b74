#!/usr/bin/env python3
"""`up`: keeps its rate, says how it went, refuses a second one, leaves no process behind (row a of the first stack)."""

import json
import os
import re
import signal
import subprocess
import tempfile
import time

import harness
from harness import Checks, Stack, alive, cli


def judged_run(seconds):
    """(exit status, stdout, stderr, report) of one `up stand`."""
    report = os.path.join(tempfile.mkdtemp(), "report.json")
    status, out, err = cli("up", "stand", "--for", seconds, "--no-viewer", "--report", report, timeout=seconds + 60)
    print(out)
    with open(report, encoding="utf-8") as file:
        return status, out, err, json.load(file)


def runs_and_judges(checks):
    """One of three runs must do: what the machine does besides can only add missed ticks."""
    seconds = 30 if harness.FULL else 5
    for _ in range(3):
        status, out, err, figures = judged_run(seconds)
        if status == 0:
            break
    checks.that(status == 0, f"up stand --for {seconds} ends with 0, not {status}: {out}{err}")
    checks.that("FIFO" in out, "up says whether it has FIFO priority")
    checks.at_most(abs(figures["state_hz"] - 500), 5, "STATE rate off 500 Hz by")
    checks.at_most(abs(figures["command_hz"] - 500), 5, "COMMAND rate off 500 Hz by")
    own = (figures["missed_ticks"] - figures["stalled_ticks"]) / figures["ticks"]
    checks.at_most(own, 0.001 if figures["fifo"] else 0.01, "share of ticks missed by ourselves")
    checks.that(figures["fell"] is False, "nobody fell")


def chooses_by_accuracy(checks):
    """An error or a budget: order and step of the ladder, in the report, and said where it does not fit."""
    report = os.path.join(tempfile.mkdtemp(), "report.json")
    status, out, err = cli("up", "stand", "--for", 1, "--no-viewer", "--budget", "0.5ms", "--report", report, timeout=120)
    checks.that("up: accuracy: order " in out and " ms of a control period" in out, f"up says what it has chosen: {status} {out}{err}")
    with open(report, encoding="utf-8") as file:
        figures = json.load(file)
    chosen = figures["accuracy"]
    checks.that(chosen["budget_s"] == 0.0005 and figures["step_s"] == chosen["step_s"], f"the report has it: {chosen}")
    checks.at_most(1e-3 * chosen["physics_ms_per_s"] * 0.002, 0.0005, "CPU of the physics in a control period")
    status, out, err = cli("up", "stand", "--for", 1, "--no-viewer", "--budget", "0.1us", timeout=120)
    checks.that(status == 1 and "FAILED: accuracy: no order and step fits into 0.0001 ms" in out, f"what fits nothing is said: {status} {out}{err}")
    status, out, err = cli("up", "stand", "--stack", "bridge", "--accuracy", "1mm")
    checks.that(status == 2 and "one simulator" in err, f"a robot has no order: {status} {out}{err}")


def refuses_a_second_one(checks, stack):
    status, _, err = cli("up", "stand", "--no-viewer", "--for", "1")
    checks.that(status == 1 and "already publishes" in err, f"a second up is refused with a reason: {status} {err}")
    status, out, _ = cli("status")
    checks.that(status == 0 and "active" in out, f"status shows the active source: {out}")
    checks.that(stack.process.poll() is None, "the first one goes on")


def stop_and_clear(checks):
    status, out, err = cli("stop", "hold")
    checks.that(status == 0 and "hold" in out, f"stop is confirmed: {out}{err}")
    out = cli("status")[1]
    checks.that(out.startswith("ACT: the robot is stopped (hold) by the operator: ./twinbus clear"), f"status says first what has to be done: {out}")
    status, out, err = cli("clear")
    checks.that(status == 0, f"clear is confirmed: {out}{err}")
    status, out, err = cli("sway")
    checks.that(status == 0 and "the robot sways (./twinbus mode balance ends that)" in out, f"sway says how it ends: {out}{err}")
    status, out, err = cli("status")
    checks.that("robot: mode balance, sways" in out, f"status says that it sways: {out}")
    checks.that(out.startswith("nothing needs acting on\n") and len(out.splitlines()) <= 16, f"status is short: {out}")
    whole = cli("status", "--all")[1]
    checks.that("rejected: of another run" in whole and re.search(r"guard +STATE +[0-9]+ ", whole) is not None, f"--all has the channels: {whole}")
    busy = [line for line in out.splitlines() if re.match(r"  simulator +[0-9.]+ +[0-9]+ +[1-9]", line)]
    checks.that(len(busy) == 1, f"status says what share of a processor each takes: {out}")
    status, out, err = cli("mode", "balance")
    checks.that(status == 0 and "mode balance" in out and "the robot sways" not in out, f"it is ended: {out}{err}")
    status, out, err = cli("reach", "left", "2", "2", "2")
    checks.that(status == 1 and "out of reach" in err and "orientation" not in err, f"out of reach, with its true remedy: {err}")
    status, out, err = cli("walk", "0.1", "0", "0", "--for", "0.5")
    checks.that(status == 0 and "stands in mode walk" in out and "limited" not in out, f"walk says how the robot is left: {out}{err}")
    walks = subprocess.Popen([harness.BIN / "twinbus", "walk", "0.3", "0", "0", "--for", "20"], stderr=subprocess.PIPE, text=True)
    time.sleep(2.0)
    checks.that(cli("stop")[0] == 0, "a balanced stop of a walk")
    said = walks.communicate(timeout=10)[1]
    checks.that(walks.returncode == 1 and "the robot is stopped (balanced)" in said, f"walk says that it was stopped: {said}")
    time.sleep(3.0)
    cli("clear")
    status, out, err = cli("walk", "2", "0", "2", "--for", "0.5")
    checks.that(status == 0 and "walk: limited to 0." in out, f"what the legs cannot do is said: {out}{err}")


def no_process_is_left(checks):
    programs = ["twinbus_simulator", "twinbus_controller", "twinbus_guard", "twinbus_planner"]
    for kill in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
        with Stack("stand", "--no-viewer") as stack:
            pids = [pid for program in programs for pid in stack.pids(program)]
            checks.that(len(pids) == 4, f"four processes run: {len(pids)}")
            if kill == signal.SIGINT:
                refuses_a_second_one(checks, stack)
                stop_and_clear(checks)
            stack.process.send_signal(kill)
            try:
                stack.process.wait(15)
            except subprocess.TimeoutExpired:
                checks.that(False, f"up ends on {kill.name}")
            time.sleep(0.3)
            left = [pid for pid in pids if alive(pid)]
            checks.that(not left, f"after {kill.name} no process is left: {left}")


def a_death_is_reported(checks):
    with Stack("stand", "--no-viewer", "--for", "60") as stack:
        os.kill(stack.pid("twinbus_planner"), signal.SIGKILL)
        end = time.monotonic() + 5
        while time.monotonic() < end and not any("planner is started again" in line for line in stack.lines):
            time.sleep(0.05)
        text = "".join(stack.lines)
        checks.that("planner ended: signal 9" in text, "the planner's death is reported")
        checks.that("/planner.log, the last lines:" in text, "with its log")
        checks.that("planner is started again" in text, "and it is started again")
        os.kill(stack.pid("twinbus_simulator"), signal.SIGKILL)
        try:
            status = stack.process.wait(20)
        except subprocess.TimeoutExpired:
            status = None
        checks.that(status == 1, f"without its only source up ends with 1, not {status}")


def interrupted_start(checks):
    """Ctrl-C while the processes start: no list of what is ready, nobody that is blamed for not being ready to end."""
    for after in (0.1, 0.3, 0.7):
        up = subprocess.Popen([harness.BIN / "twinbus", "up", "stand", "--no-viewer"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        said = up.stdout.readline()  # which stack it starts
        time.sleep(after)
        up.send_signal(signal.SIGINT)
        said += up.communicate(timeout=30)[0]
        checks.that(up.returncode == 0 and "killed" not in said and said.endswith("up: all processes ended\n"), f"^C after {after} s: {up.returncode} {said}")
        checks.that(("up: ended by the operator before everything was ready" in said) != (re.search(r"ready after .*:( [a-z]+)+\n", said) is not None),
                    f"^C after {after} s: ready, or ended before: {said}")


def interrupted_run(checks):
    """The report that was asked for has what was measured up to Ctrl-C."""
    report = os.path.join(tempfile.mkdtemp(), "report.json")
    with Stack("stand", "--no-viewer", "--report", report) as stack:
        time.sleep(2.0)
        stack.process.send_signal(signal.SIGINT)
        stack.process.wait(15)
    with open(report, encoding="utf-8") as file:
        figures = json.load(file)
    checks.that(figures["ended_by"] == "the operator" and figures["ticks"] >= 500, f"the report of an interrupted run: {figures}")
    said = "".join(stack.lines)
    checks.that("up: ended by the operator after " in said and "up: figures up to here: " + report in said, f"and it is said: {said}")


def robot_alone(checks):
    """The stack without a simulator: the stand-in robot behind the bridge stands, moves, stops and is told to go on."""
    with Stack("stand", "--stack", "bridge", "--no-viewer") as stack:
        status, out, err = cli("status")
        checks.that(status == 0 and re.search(r"bridge.*active", out) is not None and "simulator" not in out,
                    f"status shows the robot as the only source: {out}{err}")
        for words in (("sway",), ("stop", "hold"), ("clear",)):
            status, out, err = cli(*words)
            checks.that(status == 0, f"{' '.join(words)} with a robot alone: {out}{err}")
        status, out, err = cli("switch", "sim")
        checks.that(status == 1 and err.count("\n") == 1, f"switch sim says in a line that there is none: {status} {out}{err}")
        stack.process.send_signal(signal.SIGINT)
        checks.that(stack.process.wait(10) == 0, "^C ends it well")


def interrupted_choice(checks):
    """What Ctrl-C leaves of a search is not kept as its answer."""
    words = [harness.BIN / "twinbus", "tune", "push_walk", "--error", "0.001mm"]
    with tempfile.TemporaryDirectory() as cache:
        for _ in range(2):
            tune = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=dict(os.environ, TWINBUS_CACHE=cache))
            time.sleep(1.0)
            tune.send_signal(signal.SIGINT)
            said = tune.communicate(timeout=20)[0]
            checks.that(tune.returncode != 0 and "nothing is kept" in said, f"tune, interrupted, ends with {tune.returncode}: {said}")


def lists(checks):
    status, said, _ = cli("--version")
    checks.that(status == 0 and said.startswith("twinbus "), f"--version: {said}")
    status, said, _ = cli("bench")
    groups = [line for line in said.splitlines() if line in ("walking", "guard and planner", "simulation", "bus and logs")]
    checks.that(status == 0 and len(groups) == 4 and "  physics " in said, f"bench lists by group, each with a line: {said}")
    checks.that("others" not in said.splitlines() and all(len(line.split(None, 1)) == 2 for line in said.splitlines() if line.startswith("  ")),
                f"no bench without a line: {said}")
    status, _, problem = cli("run", "stnad")
    checks.that(status == 1 and "did you mean stand?" in problem, f"a scene that is not there: {problem[:200]}")
    status, said, _ = cli("scenes")
    groups = [line for line in said.splitlines() if not line.startswith(" ")]
    checks.that(status == 0 and groups == ["standing", "walking", "arms and hands", "bodies and mechanisms"], f"scenes by group: {groups}")
    status, _, problem = cli("scenes", "wlak")
    checks.that(status == 1 and "did you mean walk?" in problem, f"a word of no scene: {problem}")
    status, said, problem = cli("status")
    checks.that(status == 1 and said == "" and "no source is heard" in problem, f"status of nothing: {said}{problem}")
    status, said, problem = cli("gamepad", timeout=20)
    checks.that(status == 1 and "no pad is plugged in" in problem and "--keyboard" in problem, f"a pad that nobody plugs in: {status} {said[-200:]}{problem}")
    status, said, _ = cli("scenes", "--robot", "table")
    checks.that(status == 0 and "not for table" in said and "two legs" in said and "\nwalking\n" not in said, f"scenes for a robot without legs: {said[-600:]}")
    status, _, problem = cli("up", "--stack", "replay")
    checks.that(status == 2 and "--log FILE" in problem, f"a replay wants a log: {problem}")


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_bridge", "twinbus_controller", "twinbus_guard", "twinbus_planner", "emulated_robot")
    checks = Checks()
    lists(checks)
    interrupted_choice(checks)
    runs_and_judges(checks)
    chooses_by_accuracy(checks)
    interrupted_start(checks)
    interrupted_run(checks)
    robot_alone(checks)
    no_process_is_left(checks)
    a_death_is_reported(checks)
    checks.exit()


if __name__ == "__main__":
    main()
