#!/usr/bin/env python3
"""Robots of MuJoCo models fall and swing here and in MuJoCo: how far apart their links are.

    mujoco_compare.py [--seconds 0.5] [--step 1e-4] [--table FILE] [--least N] MODEL.xml|FOLDER ...

Needs the wheel mujoco (pip install mujoco) and numpy; says so and skips (exit status 77) without them.  Without a model: the
ones in this folder's models/.  Every model is read by both; MuJoCo refuses what it refuses.  First without contacts, limits,
springs and friction loss, both with a converged step (each side says what half the step changes): links must be within 0.1 mm.
Then, reported apart and not judged, with limits and with friction loss, which MuJoCo has soft and twinbus stiff.
Of a FOLDER every .xml in it and below that is a model.  Exit status 1 when a model that both read parts by more, or when fewer than
--least were compared or refused.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ.get("TWINBUS_BIN", ROOT / "build/release/bin"))
MOST_APART = 1e-4  # [m]

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco numpy")
    sys.exit(77)

UNSTABLE = (int(mujoco.mjtWarning.mjWARN_BADQPOS), int(mujoco.mjtWarning.mjWARN_BADQVEL), int(mujoco.mjtWarning.mjWARN_BADQACC))


def clean(name):
    """As mjcf_to_urdf.cpp makes names of links and joints."""
    name = re.sub(r"[^A-Za-z0-9_.-]", "_", name)
    return name if re.match(r"[A-Za-z_]", name) else "_" + name


def compiled(file):
    """The model in MuJoCo, without meshes whose files are missing and without what only draws them."""
    try:
        return mujoco.MjModel.from_xml_path(str(file))
    except ValueError as error:
        if "Error opening file" not in str(error):
            raise
    spec = mujoco.MjSpec.from_file(str(file))
    for geom in list(spec.geoms):
        if geom.type == mujoco.mjtGeom.mjGEOM_MESH:
            spec.delete(geom)
    for mesh in list(spec.meshes):
        spec.delete(mesh)
    return spec.compile()


def ours(file, seconds, step, words):
    """Start of the joints and end of the links, or the sentence with which it is refused."""
    run = subprocess.run([str(BIN / "mjcf_swing"), str(file), str(seconds), str(step), *words], capture_output=True, text=True,
                         timeout=3000)
    if run.returncode != 0:
        return run.stderr.strip().removeprefix("mjcf_swing: ") or f"ended with {run.returncode}", None
    joints, links = {}, {}
    for line in run.stdout.splitlines():
        kind, name, *numbers = line.split()
        (joints if kind == "joint" else links)[name] = np.array([float(x) for x in numbers])
    return joints, links


def theirs(model, joints, seconds, step, words, explicit=True):
    """Where MuJoCo has the links at the end; where its explicit steps do not hold, with implicit ones of a tenth."""
    m = model
    off = mujoco.mjtDisableBit
    m.opt.disableflags |= sum(int(b) for b in (off.mjDSBL_SPRING, off.mjDSBL_ACTUATION, off.mjDSBL_EQUALITY, off.mjDSBL_CONTACT))
    for word, bit in (("limits", off.mjDSBL_LIMIT), ("friction", off.mjDSBL_FRICTIONLOSS)):
        if word in words:
            m.opt.disableflags &= ~int(bit)
        else:
            m.opt.disableflags |= int(bit)
    m.opt.disableflags &= ~int(off.mjDSBL_GRAVITY)
    m.opt.gravity[:] = (0, 0, -9.81)
    m.opt.density = m.opt.viscosity = 0.0
    m.opt.wind[:] = 0
    m.body_gravcomp[:] = 0
    m.tendon_stiffness[:] = 0
    m.tendon_damping[:] = 0
    m.tendon_armature[:] = 0
    m.tendon_limited[:] = 0
    m.tendon_frictionloss[:] = 0
    m.opt.timestep = step
    # RK4 has no implicit limits and friction; both are soft constraints, which Euler with a small step solves as well.
    m.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4 if explicit and not words else mujoco.mjtIntegrator.mjINT_IMPLICIT
    d = mujoco.MjData(m)
    mujoco.mj_resetData(m, d)
    for j in range(m.njnt):
        qpos, dof = m.jnt_qposadr[j], m.jnt_dofadr[j]
        if m.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE:
            for values in (m.dof_armature, m.dof_damping, m.dof_frictionloss):  # of a free base: `check` says that they are not modelled
                values[dof:dof + 6] = 0.0
            d.qpos[qpos:qpos + 7] = (0, 0, 100, 1, 0, 0, 0)
            continue
        body = m.jnt_bodyid[j]
        name = m.joint(j).name or (m.body(body).name or f"body_{body}") + "_joint"
        start = joints.get(clean(name))
        if start is not None:
            d.qpos[qpos] = m.qpos0[qpos] + start[0]
            d.qvel[dof] = start[1]
    for _ in range(round(seconds / step)):
        mujoco.mj_step(m, d)
        if explicit and any(d.warning[w].number for w in UNSTABLE):
            return theirs(model, joints, seconds, 0.1 * step, words, explicit=False)
    mujoco.mj_kinematics(m, d)
    links = {}
    for b in range(1, m.nbody):
        anchor = np.zeros(3)
        if m.body_jntnum[b] > 0:
            last = m.body_jntadr[b] + m.body_jntnum[b] - 1
            if m.jnt_type[last] != mujoco.mjtJoint.mjJNT_FREE:
                anchor = m.jnt_pos[last]
        turn = d.xmat[b].reshape(3, 3)
        origin = d.xpos[b] + turn @ anchor
        links[clean(m.body(b).name or f"body_{b}")] = np.concatenate([origin, origin + turn @ np.full(3, 0.1)])
    return links


def apart(a, b):
    both = [name for name in a if name in b]
    return max((float(np.linalg.norm((a[n] - b[n]).reshape(2, 3), axis=1).max()) for n in both), default=float("nan")), len(both)


def models_of(named):
    """The file, or of a folder those that have a body of their own: others are parts of them."""
    if named.is_file():
        return [named]
    return [file for file in sorted(named.rglob("*.xml")) if re.search(r"<mujoco\b[\s\S]*<body\b", file.read_text(errors="replace"))]


def compare(file, seconds, step):
    """A row of the table, and whether it passes."""
    try:
        model = compiled(file)
        refused = ""
    except ValueError as error:
        refused = str(error).replace("\n", " ")[:160]
    joints, links = ours(file, seconds, step, [])
    if links is None:
        return {"model": file.name, "state": "refused" + (", by MuJoCo too" if refused else ""), "why": joints}, True
    if refused:
        return {"model": file.name, "state": "loads here, not in MuJoCo", "why": refused}, True
    coarse, _ = apart(links, ours(file, seconds, 2 * step, [])[1])
    reference = theirs(compiled(file), joints, seconds, step, [])
    theirs_coarse, _ = apart(reference, theirs(compiled(file), joints, seconds, 2 * step, []))
    distance, count = apart(links, reference)
    row = {"model": file.name, "state": "loads", "joints": len(joints), "links": count, "apart_mm": 1e3 * distance,
           "own_step_mm": 1e3 * coarse, "mujoco_step_mm": 1e3 * theirs_coarse}
    for word in ("limits", "friction"):
        other_joints, other = ours(file, seconds, step, [word])
        row[word + "_mm"] = 1e3 * apart(other, theirs(compiled(file), other_joints, seconds, step, [word]))[0] if other else float("nan")
    return row, distance <= MOST_APART and count > 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", nargs="*", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=0.5)
    parser.add_argument("--step", type=float, default=1e-4)
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--least", type=int, default=1)
    arguments = parser.parse_args()
    models = [file for named in arguments.models or [pathlib.Path(__file__).parent / "models"] for file in models_of(named)]
    failed, lines = 0, []
    for file in models:
        row, good = compare(file, arguments.seconds, arguments.step)
        failed += not good
        if "apart_mm" in row:
            line = (f"| {row['model']} | {row['joints']} | {row['links']} | {row['apart_mm']:.2g} | {row['own_step_mm']:.1g}, "
                    f"{row['mujoco_step_mm']:.1g} | {row['limits_mm']:.2g} | {row['friction_mm']:.2g} |{'' if good else ' FAILED'}")
        else:
            line = f"| {row['model']} | {row['state']}: {row['why']} |"
        print(line, flush=True)
        lines.append(line)
    if arguments.table:
        arguments.table.write_text("\n".join(lines) + "\n")
    print(f"{len(models)} models, {failed} apart by more than {1e3 * MOST_APART} mm")
    return 1 if failed or len(models) < arguments.least else 0


if __name__ == "__main__":
    sys.exit(main())
