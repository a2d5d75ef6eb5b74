#!/usr/bin/env python3
"""Every URDF of the example-robot-data wheel (pip install example-robot-data) through `twinbus check`.

    example_robots.py TWINBUS [FOLDER]

Each loads, with a mass equal to 1e-9 to what Python's XML reader adds up, or is refused for a reason that is looked at
here again, in the same file, by other means: `wrong` means that the reason is not true.  Without the wheel it says so
and exits 0.
"""

import importlib.util
import json
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

LIMIT = 1e-9


def wheel_folder():
    for package in ("example_robot_data", "pinocchio"):
        spec = importlib.util.find_spec(package)
        if spec is None or spec.origin is None:
            continue
        for parent in pathlib.Path(spec.origin).parents:
            for folder in (parent / "share/example-robot-data/robots", parent / "cmeel.prefix/share/example-robot-data/robots"):
                if folder.is_dir():
                    return folder
    return None


def least_moment(xx, xy, xz, yy, yz, zz):
    """Smallest eigenvalue of a symmetric 3x3 matrix, by bisection on the signs of leading minors of I - x."""
    def minors(x):
        a, b, c = xx - x, yy - x, zz - x
        return a, a * b - xy * xy, a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz)
    size = abs(xx) + abs(yy) + abs(zz) + 2 * (abs(xy) + abs(xz) + abs(yz))
    low, high = -size, size
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if all(m > 0 for m in minors(middle)) else (low, middle)
    return low


def true_reason(file, complaint):
    """Whether the file is as the complaint says; None: this script does not know that complaint."""
    if "is a xacro macro" in complaint:
        return "xacro:" in file.read_text(errors="replace")
    root = ElementTree.parse(file).getroot()
    links = {link.get("name"): link for link in root.findall("link")}
    if "the robot has no link" in complaint:
        return not links
    found = re.search(r"link (\S+): inertia is not that of a body", complaint)
    if found:
        inertia = links[found[1]].find("inertial/inertia")
        return least_moment(*(float(inertia.get(k)) for k in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))) < 0.0
    found = re.search(r"mimic: there is no joint (\S+?);", complaint)
    if found:
        return found[1] not in {joint.get("name") for joint in root.findall("joint")}
    found = re.search(r"link (\S+) moves but has no mass.*joint (\S+) under", complaint)
    if found:
        mass = links[found[1]].find("inertial/mass")
        joint = next(j for j in root.findall("joint") if j.get("name") == found[2])
        return (mass is None or float(mass.get("value")) == 0.0) and joint.get("type") != "fixed"
    return None


def mass_of(file):
    masses = (link.find("inertial/mass") for link in ElementTree.parse(file).getroot().findall("link"))
    return sum(float(mass.get("value")) for mass in masses if mass is not None)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else wheel_folder()
    if folder is None:
        print("example-robot-data: not installed, nothing looked at (pip install example-robot-data)")
        return 0
    files = sorted(f for f in folder.rglob("*.urdf*") if f.is_file())
    loaded = refused = wrong = 0
    worst = 0.0
    for file in files:
        run = subprocess.run([sys.argv[1], "check", str(file), "--json"], capture_output=True, text=True, timeout=120)
        name = file.relative_to(folder)
        if run.stdout and not run.stderr:  # a robot, whether or not it stands
            loaded += 1
            report = json.loads(run.stdout)
            ours, theirs = report["mass_kg"], mass_of(file)
            if run.returncode != 0:
                print(f"does not stand: {name}: {'; '.join(report['trial']['weak'] + report['trial']['failures'][:1])}")
            off = abs(ours - theirs) / max(1.0, theirs)
            worst = max(worst, off)
            if not off <= LIMIT:
                wrong += 1
                print(f"WRONG    {name}: {ours} kg, Python adds up {theirs}")
            continue
        refused += 1
        complaint = run.stderr.strip().replace(str(folder) + "/", "")
        verdict = true_reason(file, complaint) if run.returncode == 1 and len(complaint.splitlines()) == 1 else False
        wrong += verdict is not True
        print(f"{'refused ' if verdict else 'WRONG   ' if verdict is False else 'UNKNOWN '} {complaint}")
    print(f"{len(files)} files: {loaded} loaded, masses within {worst:.1e}; {refused} refused; {wrong} wrong")
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main())
