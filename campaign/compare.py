"""`campaign compare OUT OUT...`: the same runs done on different machines, paths or programs: which differ, and by how much.

Runs are the same when scene, robot, controller, settings, seed and time are; rows that should be equal to the last bit (same path,
same libc, same architecture) and are not are errors.  Writes compare.csv into the first folder.
"""

import argparse
import csv
import pathlib

from command import Parser
from report import read
from run_task import FIGURES

PLACE = ("processor", "architecture", "path", "libc", "program")


def what(task):
    return (task["scene"], task["scene_hash"], task["robot"], task["robot_hash"], task["controller"], tuple(sorted(task["varied"].items())),
            task["seed"], task["for"])


def place(task, result):
    return {**{key: str(result["where"].get(key, "")) for key in PLACE}, "program": task["program_hash"]}


def must_be_equal(a, b):
    """One path, one architecture, one program give the same bits: what is ours does, and libc's functions are those of the path."""
    return all(a[key] == b[key] for key in ("architecture", "path", "libc", "program"))


def size_of(a, b):
    """The largest relative difference of any figure, and its name; "" where figures are equal."""
    worst, name = 0.0, ""
    for key in FIGURES:
        x, y = a["figures"].get(key), b["figures"].get(key)
        if isinstance(x, (int, float)) and isinstance(y, (int, float)) and x != y:
            apart = abs(x - y) / max(abs(x), abs(y))
            if apart > worst:
                worst, name = apart, key
    return worst, name


def compare(folders):
    """[(id, id, equal, must be equal, places that differ, size, figure)] of runs that two folders have."""
    rows, first = [], {what(task): (task, result) for task, result in folders[0]}
    for other in folders[1:]:
        for task, result in other:
            if what(task) not in first:
                continue
            mine, its = first[what(task)]
            here, there = place(mine, its), place(task, result)
            equal = (its["status"], its["failures"], its["figures"]) == (result["status"], result["failures"], result["figures"])
            differ = "; ".join(f"{key}: {here[key]} / {there[key]}" for key in PLACE if here[key] != there[key])
            rows.append((mine["id"], task["id"], equal, must_be_equal(here, there), differ, *size_of(its, result)))
    return rows


def compare_command(words):
    parser = Parser("compare", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="+")
    given = parser.parse_args(words)
    if len(given.out) < 2:
        parser.error("wants two folders or more")
    rows = compare([read(out)[0] for out in given.out])
    with open(pathlib.Path(given.out[0]) / "compare.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["id", "other_id", "equal", "must_be_equal", "differs_in", "largest_relative_difference", "of"])
        writer.writerows([[a, b, str(equal).lower(), str(must).lower(), where, f"{size:.3g}", name] for a, b, equal, must, where, size, name in rows])
    groups = {}
    for row in rows:
        groups.setdefault(row[4] or "one machine and program", []).append(row)
    wrong = 0
    for where, group in sorted(groups.items()):
        apart = [row for row in group if not row[2]]
        wrong += sum(row[3] for row in apart)
        largest = max(apart, key=lambda row: row[5], default=None)
        print(f"{where}: {len(group) - len(apart)} of {len(group)} runs are equal"
              + (f"; largest difference {100 * largest[5]:.2g} % in {largest[6] or 'status'} of {largest[0]}" if largest else "")
              + ("; THEY MUST BE" if any(row[3] for row in apart) else ""))
    if not rows:
        print("no run is in both")
    return 1 if wrong or not rows else 0
