#!/usr/bin/env python3
"""Our kinematics and dynamics beside Pinocchio's (pip install pin): the same numbers, and the cost of each.

    pinocchio_peer.py KINEMATICS_BENCH URDF [CSV] [--cost PROGRAM]

Agreement is relative, over 64 random postures and motions; more than 1e-10 is a failure.  Costs are medians of the same
minute, ours and the peer's in turn, five times.  PROGRAM is pinocchio_cost.cpp, compiled as that file says: Pinocchio's
own C++ without Python between.  Without it Pinocchio is called from Python, and an empty call is taken off, which leaves
the conversion of arrays in its cost.  Without Pinocchio it says so and exits 0.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

try:
    import numpy
    import pinocchio
except ImportError:
    print("pinocchio: not installed, nothing compared (pip install pin)")
    sys.exit(0)

from kinematics_blocks import LIMIT, blocks  # noqa: E402


def to_peer(model, block):
    """q, v, a as Pinocchio has them, and T with v = T v_ours: base motions in the base's frame."""
    n = len(block["joints"])
    base = pinocchio.XYZQUATToSE3(numpy.concatenate([block["position"], block["turn"]]))
    q = numpy.concatenate([block["position"], block["turn"], numpy.zeros(n)])
    t = numpy.zeros((6 + n, 6 + n))
    t[:3, :3] = t[3:6, 3:6] = base.rotation.T
    for k, name in enumerate(block["joints"]):
        joint = model.joints[model.getJointId(name)]
        q[joint.idx_q] = block["q"][k]
        t[joint.idx_v, 6 + k] = 1.0
    spin = numpy.zeros(6 + n)  # Pinocchio's base acceleration is spatial
    spin[:3] = numpy.cross(block["v"][3:6], block["v"][:3])
    return q, t @ block["v"], t @ (block["a"] - spin), t, spin


def agreement(model, data, block):
    n = len(block["joints"])
    q, v, a, t, spin = to_peer(model, block)

    def off(name, theirs):
        ours = block[name].reshape(numpy.asarray(theirs).T.shape).T
        return name, float(numpy.linalg.norm(ours - theirs) / (1.0 + numpy.linalg.norm(theirs)))
    pinocchio.computeJointJacobians(model, data, q)
    pinocchio.updateFramePlacements(model, data)
    com = pinocchio.jacobianCenterOfMass(model, data, q)
    yield off("com", pinocchio.centerOfMass(model, data, q))
    yield off("com_jacobian", com @ t)
    best = min((float(numpy.linalg.norm(data.oMi[i].translation - block["hand"])), i) for i in range(1, model.njoints))
    yield "hand", best[0]
    same = [i for i in range(1, model.njoints) if numpy.linalg.norm(data.oMi[i].translation - block["hand"]) < 1e-9]
    jacobians = [pinocchio.getJointJacobian(model, data, i, pinocchio.LOCAL_WORLD_ALIGNED) @ t for i in same]
    yield "hand_jacobian", min(off("hand_jacobian", j)[1] for j in jacobians)
    mass = pinocchio.crba(model, data, q)
    mass = numpy.triu(mass) + numpy.triu(mass, 1).T
    yield off("mass_matrix", t.T @ mass @ t)
    yield off("inverse_dynamics", t.T @ pinocchio.rnea(model, data, q, v, a))
    tau = numpy.zeros(6 + n)
    tau[6:] = block["inverse_dynamics"][6:]
    yield off("forward_dynamics", t.T @ pinocchio.aba(model, data, q, v, t @ tau) + spin)


def median_us(call, calls=16, rounds=1500):  # as few in a row as ours, so that a busy machine disturbs both alike
    times = []
    for _ in range(rounds):
        begin = time.perf_counter()
        for i in range(calls):
            call(i % 64)
        times.append((time.perf_counter() - begin) / calls * 1e6)
    return float(numpy.median(times))


def peer_costs(model, data, all_blocks):
    states = [to_peer(model, block) for block in all_blocks]
    empty = median_us(lambda i: model.getFrameId("") if False else states[i][0])
    last = model.njoints - 1
    ends = [last, last // 2, last // 3, last // 4]

    def kinematics(i):
        pinocchio.computeJointJacobians(model, data, states[i][0])
        for end in ends:
            pinocchio.getJointJacobian(model, data, end, pinocchio.LOCAL_WORLD_ALIGNED)
        pinocchio.jacobianCenterOfMass(model, data, states[i][0])
    jacobian = median_us(lambda i: pinocchio.getJointJacobian(model, data, last, pinocchio.LOCAL_WORLD_ALIGNED))
    return {"all: kinematics and jacobians": median_us(kinematics) - 4 * jacobian - 2 * empty,  # the four copies are Python's
            "all: inverse dynamics": median_us(lambda i: pinocchio.rnea(model, data, *states[i][:3])) - empty,
            "all: mass matrix": median_us(lambda i: pinocchio.crba(model, data, states[i][0])) - empty,
            "all: forward dynamics": median_us(lambda i: pinocchio.aba(model, data, *states[i][:3])) - empty}


def write_numbers(model, all_blocks, file):
    """What pinocchio_cost reads."""
    def line(*values):
        return " ".join(v if isinstance(v, str) else " ".join(repr(float(x)) for x in numpy.asarray(v).ravel()) for v in values)
    lines = [str(model.njoints - 1)]
    for j in range(1, model.njoints):
        inertia, at = model.inertias[j], model.jointPlacements[j]
        kind = model.joints[j].shortname()
        if kind not in ("JointModelFreeFlyer", "JointModelRX", "JointModelRY", "JointModelRZ"):
            sys.exit(f"pinocchio_cost: joints of kind {kind} are not written")
        lines.append(line(str(model.parents[j]), kind, [0.0, 0.0, 1.0], at.rotation, at.translation, inertia.mass,
                          inertia.lever, inertia.inertia))
    lines += [line(*to_peer(model, block)[:3]) for block in all_blocks]
    file.write_text("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench")
    parser.add_argument("urdf")
    parser.add_argument("csv", nargs="?")
    parser.add_argument("--cost")
    options = parser.parse_args()
    model = pinocchio.buildModelFromUrdf(options.urdf, pinocchio.JointModelFreeFlyer())
    data = model.createData()
    robot = str(pathlib.Path(options.urdf).resolve().parent)

    def costs(command, separator):
        text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        return {name.strip(): float(value) for name, value in (row.rsplit(separator, 1) for row in text.splitlines())}

    def our_costs(csv):
        csv.unlink(missing_ok=True)
        subprocess.run([options.bench, "--robot", robot, "--calls", "20000", "--csv", csv], check=True,
                       stdout=subprocess.DEVNULL)
        return {line.split('"')[1]: float(line.split(",us,")[1].split(",")[0]) for line in csv.read_text().splitlines()}
    ours, theirs = [], []
    with tempfile.TemporaryDirectory() as folder:
        dump, csv, numbers = (pathlib.Path(folder) / name for name in ("dump", "csv", "numbers"))
        subprocess.run([options.bench, "--robot", robot, "--dump", dump], check=True)
        all_blocks = list(blocks(dump.read_text()))
        write_numbers(model, all_blocks, numbers)
        for _ in range(5):
            ours.append(our_costs(csv))
            theirs.append(costs([options.cost, numbers], ",") if options.cost else peer_costs(model, data, all_blocks))
    worst = {}
    for block in all_blocks:
        for name, off in agreement(model, data, block):
            worst[name] = max(worst.get(name, 0.0), off)
    print("relative difference, worst of", len(all_blocks))
    for name, off in worst.items():
        print(f"  {name:20s} {off:.1e}{'' if off <= LIMIT else '  TOO LARGE'}")
    print(f"{'microseconds, median of 5 medians':34s} {'ours':>8s} {'peer':>8s} {'ratio':>6s}   pinocchio {pinocchio.__version__} from "
          + ("C++" if options.cost else "Python"))
    rows = []
    for name in (name for name in theirs[0] if name in ours[0]):
        us, them = (float(numpy.median([run[name] for run in runs])) for runs in (ours, theirs))
        ratio = float(numpy.median([a[name] / b[name] for a, b in zip(ours, theirs)]))
        print(f"{name:34s} {us:8.3f} {them:8.3f} {ratio:6.2f}")
        rows.append(f'kinematics,"{name}",cost,us,{us:.3f},,,,pinocchio,{them:.3f},{ratio:.3f}\n')
    if options.csv:
        with open(options.csv, "a") as file:
            file.writelines(rows)
    return 0 if all(off <= LIMIT for off in worst.values()) else 1


sys.exit(main())
