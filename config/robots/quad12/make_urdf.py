#!/usr/bin/env python3
"""Writes quad12.urdf and quad12.srdf beside itself: four legs of three joints on point feet, 0.3 m high and 12.4 kg.

The class of the small electric quadrupeds that many laboratories have.  All numbers are our own.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from robot_writer import Robot, ball, box, deg, mirrored, rod  # noqa: E402

THIGH = SHANK = 0.21    # [m]
FOOT = 0.02             # radius of the ball [m]
BENT = 0.72             # height of the hips in half_sitting, of the legs' length
LEGS = (("FL", 1, 1), ("FR", 1, -1), ("HL", -1, 1), ("HR", -1, -1))
JOINTS = ("HIP_R", "HIP_P", "KNEE")

robot = Robot("quad12")


def leg(name, front, side):
    robot.link(f"{name}_HIP", 0.6, (0, 0.012 * side, 0), (0.08, 0.08, 0.08), [rod(0.042, 0.05, "x", (0, 0, 0), "joint")])
    robot.link(f"{name}_THIGH", 0.85, (0, -0.015 * side, -0.035), (0.06, 0.06, 0.20),
               [rod(0.042, 0.036, "y", (0, 0, 0), "joint"), box(0.034, 0.026, 0.15, (0, 0, -0.115))])
    robot.link(f"{name}_SHANK", 0.25, (0, 0, -0.085), (0.02, 0.02, 0.20),
               [ball(0.026, (0, 0, 0), "joint", "v"), rod(0.011, 0.16, "z", (0, 0, -0.11)), ball(FOOT, (0, 0, -SHANK), "sole")])
    at = (0.185 * front, 0.05 * side, 0)
    robot.joint(f"{name}_HIP_R", "TRUNK", f"{name}_HIP", at, "x", *mirrored(side, deg(-45), deg(45)), 24, 30)
    robot.joint(f"{name}_HIP_P", f"{name}_HIP", f"{name}_THIGH", (0, 0.08 * side, 0), "y", deg(-60), deg(160), 24, 30)
    robot.joint(f"{name}_KNEE", f"{name}_THIGH", f"{name}_SHANK", (0, 0, -THIGH), "y", deg(-155), deg(-50), 36, 20)


def main():
    robot.link("TRUNK", 5.6, (0, 0, 0), (0.36, 0.16, 0.11),
               [box(0.36, 0.10, 0.11, (0, 0, 0)), box(0.02, 0.08, 0.05, (0.185, 0, 0.01), "visor", "v"),
                box(0.20, 0.06, 0.01, (0, 0, 0.06), "accent", "v")])
    for name, front, side in LEGS:
        leg(name, front, side)
        robot.group(f"{name.lower()}_leg", [f"{name}_{joint}" for joint in JOINTS])
    robot.frame("IMU", "TRUNK", (0, 0, 0))
    bend = math.acos(BENT)
    for pose, q in (("lying", (0, 1.2, -2.6)), ("half_sitting", (0, bend, -2 * bend))):
        robot.pose(pose, [[(f"{name}_{joint}", round(v, 4)) for joint, v in zip(JOINTS, q)] for name, _, _ in LEGS])
    assert abs(robot.mass() - 12.4) < 1e-9, robot.mass()
    robot.write(pathlib.Path(__file__).resolve().parent)


main()
