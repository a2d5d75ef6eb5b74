"""What recorded postures say about contact: STATE and TRUTH of the same tick, through posture_probe."""

import math
import subprocess

from harness import BIN, type_of


class Postures:
    """Every `stride`-th tick since `since_ns` of which STATE and TRUTH were heard."""

    def __init__(self, bus, since_ns=0, until_ns=1 << 62, stride=5, scene=None):
        truths = {}
        truth_type, state_type = type_of("TRUTH"), type_of("STATE")
        states = {}
        for at, channel, body in bus.records:
            if not since_ns <= at <= until_ns:
                continue
            if channel == "TRUTH":
                truth = truth_type.decode(body)
                truths[truth.run_id, truth.tick] = truth
            elif channel == "STATE":
                state = state_type.decode(body)
                states[state.run_id, state.tick] = (at, state)
        keys = sorted(states.keys() & truths.keys(), key=lambda key: states[key][0])
        self.truths = [truths[key] for key in keys]
        keys = keys[::stride] + ([keys[-1]] if keys else [])
        self.rows = [(states[key][0], states[key][1], truths[key]) for key in keys]
        lines = []
        for _, state, truth in self.rows:
            numbers = [*truth.base_position, *truth.base_attitude, *state.q[:state.joint_count]]
            lines.append(" ".join(f"{number:.9g}" for number in numbers))
        command = [BIN / "posture_probe"] + (["--scene", str(scene)] if scene else [])
        done = subprocess.run(command, input="\n".join(lines) + "\n" if lines else "", capture_output=True, text=True,
                              timeout=120)
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        found = [[float(word) for word in line.split()] for line in done.stdout.splitlines()]
        self.self_distance = [row[0] for row in found]      # [m]
        self.obstacle_distance = [row[1] for row in found]  # [m]
        self.touching = sum(row[2] != 0 for row in found)
        self.left_hand = [row[3:6] for row in found]        # world [m]
        self.right_hand = [row[6:9] for row in found]

    @property
    def fell(self):
        return any(truth.fell for truth in self.truths)

    @property
    def zmp_margin(self):
        return min((truth.zmp_margin for truth in self.truths if truth.contact_count > 0), default=float("nan"))


def in_ground(truth, point):
    """A point of the world in the ground frame: midway between the soles, x forward, z up."""
    (a, b), headings = truth.foot_position[:2], []
    for w, x, y, z in truth.foot_attitude[:2]:
        headings.append(math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
    heading = math.atan2(sum(map(math.sin, headings)), sum(map(math.cos, headings)))
    d = [point[k] - 0.5 * (a[k] + b[k]) for k in range(3)]
    c, s = math.cos(heading), math.sin(heading)
    return [c * d[0] + s * d[1], -s * d[0] + c * d[1], d[2]]
