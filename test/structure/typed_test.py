#!/usr/bin/env python3
"""Whoever prints ./twinbus prints what is typed where the program runs: through common/process/command_word.h, which says twinbus in
an installation.  Exceptions, help texts and events go through it where they are shown."""

import pathlib
import re
import subprocess
import sys

from report import report

ROOT = pathlib.Path(__file__).resolve().parents[2]
# A call that prints at once, up to its semicolon.
PRINT = re.compile(r"std::(?:printf|fprintf|puts|fputs)\((?:[^;\"]|\"(?:[^\"\\]|\\.)*\")*;")


def untyped(text):
    """Line numbers of prints that name the program."""
    return [text.count("\n", 0, found.start()) + 1 for found in PRINT.finditer(text) if "./twinbus" in found[0] and "as_typed" not in found[0]]


def main():
    assert untyped('std::printf("a; b");\n  std::fprintf(stderr,\n "see ./twinbus status\\n");') == [2]
    assert untyped('std::fputs(as_typed("./twinbus").c_str(), out); print_typed(stdout, "./twinbus");') == []
    files = subprocess.run(["git", "ls-files", "*.cpp", "*.h"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    wrong = [f"{file}:{line}: print_typed() of common/process/command_word.h prints what is typed here"
             for file in files if not file.startswith(("test/", "examples/")) and (ROOT / file).is_file()
             for line in untyped((ROOT / file).read_text())]
    return report(wrong)


if __name__ == "__main__":
    sys.exit(main())
