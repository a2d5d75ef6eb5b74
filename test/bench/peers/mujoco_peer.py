#!/usr/bin/env python3
"""Our kinematics and dynamics beside MuJoCo's (pip install mujoco): the same numbers on our robots and on random trees.

    mujoco_peer.py KINEMATICS_BENCH [--trees N] [--seed N] [URDF ...]

Positions, Jacobians, mass matrix, bias, inverse and forward dynamics, floating base, 64 random postures and motions of
each URDF and of N random trees of joints of every kind; relative differences above 1e-10 are a failure.  Without MuJoCo
it says so and exits 0.
"""

import argparse
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

try:
    import mujoco
    import numpy
except ImportError:
    print("mujoco: not installed, nothing compared (pip install mujoco)")
    sys.exit(0)

from kinematics_blocks import LIMIT, blocks  # noqa: E402


def peer_model(urdf):
    """The same file without shapes, friction and limits, its root on a floating joint."""
    root = ElementTree.parse(urdf).getroot()
    children = {joint.find("child").get("link") for joint in root.findall("joint")}
    base = next(link.get("name") for link in root.findall("link") if link.get("name") not in children)
    for link in root.findall("link"):
        for shape in link.findall("visual") + link.findall("collision"):
            link.remove(shape)
    for joint in root.findall("joint"):
        for part in joint.findall("dynamics") + joint.findall("safety_controller"):
            joint.remove(part)
    for extra in ("transmission", "gazebo", "material"):
        for part in root.findall(extra):
            root.remove(part)
    ElementTree.SubElement(root, "link", name="peer_world")
    joint = ElementTree.SubElement(root, "joint", name="peer_floating", type="floating")
    ElementTree.SubElement(joint, "parent", link="peer_world")
    ElementTree.SubElement(joint, "child", link=base)
    ElementTree.SubElement(ElementTree.SubElement(root, "mujoco"), "compiler", fusestatic="true", discardvisual="true")
    model = mujoco.MjModel.from_xml_string(ElementTree.tostring(root, encoding="unicode"))
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT | mujoco.mjtDisableBit.mjDSBL_CONTACT
    model.opt.gravity[:] = (0.0, 0.0, -9.81)
    model.dof_armature[:] = 0.0
    model.dof_damping[:] = 0.0
    return model


def agreement(model, data, block):
    names, n = block["joints"], len(block["joints"])
    joint = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in names]
    x, y, z, w = block["turn"]
    data.qpos[:3], data.qpos[3:7] = block["position"], (w, x, y, z)
    matrix = numpy.zeros(9)
    mujoco.mju_quat2Mat(matrix, data.qpos[3:7].copy())
    t = numpy.zeros((6 + n, 6 + n))  # v of MuJoCo = t v of ours: angular velocity of the base in its own axes
    t[:3, :3] = numpy.eye(3)
    t[3:6, 3:6] = matrix.reshape(3, 3).T
    for k, j in enumerate(joint):
        data.qpos[model.jnt_qposadr[j]] = block["q"][k]
        t[model.jnt_dofadr[j], 6 + k] = 1.0
    data.qvel[:] = t @ block["v"]
    data.qfrc_applied[:] = 0.0
    # Forces transform the other way: ours = t' theirs.
    data.qfrc_applied[:] = numpy.linalg.inv(t.T) @ numpy.concatenate([numpy.zeros(6), block["inverse_dynamics"][6:]])
    mujoco.mj_forward(model, data)

    def off(name, theirs):
        ours = block[name].reshape(numpy.asarray(theirs).T.shape).T
        return name, float(numpy.linalg.norm(ours - theirs) / (1.0 + numpy.linalg.norm(theirs)))
    body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, block["link"][0])
    linear, angular, com = numpy.zeros((3, 6 + n)), numpy.zeros((3, 6 + n)), numpy.zeros((3, 6 + n))
    mujoco.mj_jacBody(model, data, linear, angular, body)
    mujoco.mj_jacSubtreeCom(model, data, com, 0)
    yield off("hand", data.xpos[body])
    yield off("hand_jacobian", numpy.vstack([linear, angular]) @ t)
    yield off("com", data.subtree_com[0])
    yield off("com_jacobian", com @ t)
    mass = numpy.zeros((6 + n, 6 + n))
    if hasattr(data, "qM"):
        mujoco.mj_fullM(model, mass, data.qM)
    else:  # from version 4 on
        mujoco.mj_fullM(model, data, mass)
    yield off("mass_matrix", t.T @ mass @ t)
    yield off("bias", t.T @ data.qfrc_bias)
    yield off("inverse_dynamics", t.T @ (mass @ (t @ block["a"]) + data.qfrc_bias))
    yield off("forward_dynamics", numpy.linalg.inv(t) @ data.qacc)


def random_tree(rng, file):
    """A URDF of 2 to 40 bodies that nobody designed."""
    def three(size):
        return " ".join(repr(rng.uniform(-size, size)) for _ in range(3))

    def direction():
        v = [rng.gauss(0, 1) for _ in range(3)]
        return " ".join(repr(c / math.sqrt(sum(e * e for e in v))) for c in v)
    lines = ['<robot name="tree">']
    for i in range(rng.randint(2, 40)):
        mass = rng.uniform(0.1, 5.0)
        a, b, c = (rng.uniform(0.02, 0.2) ** 2 for _ in range(3))
        moments = [mass / 3 * s for s in (b + c, a + c, a + b)]
        lines.append(f'<link name="link{i}"><inertial><origin xyz="{three(0.2)}" rpy="{three(3)}"/><mass value="{mass!r}"/>'
                     f'<inertia ixx="{moments[0]!r}" iyy="{moments[1]!r}" izz="{moments[2]!r}" ixy="0" ixz="0" iyz="0"/>'
                     "</inertial></link>")
        if i == 0:
            continue
        kind = rng.choice(("revolute", "revolute", "continuous", "prismatic"))
        lines.append(f'<joint name="joint{i}" type="{kind}"><parent link="link{rng.randrange(i)}"/><child link="link{i}"/>'
                     f'<origin xyz="{three(0.4)}" rpy="{three(3)}"/><axis xyz="{direction()}"/>'
                     '<limit lower="-1" upper="1.5" effort="10" velocity="5"/></joint>')
    file.write_text("\n".join([*lines, "</robot>"]))


def compare(bench, urdf, dump):
    subprocess.run([bench, "--robot", urdf, "--dump", dump], check=True)
    model = peer_model(urdf)
    data = mujoco.MjData(model)
    worst = {}
    for block in blocks(dump.read_text()):
        for name, off in agreement(model, data, block):
            worst[name] = max(worst.get(name, 0.0), off)
    return worst


def show(title, worst):
    print(title + ": " + ", ".join(f"{name} {off:.1e}{'' if off <= LIMIT else ' TOO LARGE'}" for name, off in worst.items()))
    return all(off <= LIMIT for off in worst.values())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench")
    parser.add_argument("urdf", nargs="*")
    parser.add_argument("--trees", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_intermixed_args()
    good = True
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for urdf in options.urdf:
            good = show(pathlib.Path(urdf).stem, compare(options.bench, urdf, folder / "dump")) and good
        worst = {}
        for k in range(options.trees):
            random_tree(random.Random(options.seed * 1000003 + k), folder / "tree.urdf")
            for name, off in compare(options.bench, folder / "tree.urdf", folder / "dump").items():
                worst[name] = max(worst.get(name, 0.0), off)
        if options.trees > 0:
            good = show(f"{options.trees} random trees, seed {options.seed}", worst) and good
    return 0 if good else 1


sys.exit(main())
