#!/usr/bin/env python3
"""Sanitizer builds compile the files of a folder together: what stands in their unnamed namespaces must not share a name.

    unity_test.py            checks the tree this file is in
    unity_test.py FOLDER     checks another one (the test of this test does)

Looked at are constants, types, names for different types, and functions of the same parameters, in the rooms of the product and in their tests: which
files of a test program are compiled together changes with each file that comes.  A type of an unnamed namespace must not take the name of a type that another room's header gives and
another file of its folder uses: there the wrong one of both would be found.
"""

import collections
import pathlib
import re
import sys

from report import files_of, report

# Folders whose programs have one source each.
APART = (("test", "bench"), ("test", "fuzz"), ("test", "tools"))
OPENS, CLOSES = re.compile(r"^namespace \{"), re.compile(r"^\}  // namespace$")
TYPE = re.compile(r"^(?:struct|class|enum class|enum) (\w+)(?! *;)")
NAMED = re.compile(r"^(?:\[\[\w+\]\] )?(?:[\w:<>,&*]+ )+[&*]?(\w+)(\(.*|[\[={; ].*)$")
# Of a parameter its type: without name and default.
PARAMETER_NAME = re.compile(r"(?<=[\w>&*]) ?\b\w+(?: = [^,()]*)?(?=[,)])| = [^,()]*")


def named(line):
    """What a line at the left edge of an unnamed namespace declares; None: nothing that could clash."""
    if found := TYPE.match(line):
        return found[1]
    if found := re.match(r"using (\w+) =", line):
        return found[1]
    if line.startswith(("template", "using ", "namespace ")) or not (found := NAMED.match(line)):
        return None
    if not found[2].startswith("("):
        return found[1]
    return found[1] + PARAMETER_NAME.sub("", found[2].split(")")[0] + ")").replace(" ", "")


ALSO = re.compile(r",\s*(k[A-Z]\w*)\s*(?==[^=]|\{)")  # constexpr double kOne = 1.0, kTwo = 2.0;


def names_of(text):
    inside = False
    for number, line in enumerate(text.splitlines(), 1):
        if OPENS.match(line) or CLOSES.match(line):
            inside = line.startswith("namespace {")
        elif inside and (line[:1].isalpha() or line.startswith("[[")):
            if name := named(line):
                yield name, number, line
            if line.startswith("constexpr "):
                for also in ALSO.findall(line):
                    yield also, number, line


def hidden_types(root, found):
    """Types of unnamed namespaces that hide a type of some header from another file of their folder."""
    given, folders = {}, collections.defaultdict(list)
    for name in files_of(root):
        path = pathlib.PurePath(name)
        if path.parts[0] in ("test", "examples"):
            continue
        if path.suffix == ".h":
            given.update((line[1], name) for line in re.finditer(TYPE.pattern, (root / name).read_text(), re.MULTILINE))
        elif path.suffix == ".cpp" and not path.stem.endswith("main"):
            folders[path.parent].append(name)
    for (folder, what), places in sorted(found.items(), key=lambda item: item[1]):
        if what not in given or not what[:1].isupper():
            continue
        own = {place[0] for place in places}
        for other in folders[folder]:
            if other not in own and re.search(rf"\b{what}\b", (root / other).read_text()):
                yield (f"{places[0][0]}:{places[0][1]}: {what} hides that of {given[what]} from {other}, because sanitizer builds compile both together: "
                       "give it another name")


def check(root):
    found = collections.defaultdict(list)
    for name in files_of(root):
        path = pathlib.PurePath(name)
        if path.suffix == ".cpp" and not path.stem.endswith("main") and path.parts[0] != "examples" and path.parts[:2] not in APART:
            for what, number, line in names_of((root / name).read_text()):
                found[path.parent, what].append((name, number, line))
    problems = list(hidden_types(root, found))
    for (_, what), places in sorted(found.items(), key=lambda item: item[1]):
        files, lines = ({place[k] for place in places} for k in (0, 2))
        if len(files) > 1 and (len(lines) > 1 or not places[0][2].startswith("using ")):
            first, second = (f"{name}:{number}" for name, number, _ in places[:2])
            problems.append(f"{second}: {what} stands in {first}, too, and sanitizer builds compile both together: "
                            "give one another name, or move it into a header that both include")
    return problems


if __name__ == "__main__":
    sys.exit(report(check(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2]))))
