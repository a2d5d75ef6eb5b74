#!/usr/bin/env python3
"""Writes biped12.urdf and biped12.srdf beside itself: two legs of six joints that carry a box of ballast, 1.3 m and 58 kg.

The class of the leg module that walks by game pad in the OpenHRP paper.  All numbers are our own.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from robot_writer import Robot, ball, box, mirrored, rod  # noqa: E402

LEG = ["HIP_Y", "HIP_R", "HIP_P", "KNEE", "ANKLE_P", "ANKLE_R"]
robot = Robot("biped12")


def leg(prefix, side):
    def n(part):
        return f"{prefix}LEG_{part}"
    robot.link(n("HIP_Y"), 0.8, (0, 0, 0), (0.09, 0.08, 0.08), [rod(0.042, 0.07, "z", (0, 0, 0.02), "joint", "v")])
    robot.link(n("HIP_R"), 1.2, (0, 0, 0), (0.10, 0.09, 0.09), [rod(0.042, 0.100, "x", (0, 0, 0), "joint")])
    robot.link(n("HIP_P"), 3.4, (0, 0, -0.13), (0.11, 0.11, 0.24),
               [rod(0.054, 0.185, "z", (0, 0, -0.155)), ball(0.052, (0, 0, 0), "accent", "v")])
    robot.link(n("KNEE"), 2.4, (0, 0, -0.12), (0.09, 0.09, 0.24),
               [rod(0.048, 0.10, "y", (0, 0, 0), "accent"), rod(0.042, 0.19, "z", (0, 0, -0.145))])
    robot.link(n("ANKLE_P"), 0.5, (0, 0, 0), (0.07, 0.07, 0.07), [ball(0.036, (0, 0, 0), "joint", "v")])
    robot.link(n("ANKLE_R"), 1.2, (0.02, 0, -0.075), (0.24, 0.138, 0.03),
               [box(0.24, 0.138, 0.02, (0.02, 0, -0.095), "sole"), box(0.13, 0.09, 0.035, (0.01, 0, -0.068), "shell", "v")])
    chain = [("HIP_Y", "WAIST", (0, 0.085 * side, 0), "z", mirrored(side, -0.52, 0.78), 120, 6),
             ("HIP_R", n("HIP_Y"), (0, 0, 0), "x", mirrored(side, -0.35, 0.61), 150, 6),
             ("HIP_P", n("HIP_R"), (0, 0, 0), "y", (-2.18, 0.73), 200, 8),
             ("KNEE", n("HIP_P"), (0, 0, -0.30), "y", (-0.03, 2.62), 200, 9),
             ("ANKLE_P", n("KNEE"), (0, 0, -0.30), "y", (-1.31, 0.73), 200, 8),
             ("ANKLE_R", n("ANKLE_P"), (0, 0, 0), "x", (-0.61, 0.61), 120, 8)]
    for part, parent, at, axis, (lower, upper), effort, velocity in chain:
        robot.joint(n(part), parent, n(part), at, axis, lower, upper, effort, velocity)
    robot.frame(f"{prefix}FOOT_SOLE", n("ANKLE_R"), (0, 0, -0.105))
    robot.frame(f"{prefix}FOOT_SENSOR", n("ANKLE_R"), (0, 0, -0.105))


def main():
    robot.link("WAIST", 39.0, (0, 0, 0.28), (0.20, 0.30, 0.45),
               [box(0.18, 0.26, 0.10, (0, 0, 0.11), "joint"), box(0.20, 0.30, 0.42, (0, 0, 0.37)),
                box(0.02, 0.18, 0.08, (0.105, 0, 0.42), "accent", "v")])
    leg("R", -1)
    leg("L", 1)
    robot.frame("IMU", "WAIST", (0, 0, 0.10))
    for side, prefix in (("right", "R"), ("left", "L")):
        robot.group(f"{side}_leg", [f"{prefix}LEG_{j}" for j in LEG])
        robot.end_effector(f"{side}_foot", f"{prefix}LEG_ANKLE_R", f"{side}_leg")
    for name, q in (("zero", [0] * 6), ("initial", [0, 0, -0.30, 0.60, -0.30, 0]),
                    ("half_sitting", [0, 0, -0.4650, 0.8727, -0.4077, 0])):
        robot.pose(name, [list(zip([f"{prefix}LEG_{j}" for j in LEG], q)) for prefix in ("R", "L")])
    assert abs(robot.mass() - 58.0) < 1e-9, robot.mass()
    assert len(robot.joints) == 12
    robot.write(pathlib.Path(__file__).resolve().parent)


main()
