#!/usr/bin/env python3
"""Writes hrp2p.urdf and hrp2p.srdf beside itself: a humanoid of 30 joints, 1.54 m and 58 kg made of primitives.

The class of the second robot of the OpenHRP paper: legs 2 x 6, arms 2 x 6, hands 2 x 1, waist 2, neck 2; thigh and shank
of 0.30 m.  Widths, masses of single links and limits are our own.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from robot_writer import Robot, ball, box, deg, mirrored, rod  # noqa: E402
from short_leg import LEG, leg  # noqa: E402

ARM = ["SHOULDER_P", "SHOULDER_R", "SHOULDER_Y", "ELBOW", "WRIST_Y", "WRIST_P", "HAND"]
robot = Robot("hrp2p")


def arm(prefix, side):
    def n(part):
        return f"{prefix}ARM_{part}"
    robot.link(n("SHOULDER_P"), 0.7, (0, -0.02 * side, 0), (0.08, 0.06, 0.08),
               [rod(0.040, 0.05, "y", (0, -0.028 * side, 0), "joint")])
    robot.link(n("SHOULDER_R"), 0.7, (0, 0, 0), (0.07, 0.07, 0.07), [ball(0.043, (0, 0, 0), "accent")])
    robot.link(n("SHOULDER_Y"), 1.4, (0, 0, -0.14), (0.075, 0.075, 0.19), [rod(0.037, 0.14, "z", (0, 0, -0.125))])
    robot.link(n("ELBOW"), 0.9, (0, 0, -0.09), (0.065, 0.065, 0.16),
               [ball(0.036, (0, 0, 0), "accent"), rod(0.031, 0.11, "z", (0, 0, -0.105))])
    robot.link(n("WRIST_Y"), 0.3, (0, 0, 0.01), (0.05, 0.05, 0.06), [rod(0.026, 0.04, "z", (0, 0, 0.02), "joint", "v")])
    robot.link(n("WRIST_P"), 0.5, (0, 0, -0.05), (0.04, 0.07, 0.09), [box(0.036, 0.072, 0.07, (0, 0, -0.055), "hand")])
    robot.link(n("HAND"), 0.2, (0, 0, -0.035), (0.02, 0.06, 0.06), [box(0.016, 0.060, 0.055, (0, 0, -0.036), "hand", "v")])
    chain = [("SHOULDER_P", "CHEST", (0, 0.20 * side, 0.27), "y", (deg(-180), deg(60)), 50, 6),
             ("SHOULDER_R", n("SHOULDER_P"), (0, 0.05 * side, 0), "x", mirrored(side, deg(-10), deg(95)), 50, 6),
             ("SHOULDER_Y", n("SHOULDER_R"), (0, 0, 0), "z", (deg(-91), deg(91)), 30, 6),
             ("ELBOW", n("SHOULDER_Y"), (0, 0, -0.25), "y", (deg(-137), deg(1)), 30, 6),
             ("WRIST_Y", n("ELBOW"), (0, 0, -0.21), "z", (deg(-91), deg(91)), 12, 6),
             ("WRIST_P", n("WRIST_Y"), (0, 0, 0), "y", (deg(-91), deg(91)), 12, 6),
             ("HAND", n("WRIST_P"), (0.018, 0, -0.07), "y", (deg(-16), deg(60)), 6, 6)]
    for part, parent, at, axis, (lower, upper), effort, velocity in chain:
        robot.joint(n(part), parent, n(part), at, axis, lower, upper, effort, velocity)
    robot.frame(f"{prefix}HAND", n("WRIST_P"), (0, 0, -0.09))
    robot.frame(f"{prefix}HAND_SENSOR", n("WRIST_P"), (0, 0, 0))


def body():
    robot.link("WAIST", 7.6, (0, 0, 0.06), (0.16, 0.22, 0.14), [box(0.15, 0.20, 0.10, (0, 0, 0.11))])
    leg(robot, "R", -1, width=0.08, thigh=(3.6, 0.01), shank=2.6, foot=1.3)
    arm("R", -1)
    leg(robot, "L", 1, width=0.08, thigh=(3.6, 0.01), shank=2.6, foot=1.3)
    arm("L", 1)
    robot.link("CHEST_Y", 1.0, (0, 0, 0), (0.10, 0.10, 0.08), [rod(0.05, 0.05, "z", (0, 0, 0), "joint")])
    robot.link("CHEST", 17.5, (0.01, 0, 0.17), (0.20, 0.28, 0.34),
               [box(0.19, 0.28, 0.29, (0, 0, 0.19)), box(0.09, 0.26, 0.30, (-0.13, 0, 0.19), "joint"),
                box(0.02, 0.18, 0.10, (0.10, 0, 0.23), "accent", "v")])
    robot.link("NECK_Y", 0.5, (0, 0, 0), (0.06, 0.06, 0.06), [rod(0.035, 0.05, "z", (0, 0, 0), "joint", "v")])
    robot.link("HEAD", 2.0, (0.01, 0, 0.09), (0.15, 0.15, 0.18),
               [ball(0.092, (0.01, 0, 0.095)), rod(0.078, 0.05, "z", (0.032, 0, 0.10), "visor", "v")])
    robot.joint("CHEST_Y", "WAIST", "CHEST_Y", (0, 0, 0.215), "z", deg(-45), deg(45), 120, 4)
    robot.joint("CHEST_P", "CHEST_Y", "CHEST", (0, 0, 0.03), "y", deg(-5), deg(60), 150, 4)
    robot.joint("NECK_Y", "CHEST", "NECK_Y", (0, 0, 0.377), "z", deg(-45), deg(45), 10, 5)
    robot.joint("NECK_P", "NECK_Y", "HEAD", (0, 0, 0.023), "y", deg(-30), deg(45), 10, 5)
    robot.frame("IMU", "CHEST", (-0.08, 0, 0.12))
    robot.frame("LEFT_CAMERA", "HEAD", (0.10, 0.035, 0.10))
    robot.frame("RIGHT_CAMERA", "HEAD", (0.10, -0.035, 0.10))


def pose(name, hip, knee, ankle):
    rows = []
    for prefix, side in (("R", -1), ("L", 1)):
        rows.append(list(zip([f"{prefix}LEG_{j}" for j in LEG], [0, 0, hip, knee, ankle, 0])))
        arm_q = [0.2618, 0.1745 * side, 0, -0.5236, 0, 0, 0] if name != "zero" else [0] * 7
        rows.append(list(zip([f"{prefix}ARM_{j}" for j in ARM], arm_q)))
    rows.append([(j, 0) for j in ("CHEST_Y", "CHEST_P", "NECK_Y", "NECK_P")])
    robot.pose(name, rows)


def main():
    body()
    for group, names in (("right_leg", [f"RLEG_{j}" for j in LEG]), ("left_leg", [f"LLEG_{j}" for j in LEG]),
                         ("right_arm", [f"RARM_{j}" for j in ARM]), ("left_arm", [f"LARM_{j}" for j in ARM]),
                         ("torso", ["CHEST_Y", "CHEST_P", "NECK_Y", "NECK_P"])):
        robot.group(group, names)
    for side, prefix in (("left", "L"), ("right", "R")):
        robot.end_effector(f"{side}_hand", f"{prefix}ARM_WRIST_P", f"{side}_arm")
        robot.end_effector(f"{side}_foot", f"{prefix}LEG_ANKLE_R", f"{side}_leg")
    pose("zero", 0, 0, 0)
    pose("initial", -0.30, 0.60, -0.30)
    pose("half_sitting", -0.4720, 0.8727, -0.4007)
    assert abs(robot.mass() - 58.0) < 1e-9, robot.mass()
    assert len(robot.joints) == 30
    robot.write(pathlib.Path(__file__).resolve().parent)


main()
