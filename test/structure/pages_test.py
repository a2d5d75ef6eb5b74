#!/usr/bin/env python3
"""Every path that a page names exists: links of README.md, doc/, examples/ and the rooms, and paths between backquotes that begin
with a folder of the tree (without .h or .cpp too); and doc/protocol.md has every channel.
Functions that a page names, as `CommandGate::judge()`, are in the code.  README.md is short enough to be read.

    pages_test.py [FOLDER]
"""

import pathlib
import re
import subprocess
import sys

import lcm_channels

from report import report

README_LINES = 200
PAGES = re.compile(r"(README\.md|doc/[^/]+\.md|examples/[^/]+\.md|[a-z_]+/README\.md|config/robots/README\.md)")
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
HOLE = re.compile(r"(^|[/_])[A-Z]{3,}([/_.]|$)")  # test/ROOM, lcmtypes/NAME_t.lcm: for the reader to fill in
SPAN = re.compile(r"`([^`\n]+)`")
CALL = re.compile(r"^(?:([A-Z]\w*)::)?([a-z]\w*)\(\)$")  # `CommandGate::judge()`
PATH = re.compile(r"(?<![\w./{}~$-])((?:[A-Za-z0-9_]+/)+[A-Za-z0-9_.-]*[A-Za-z0-9_]/?)(?![\w*/<{}-])")


def check_protocol(root, problems):
    """The table of channels in doc/protocol.md has every channel, with the type and size of lcmtypes/bus."""
    page = (root / "doc/protocol.md").read_text()
    for channel, (kind, size) in lcm_channels.channels(root).items():
        if not re.search(rf"^\| [^|]*`{channel}`[^|]* \| `{kind}` \| {size} \|", page, re.MULTILINE):
            problems.append(f"doc/protocol.md: the table of channels in section 2 lacks {channel}, {kind}, {size} bytes: write that row")


def check(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "-co", "--exclude-standard"], capture_output=True, text=True, check=True)
    pages = [page for page in listed.stdout.splitlines() if PAGES.fullmatch(page) and (root / page).is_file()]
    code = "\n".join((root / file).read_text(errors="replace") for file in listed.stdout.splitlines()
                     if file.endswith((".h", ".cpp", ".cmake", "CMakeLists.txt", ".py")) and (root / file).is_file())
    words = set(re.findall(r"\w+", code))
    tops = {line.split("/")[0] for line in listed.stdout.splitlines() if "/" in line}
    problems = []
    for page in pages:
        for number, line in enumerate((root / page).read_text().splitlines(), 1):
            for link in LINK.findall(line):
                if not link.startswith(("http:", "https:")) and not (root / page).parent.joinpath(link).exists():
                    problems.append(f"{page}:{number}: links to {link}, which is not there: name the file that is")
            for span in SPAN.findall(line):
                call = CALL.match(span)
                if call and page != "doc/style.md" and not words.issuperset(filter(None, call.groups())):
                    problems.append(f"{page}:{number}: names {span}, which no code has: name the function that is there")
                for path in PATH.findall(span):
                    if HOLE.search(path) and "README" not in path:
                        continue
                    if path.split("/")[0] in tops and not any((root / (path + end)).exists() for end in ("", ".h", ".cpp")):
                        problems.append(f"{page}:{number}: names {path}, which is not there: name the file that is")
    lines = len((root / "README.md").read_text().splitlines())
    if lines > README_LINES:
        problems.append(f"README.md has {lines} lines, {README_LINES} are allowed: write it into a page of doc/ that the README leads to")
    check_protocol(root, problems)
    return problems


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    if not (root / ".git").exists():
        print("skipped: no git here")
        return 77
    return report(check(root))


if __name__ == "__main__":
    sys.exit(main())
