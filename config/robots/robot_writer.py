"""Writes the URDF and SRDF of a robot made of primitives; each robot's make_urdf.py says what it is made of.

Everything that moves has a body whose inertia is that of the box its mass is spread over, so it is an inertia that
exists.  Joints stand in the file in the order of the bus.
"""
import math
from xml.sax.saxutils import quoteattr

import shells

COLORS = {"shell": "0.90 0.91 0.93 1", "joint": "0.22 0.24 0.28 1", "accent": "0.10 0.36 0.66 1",
          "sole": "0.10 0.10 0.11 1", "visor": "0.05 0.07 0.10 1", "hand": "0.45 0.48 0.52 1"}
ROTATION = {"x": "0 1.5707963267948966 0", "y": "1.5707963267948966 0 0", "z": "0 0 0"}
AXIS = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1"}


# Shapes: (kind, size, centre, color, "vc"), v seen, c checked for collision.  A cylinder's size is radius, length, axis.
def box(x, y, z, at, color="shell", use="vc"):
    return ("box", (x, y, z), at, color, use)


def ball(radius, at, color="joint", use="vc"):
    return ("sphere", (radius,), at, color, use)


def rod(radius, length, axis, at, color="shell", use="vc"):
    return ("cylinder", (radius, length, axis), at, color, use)


def deg(angle):
    return math.radians(angle)


def mirrored(side, lower, upper):
    return (lower, upper) if side > 0 else (-upper, -lower)


def numbers(values):
    return " ".join(f"{v:.6g}" for v in values)


class Robot:
    """Links, joints and massless frames; groups and poses for the SRDF.

    with_shells: a viewer sees surfaces of triangles, one file per link and colour, instead of the primitives.
    """

    def __init__(self, name, with_shells=False):
        self.name, self.with_shells = name, with_shells
        self.meshes = {}  # file name -> triangles
        self.links, self.joints, self.frames = [], [], []
        self.groups, self.ends, self.poses = [], [], []

    def link(self, name, mass, com, extent, shapes):
        """mass [kg], com [m], extent: the box [m] its mass is spread over."""
        self.links.append((name, mass, com, extent, shapes))

    def joint(self, name, parent, child, at, axis, lower, upper, effort, velocity):
        self.joints.append((name, parent, child, at, axis, lower, upper, effort, velocity))

    def frame(self, name, parent, at):
        self.frames.append((name, parent, at))

    def group(self, name, joints):
        self.groups.append((name, joints))

    def end_effector(self, name, parent, group):
        self.ends.append((name, parent, group))

    def pose(self, name, rows):
        """rows: lists of (joint, angle [rad]), one line of the file each."""
        self.poses.append((name, rows))

    def mass(self):
        return sum(link[1] for link in self.links)

    def shape_xml(self, shape):
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
        if "v" in use and not self.with_shells:
            out.append(f'    <visual>{origin}<geometry>{geometry}</geometry><material name="{color}"/></visual>')
        if "c" in use:
            out.append(f'    <collision>{origin}<geometry>{geometry}</geometry></collision>')
        return out

    def shell_xml(self, link, shapes):
        out = []
        for color in sorted({shape[3] for shape in shapes if "v" in shape[4]}):
            file = f"meshes/{link.lower()}_{color}.stl"
            self.meshes[file] = [t for shape in shapes if "v" in shape[4] and shape[3] == color
                                 for t in shells.of_shape(shape)]
            out.append(f'    <visual><geometry><mesh filename="{file}"/></geometry><material name="{color}"/></visual>')
        return out

    def head(self):
        return ['<?xml version="1.0"?>', "<!-- Written by make_urdf.py: change that file, not this one. -->",
                f'<robot name="{self.name}">']

    def urdf(self):
        out = self.head()
        for name, rgba in COLORS.items():
            out.append(f'  <material name="{name}"><color rgba="{rgba}"/></material>')
        for name, mass, com, (x, y, z), shapes in self.links:
            ixx, iyy, izz = mass / 12 * (y * y + z * z), mass / 12 * (x * x + z * z), mass / 12 * (x * x + y * y)
            out.append(f"  <link name={quoteattr(name)}>")
            out.append(f'    <inertial><origin xyz="{numbers(com)}"/><mass value="{mass:g}"/>'
                       f'<inertia ixx="{ixx:.6g}" ixy="0" ixz="0" iyy="{iyy:.6g}" iyz="0" izz="{izz:.6g}"/></inertial>')
            for shape in shapes:
                out.extend(self.shape_xml(shape))
            if self.with_shells:
                out.extend(self.shell_xml(name, shapes))
            out.append("  </link>")
        for name, _, _ in self.frames:
            out.append(f"  <link name={quoteattr(name)}/>")
        for name, parent, child, at, axis, lower, upper, effort, velocity in self.joints:
            out.append(f'  <joint name={quoteattr(name)} type="revolute"><parent link={quoteattr(parent)}/>'
                       f'<child link={quoteattr(child)}/>')
            out.append(f'    <origin xyz="{numbers(at)}"/><axis xyz="{AXIS[axis]}"/>'
                       f'<limit lower="{lower:.6g}" upper="{upper:.6g}" effort="{effort:g}" velocity="{velocity:g}"/>')
            out.append("  </joint>")
        for name, parent, at in self.frames:
            out.append(f'  <joint name={quoteattr(name + "_FIXED")} type="fixed"><parent link={quoteattr(parent)}/>'
                       f'<child link={quoteattr(name)}/><origin xyz="{numbers(at)}"/></joint>')
        out.append("</robot>")
        return "\n".join(out) + "\n"

    def srdf(self):
        out = self.head()
        for group, names in self.groups:
            out.append(f'  <group name="{group}">' + "".join(f'<joint name="{n}"/>' for n in names) + "</group>")
        out.append('  <group name="all">' + "".join(f'<group name="{g}"/>' for g, _ in self.groups) + "</group>")
        for name, parent, group in self.ends:
            out.append(f'  <end_effector name="{name}" parent_link="{parent}" group="{group}"/>')
        for pose, rows in self.poses:
            out.append(f'  <group_state name="{pose}" group="all">')
            for row in rows:
                out.append("    " + "".join(f'<joint name="{n}" value="{v:g}"/>' for n, v in row))
            out.append("  </group_state>")
        out.append("</robot>")
        return "\n".join(out) + "\n"

    def write(self, folder):
        (folder / f"{self.name}.urdf").write_text(self.urdf())
        (folder / f"{self.name}.srdf").write_text(self.srdf())
        if self.meshes:
            (folder / "meshes").mkdir(exist_ok=True)
            for old in (folder / "meshes").glob("*.stl"):
                old.unlink()
            for file, triangles in self.meshes.items():
                shells.write_stl(folder / file, triangles)
            print(f"{len(self.meshes)} meshes, {sum(len(t) for t in self.meshes.values())} triangles")
        print(f"{self.name}: {len(self.joints)} joints, {len(self.links)} moving links, {self.mass():.1f} kg")
