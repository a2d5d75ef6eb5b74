#!/usr/bin/env python3
"""The robots and problems of a VAMP checkout as `./twinbus bench planner --data` takes them (needs PyYAML).

    vamp_problems.py VAMP OUT ROBOT ...

Of each ROBOT (ur5, fetch, baxter, panda) under VAMP/resources: OUT/robots/ROBOT, its URDFs, SRDF and the meshes that are there,
and OUT/problems/ROBOT/ROBOT_problems.txt, one record a line as in the problems that come with the test data.
"""

import pathlib
import re
import shutil
import sys
import tarfile

import yaml

LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def matrix(pose):
    """Rows of a 3 x 4 matrix."""
    x, y, z, w = pose["orientation"]
    rotation = ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
                (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
                (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))
    return [[*row, p] for row, p in zip(rotation, pose["position"])]


def product(a, b):
    rows = [*b, [0, 0, 0, 1]]
    return [[sum(a[i][k] * rows[k][j] for k in range(4)) for j in range(4)] for i in range(3)]


def thing(found):
    base = matrix(found["pose"]) if "pose" in found else [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]
    pose = product(base, matrix(found["primitive_poses"][0]))
    primitive = found["primitives"][0]
    sizes = [*primitive["dimensions"], 0, 0][:3]
    return " ".join([primitive["type"], *(f"{v:.9g}" for v in sizes), *(f"{v:.9g}" for row in pose for v in row)])


def joints_of(header):
    text = header.read_text()
    return re.findall(r'"([^"]+)"', re.search(r"joint_names = \{(.*?)\};", text, re.S)[1])


def convert(vamp, out, robot):
    source = vamp / "resources" / robot
    folder = out / "robots" / robot
    shutil.copytree(source, folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("*.bz2"))
    joints = joints_of(vamp / "src/impl/vamp/robots" / f"{robot}.hh")
    scenes, requests = {}, {}
    with tarfile.open(source / "problems.tar.bz2") as tar:
        for member in tar:
            if not member.isfile():
                continue
            _, problem, name = member.name.split("/")
            key = problem.replace("_" + robot, ""), int(re.search(r"\d+", name)[0])
            (scenes if "scene" in name else requests)[key] = yaml.load(tar.extractfile(member), LOADER)
    target = out / "problems" / robot / f"{robot}_problems.txt"
    target.parent.mkdir(parents=True, exist_ok=True)
    with open(target, "w") as file:
        file.write(f"robot {robot}\njoints {len(joints)} {' '.join(joints)}\nproblems {len(scenes)}\n")
        for problem, number in sorted(scenes):
            request = requests[problem, number]
            state = request["start_state"]["joint_state"]
            start = dict(zip(state["name"], state["position"]))
            goal = {g["joint_name"]: g["position"] for g in request["goal_constraints"][0]["joint_constraints"]}
            objects = scenes[problem, number]["world"]["collision_objects"]
            file.write(f"problem {problem} {number}\n")
            for word, q in (("start", start), ("goal", goal)):
                file.write(word + "".join(f" {q[j]:.9g}" for j in joints) + "\n")
            file.write(f"objects {len(objects)}\n" + "".join(thing(o) + "\n" for o in objects))
    print(f"{target}: {len(scenes)} problems, {len(joints)} joints")


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    for name in sys.argv[3:]:
        convert(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), name)
