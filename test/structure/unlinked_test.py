#!/usr/bin/env python3
"""Every function of the product is called by a program: one that only tests call, or nothing, is found in the object files.

    unlinked_test.py BUILD

A function counts as called when an object file of the product, its own included, refers to it (position-independent code refers
to every function by name).  Functions in headers are not looked at.  Skipped where the programs are not built, or not by GCC.
"""

import pathlib
import re
import subprocess
import sys

ROOMS = ["common", "geometry", "lcmtypes", "robot", "bridge", "sim", "control", "planner", "viewer_log", "launcher"]
SKIPPED = 77
ROOT = pathlib.Path(__file__).resolve().parents[2]
# twinbus::sim::World, as it is called here: World.
ROOM = re.compile(r"\btwinbus::(?:" + "|".join(ROOMS) + ")::")
# Called by nothing of the product, and kept: functions (without twinbus:: and room) by what uses them.
KEPT = {
    "tests and benches ask the product with them what the programs ask in other ways": """
        ArmPlanner::path_free ArticulatedWorld::resume BlockCheck::settle_by_pieces BlockCheck::settle_touching BlockScene::add_capsule
        Collision::in_collision Guard::check Guard::pair_count Guard::pairs Guard::unproved Guard::work
        InverseKinematics::pose JointReach::between fastest_time""",
    "stall tests and benches play operator and machine with them": """
        OneProcess::restart_controller OneProcess::say OneProcess::stall_controller Source::effective_command""",
    "the exact check of all pairs is for tools of one's own; tests and bench collision hold it": """
        SelfCollision::any_touching SelfCollision::enable SelfCollision::lower_bound SelfCollision::lower_bounds
        SelfCollision::surfaces_cross SelfCollision::use SelfCollision::work""",
    "one machine tests every instruction set with them": "lower_simd",
    "part of an interface for mains of others": "Options::rest",
    "a model from text is for tests, of a file for programs": "read_mjcf_model_text",
}
# Of several functions of one name.  A driver of a real robot speaks the other side of the wire; until there is one, tests,
# the fuzzer and unitree_probe do.
KEPT_OVERLOADS = re.compile(r"twinbus::(encode\(twinbus::LowCommand const&|decode\(std::span<std::byte const.*twinbus::LowReading&)")
# Linked by one program only, which is left out where its libraries are not there.
OPTIONAL = {"bridge/unitree/": "twinbus_face", "bridge/adaptors/unitree_dds/": "twinbus_face"}
KEPT_NAMES = {"twinbus::" + name for names in KEPT.values() for name in names.split()}
# No functions of ours: clones, guards, tables; and what every class has, written or not.
OURS = re.compile(r"^(?!.*(\[clone|guard variable|vtable|typeinfo|operator\(\)|operator new|operator delete))twinbus::")


def lines(*words, stdin=None):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, input=stdin, check=True).stdout.splitlines()


def symbols(objects):
    """(defined global functions {mangled: object}, names that are referred to)."""
    defined, used = {}, set()
    for line in lines("nm", "-A", "--defined-only", *objects):
        name, _, rest = line.rpartition(":")
        words = rest.split()
        if len(words) == 3 and words[1] == "T":
            defined[words[2]] = pathlib.Path(name)
    for line in lines("objdump", "-r", *objects):
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
    found = {ROOM.sub("twinbus::", plain[n]): defined[n] for n in names if OURS.match(plain[n]) and plain[n] not in called}
    return sorted((function, file) for function, file in found.items() if function.split("(")[0] not in KEPT_NAMES and not KEPT_OVERLOADS.match(function))


def source_of(file, build):
    return re.sub(r"/CMakeFiles/[^/]*[.]dir", "", str(file.relative_to(build)))[:-2]


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
    # Clang calls a function of the same file without its name.
    if any('CMAKE_CXX_COMPILER_ID "Clang"' in file.read_text() for file in build.glob("CMakeFiles/*/CMakeCXXCompiler.cmake")):
        print(f"skipped: the programs in {build} are not built by GCC")
        return SKIPPED
    # An object of a file that is gone lies about until somebody cleans up.
    objects = [file for room in ROOMS for file in sorted((build / room).rglob("*.o")) if (ROOT / source_of(file, build)).is_file()]
    absent = tuple(folder for folder, program in OPTIONAL.items() if not (build / "bin" / program).exists())
    found = [(function, file) for function, file in without_caller(objects) if not absent or not source_of(file, build).startswith(absent)]
    for function, file in found:
        print(f"{source_of(file, build)}: no program calls {function}: delete it, move it to test/, or give it a user")
    if not find_planted(build, objects):
        print("a planted function without a caller was not found")
        return 1
    print(f"{len(found)} functions without a caller in {len(objects)} objects")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
