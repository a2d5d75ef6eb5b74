"""The same walk on two sources, each with a bus's whole stack to itself, and what was logged of it side by side.

The controller's binary, the operator's command and the recorder are the same; the source is the simulator once, and once the
hardware bridge with the stand-in robot (a program with a clock of its own, another engine, other masses, friction, backlash,
noise and delay).  Run under test/tools/private_bus.sh.
"""

import csv
import math
import os
import pathlib
import tempfile

import harness
from harness import Stack, cli

STACKS = {"simulator": "sim", "robot": "bridge"}
PERIOD = 0.002  # [s]
QUANTITIES = {  # name: unit
    "left": "N", "right": "N", "roll": "rad", "pitch": "rad", "zmp_y": "m", "hip": "rad", "knee": "rad", "ankle_torque": "N m"}


def tilt_of(w, x, y, z):
    """(roll, pitch) of a quaternion."""
    return (math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y)),
            math.asin(max(-1.0, min(1.0, 2.0 * (w * y - z * x)))))


class Walk:
    """What a source measured, and where the estimator saw the base, by ticks since the walk began."""

    def __init__(self, robot, log):
        self.joints = [joint.get("name") for joint in harness.bus_joints(robot)]
        states = self._table(log, "STATE", "tick,run_id,source,stop_kind,q,tau,attitude,wrench")
        status = self._table(log, "CONTROLLER_STATUS", "tick,mode,walk_sequence,zmp,base_position,base_attitude")
        self.lost = max(states) - min(states) + 1 - len(states)
        self.began = next((tick for tick in sorted(status) if int(status[tick]["walk_sequence"]) > 0), None)
        if self.began is None:
            raise RuntimeError(f"nobody walked in {log}")
        self.states = {tick - self.began: row for tick, row in states.items() if tick >= self.began}
        self.status = {tick - self.began: row for tick, row in status.items() if tick >= self.began}

    @staticmethod
    def _table(log, channel, fields):
        file = pathlib.Path(log).with_name(f"{channel}.csv")
        status, _, error = cli("log", "csv", log, channel, file, "--fields", fields, "--numbers")
        if status != 0:
            raise RuntimeError(error)
        with open(file, newline="", encoding="utf-8") as source:
            return {int(row["tick"]): row for row in csv.DictReader(source)}

    def posture(self, tick):
        """Joints by name, and where the estimator sees the base."""
        state, status = self.states[tick], self.status[tick]
        base = {f"base_{axis}": float(status[f"base_position[{k}]"]) for k, axis in enumerate("xyz")}
        turn = {f"turn_{axis}": float(status[f"base_attitude[{k}]"]) for k, axis in enumerate("wxyz")}
        return {name: float(state[f"q[{k}]"]) for k, name in enumerate(self.joints)}, base | turn

    def figures(self, tick):
        """QUANTITIES at a tick."""
        state, status = self.states[tick], self.status[tick]
        roll, pitch = tilt_of(*(float(state[f"attitude[{k}]"]) for k in range(4)))
        hip, knee, ankle = (self.joints.index(f"LLEG_{name}") for name in ("HIP_P", "KNEE", "ANKLE_P"))
        return {"left": float(state["wrench[0][2]"]), "right": float(state["wrench[1][2]"]), "roll": roll, "pitch": pitch,
                "zmp_y": float(status["zmp[1]"]), "hip": float(state[f"q[{hip}]"]), "knee": float(state[f"q[{knee}]"]),
                "ankle_torque": float(state[f"tau[{ankle}]"])}

    def lifts(self, ticks, weight):
        """How often the left foot gave its load away; a touch on the way is no step."""
        heavy = [float(self.states[tick]["wrench[0][2]"]) > 0.5 * weight for tick in ticks if tick in self.states]
        return sum(a and not b for a, b in zip(heavy, heavy[1:]))


def walk_on_both(robot, speed, seconds):
    """{source: Walk} of a walk straight on [m/s, s]; the launcher's lines are printed when one does not come about."""
    walks = {}
    with tempfile.TemporaryDirectory() as folder:
        os.environ |= {"TWINBUS_RUNS": folder, "TWINBUS_RECORD": "1"}
        for source, stack in STACKS.items():
            with Stack("stand", "--robot", robot, "--stack", stack, "--no-viewer") as up:
                status, out, error = cli("walk", speed, "0", "0", "--for", seconds, timeout=seconds + 20.0)
            if status != 0:
                print("".join(up.lines))
                raise RuntimeError(f"{source}: {out}{error}")
            walks[source] = Walk(robot, harness.newest_run_folder() / "run.log")
    return walks


def side_by_side(walks, begin, end):
    """One row per tick that every source has, from begin to end [s] of the walk: NAME_SOURCE for each of QUANTITIES."""
    for tick in range(round(begin / PERIOD), round(end / PERIOD)):
        if all(tick in walk.states and tick in walk.status for walk in walks.values()):
            row = {"time": round(tick * PERIOD, 3)}
            for source, walk in walks.items():
                row |= {f"{name}_{source}": value for name, value in walk.figures(tick).items()}
            yield row


def rms_difference(rows, name):
    one, other = (f"{name}_{source}" for source in STACKS)
    return math.sqrt(sum((float(row[one]) - float(row[other])) ** 2 for row in rows) / len(rows))
