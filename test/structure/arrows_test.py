#!/usr/bin/env python3
"""The structure of the tree: arrows between folders, a namespace per room, one of everything, third-party headers outside their one door, sizes
of files and folders, pages that are cited, and traces of one machine.

    arrows_test.py            checks the tree this file is in
    arrows_test.py FOLDER     checks another one (the test of this test does)

The arrows are the PUBLIC and PRIVATE lists of twinbus_folder() in the CMakeLists.txt of each room.
"""

import os
import pathlib
import re
import sys

from report import files_of, report

ROOMS = ["common", "geometry", "lcmtypes", "robot", "bridge", "sim", "control", "planner", "viewer_log", "launcher", "python"]

# Mains tie rooms together: main.cpp, *_main.cpp, *_main.h.  Adaptors are shared objects of their own.
MAIN = re.compile(r"(^|[/_])main\.(cpp|h)$")
ADAPTORS = "bridge/adaptors/"

# The bus is used by mains and the launcher only.
BUS = "lcmtypes/bus"
BUS_USERS = ("lcmtypes/", "launcher/")

# Headers -> files that may include them.
DOORS = {
    r"ode/": r"sim/engine/ode[a-z_]*\.(cpp|h)",
    r"fcl/|ccd/": r"no file of the product: test/oracles/fcl_oracle\.cpp",
    r"urdf_parser/|urdf_model/|urdf_exception/": r"robot/description/urdf\.cpp",
    r"expat": r"common/text/xml\.cpp",
    r"SDL": r"control/teleop/sdl_pad\.cpp",
    r"boost/beast|boost/asio": r"viewer_log/server/web_server\.cpp",
    r"nanobind/": r"python/native_main\.cpp",
    r"lcm/": r"lcmtypes/bus/[a-z_]+\.(cpp|h)",
    r"dds/|unitree_(hg|go|api)\.h": r"bridge/adaptors/unitree_dds/unitree_dds\.cpp",
}

# "About 200" and "about 450": a tenth more is still about.
HEADER_CEILING = 220
SOURCE_CEILING = 495
FOLDER_CEILING = 30  # C++ files of a folder
TEST_FOLDER_CEILING = 40

MACHINE = re.compile(r"/(home|work|Users|root|tmp/[a-z]+_clone)/[A-Za-z0-9_.-]+")
# TWINBUS_KERNEL_FILE names what common/simd/fused_kernels.h includes for each instruction set.
INCLUDE = re.compile(r'^\s*#\s*(?:include|define TWINBUS_KERNEL_FILE)\s+([<"])([^>"]+)[>"]', re.MULTILINE)
CODE = {".h", ".cpp", ".c", ".cc", ".hpp", ".inl"}
TEXT = CODE | {".py", ".sh", ".yaml", ".yml", ".txt", ".md", ".cmake", ".json", ".lcm", ".java", ".urdf", ".srdf", ".nft", ""}
TYPE = re.compile(r"^(?:class|struct|enum class)\s+(?:alignas\([^)]*\)\s+)?([A-Z]\w*)(?:\s+final)?\s*(?::[^:][^{;]*)?\{", re.MULTILINE)
# What is opened, up to what closes it; a block that only declares may be of another room.
NAMESPACE = re.compile(r"^(?:inline )?namespace (twinbus\S*(?: \w+)?(?:::\w+)*) \{\n(.*?)^\}", re.MULTILINE | re.DOTALL)
DECLARES = re.compile(r"(\s|//[^\n]*\n|template <[^>\n]*>\n|(class|struct|enum class) \w+( : [\w:]+)?;)*")
PAGE = re.compile(r"(?<![\w/.-])((?:[A-Za-z0-9_-]+/)*[A-Za-z0-9_-]+\.md)\b")

STARTED = re.compile(r"test/bench/(bench|chart)_\w+\.py")  # by ./twinbus bench and chart


def declared(files, read):
    """{folder: (public, private)} of every twinbus_folder() call."""
    arrows = {}
    for file in files:
        if not re.fullmatch(r"[a-z_]+/CMakeLists\.txt", file):
            continue
        for call in re.findall(r"^twinbus_folder\(([^)]*)\)", re.sub(r"#.*", "", read(file)), re.MULTILINE):
            lists = {"": [], "PUBLIC": [], "PRIVATE": [], "LIBRARIES": []}
            now = ""
            for word in call.split():
                if word in lists and word:
                    now = word
                else:
                    lists[now].append(word)
            arrows[lists[""][0]] = (set(lists["PUBLIC"]), set(lists["PRIVATE"]))
    return arrows


def circles(arrows, problems):
    state = {}

    def visit(folder, way):
        if state.get(folder) == "done":
            return
        if folder in way:
            ring = way[way.index(folder):] + [folder]
            problems.append(f"{folder.split('/')[0]}/CMakeLists.txt: a circle of folders: {' -> '.join(ring)}; "
                            "move what both need into a folder below them")
            return
        for other in sorted(set().union(*arrows.get(folder, (set(), set())))):
            visit(other, way + [folder])
        state[folder] = "done"

    for folder in sorted(arrows):
        visit(folder, [])


def check_arrows(code, problems, arrows):
    """Includes against the arrows, and arrows against the includes."""
    used = {folder: set() for folder in arrows}
    for file, text in code.items():
        room = file.split("/")[0]
        if room not in ROOMS or file.startswith(ADAPTORS):
            continue
        folder = os.path.dirname(file)
        is_main = bool(MAIN.search(file))
        if folder not in arrows and not is_main:
            problems.append(f"{file}: {folder} is in no twinbus_folder() of {room}/CMakeLists.txt: add it there with its arrows")
            continue
        for _, header in INCLUDE.findall(text):
            there = os.path.dirname(header)
            if header.startswith("twinbus/") and header.endswith("_t.hpp") or there == BUS:
                if not file.startswith(BUS_USERS) and not is_main:
                    problems.append(f"{file}: includes {header}; only mains, launcher/ and lcmtypes/ know the bus")
                    continue
            if header.startswith("test/"):
                problems.append(f"{file}: includes {header}; the product needs no test")
                continue
            if there.split("/")[0] not in ROOMS or there == folder or is_main or there.startswith(ADAPTORS.rstrip("/")):
                continue
            public, private = arrows[folder]
            used[folder].add(there)
            if there not in public | private:
                problems.append(f"{file}: includes {header}; no arrow leads from {folder} to {there}: see twinbus_folder({folder} "
                                f"in {room}/CMakeLists.txt")
            elif there in private and there not in public and file.endswith(".h"):
                problems.append(f"{file}: a header includes {header}, but {there} is PRIVATE in twinbus_folder({folder}: make it PUBLIC")
    for folder, (public, private) in arrows.items():
        for other in sorted((public | private) - used[folder]):
            problems.append(f"{folder.split('/')[0]}/CMakeLists.txt: twinbus_folder({folder} names {other}, which no file there includes: "
                            "take it out")
    circles(arrows, problems)


def check_namespaces(code, problems):
    """What a room of the product defines is in its namespace, which is inline: twinbus::World is twinbus::sim::World.  Kernels,
    which are included inside a namespace, have no #pragma once."""
    for file, text in code.items():
        room = file.split("/")[0]
        if room not in ROOMS or room == "python" or os.path.splitext(file)[1] == ".c":
            continue
        own = f"twinbus::inline {room}"
        blocks = NAMESPACE.findall(text)
        for name, inside in blocks:
            if name != own and not name.startswith(own + "::") and not DECLARES.fullmatch(inside):
                problems.append(f"{file}: defines something in namespace {name}: open it with `namespace {own} {{`")
        opened = any(name == own or name.startswith(own + "::") for name, _ in blocks)
        if not opened and re.search(r"^(class|struct|enum class|namespace) [^;\n]*\{$", text, re.MULTILINE):
            if not MAIN.search(file) and (file.endswith(".cpp") or re.search(r"^#pragma once", text, re.MULTILINE)):
                problems.append(f"{file}: defines something outside the namespace of its room: put it into `namespace {own} {{`")


def check_types(code, problems):
    """One definition of every type name (kernels that are compiled once per instruction set apart): rooms are inline namespaces, and
    of two rooms' types of one name twinbus::NAME says neither."""
    seen = {}
    for file, text in code.items():
        room = file.split("/")[0]
        if room not in ROOMS or not file.endswith(".h") or "#pragma once" not in text:
            continue
        for name in TYPE.findall(text):
            first = seen.setdefault(name, file)
            if first != file and first.split("/")[0] == room:
                problems.append(f"{file}: {name} is defined in {first} too: one program that links both is broken; rename one")
            elif first != file:
                problems.append(f"{file}: {name} is defined in {first} too, of another room: twinbus::{name} would be ambiguous; rename one")


def check_users(code, problems):
    """Every header of the product is included by the product."""
    included = {header for file, text in code.items() if file.split("/")[0] in ROOMS for _, header in INCLUDE.findall(text)
                if header.rsplit(".", 1)[0] != file.rsplit(".", 1)[0]}
    for file in code:
        if file.split("/")[0] in ROOMS and file.endswith(".h") and file not in included:
            if not any(os.path.basename(file) == header for header in included):
                problems.append(f"{file}: no file of the product includes it: give it a user, move it to test/, or delete it")


def check_sizes(files, code, problems):
    folders = {}
    for file in files:
        if os.path.splitext(file)[1] in CODE:
            folders[os.path.dirname(file)] = folders.get(os.path.dirname(file), 0) + 1
    for folder, count in sorted(folders.items()):
        most = TEST_FOLDER_CEILING if folder.startswith("test") else FOLDER_CEILING
        if count > most:
            problems.append(f"{folder}: {count} C++ files, the ceiling is {most}: divide the folder by what its files are about")
    for file, text in code.items():
        lines = text.count("\n")
        ceiling = HEADER_CEILING if file.endswith((".h", ".hpp")) else SOURCE_CEILING
        if lines > ceiling and not file.startswith("test/"):
            problems.append(f"{file}: {lines} lines, the ceiling is {ceiling}: two ideas, find the seam")


def check_doors(code, problems):
    for file, text in code.items():
        if file.split("/")[0] in ("test", "examples"):
            continue  # oracles of tests and programs of users may look behind the doors
        for _, header in INCLUDE.findall(text):
            for pattern, door in DOORS.items():
                if re.match(pattern, header) and not re.fullmatch(door, file):
                    problems.append(f"{file}: includes <{header}>; its door is {door}")


def check_pages(files, texts, problems):
    """Every page that is cited exists."""
    names = {os.path.basename(f) for f in files}
    for file, text in texts.items():
        if file.startswith("test/structure/"):
            continue
        for page in PAGE.findall(text):
            if page not in files and os.path.basename(page) not in names:
                problems.append(f"{file}: cites {page}, which is not there: write the page or name the one that is")


def check(root):
    problems = []
    files = files_of(root)
    texts = {}
    for file in files:
        path = root / file
        if STARTED.fullmatch(file) and not os.access(path, os.X_OK):
            problems.append(f"{file}: the launcher starts it, so it must be executable: chmod +x")
        if path.suffix not in TEXT or "package-lock" in file or "/web/" in file:
            continue
        try:
            texts[file] = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        if not file.endswith("arrows_test.py"):
            for number, line in enumerate(texts[file].splitlines(), 1):
                if MACHINE.search(line):
                    problems.append(f"{file}:{number}: a path of one machine: {MACHINE.search(line).group(0)}")
    code = {f: t for f, t in texts.items() if os.path.splitext(f)[1] in CODE}
    check_arrows(code, problems, declared(files, lambda f: texts.get(f, "")))
    check_namespaces(code, problems)
    check_types(code, problems)
    check_users(code, problems)
    check_sizes(files, code, problems)
    check_doors(code, problems)
    check_pages(set(files), texts, problems)
    return problems


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    return report(check(root))


if __name__ == "__main__":
    sys.exit(main())
