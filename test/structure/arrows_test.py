#!/usr/bin/env python3
"""Arrows between rooms, third-party headers outside their one door, sizes of files, and traces of one machine.

    arrows_test.py            checks the tree this file is in
    arrows_test.py FOLDER     checks another one (the test of this test does)
"""

import os
import pathlib
import re
import subprocess
import sys

ROOMS = ["lcmtypes", "robot", "bridge", "sim", "control", "planner", "viewer_log", "launcher", "test", "examples"]

# room -> rooms whose headers it may include (besides its own).
ARROWS = {
    "robot": set(),
    "bridge": {"robot"},
    "sim": {"robot", "bridge"},
    "control": {"robot"},
    "planner": {"robot"},
    "viewer_log": {"robot"},
    "lcmtypes": {"robot"},  # the structs that messages carry
    "launcher": {"robot", "bridge", "sim", "control", "planner", "lcmtypes", "viewer_log"},
}

# The bus is used by mains only: *main.cpp, *_main.h, *_main.cpp, and the launcher.
BUS = "lcmtypes"
MAIN = re.compile(r"(^|[/_])main\.(cpp|h)$")

# Headers -> files that may include them.  ODE may be spread over sim/ode*.
DOORS = {
    r"ode/": r"sim/ode[a-z_]*\.(cpp|h)",
    r"fcl/|ccd/": r"robot/[a-z_]+\.cpp",
    r"urdf_parser/|urdf_model/|urdf_exception/": r"robot/[a-z_]+\.cpp",
    r"assimp/": r"robot/[a-z_]+\.cpp",
    r"SDL": r"control/[a-z_]+\.cpp",
    r"boost/beast|boost/asio": r"viewer_log/[a-z_]+\.cpp",
    r"lcm/": r"lcmtypes/[a-z_]+\.(cpp|h)",
}
ONE_FILE_DOORS = [r"fcl/|ccd/", r"urdf_parser/|urdf_model/|urdf_exception/", r"assimp/", r"SDL", r"boost/beast|boost/asio"]

# "About 200" and "about 450": a tenth more is still about.
HEADER_CEILING = 220
SOURCE_CEILING = 495
LISTS = {"robot/requests.h"}  # one struct per message: long because the bus has many messages, not many ideas

# test/no_alloc.h is the one header of test/ that products include: a heartbeat counts allocations.
SHARED_TEST_HEADERS = {"test/no_alloc.h"}

MACHINE = re.compile(r"/(home|work|Users|root|tmp/[a-z]+_clone)/[A-Za-z0-9_.-]+")
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.MULTILINE)
CODE = {".h", ".cpp", ".c", ".cc", ".hpp"}
TEXT = CODE | {".py", ".sh", ".yaml", ".yml", ".txt", ".md", ".cmake", ".json", ".lcm", ".java", ".urdf", ".srdf", ".nft", ""}

STARTED = re.compile(r"test/bench/(bench|chart)_\w+\.py")  # by ./twinbus bench and chart


def files_of(root):
    """Tracked files and those that could be; without git, everything outside build folders."""
    try:
        listed = subprocess.run(["git", "-C", root, "ls-files", "-co", "--exclude-standard"], capture_output=True, text=True,
                                check=True).stdout.splitlines()
    except (OSError, subprocess.CalledProcessError):
        listed = [str(p.relative_to(root)) for p in root.rglob("*") if p.is_file()]
    return sorted(f for f in listed if (root / f).is_file() and not f.startswith(("build/", "runs/")))


def check_include(file, header, problems):
    room = file.split("/")[0]
    if room not in ARROWS:
        return
    target = header.split("/")[0]
    is_main = bool(MAIN.search(file))
    if target == BUS or (header.startswith("twinbus/") and header.endswith("_t.hpp")):
        if room not in (BUS, "launcher") and not is_main:
            problems.append(f"{file}: includes {header}; only mains, launcher/ and lcmtypes/ know the bus")
        return
    if target not in ROOMS or target == room or header in SHARED_TEST_HEADERS and is_main:
        return
    if target == "test" and header in SHARED_TEST_HEADERS:
        return
    if target not in ARROWS[room] and not is_main:
        problems.append(f"{file}: includes {header}; no arrow leads from {room}/ to {target}/")


def check_doors(file, header, doors_used, problems):
    if file.split("/")[0] == "test":
        return  # oracles of tests may look behind the doors
    for pattern, door in DOORS.items():
        if re.match(pattern, header):
            if not re.fullmatch(door, file):
                problems.append(f"{file}: includes <{header}>; its door is {door}")
            doors_used.setdefault(pattern, set()).add(file)


def check(root):
    problems = []
    doors_used = {}
    for file in files_of(root):
        path = root / file
        suffix = path.suffix
        if STARTED.fullmatch(file) and not os.access(path, os.X_OK):
            problems.append(f"{file}: the launcher starts it, so it must be executable: chmod +x")
        if suffix not in TEXT or "package-lock" in file or "/web/" in file:
            continue
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        if not file.endswith("arrows_test.py"):
            for number, line in enumerate(text.splitlines(), 1):
                if MACHINE.search(line):
                    problems.append(f"{file}:{number}: a path of one machine: {MACHINE.search(line).group(0)}")
        if suffix not in CODE:
            continue
        for _, header in INCLUDE.findall(text):
            check_include(file, header, problems)
            check_doors(file, header, doors_used, problems)
        lines = text.count("\n")
        ceiling = HEADER_CEILING if suffix in (".h", ".hpp") else SOURCE_CEILING
        if lines > ceiling and not file.startswith("test/") and file not in LISTS:
            problems.append(f"{file}: {lines} lines, the ceiling is {ceiling}: two ideas, find the seam")
    for pattern in ONE_FILE_DOORS:
        if len(doors_used.get(pattern, ())) > 1:
            problems.append(f"{', '.join(sorted(doors_used[pattern]))}: all include {pattern}; there must be one door")
    return problems


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    problems = check(root)
    for problem in problems:
        print(problem)
    print(f"{len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
