#!/usr/bin/env python3
"""A controller without any sense: holds the posture it finds, and drives the left arm where it was told to.

    hostile_arm.py into     into the body, slowly, and goes on asking
    hostile_arm.py swing    the elbow to and fro beside the body, for ever
"""
import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
import twinbus  # noqa: E402

ROLL, YAW, ELBOW = 20, 21, 22  # of the left arm, bus order
INTO = {ROLL: -0.26, YAW: -1.5, ELBOW: -1.8}
SPEED = 0.8  # [rad/s]


# Of hrp1s, as in examples/02: first joint, last joint, kp [N m/rad], kd [N m s/rad].
GAINS = [(0, 5, 15000.0, 300.0), (6, 9, 3000.0, 60.0), (10, 12, 600.0, 6.0), (13, 18, 15000.0, 300.0), (19, 22, 3000.0, 60.0),
         (23, 25, 600.0, 6.0), (26, 28, 15000.0, 300.0)]


def main():
    what = sys.argv[1]
    kp, kd = [0.0] * twinbus.JOINTS, [0.0] * twinbus.JOINTS
    for first, last, stiffness, damping in GAINS:
        kp[first:last + 1] = [stiffness] * (last + 1 - first)
        kd[first:last + 1] = [damping] * (last + 1 - first)
    bus = twinbus.Bus()
    bus.listen("STATE")
    me = twinbus.new_id()
    posture = torque = first = None
    print("hostile_arm.py: ready", flush=True)
    while True:
        state = twinbus.newest_state(bus.receive(0.1))
        if state is None:
            continue
        if posture is None:
            home, torque, first = list(state.q), state.tau, state.tick
            posture = list(home)
        t = (state.tick - first) * 1e-9 * state.period_ns - 1.0
        qd = [0.0] * twinbus.JOINTS
        if t > 0 and what == "into":
            for joint, end in INTO.items():
                way = min(SPEED * t, abs(end - home[joint]))
                posture[joint] = home[joint] + math.copysign(way, end - home[joint])
                qd[joint] = math.copysign(SPEED, end - home[joint]) if way < abs(end - home[joint]) else 0.0
        elif t > 0:
            posture[ELBOW] = home[ELBOW] - 0.3 * (1 - math.cos(3 * t))
            qd[ELBOW] = -0.9 * math.sin(3 * t)
        bus.send("COMMAND", twinbus.command_for(state, me, posture, qd=qd, tau=torque, kp=kp, kd=kd))


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
