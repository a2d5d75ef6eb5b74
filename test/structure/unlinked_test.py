#!/usr/bin/env python3
"""Every function of the product is called by a program: one that only tests call, or nothing, is found in the object files.

    unlinked_test.py BUILD

A function counts as called when an object file of the product, its own included, refers to it (position-independent code refers
to every function by name).  Functions in headers are not looked at.  Skipped where the programs are not built.
"""

import pathlib
import re
import subprocess
import sys

ROOMS = ["common", "geometry", "lcmtypes", "robot", "bridge", "sim", "control", "planner", "viewer_log", "launcher"]
SKIPPED = 77
# What is called from outside of the programs, and why.
KEPT = {
}
# No functions of ours: clones, guards, tables; and what every class has, written or not.
OURS = re.compile(r"^(?!.*(\[clone|guard variable|vtable|typeinfo|operator\(\)|operator new|operator delete))twinbus::")


def lines(*words, stdin=None):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, input=stdin, check=True).stdout.splitlines()


def symbols(objects):
    """(defined global functions {mangled: object}, names that are referred to)."""
    defined, used = {}, set()
    for file in objects:
        for line in lines("nm", "--defined-only", file):
            words = line.split()
            if len(words) == 3 and words[1] == "T":
                defined[words[2]] = file
        for line in lines("objdump", "-r", file):
            words = line.split()
            if len(words) == 3 and words[1].startswith("R_"):
                used.add(re.sub(r"[-+]0x[0-9a-f]+$", "", words[2]))
    return defined, used


def without_caller(objects):
    """[(function, object)]: constructors and destructors have several names for one."""
    defined, used = symbols(objects)
    names = sorted(defined)
    plain = dict(zip(names, lines("c++filt", stdin="\n".join(names) + "\n")))
    called = set(lines("c++filt", stdin="\n".join(sorted(used)) + "\n"))
    found = {plain[n]: defined[n] for n in names if OURS.match(plain[n]) and plain[n] not in called}
    return sorted((function, file) for function, file in found.items() if function.split("(")[0] not in KEPT)


def find_planted(build, objects):
    """A function without a caller is found."""
    file = build / "unlinked_test.o"
    text = "namespace twinbus { int planted(int x) { return x + 1; } int called(int x) { return x; } int main_of() { return called(1); } }"
    subprocess.run(["c++", "-O2", "-fPIC", "-xc++", "-c", "-", "-o", str(file)], input=text, text=True, check=True)
    found = [function for function, _ in without_caller([*objects, file])]
    file.unlink()
    return any("planted" in f for f in found) and not any("twinbus::called" in f for f in found)


def main():
    build = pathlib.Path(sys.argv[1])
    if not all((build / "bin" / name).exists() for name in ("twinbus", "twinbus_simulator", "twinbus_viewer", "twinbus_replay", "twinbus_gamepad")):
        print(f"skipped: the programs are not built in {build}")
        return SKIPPED
    objects = [file for room in ROOMS for file in sorted((build / room).rglob("*.o"))]
    found = without_caller(objects)
    for function, file in found:
        source = str(file.relative_to(build)).replace(".o", "")
        print(f"{re.sub(r'/CMakeFiles/[^/]*[.]dir', '', source)}: no program calls {function}: delete it, move it to test/, or give it a user")
    if not find_planted(build, objects):
        print("a planted function without a caller was not found")
        return 1
    print(f"{len(found)} functions without a caller in {len(objects)} objects")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
