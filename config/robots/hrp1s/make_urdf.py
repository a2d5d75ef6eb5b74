#!/usr/bin/env python3
"""Writes hrp1s.urdf and hrp1s.srdf beside itself: a humanoid of 29 joints, 1.6 m and 130.8 kg made of primitives.

The class of robot of the OpenHRP paper.  Joints stand in the file in the order of the bus.  Everything that moves has a
body whose inertia is that of the box or cylinder its mass is spread over, so it is an inertia that exists.
"""
import math
import pathlib
from xml.sax.saxutils import quoteattr

MASS = 130.8  # [kg], checked below

COLORS = {"shell": "0.90 0.91 0.93 1", "joint": "0.22 0.24 0.28 1", "accent": "0.10 0.36 0.66 1",
          "sole": "0.10 0.10 0.11 1", "visor": "0.05 0.07 0.10 1", "hand": "0.45 0.48 0.52 1"}


# Shapes: (kind, size, centre, color, "vc"), v seen, c checked for collision.  A cylinder's size is radius, length, axis.
def box(x, y, z, at, color="shell", use="vc"):
    return ("box", (x, y, z), at, color, use)


def ball(radius, at, color="joint", use="vc"):
    return ("sphere", (radius,), at, color, use)


def rod(radius, length, axis, at, color="shell", use="vc"):
    return ("cylinder", (radius, length, axis), at, color, use)


def box_inertia(mass, x, y, z):
    return [mass / 12 * (y * y + z * z), mass / 12 * (x * x + z * z), mass / 12 * (x * x + y * y)]


class Link:
    """mass [kg], com [m], extent: the box [m] its mass is spread over."""

    def __init__(self, name, mass, com, extent, shapes):
        self.name, self.mass, self.com, self.extent, self.shapes = name, mass, com, extent, shapes


class Joint:
    def __init__(self, name, parent, child, at, axis, lower, upper, effort, velocity):
        self.name, self.parent, self.child, self.at, self.axis = name, parent, child, at, axis
        self.lower, self.upper, self.effort, self.velocity = lower, upper, effort, velocity


links, joints, frames = [], [], []  # frames: (name, parent, at), fixed and massless


def deg(angle):
    return math.radians(angle)


def mirrored(side, lower, upper):
    return (lower, upper) if side > 0 else (-upper, -lower)


def leg(prefix, side):
    def name(part):
        return f"{prefix}LEG_{part}"
    links.extend([
        Link(name("HIP_R"), 2.5, (0, 0, 0), (0.12, 0.10, 0.10), [rod(0.050, 0.120, "x", (0, 0, 0), "joint")]),
        Link(name("HIP_P"), 2.0, (0, 0, -0.02), (0.11, 0.11, 0.11), [ball(0.058, (0, 0, 0), "accent", "v")]),
        Link(name("HIP_Y"), 5.1, (0, 0, -0.1735), (0.13, 0.13, 0.26),
             [rod(0.064, 0.215, "z", (0, 0, -0.1875)), rod(0.050, 0.06, "z", (0, 0, -0.06), "joint", "v"),
              ball(0.064, (0, 0, -0.295), "shell")]),
        Link(name("KNEE"), 7.0, (0, 0, -0.12), (0.11, 0.11, 0.27),
             [rod(0.056, 0.115, "y", (0, 0, 0), "accent"), rod(0.050, 0.185, "z", (0, 0, -0.1425)),
              rod(0.036, 0.05, "z", (0, 0, -0.255), "joint", "v")]),
        Link(name("ANKLE_P"), 2.5, (0, 0, 0), (0.09, 0.09, 0.09), [ball(0.043, (0, 0, 0), "joint", "v")]),
        Link(name("ANKLE_R"), 1.9, (0.045, 0, -0.055), (0.25, 0.14, 0.03),
             [box(0.25, 0.14, 0.02, (0.055, 0, -0.06), "sole"), box(0.15, 0.10, 0.022, (0.035, 0, -0.041), "shell", "v"),
              rod(0.05, 0.022, "z", (0.11, 0, -0.041), "shell", "v")]),
    ])
    chain = [
        ("HIP_R", "WAIST", (0, 0.09 * side, 0), "x", mirrored(side, -0.60, 0.80), 400, 8),
        ("HIP_P", name("HIP_R"), (0, 0, 0), "y", (-2.10, 0.90), 400, 8),
        ("HIP_Y", name("HIP_P"), (0, 0, 0), "z", mirrored(side, -0.80, 0.80), 400, 8),
        ("KNEE", name("HIP_Y"), (0, 0, -0.3535), "y", (-0.02, 2.60), 400, 10),
        ("ANKLE_P", name("KNEE"), (0, 0, -0.300), "y", (-1.25, 0.75), 400, 8),
        ("ANKLE_R", name("ANKLE_P"), (0, 0, 0), "x", (-0.60, 0.60), 400, 8),
    ]
    for part, parent, at, axis, (lower, upper), effort, velocity in chain:
        joints.append(Joint(name(part), parent, name(part), at, axis, lower, upper, effort, velocity))
    frames.append((f"{prefix}FOOT_SOLE", name("ANKLE_R"), (0, 0, -0.07)))
    frames.append((f"{prefix}FOOT_SENSOR", name("ANKLE_R"), (0, 0, -0.07)))


def arm(prefix, side):
    def name(part):
        return f"{prefix}ARM_{part}"
    links.extend([
        Link(name("SHOULDER_P"), 0.4, (0, -0.035 * side, 0), (0.09, 0.07, 0.09),
             [rod(0.045, 0.060, "y", (0, -0.038 * side, 0), "joint")]),
        Link(name("SHOULDER_R"), 2.2, (0, 0, -0.11), (0.09, 0.09, 0.24),
             [ball(0.050, (0, 0, 0), "accent"), rod(0.042, 0.150, "z", (0, 0, -0.110))]),
        Link(name("SHOULDER_Y"), 0.4, (0, 0, 0), (0.08, 0.08, 0.08), [ball(0.041, (0, 0, 0), "accent")]),
        Link(name("ELBOW"), 2.2, (0, 0, -0.12), (0.075, 0.075, 0.19),
             [rod(0.036, 0.125, "z", (0, 0, -0.1375)), rod(0.028, 0.05, "z", (0, 0, -0.06), "joint", "v")]),
        Link(name("WRIST_Y"), 0.4, (0, 0, 0.02), (0.06, 0.06, 0.06), [rod(0.028, 0.05, "z", (0, 0, 0.025), "joint", "v")]),
        Link(name("WRIST_P"), 0.4, (0, 0, 0), (0.06, 0.06, 0.06), [ball(0.031, (0, 0, 0), "accent", "v")]),
        Link(name("WRIST_R"), 0.4, (0, 0, -0.07), (0.04, 0.08, 0.11),
             [box(0.036, 0.080, 0.075, (0, 0, -0.0625), "hand"), rod(0.018, 0.080, "y", (0, 0, -0.100), "hand"),
              ball(0.016, (0.026, -0.028 * side, -0.075), "hand", "v")]),
    ])
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
        joints.append(Joint(name(part), parent, name(part), at, axis, lower, upper, effort, velocity))
    frames.append((f"{prefix}HAND", name("WRIST_R"), (0, 0, -0.09)))
    frames.append((f"{prefix}HAND_SENSOR", name("WRIST_R"), (0, 0, 0)))


def body():
    links.append(Link("WAIST", 27.0, (0.02, 0, 0.085), (0.18, 0.28, 0.14),
                      [box(0.14, 0.26, 0.085, (0, 0, 0.1075)), box(0.02, 0.20, 0.05, (0.072, 0, 0.11), "accent", "v"),
                       ball(0.03, (0, 0.09, 0.055), "joint", "v"), ball(0.03, (0, -0.09, 0.055), "joint", "v")]))
    leg("R", -1)
    arm("R", -1)
    leg("L", 1)
    arm("L", 1)
    links.append(Link("WAIST_P", 6.0, (0, 0, 0), (0.12, 0.18, 0.12), [rod(0.052, 0.17, "y", (0, 0, 0), "joint")]))
    links.append(Link("WAIST_R", 30.0, (0.05, 0, 0.18), (0.24, 0.28, 0.26),
                      [box(0.20, 0.26, 0.20, (0, 0, 0.18)), rod(0.06, 0.05, "z", (0, 0, 0.055), "joint", "v"),
                       box(0.02, 0.18, 0.12, (0.105, 0, 0.20), "accent", "v"),
                       box(0.09, 0.24, 0.18, (-0.14, 0, 0.19), "joint")]))
    links.append(Link("CHEST", 13.0, (0, 0, 0.08), (0.18, 0.28, 0.28),
                      [box(0.18, 0.26, 0.15, (0, 0, 0.02)), rod(0.07, 0.05, "z", (0, 0, -0.075), "joint", "v"),
                       box(0.02, 0.16, 0.07, (0.092, 0, 0.03), "accent", "v"),
                       rod(0.045, 0.06, "z", (0, 0, 0.12), "joint"), ball(0.095, (0.01, 0, 0.235), "shell"),
                       rod(0.082, 0.05, "z", (0.030, 0, 0.245), "visor", "v")]))
    joints.append(Joint("WAIST_P", "WAIST", "WAIST_P", (0, 0, 0.176), "y", -0.50, 1.00, 300, 4))
    joints.append(Joint("WAIST_R", "WAIST_P", "WAIST_R", (0, 0, 0), "x", -0.45, 0.45, 300, 4))
    joints.append(Joint("CHEST", "WAIST_R", "CHEST", (0, 0, 0.35), "z", -0.80, 0.80, 200, 4))
    frames.append(("IMU", "WAIST", (0, 0, 0.10)))
    frames.append(("LEFT_CAMERA", "CHEST", (0.105, 0.03, 0.245)))
    frames.append(("RIGHT_CAMERA", "CHEST", (0.105, -0.03, 0.245)))


def numbers(values):
    return " ".join(f"{v:.6g}" for v in values)


ROTATION = {"x": "0 1.5707963267948966 0", "y": "1.5707963267948966 0 0", "z": "0 0 0"}
AXIS = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1"}


def shape_xml(shape):
    kind, size, at, color, use = shape
    rotation = "0 0 0"
    if kind == "box":
        geometry = f'<box size="{numbers(size)}"/>'
    elif kind == "sphere":
        geometry = f'<sphere radius="{numbers(size)}"/>'
    else:
        geometry = f'<cylinder radius="{size[0]:.6g}" length="{size[1]:.6g}"/>'
        rotation = ROTATION[size[2]]
    origin = f'<origin xyz="{numbers(at)}" rpy="{rotation}"/>'
    out = []
    if "v" in use:
        out.append(f'    <visual>{origin}<geometry>{geometry}</geometry><material name="{color}"/></visual>')
    if "c" in use:
        out.append(f'    <collision>{origin}<geometry>{geometry}</geometry></collision>')
    return out


def urdf():
    out = ['<?xml version="1.0"?>', "<!-- Written by make_urdf.py: change that file, not this one. -->",
           '<robot name="hrp1s">']
    for name, rgba in COLORS.items():
        out.append(f'  <material name="{name}"><color rgba="{rgba}"/></material>')
    for link in links:
        out.append(f"  <link name={quoteattr(link.name)}>")
        ixx, iyy, izz = box_inertia(link.mass, *link.extent)
        out.append(f'    <inertial><origin xyz="{numbers(link.com)}"/><mass value="{link.mass:g}"/>'
                   f'<inertia ixx="{ixx:.6g}" ixy="0" ixz="0" iyy="{iyy:.6g}" iyz="0" izz="{izz:.6g}"/></inertial>')
        for shape in link.shapes:
            out.extend(shape_xml(shape))
        out.append("  </link>")
    for name, _, _ in frames:
        out.append(f"  <link name={quoteattr(name)}/>")
    for j in joints:
        out.append(f'  <joint name={quoteattr(j.name)} type="revolute"><parent link={quoteattr(j.parent)}/>'
                   f'<child link={quoteattr(j.child)}/>')
        out.append(f'    <origin xyz="{numbers(j.at)}"/><axis xyz="{AXIS[j.axis]}"/>'
                   f'<limit lower="{j.lower:.6g}" upper="{j.upper:.6g}" effort="{j.effort:g}" velocity="{j.velocity:g}"/>')
        out.append("  </joint>")
    for name, parent, at in frames:
        out.append(f'  <joint name={quoteattr(name + "_FIXED")} type="fixed"><parent link={quoteattr(parent)}/>'
                   f'<child link={quoteattr(name)}/><origin xyz="{numbers(at)}"/></joint>')
    out.append("</robot>")
    return "\n".join(out) + "\n"


LEG = ["HIP_R", "HIP_P", "HIP_Y", "KNEE", "ANKLE_P", "ANKLE_R"]
ARM = ["SHOULDER_P", "SHOULDER_R", "SHOULDER_Y", "ELBOW", "WRIST_Y", "WRIST_P", "WRIST_R"]
ARM_RIGHT = [0.3113, -0.1595, -0.1154, -0.6363, 0, 0, 0]
ARM_LEFT = [0.3113, 0.1595, 0.1154, -0.6363, 0, 0, 0]
POSES = {  # [rad]
    "zero": ([0] * 6, [0] * 7, [0] * 7),
    "initial": ([0, -0.3786, 0, 0.8320, -0.4526, 0], ARM_RIGHT, ARM_LEFT),
    "half_sitting": ([0, -0.5710, 0, 1.2644, -0.6925, 0], ARM_RIGHT, ARM_LEFT),
}


def srdf():
    out = ['<?xml version="1.0"?>', "<!-- Written by make_urdf.py: change that file, not this one. -->",
           '<robot name="hrp1s">']
    for group, names in (("right_leg", [f"RLEG_{j}" for j in LEG]), ("left_leg", [f"LLEG_{j}" for j in LEG]),
                         ("right_arm", [f"RARM_{j}" for j in ARM]), ("left_arm", [f"LARM_{j}" for j in ARM]),
                         ("torso", ["WAIST_P", "WAIST_R", "CHEST"])):
        out.append(f'  <group name="{group}">' + "".join(f'<joint name="{n}"/>' for n in names) + "</group>")
    out.append('  <group name="all">' + "".join(
        f'<group name="{g}"/>' for g in ("right_leg", "left_leg", "right_arm", "left_arm", "torso")) + "</group>")
    for side, prefix in (("left", "L"), ("right", "R")):
        out.append(f'  <end_effector name="{side}_hand" parent_link="{prefix}ARM_WRIST_R" group="{side}_arm"/>')
        out.append(f'  <end_effector name="{side}_foot" parent_link="{prefix}LEG_ANKLE_R" group="{side}_leg"/>')
    for pose, (leg_q, right, left) in POSES.items():
        out.append(f'  <group_state name="{pose}" group="all">')
        for names, values in (([f"RLEG_{j}" for j in LEG], leg_q), ([f"RARM_{j}" for j in ARM], right),
                              ([f"LLEG_{j}" for j in LEG], leg_q), ([f"LARM_{j}" for j in ARM], left),
                              (["WAIST_P", "WAIST_R", "CHEST"], [0, 0, 0])):
            out.append("    " + "".join(f'<joint name="{n}" value="{v:g}"/>' for n, v in zip(names, values)))
        out.append("  </group_state>")
    out.append("</robot>")
    return "\n".join(out) + "\n"


def main():
    body()
    total = sum(link.mass for link in links)
    assert abs(total - MASS) < 1e-9, total
    assert len(joints) == 29
    folder = pathlib.Path(__file__).resolve().parent
    (folder / "hrp1s.urdf").write_text(urdf())
    (folder / "hrp1s.srdf").write_text(srdf())
    print(f"hrp1s: {len(joints)} joints, {len(links)} moving links, {total:.1f} kg")


main()
