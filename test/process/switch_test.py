#!/usr/bin/env python3
"""The live switch between simulator and robot, and between two simulators.

    switch_test.py [bench [--csv F]] [sway] [squat] [reach] [twosims]

`bench` prints the figures of every switch, and a table.  TWINBUS_FULL=1: 100 switches per motion, otherwise 4; SWITCHES=N
says how many.  A switch that failed while the machine itself stood still (stalls.py) is counted, printed and repeated.
"""

import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

import harness
import switch_figures
from harness import Bus, Checks, Stack, cli, percentile
from stalls import Stalls

PER_MOTION = 100 if harness.FULL else 4
# What is wrong with the second robot besides the model errors that it has anyway: IMU yaw drift and sole height.
DISTURBED = ["--set", "sensor.imu_yaw_drift=0.003", "--set", "ground.left_height_error=0.001"]
MOTIONS = ("sway", "squat", "reach")


def active_run(bus):
    _, state = bus.wait_for("STATE", timeout=2.0)
    return state.run_id if state else 0


def switch_once(bus, word, efforts, policy="now"):
    """(exit status, what was printed, figures or None)"""
    old = active_run(bus)
    bus.forget()
    time.sleep(0.25)
    status, out, err = cli("switch", word, "--policy", policy, timeout=40)
    if status != 0:
        return status, out + err, None
    # On a busy machine it is read late here: each STATE is looked at once, and what counts is when it came.
    at, state = bus.wait_for("STATE", lambda s: s.run_id != old, timeout=10.0, start=0)
    if state is None:
        return status, "no STATE of a new source", None
    time.sleep(0.55)
    return status, out + err, switch_figures.figures(bus, state.run_id, at, efforts)


def disturbed_stack(name):
    """The stack, with what is wrong with its robot besides the model errors that it has anyway."""
    text = (harness.ROOT / "config/stacks" / f"{name}.yaml").read_text(encoding="utf-8")
    plain = '"--socket", "{device}"]'
    assert plain in text
    words = ", ".join(f'"{word}"' for word in DISTURBED)
    file = pathlib.Path(tempfile.mkdtemp()) / f"{name}_disturbed.yaml"
    file.write_text(text.replace(plain, plain[:-1] + f", {words}]", 1), encoding="utf-8")
    return str(file)


# So long the machine may stand still before source, device or controller rightly stop the robot [ms].
STOPS_RIGHTLY = 15.0


class Interrupted(Exception):
    """The machine stood still for so long that the robot was rightly stopped."""


def one_switch(stack, bus, stalls, checks, what, target, efforts, policy, judge=switch_figures.judge):
    """(figures of a switch or None, a stall of the machine spoilt it).  Interrupted: it stopped the robot."""
    since = time.monotonic_ns() - 2_000_000_000
    status, said, f = switch_once(bus, target, efforts, policy)
    stops = [line.strip() for line in stack.lines if " stop '" in line][-2:]
    if status != 0 or f is None:
        if stops and stalls.longest_ms(since, time.monotonic_ns()) >= STOPS_RIGHTLY:
            raise Interrupted(f"{what}: {' '.join(stops)}")
        checks.that(False, f"{what}: {said.strip()} {' '.join(stops)}")
        print("\n".join(harness.story_of_a_stop(bus, stalls=stalls)), flush=True)
        return None, False
    checks.that(True, what)
    attempt = checks.tentative()
    judge(f, attempt, what)
    stall = stalls.longest_ms(f.from_ns, f.to_ns)
    hit = attempt.failed > 0 and stall > 0.0
    print(f"{what}: {f.row()}" + (f"; the machine stood still for {stall:.1f} ms" if stall > 0.0 else ""), flush=True)
    if hit:
        for good, sentence in attempt.claims:
            if not good:
                print(f"  not judged, machine stall: {sentence}", flush=True)
    else:
        checks.adopt(attempt)
    return f, hit


class Row:
    """Switches of one motion: count of them, and one more for each that a stall of the machine spoilt.  engine: of the simulator;
    judge_of: what a switch to "sim" or "bridge" is judged by."""

    def __init__(self, checks, motion, count, all_figures, rng, stalls, twosims, engine="", judge_of=lambda target: switch_figures.judge):
        self.checks, self.motion, self.count, self.all_figures = checks, motion, count, all_figures
        self.rng, self.stalls, self.twosims = rng, stalls, twosims
        self.label = f"{motion}, two simulators" if twosims else f"{motion}, {engine} and bridge" if engine else motion
        self.words, self.judge_of = ["--engine", engine] if engine else [], judge_of
        self.efforts = harness.effort_limits()
        self.number = self.spoilt = self.refused = 0

    def wants_more(self):
        return self.number < self.count and self.spoilt <= self.count and self.refused < 3

    def run(self):
        while self.wants_more():
            name = "twosims" if self.twosims else disturbed_stack("both")
            with Stack(self.motion, "--stack", name, "--no-viewer", *self.words) as stack:
                bus = Bus()
                try:
                    self.back_and_forth(stack, bus)
                except Interrupted as stopped:
                    self.spoilt += 1
                    print(f"  not judged, the machine stood still and the robot was stopped: {stopped}", flush=True)
                bus.close()
        print(f"{self.label}: {self.number} switches judged, {self.spoilt} hit by a stall of the machine and repeated",
              flush=True)
        self.checks.at_least(self.number, self.count, f"{self.label}: switches judged")

    def back_and_forth(self, stack, bus):
        time.sleep(2.5)  # until the motion is under way
        target = "sim" if self.twosims else "bridge"
        while self.wants_more():
            what = f"{self.label} {self.number}: to {target}"
            # Now and then within the blend of the last one, otherwise at a random phase of the motion.
            time.sleep(0.02 if self.number % 5 == 4 else 0.3 + 0.7 * self.rng.random())
            # A robot is left only when it stands still; a simulator at any time.
            policy = "now" if target == "bridge" or self.twosims else "when-safe"
            f, hit = one_switch(stack, bus, self.stalls, self.checks, what, target, self.efforts, policy, self.judge_of(target))
            if f is None:
                self.refused += 1
                continue
            if hit:
                self.spoilt += 1
            else:
                self.number += 1
                self.all_figures.append((f"{self.label} to {target}", f))
            if policy == "when-safe" and self.motion != "reach":
                self.go_on(what, bus)
            if not self.twosims:
                target = "sim" if target == "bridge" else "bridge"
        programs = ["twinbus_guard", "twinbus_controller"] + ([] if self.twosims else ["twinbus_planner"])
        self.checks.that(all(len(stack.pids(p)) == 1 for p in programs),
                         f"{self.label}: guard, planner and controller still run")
        self.checks.that(not any("started again" in line for line in stack.lines),
                         f"{self.label}: and none was started again")

    def go_on(self, what, bus):
        """When-safe ended the motion; it begins again.  What stops the robot may come before it is asked to."""
        since = time.monotonic_ns() - 2_000_000_000
        status, out, err = cli(self.motion)
        if status != 0 and self.stalls.longest_ms(since, time.monotonic_ns()) >= STOPS_RIGHTLY:
            raise Interrupted(f"{what}: {err.strip()}")
        if not self.checks.that(status == 0, f"{what}: and the motion goes on: {out}{err}"):
            print("\n".join(harness.story_of_a_stop(bus, stalls=self.stalls)), flush=True)


def refusals(checks):
    """Refused with its own sentence, and nothing moves: unknown, stopped, already active."""
    with Stack("stand", "--stack", "both", "--no-viewer"):
        bus = Bus()
        time.sleep(0.5)
        run = active_run(bus)
        status, out, err = cli("switch", "replay")  # none is running
        checks.that(status == 1 and "replay" in err, f"a source that is not there is refused: {out}{err}")
        cli("stop", "hold")
        bus.forget()
        status, out, err = cli("switch", "bridge", "--policy", "now")
        checks.that(status == 1 and "stop" in err.lower(), f"a stopped source does not hand over: {out}{err}")
        checks.that(active_run(bus) == run, "and stays the active one")
        moved = [s for _, s in bus.messages("STATE")]
        steps = max((abs(a.q[k] - b.q[k]) for a, b in zip(moved, moved[1:]) for k in range(b.joint_count)), default=0.0)
        checks.at_most(steps, 0.002, "and does not move [rad per tick]")
        cli("clear")
        status, out, err = cli("switch", "bridge")
        checks.that(status == 0 and active_run(bus) != run, f"an older refusal is none of a switch that is asked for later: {status}, {out}{err}")
        bus.close()


def out_of_a_walk(checks):
    """The robot that takes over stands at its own posture, a little off: that is no motion, and stops nobody."""
    with Stack("stand", "--stack", "both", "--no-viewer"):
        bus = Bus()
        time.sleep(1.5)
        walk = subprocess.Popen([harness.BIN / "twinbus", "walk", "0.3", "0", "0", "--for", "8"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(4.0)
        status, out, err = cli("switch", "bridge", timeout=40)
        time.sleep(1.5)
        _, state = bus.wait_for("STATE", timeout=2.0)
        checks.that(status == 0 and state is not None and state.stop_kind == 0,
                    f"switched while it walks it stops, and nothing is stopped afterwards: {status}, {state and state.stop_kind}, {out}{err}")
        walk.kill()
        walk.wait()
        bus.close()


def table(all_figures, csv):
    rows = []
    for case in sorted({name for name, _ in all_figures}):
        of_case = [f for name, f in all_figures if name == case]
        for metric, unit, take in (("torque_step", "share of limit", lambda f: f.torque_step),
                                   ("foot_force_step", "share of weight", lambda f: f.force_step),
                                   ("gap", "ms", lambda f: f.gap_ms),
                                   ("missed", "ticks", lambda f: f.ticks_without_command),
                                   ("zmp_margin", "mm", lambda f: f.zmp_margin_mm)):
            values = [take(f) for f in of_case]
            worst = min(values) if metric == "zmp_margin" else max(values)
            # Of a margin the low side is the bad one.
            shares = (0.5, 0.01, 0.001) if metric == "zmp_margin" else (0.5, 0.99, 0.999)
            rows.append(["switch", case, metric, unit] + [f"{percentile(values, s):.6g}" for s in shares] + [f"{worst:.6g}", "", "", ""])
    print(f"\n{'case':<20} {'figure':<16} {'unit':<16} {'median':>10} {'p99':>10} {'worst':>10}")
    for row in rows:
        print(f"{row[1]:<20} {row[2]:<16} {row[3]:<16} {row[4]:>10} {row[5]:>10} {row[7]:>10}")
    if csv:
        with open(csv, "w", encoding="utf-8") as file:
            file.write("bench,case,metric,unit,median,p99,p999,max,peer,peer_median,ratio\n")
            for row in rows:
                file.write(",".join(row) + "\n")


def main():
    harness.require(*harness.STACK, "twinbus_bridge", "emulated_robot")
    seed = random.randrange(1 << 30)
    print(f"seed {seed}")
    rng = random.Random(seed)
    checks = Checks()
    all_figures = []
    bench = "bench" in sys.argv[1:]
    stalls = Stalls()
    wanted = [word for word in sys.argv[1:] if word in MOTIONS + ("twosims",)]
    count = int(os.environ.get("SWITCHES", PER_MOTION))
    for motion in MOTIONS:
        if not wanted or motion in wanted:
            Row(checks, motion, count, all_figures, rng, stalls, twosims=False).run()
    if not wanted or "twosims" in wanted:
        Row(checks, "sway", count, all_figures, rng, stalls, twosims=True).run()
    if not bench and not wanted:
        refusals(checks)
        out_of_a_walk(checks)
    stalls.close()
    csv = sys.argv[sys.argv.index("--csv") + 1] if "--csv" in sys.argv[:-1] else None
    if all_figures:
        table(all_figures, csv)
    checks.exit()


if __name__ == "__main__":
    main()
