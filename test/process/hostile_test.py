#!/usr/bin/env python3
"""Hostile and stale messages on a running stack (row o): refused, counted, and nothing obeys them.

Not a number, infinite and absurd values in every field of every message that somebody consumes; foreign and higher terms;
the log of another run played by the stock lcm-logplayer; stop and clear in one batch.
HOSTILE_SEED=N repeats a run.
"""

import math
import os
import random
import shutil
import subprocess
import tempfile
import time

import harness
from harness import Bus, Checks, Stack, alive, cli, twinbus

URL = f"udpm://{harness.GROUP}:{harness.PORT}?ttl=0&recv_buf_size=4194304"
CONSUMED = ("STATE", "COMMAND", "SOURCE_REQUEST", "CONTROLLER_REQUEST", "MODE_REQUEST", "ARM_GOAL", "STOP", "GUARD", "WALK", "STEPS", "MOTION",
            "GAMEPAD", "ARM_PATH", "OBSTACLES", "CONTROLLER_STATUS")
TYPES = dict(harness.CHANNEL_TYPES, WALK="walk_command_t", STEPS="step_list_t", MOTION="motion_t", GAMEPAD="gamepad_t", OBSTACLES="obstacles_t")
PROGRAMS = ("twinbus_simulator", "twinbus_bridge", "twinbus_controller", "twinbus_guard", "twinbus_planner")
LARGEST_TILT = math.radians(3)


class Watched:
    """What must not change while somebody else talks: source, term, mode, stop, posture, processes."""

    def __init__(self, bus, stack, checks):
        self.bus, self.stack, self.checks = bus, stack, checks
        self.pids = {pid for program in PROGRAMS for pid in stack.pids(program)}
        _, self.state = bus.wait_for("STATE", lambda s: s.role == 2)
        _, self.status = bus.wait_for("CONTROLLER_STATUS")
        if self.state is None or self.status is None:
            raise RuntimeError("the stack does not run:\n" + "".join(stack.lines))

    def rejected(self):
        """Sum over all processes of the stack; a second is enough for every one to say it."""
        counts = {}
        for _, beat in self.bus.messages("HEARTBEAT", time.monotonic_ns() - 1_000_000_000):
            if beat.pid in self.pids:
                counts[beat.pid] = beat.messages_rejected
        return sum(counts.values())

    def unharmed(self, what, forged_ids=()):
        since = time.monotonic_ns()
        time.sleep(0.6)
        checks, own = self.checks, self.state.run_id
        states = [s for _, s in self.bus.messages("STATE", since) if s.run_id == own]
        foreign = [c for _, c in self.bus.messages("COMMAND", since) if c.run_id != own and c.controller_id not in forged_ids]
        _, status = self.bus.newest("CONTROLLER_STATUS")
        checks.that(len(states) > 200, f"{what}: STATE goes on, {len(states)} states")
        if not states:
            return
        now = states[-1]
        checks.that((now.run_id, now.term, now.role, now.stop_kind) == (own, self.state.term, 2, 0),
                    f"{what}: source, term and role stay: term {now.term} role {now.role} stop {now.stop_kind}")
        checks.that(not foreign, f"{what}: all commands are for the active source")
        answered = {c.tick for _, c in self.bus.messages("COMMAND", since) if c.run_id == own}
        checks.at_least(len(answered) / len(states), 0.9, f"{what}: share of ticks answered")
        checks.that((status.run_id, status.mode, status.motion) == (own, self.status.mode, self.status.motion),
                    f"{what}: the controller follows the same source in the same mode")
        tilt = max(math.acos(max(-1.0, 1.0 - 2.0 * (s.attitude[1] ** 2 + s.attitude[2] ** 2))) for s in states)
        checks.at_most(tilt, LARGEST_TILT, f"{what}: tilt")
        dead = [pid for pid in self.pids if not alive(pid)]
        checks.that(not dead, f"{what}: no process ended")


def first_number(value):
    while isinstance(value, (list, tuple)):
        value = value[0]
    return value


def replaced(value, number):
    """The same shape with its first number replaced."""
    if isinstance(value, (list, tuple)):
        return [replaced(value[0], number), *value[1:]]
    return number


def with_value(message, name, number):
    """Encodes the message with one number of one field replaced."""
    old = getattr(message, name)
    setattr(message, name, replaced(old, number))
    try:
        return message.encode()
    finally:
        setattr(message, name, old)


def bad_values(bus, watched, checks):
    sent = {}
    for channel in CONSUMED:
        kind = getattr(twinbus, TYPES[channel])
        # A true one where there is one: addressed as it must be, so that the value alone is wrong.
        message = next((kind.decode(body) for _, name, body in reversed(bus.records) if name == channel), kind())
        for name in ("run_id", "model_hash", "term", "controller_id", "tick"):
            if name in kind.__slots__ and getattr(message, name) == 0:
                source = watched.status if name == "controller_id" else watched.state
                setattr(message, name, getattr(source, name))
        for name in kind.__slots__:
            if isinstance(first_number(getattr(message, name)), float):
                values = (math.nan, math.inf, -math.inf, 3e38, -3e38)
            elif name in ("kind", "action", "policy", "mode", "motion", "joint_count", "role", "source", "side", "count"):
                values = (-1, 100)
            else:
                continue
            for value in values:
                bus.send_raw(channel, with_value(message, name, value))
                sent[channel] = sent.get(channel, 0) + 1
        time.sleep(0.02)
    return sent


def no_bad_value_is_obeyed(bus, watched, checks):
    time.sleep(0.5)
    before = watched.rejected()
    sent = bad_values(bus, watched, checks)
    time.sleep(1.2)
    counted = watched.rejected() - before
    print(f"bad values sent {sum(sent.values())} {sent}, refusals counted {counted}", flush=True)
    # Each channel has at least one listener in the stack.
    checks.at_least(counted, sum(sent.values()), "refused messages are counted")
    watched.unharmed("bad values")


def no_foreign_term_is_believed(bus, watched, checks, rng):
    _, state = bus.newest("STATE")
    before = watched.rejected()
    runs = [rng.getrandbits(52) for _ in range(40)]
    count = 0
    for run in runs:
        for step in (0, 1, 2, 3, 1000, 2**31 - 1 - state.term):
            forged = harness.type_of("STATE").decode(state.encode())
            forged.run_id, forged.term, forged.tick = run, state.term + step, state.tick + rng.randrange(0, 2000)
            forged.role = 2
            bus.send("STATE", forged)
            count += 1
        _, state = bus.newest("STATE", lambda s: s.run_id == watched.state.run_id)
        time.sleep(0.01)
    # Commands for the robot from somebody the gate is not bound to, with a posture it must not take.
    _, command = bus.newest("COMMAND")
    for _ in range(100):
        _, now = bus.newest("STATE", lambda s: s.run_id == watched.state.run_id)
        command.tick, command.controller_id = now.tick, 4711
        command.q = [q + 0.5 for q in now.q]
        bus.send("COMMAND", command)
        count += 1
        time.sleep(0.003)
    time.sleep(1.2)
    counted = watched.rejected() - before
    print(f"forged {count}, refusals counted {counted}", flush=True)
    checks.at_least(counted, count, "forged states and commands are counted")
    watched.unharmed("forged terms and commands", forged_ids=(4711,))


def no_stale_request_is_obeyed(bus, watched, checks):
    """Requests that name another run, as those of an old log do."""
    for number in range(30):
        for channel, values in (("MODE_REQUEST", {"mode": 1}), ("SOURCE_REQUEST", {"action": 5}), ("SOURCE_REQUEST", {"action": 2, "policy": 1}),
                                ("CONTROLLER_REQUEST", {"controller_id": 4711}), ("STOP", {"kind": 0, "stop_nonce": number})):
            message = getattr(twinbus, TYPES[channel])()
            message.sender_id, message.sequence = 99, number + 1
            if channel != "STOP":
                message.run_id = 123456
            if channel == "SOURCE_REQUEST":
                message.target_run_id = 123456
            for name, value in values.items():
                setattr(message, name, value)
            bus.send(channel, message)
        time.sleep(0.01)
    watched.unharmed("requests for another run")


def stop_message(kind, nonce=0, sender=77, sequence=1):
    message = twinbus.stop_t()
    message.sender_id, message.sequence, message.kind, message.stop_nonce = sender, sequence, kind, nonce
    return message


def a_stop_outlives_any_clear_sent_with_it(bus, watched, checks, rng):
    """Stop and clear in one batch, in every order and with every nonce that could be known before: stopped."""
    for number in range(10):
        _, state = bus.newest("STATE")
        nonces = [0, state.stop_nonce, state.stop_nonce + 1, state.stop_nonce - 1, rng.getrandbits(31)]
        batch = [stop_message(2, sequence=10 * number + 1)]
        batch += [stop_message(0, nonce, sequence=10 * number + 2 + k) for k, nonce in enumerate(nonces)]
        rng.shuffle(batch)
        for message in batch:
            bus.send("STOP", message)
        time.sleep(0.3)
        _, after = bus.newest("STATE")
        checks.that(after.stop_kind == 2, f"stop and clear in one batch {number}: stopped, not {after.stop_kind}")
        checks.that(after.stop_nonce != state.stop_nonce, f"stop and clear in one batch {number}: the nonce is a new one")
        status, out, err = cli("clear")
        checks.that(status == 0, f"a clear with the nonce shown ends it: {out}{err}")
        time.sleep(0.3)
    print("stop and clear in one batch: 10 of 10", flush=True)


def record_a_run(folder, checks):
    """A log with states, commands and what an operator asked for."""
    log = os.path.join(folder, "old.log")
    with Stack("sway", "--stack", "both", "--no-viewer"):
        logger = subprocess.Popen(["lcm-logger", "-q", "-f", f"--lcm-url={URL}", log], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(0.7)
        for words in (("squat",), ("mode", "hold"), ("mode", "balance"), ("switch", "bridge", "--policy", "now")):
            cli(*words)
        time.sleep(0.5)
        logger.terminate()
        logger.wait(10)
    checks.that(os.path.getsize(log) > 1_000_000, f"a log of {os.path.getsize(log)} bytes was written")
    return log


def an_old_log_moves_nothing(bus, watched, checks, log):
    _, state = bus.newest("STATE")
    before = watched.rejected()
    done = subprocess.run(["lcm-logplayer", "-l", URL, "-e", "^(?!STOP$).*$", log], capture_output=True, text=True, timeout=60)
    checks.that(done.returncode == 0, f"lcm-logplayer plays it: {done.stderr[-200:]}")
    time.sleep(1.0)
    old = sum(1 for _, s in bus.messages("STATE") if s.run_id != state.run_id)
    print(f"old log: {old} old states were heard, {watched.rejected() - before} messages refused", flush=True)
    checks.at_least(old, 500, "the log's states are on the bus")
    checks.at_least(watched.rejected() - before, old, "and are counted")
    watched.unharmed("old log")


def main():
    harness.require("twinbus", *PROGRAMS, "emulated_robot")
    seed = int(os.environ.get("HOSTILE_SEED", random.randrange(1 << 30)))
    print(f"HOSTILE_SEED={seed}")
    rng = random.Random(seed)
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        stock = shutil.which("lcm-logger") and shutil.which("lcm-logplayer")
        log = record_a_run(folder, checks) if stock else None
        with Stack("stand", "--stack", "both", "--no-viewer") as stack:
            bus = Bus()
            time.sleep(2.0)
            watched = Watched(bus, stack, checks)
            no_bad_value_is_obeyed(bus, watched, checks)
            bus.forget()
            time.sleep(1.0)
            no_foreign_term_is_believed(bus, watched, checks, rng)
            no_stale_request_is_obeyed(bus, watched, checks)
            if log:
                bus.forget()
                time.sleep(1.0)
                an_old_log_moves_nothing(bus, watched, checks, log)
            else:
                print("lcm-logger or lcm-logplayer is missing: no old log was played")
            a_stop_outlives_any_clear_sent_with_it(bus, watched, checks, rng)
            bus.close()
    checks.exit()


if __name__ == "__main__":
    main()
