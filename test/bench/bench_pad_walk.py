#!/usr/bin/env python3
"""A long walk with the pad, the page open in a browser, beside a build on all cores: falls, stops and their causes, pace.

    bench_pad_walk.py [--minutes M] [--no-load] [-- WORDS FOR up]      e.g. bench_pad_walk.py --minutes 10 -- --strict

Run under test/tools/private_bus.sh.  Without words `up` has its default settings; `--no-fifo` is a machine without real-time rights.
The sticks move every few seconds, as the seed draws (PAD_SEED=N repeats a run).  A stop is counted with its cause, cleared, and
the walk goes on.  Exit status 1 when the robot fell.
"""

import argparse
import collections
import os
import pathlib
import random
import subprocess
import sys
import threading
import time

import programs

programs.help_is(__doc__)
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "test/process"), str(ROOT / "test/viewer")]

import harness  # noqa: E402
from browser import Browser, find_browser  # noqa: E402
from harness import Bus, Stack, address_of, cli, text_of  # noqa: E402
from pads_test import FORWARD, LEFT, Pad  # noqa: E402
from stalls import Stalls  # noqa: E402

TURN = 2        # axis of the right stick
WALKS = 5       # mode of CONTROLLER_STATUS
LOOK_S = 2.0    # between two looks at what was said
REASONS = {1: "operator", 2: "pad", 3: "page", 4: "guard", 5: "launcher", 6: "controller", 7: "command timeout", 8: "device", 10: "fall"}


class Load:
    """A compiler per core, without end."""

    def __init__(self, wanted):
        self.run = wanted
        self.compiled = 0
        words = ["c++", "-std=c++20", "-O2", f"-I{ROOT}", "-isystem", "/usr/include/eigen3", "-c", "-o", "/dev/null"]
        files = ["control/walk/walk.cpp", "robot/dynamics/inverse_dynamics.cpp", "control/balance/balance.cpp", "robot/estimation/estimator.cpp"]

        def work():
            while self.run:
                for name in files:
                    subprocess.run([*words, str(ROOT / name)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
                    self.compiled += 1
                    if not self.run:
                        return
        self.threads = [threading.Thread(target=work, daemon=True) for _ in range(os.cpu_count() or 1)] if wanted else []
        for thread in self.threads:
            thread.start()

    def end(self):
        self.run = False
        for thread in self.threads:
            thread.join()


class Watch:
    """What the bus says, looked at every now and then and forgotten."""

    def __init__(self, bus):
        self.bus = bus
        self.falls = self.plans = self.missed = 0
        self.stops = collections.Counter()
        self.events = []
        self.way = 0.0
        self.first_tick = self.last_tick = None
        self.begun = time.monotonic()
        self.slowest = 1.0
        self.worst_tilt = 0.0
        self.stop = 0
        self._place = None
        self._plans = self._missed = None

    def look(self):
        """The stop that is in force, else 0."""
        records = list(self.bus.records)
        del self.bus.records[:len(records)]
        stop, fell = self.stop, False
        seen = collections.Counter()
        for at, channel, body in records:
            seen[channel] += 1
            if channel == "SOURCE_STATUS":
                s = harness.type_of(channel).decode(body)
                if s.role not in (2, 5) and not s.stop_kind:
                    continue
                if self._plans is not None:
                    self.plans += max(0, s.plans_followed - self._plans)
                    self.missed += max(0, s.ticks_missed - self._missed)
                self._plans, self._missed = s.plans_followed, s.ticks_missed
                if s.stop_kind and not stop:
                    self.stops[REASONS.get(s.stop_reason, str(s.stop_reason))] += 1
                stop = s.stop_kind
            elif channel == "TRUTH" and seen[channel] % 25 == 0:
                t = harness.type_of(channel).decode(body)
                fell = fell or t.fell
                x, y = t.base_position[0], t.base_position[1]
                if self._place is not None:
                    self.way += ((x - self._place[0]) ** 2 + (y - self._place[1]) ** 2) ** 0.5
                self._place = (x, y)
                self.last_tick = t.tick
                self.first_tick = t.tick if self.first_tick is None else self.first_tick
            elif channel == "EVENT":
                text = text_of(harness.type_of(channel).decode(body))
                self.events.append(text)
        self.stop = stop
        self.falls += fell
        return 3 if fell else stop

    def pace(self):
        """Simulated over real time."""
        if self.first_tick is None:
            return float("nan")
        return 0.002 * (self.last_tick - self.first_tick) / (time.monotonic() - self.begun)


def take_hold(pad):
    """With centred sticks, or nothing moves."""
    pad.say(f"axis {FORWARD} 0", f"axis {TURN} 0", f"axis {LEFT} 0")
    time.sleep(0.3)
    pad.hold()
    time.sleep(0.3)


def walk(stack, bus, pad, rng, minutes):
    watch = Watch(bus)
    end = time.monotonic() + 60.0 * minutes
    told = time.monotonic()
    while time.monotonic() < end:
        forward, turn, side = rng.uniform(-0.2, 0.8), rng.choice((0.0, 0.0, rng.uniform(-1.0, 1.0))), rng.choice((0.0, rng.uniform(-0.4, 0.4)))
        pad.say(f"axis {FORWARD} {int(-32767 * forward)}", f"axis {TURN} {int(-32767 * turn)}", f"axis {LEFT} {int(-32767 * side)}")
        time.sleep(rng.uniform(1.0, 2.0 * LOOK_S))
        stop = watch.look()
        if stop:
            print(f"stopped: {'; '.join(line.strip() for line in stack.lines[-4:])}; {'; '.join(watch.events[-6:])}", flush=True)
            if watch.falls:
                break
            time.sleep(2.0)
            pad.let_go()
            cli("clear")
            cli("mode", "balance")
            time.sleep(1.0)
            cli("mode", "walk")
            take_hold(pad)
            watch.look()
        if time.monotonic() - told > 60.0:
            told = time.monotonic()
            print(f"{watch.way:.0f} m, {watch.falls} falls, stops {dict(watch.stops)}, {watch.plans} stop plans followed, "
                  f"{watch.pace():.3f} times real time", flush=True)
    return watch


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--no-load", action="store_true")
    words, rest = sys.argv[1:], []
    if "--" in words:
        words, rest = words[:words.index("--")], words[words.index("--") + 1:]
    options = parser.parse_args(words)
    harness.CHANNEL_TYPES.setdefault("GAMEPAD", "gamepad_t")
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard", "twinbus_gamepad", "twinbus_viewer")
    seed = int(os.environ.get("PAD_SEED", random.randrange(1 << 30)))
    print(f"PAD_SEED={seed}", flush=True)
    stalls = Stalls()
    with Stack("stand", *rest) as stack:
        print("".join(line for line in stack.lines if "FIFO" in line), end="", flush=True)
        bus = Bus()
        load = Load(not options.no_load)
        page = None
        try:
            address = next(filter(None, map(address_of, stack.lines)), None)
            if find_browser() and address:
                page = Browser(address)
                print(f"page open: {page.wait_for('document.getElementById(`rate-state`) !== null', 60.0)}", flush=True)
            time.sleep(2.0)
            cli("mode", "walk")
            pad = Pad(77)
            pad.say("plug")
            if bus.wait_for("GAMEPAD", lambda g: g.connected, 20.0)[1] is None:
                raise RuntimeError("no pad appears")
            time.sleep(0.5)
            take_hold(pad)
            del bus.records[:]
            began = time.monotonic_ns()
            watch = walk(stack, bus, pad, random.Random(seed), options.minutes)
            slow = page.value("document.getElementById('rate-factor').textContent") if page else "no page"
            table = cli("status")[1]
        finally:
            load.end()
        pad.close()
        if page:
            page.end()
        print(f"{options.minutes:g} minutes, {watch.way:.0f} m, {load.compiled} files compiled beside: {watch.falls} falls, "
              f"{sum(watch.stops.values())} stops {dict(watch.stops)}, {watch.plans} stop plans followed, {watch.missed} ticks missed; "
              f"{watch.pace():.3f} times real time (page: {slow}); the machine stood still for {stalls.longest_ms(began, time.monotonic_ns()):.1f} ms "
              f"at most", flush=True)
        kinds = collections.Counter(text.split(":")[0] for text in watch.events)
        print(f"events: {dict(kinds)}", flush=True)
        print("\n".join(line for line in table.splitlines() if "real time" in line or "waits" in line), flush=True)
        bus.close()
    stalls.close()
    sys.exit(1 if watch.falls else 0)


if __name__ == "__main__":
    main()
