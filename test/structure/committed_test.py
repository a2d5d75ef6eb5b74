#!/usr/bin/env python3
"""A clean clone has all that its build names: sources of every CMakeLists.txt, included headers, scripts, schema files.

A file that is on one disk only breaks the build of everybody else.  Skipped where there is no git checkout.
"""

import pathlib
import posixpath
import re
import subprocess
import sys

from report import report

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77
NAME = re.compile(r"[\w./-]+\.(?:cpp|c|in|py|sh|java|lcm|cmake|yaml)")
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
GENERATED = re.compile(r"twinbus/\w+_t\.hpp$|^message_schemas\.inc$|^lcmtypes/(bus/(wire_table|older_messages|message_\w+)|msg/(messages|labels))\.h$")


def named_sources(folder, text):
    """Files that a CMakeLists.txt of this folder names, as (path from the root, name as written)."""
    for token in re.split(r'[\s()"]+', re.sub(r"#.*", "", text)):
        here = posixpath.join(folder, token.replace("${CMAKE_CURRENT_SOURCE_DIR}/", ""))
        path = re.sub(r"^.*\$\{(PROJECT|CMAKE)_SOURCE_DIR\}/", "", here)
        if NAME.fullmatch(path):
            yield posixpath.normpath(path), posixpath.normpath(token)


def missing(files, read):
    """Problems of a tree: files is the set of its paths, read(path) gives the text of one."""
    problems = []
    for path in sorted(files):
        folder, name = posixpath.split(path)
        if name == "CMakeLists.txt":
            for source, name_from_root in named_sources(folder, read(path)):
                if source not in files and name_from_root not in files:
                    problems.append(f"{path}: names {source}, which is not committed")
        elif name.endswith((".h", ".cpp")):
            text = read(path)
            for header in INCLUDE.findall(text):
                beside = posixpath.normpath(posixpath.join(folder, header))
                optional = f'__has_include("{header}")' in text
                if not (header in files or beside in files or optional or GENERATED.search(header)):
                    problems.append(f"{path}: includes {header}, which is not committed")
    return problems


def git(*words):
    return subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True, check=True).stdout


def planted_mistakes_are_found():
    good = {"a/CMakeLists.txt": "add_library(a x.cpp ../b/y.cpp ${PROJECT_SOURCE_DIR}/b/y.cpp)  # old.cpp\n",
            "a/x.cpp": '#include "a/x.h"\n#include "twinbus/stop_t.hpp"\n', "a/x.h": "", "b/y.cpp": ""}
    assert missing(set(good), good.get) == [], missing(set(good), good.get)
    for gone, user in (("b/y.cpp", "a/CMakeLists.txt"), ("a/x.h", "a/x.cpp")):
        found = missing(set(good) - {gone}, good.get)
        assert found and all(p.startswith(user) and gone in p for p in found), (gone, found)


def main():
    planted_mistakes_are_found()
    try:
        listed = set(git("ls-files").splitlines())
        commit = set(git("ls-tree", "-r", "--name-only", "HEAD").splitlines())
    except (OSError, subprocess.CalledProcessError):
        print("skipped: not a git checkout")
        return SKIPPED
    # What is on disk may name only what git knows; what is committed only what is committed.
    on_disk = {path for path in listed if (ROOT / path).is_file()}
    problems = missing(on_disk, lambda path: (ROOT / path).read_text(encoding="utf-8"))
    builds = [path for path in commit if path.endswith("CMakeLists.txt")]
    texts = {path: git("show", f"HEAD:{path}") for path in builds}
    for path in builds:
        for source, name_from_root in named_sources(posixpath.dirname(path), texts[path]):
            if source not in commit and name_from_root not in commit:
                problems.append(f"HEAD: {path}: names {source}, which is not in the commit")
    return report(problems, f" in {len(on_disk)} files")


if __name__ == "__main__":
    sys.exit(main())
