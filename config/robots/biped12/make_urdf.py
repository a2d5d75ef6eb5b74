#!/usr/bin/env python3
"""Writes biped12.urdf and biped12.srdf beside itself: two legs of six joints that carry a box of ballast, 1.3 m and 58 kg.

The class of the leg module that walks by game pad in the OpenHRP paper.  All numbers are our own.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from robot_writer import Robot, box  # noqa: E402
from short_leg import LEG, leg  # noqa: E402

robot = Robot("biped12")


def main():
    robot.link("WAIST", 39.0, (0, 0, 0.28), (0.20, 0.30, 0.45),
               [box(0.18, 0.26, 0.10, (0, 0, 0.11), "joint"), box(0.20, 0.30, 0.42, (0, 0, 0.37)),
                box(0.02, 0.18, 0.08, (0.105, 0, 0.42), "accent", "v")])
    leg(robot, "R", -1, width=0.085, thigh=(3.4, 0), shank=2.4, foot=1.2)
    leg(robot, "L", 1, width=0.085, thigh=(3.4, 0), shank=2.4, foot=1.2)
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
