#!/usr/bin/env python3
"""Writes hrp1s.urdf and hrp1s.srdf beside itself: a humanoid of 29 joints, 1.6 m and 130.8 kg made of primitives.

The class of robot of the OpenHRP paper.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from robot_writer import Robot, ball, box, deg, mirrored, rod  # noqa: E402

MASS = 130.8  # [kg], checked below
robot = Robot("hrp1s", with_shells=True)


def leg(prefix, side):
    def name(part):
        return f"{prefix}LEG_{part}"
    for parts in [
        (name("HIP_R"), 2.5, (0, 0, 0), (0.12, 0.10, 0.10), [rod(0.050, 0.120, "x", (0, 0, 0), "joint")]),
        (name("HIP_P"), 2.0, (0, 0, -0.02), (0.11, 0.11, 0.11), [ball(0.058, (0, 0, 0), "accent", "v")]),
        (name("HIP_Y"), 5.1, (0, 0, -0.1735), (0.13, 0.13, 0.26),
             [rod(0.064, 0.215, "z", (0, 0, -0.1875)), rod(0.050, 0.06, "z", (0, 0, -0.06), "joint", "v"),
              ball(0.064, (0, 0, -0.295), "shell")]),
        (name("KNEE"), 7.0, (0, 0, -0.12), (0.11, 0.11, 0.27),
             [rod(0.056, 0.115, "y", (0, 0, 0), "accent"), rod(0.050, 0.185, "z", (0, 0, -0.1425)),
              rod(0.036, 0.05, "z", (0, 0, -0.255), "joint", "v")]),
        (name("ANKLE_P"), 2.5, (0, 0, 0), (0.09, 0.09, 0.09), [ball(0.043, (0, 0, 0), "joint", "v")]),
        (name("ANKLE_R"), 1.9, (0.045, 0, -0.055), (0.25, 0.14, 0.03),
             [box(0.25, 0.14, 0.02, (0.055, 0, -0.06), "sole"), box(0.15, 0.10, 0.022, (0.035, 0, -0.041), "shell", "v"),
              rod(0.05, 0.022, "z", (0.11, 0, -0.041), "shell", "v")]),
    ]:
        robot.link(*parts)
    chain = [
        ("HIP_R", "WAIST", (0, 0.09 * side, 0), "x", mirrored(side, -0.60, 0.80), 400, 8),
        ("HIP_P", name("HIP_R"), (0, 0, 0), "y", (-2.10, 0.90), 400, 8),
        ("HIP_Y", name("HIP_P"), (0, 0, 0), "z", mirrored(side, -0.80, 0.80), 400, 8),
        ("KNEE", name("HIP_Y"), (0, 0, -0.3535), "y", (-0.02, 2.60), 400, 10),
        ("ANKLE_P", name("KNEE"), (0, 0, -0.300), "y", (-1.25, 0.75), 400, 8),
        ("ANKLE_R", name("ANKLE_P"), (0, 0, 0), "x", (-0.60, 0.60), 400, 8),
    ]
    for part, parent, at, axis, (lower, upper), effort, velocity in chain:
        robot.joint(name(part), parent, name(part), at, axis, lower, upper, effort, velocity)
    robot.frame(f"{prefix}FOOT_SOLE", name("ANKLE_R"), (0, 0, -0.07))
    robot.frame(f"{prefix}FOOT_SENSOR", name("ANKLE_R"), (0, 0, -0.07))


def arm(prefix, side):
    def name(part):
        return f"{prefix}ARM_{part}"
    for parts in [
        (name("SHOULDER_P"), 0.4, (0, -0.035 * side, 0), (0.09, 0.07, 0.09),
             [rod(0.045, 0.060, "y", (0, -0.038 * side, 0), "joint")]),
        (name("SHOULDER_R"), 2.2, (0, 0, -0.11), (0.09, 0.09, 0.24),
             [ball(0.050, (0, 0, 0), "accent"), rod(0.042, 0.150, "z", (0, 0, -0.110))]),
        (name("SHOULDER_Y"), 0.4, (0, 0, 0), (0.08, 0.08, 0.08), [ball(0.041, (0, 0, 0), "accent")]),
        (name("ELBOW"), 2.2, (0, 0, -0.12), (0.075, 0.075, 0.19),
             [rod(0.036, 0.125, "z", (0, 0, -0.1375)), rod(0.028, 0.05, "z", (0, 0, -0.06), "joint", "v")]),
        (name("WRIST_Y"), 0.4, (0, 0, 0.02), (0.06, 0.06, 0.06), [rod(0.028, 0.05, "z", (0, 0, 0.025), "joint", "v")]),
        (name("WRIST_P"), 0.4, (0, 0, 0), (0.06, 0.06, 0.06), [ball(0.031, (0, 0, 0), "accent", "v")]),
        (name("WRIST_R"), 0.4, (0, 0, -0.07), (0.04, 0.08, 0.11),
             [box(0.036, 0.080, 0.075, (0, 0, -0.0625), "hand"), rod(0.018, 0.080, "y", (0, 0, -0.100), "hand"),
              ball(0.016, (0.026, -0.028 * side, -0.075), "hand", "v")]),
    ]:
        robot.link(*parts)
    chain = [
        ("SHOULDER_P", "CHEST", (0, 0.21 * side, 0), "y", (deg(-180), deg(90)), 120, 6),
        ("SHOULDER_R", name("SHOULDER_P"), (0, 0, 0), "x", mirrored(side, deg(-15), deg(120)), 120, 6),
        ("SHOULDER_Y", name("SHOULDER_R"), (0, 0, -0.263), "z", mirrored(side, deg(-90), deg(90)), 80, 6),
        ("ELBOW", name("SHOULDER_Y"), (0, 0, 0), "y", (deg(-150), deg(10)), 80, 6),
        ("WRIST_Y", name("ELBOW"), (0, 0, -0.247), "z", mirrored(side, deg(-120), deg(120)), 25, 6),
        ("WRIST_P", name("WRIST_Y"), (0, 0, 0), "y", (deg(-75), deg(75)), 25, 6),
        ("WRIST_R", name("WRIST_P"), (0, 0, 0), "x", mirrored(side, deg(-60), deg(60)), 25, 6),
    ]
    for part, parent, at, axis, (lower, upper), effort, velocity in chain:
        robot.joint(name(part), parent, name(part), at, axis, lower, upper, effort, velocity)
    robot.frame(f"{prefix}HAND", name("WRIST_R"), (0, 0, -0.09))
    robot.frame(f"{prefix}HAND_SENSOR", name("WRIST_R"), (0, 0, 0))


def body():
    robot.link("WAIST", 27.0, (0.02, 0, 0.085), (0.18, 0.28, 0.14),
                      [box(0.14, 0.26, 0.085, (0, 0, 0.1075)), box(0.02, 0.20, 0.05, (0.072, 0, 0.11), "accent", "v"),
                       ball(0.03, (0, 0.09, 0.055), "joint", "v"), ball(0.03, (0, -0.09, 0.055), "joint", "v")])
    leg("R", -1)
    arm("R", -1)
    leg("L", 1)
    arm("L", 1)
    robot.link("WAIST_P", 6.0, (0, 0, 0), (0.12, 0.18, 0.12), [rod(0.052, 0.17, "y", (0, 0, 0), "joint")])
    robot.link("WAIST_R", 30.0, (0.05, 0, 0.18), (0.24, 0.28, 0.26),
                      [box(0.20, 0.26, 0.20, (0, 0, 0.18)), rod(0.06, 0.05, "z", (0, 0, 0.055), "joint", "v"),
                       box(0.02, 0.18, 0.12, (0.105, 0, 0.20), "accent", "v"),
                       box(0.09, 0.24, 0.18, (-0.14, 0, 0.19), "joint")])
    robot.link("CHEST", 13.0, (0, 0, 0.08), (0.18, 0.28, 0.28),
                      [box(0.18, 0.26, 0.15, (0, 0, 0.02)), rod(0.07, 0.05, "z", (0, 0, -0.075), "joint", "v"),
                       box(0.02, 0.16, 0.07, (0.092, 0, 0.03), "accent", "v"),
                       rod(0.045, 0.06, "z", (0, 0, 0.12), "joint"), ball(0.095, (0.01, 0, 0.235), "shell"),
                       rod(0.082, 0.05, "z", (0.030, 0, 0.245), "visor", "v")])
    robot.joint("WAIST_P", "WAIST", "WAIST_P", (0, 0, 0.176), "y", -0.50, 1.00, 300, 4)
    robot.joint("WAIST_R", "WAIST_P", "WAIST_R", (0, 0, 0), "x", -0.45, 0.45, 300, 4)
    robot.joint("CHEST", "WAIST_R", "CHEST", (0, 0, 0.35), "z", -0.80, 0.80, 200, 4)
    robot.frame("IMU", "WAIST", (0, 0, 0.10))
    robot.frame("LEFT_CAMERA", "CHEST", (0.105, 0.03, 0.245))
    robot.frame("RIGHT_CAMERA", "CHEST", (0.105, -0.03, 0.245))


LEG = ["HIP_R", "HIP_P", "HIP_Y", "KNEE", "ANKLE_P", "ANKLE_R"]
ARM = ["SHOULDER_P", "SHOULDER_R", "SHOULDER_Y", "ELBOW", "WRIST_Y", "WRIST_P", "WRIST_R"]
TORSO = ["WAIST_P", "WAIST_R", "CHEST"]
ARM_RIGHT = [0.3113, -0.1595, -0.1154, -0.6363, 0, 0, 0]
ARM_LEFT = [0.3113, 0.1595, 0.1154, -0.6363, 0, 0, 0]
POSES = {  # [rad]
    "zero": ([0] * 6, [0] * 7, [0] * 7),
    "initial": ([0, -0.3786, 0, 0.8320, -0.4526, 0], ARM_RIGHT, ARM_LEFT),
    "half_sitting": ([0, -0.5710, 0, 1.2644, -0.6925, 0], ARM_RIGHT, ARM_LEFT),
    "brace": ([0, -0.9, 0, 1.9, -1.0, 0], [-0.5, -0.25, -0.1154, -1.5, 0, 0, 0], [-0.5, 0.25, 0.1154, -1.5, 0, 0, 0]),
}


def pose(name, leg_q, right, left):
    robot.pose(name, [list(zip(names, values)) for names, values in (
        ([f"RLEG_{j}" for j in LEG], leg_q), ([f"RARM_{j}" for j in ARM], right),
        ([f"LLEG_{j}" for j in LEG], leg_q), ([f"LARM_{j}" for j in ARM], left), (TORSO, [0, 0, 0]))])


def main():
    body()
    for group, names in (("right_leg", [f"RLEG_{j}" for j in LEG]), ("left_leg", [f"LLEG_{j}" for j in LEG]),
                         ("right_arm", [f"RARM_{j}" for j in ARM]), ("left_arm", [f"LARM_{j}" for j in ARM]),
                         ("torso", TORSO)):
        robot.group(group, names)
    for side, prefix in (("left", "L"), ("right", "R")):
        robot.end_effector(f"{side}_hand", f"{prefix}ARM_WRIST_R", f"{side}_arm")
        robot.end_effector(f"{side}_foot", f"{prefix}LEG_ANKLE_R", f"{side}_leg")
    for name, angles in POSES.items():
        pose(name, *angles)
    assert abs(robot.mass() - MASS) < 1e-9, robot.mass()
    assert len(robot.joints) == 29
    robot.write(pathlib.Path(__file__).resolve().parent)


main()
