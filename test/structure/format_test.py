#!/usr/bin/env python3
"""No line of C++ that clang-format would never write: what a hand leaves, found without clang-format.

Full layout is clang-format's (.clang-format); this holds what can be told from one line, in every file.
"""

import pathlib
import re
import subprocess
import sys

from report import report

ROOT = pathlib.Path(__file__).resolve().parents[2]
WIDEST = 130  # columns of the product
RULES = [
    (re.compile(r"\t"), "a tab: two spaces"),
    (re.compile(r"[ \r]+$"), "blanks at the end of the line: take them out"),
    (re.compile(r"^\s*(?:\}\s*else\s+)?(?:if|for|while|switch)\("), "a space before ("),
    (re.compile(r"\)\{$"), "a space between ) and {"),
    (re.compile(r"\}else\b|\belse\{"), "spaces around else"),
    (re.compile(r"^\s*(?:if|for|while)\b[^\"'/]*\( \S"), "no space behind ("),
    (re.compile(r"[^\s(\"'/*<>,:&]\s*,[^\s\"')}>|\\]"), "a space behind the comma"),
    (re.compile(r"^(?: {2})* (?=(?:if|for|while|return|const|int|double|auto|void|bool)\b)"), "indent by two spaces or line up with what is continued"),
]
STRING = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\'|//[^\n]*|/\*.*?\*/', re.DOTALL)


def blanked(text):
    """Strings and comments without their inside, as many lines as before."""
    return STRING.sub(lambda m: '""' + "\n" * m[0].count("\n"), text)


def problems_of(name, text):
    found = []
    if text and not text.endswith("\n") or text.endswith("\n\n"):
        found.append(f"{name}: ends with one newline, no more and no less")
    whole, bare = text.split("\n"), blanked(text).split("\n")
    for number, (line, code) in enumerate(zip(whole, bare), 1):
        if len(line) > WIDEST and not name.startswith("test/") and len(line.split("//")[0].rstrip()) > WIDEST and not STRING.search(line):
            found.append(f"{name}:{number}: {len(line)} columns, the most are {WIDEST}: clang-format-14 -i {name}")
        for rule, what in RULES[:2]:
            if rule.search(line):
                found.append(f"{name}:{number}: {what}")
        for rule, what in RULES[2:7 if len(whole) == len(bare) else 2]:
            if rule.search(code):
                found.append(f"{name}:{number}: not formatted ({what}): clang-format-14 -i {name}")
    return found


PLANTED = ["int a;\t// x", "int a; ", "  if(a) return;", "void f(){", "  } else{", "  f(1,2);", "int " + "a" * 90 + " = " + "b" * 90 + ";"]


def main():
    for line in PLANTED:
        if not problems_of("planted.cpp", line + "\n"):
            print(f"not found: {line!r}")
            return 1
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard", "*.cpp", "*.h"], capture_output=True, text=True)
    names = listed.stdout.splitlines() or [str(p.relative_to(ROOT)) for p in ROOT.rglob("*.[ch]*")
                                           if p.suffix in (".h", ".cpp") and not p.is_relative_to(ROOT / "build")]
    problems = [p for name in names if (ROOT / name).is_file() for p in problems_of(name, (ROOT / name).read_text())]
    return report(problems, f" in {len(names)} files", most=200)


if __name__ == "__main__":
    sys.exit(main())
