#!/usr/bin/env python3
"""doc/files.md lists every source file with what stands at its top, so that a word of the task finds the file.

    files_page_test.py            says what is missing or old
    files_page_test.py --write    writes the page anew

A header and a source of one name are one row.  Unit tests have no rows: they lie in test/ under the name of what they test.
"""

import ast
import pathlib
import re
import subprocess
import sys

from report import report

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "doc/files.md"
HEAD = """# Every source file and what it is for

Search this page for a word of what you want to change; `doc/architecture.md` says how the rooms fit together. Written by
`test/structure/files_page_test.py --write` from the first lines of the files; unit tests lie in `test/` under the name of what they test.
"""
KINDS = (".h", ".cpp", ".py", ".js", ".lcm", ".sh", ".cmake")
MOST = 400  # characters of a row


def listed(name):
    file = pathlib.PurePosixPath(name)
    if "dist" in file.parts or file.name in ("__init__.py", "conftest.py") or re.search(r"_test\.(cpp|mjs|js)$", file.name):
        return False
    if name.startswith("test/bench/campaigns/"):
        return file.suffix == ".yaml"
    return file.suffix in KINDS or file.name == "CMakeLists.txt" and len(file.parts) <= 2 or name == "twinbus"


def marked(text, mark):
    """The comment of lines that begin with mark, before anything else but directives."""
    lines = []
    for line in text.splitlines():
        if line.startswith(mark) and not line.startswith("#!"):
            lines.append(line[len(mark):].strip())
        elif lines:
            break
        elif line.strip() and not line.startswith(("#!", "package ", "set -", "#include", "#pragma")):
            break
    return " ".join(lines)


def about(file):
    """What stands at the top of a file, or ""."""
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".py":
        text = ast.get_docstring(ast.parse(text)) or ""
    else:
        text = marked(text, "//" if file.suffix in (".h", ".cpp", ".js", ".lcm") else "#")
    text = re.sub(r"\s*\{\w+\}$", "", " ".join(text.split()))
    if len(text) > MOST:
        end = max(text.rfind(". ", 0, MOST), text.rfind("; ", 0, MOST), text.rfind(": ", 0, MOST))
        text = text[:end if end > 60 else MOST].rstrip(";:. ") + "."
    return text.replace("|", "\\|").replace("<", "&lt;")


def rows(names):
    """{folder: [(files, text)]} and what has nothing at its top."""
    there, found, problems = set(names), {}, []
    for name in names:
        file = pathlib.PurePosixPath(name)
        if file.suffix == ".cpp" and str(file.with_suffix(".h")) in there:
            continue
        text = about(ROOT / name)
        if not text:
            problems.append(f"{name}: begins with no comment; say in its first line what is in it, for doc/files.md")
        both = f"`{file.name}`" + (" `.cpp`" if file.suffix == ".h" and str(file.with_suffix(".cpp")) in there else "")
        found.setdefault(str(file.parent), []).append((both, text))
    return found, problems


def main():
    if not (ROOT / ".git").exists():
        print("skipped: no git here")
        return 77
    names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    found, problems = rows([name for name in names if listed(name) and (ROOT / name).exists()])
    text = HEAD
    for folder in sorted(found):
        text += f"\n## {'The top' if folder == '.' else folder}\n\n| file | what is in it |\n| --- | --- |\n"
        text += "".join(f"| {files} | {words} |\n" for files, words in found[folder])
    if "--write" in sys.argv[1:]:
        PAGE.write_text(text, encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != text:
        problems.append("doc/files.md is not what the first lines of the files say; run: test/structure/files_page_test.py --write")
    return report(problems, f" in {sum(map(len, found.values()))} rows")


if __name__ == "__main__":
    sys.exit(main())
