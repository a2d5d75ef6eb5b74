#!/usr/bin/env python3
"""Every path that a page names exists: links of README.md, doc/, examples/ and the rooms, and paths between backquotes that begin
with a folder of the tree (without .h or .cpp too).

    pages_test.py [FOLDER]
"""

import pathlib
import re
import subprocess
import sys

PAGES = re.compile(r"(README\.md|doc/[^/]+\.md|examples/[^/]+\.md|[a-z_]+/README\.md|config/robots/README\.md)")
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
SPAN = re.compile(r"`([^`\n]+)`")
PATH = re.compile(r"(?<![\w./{}~$-])((?:[A-Za-z0-9_]+/)+[A-Za-z0-9_.-]*[A-Za-z0-9_]/?)(?![\w*/<{}-])")


def check(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "-co", "--exclude-standard"], capture_output=True, text=True, check=True)
    pages = [page for page in listed.stdout.splitlines() if PAGES.fullmatch(page) and (root / page).is_file()]
    tops = {line.split("/")[0] for line in listed.stdout.splitlines() if "/" in line}
    problems = []
    for page in pages:
        for number, line in enumerate((root / page).read_text().splitlines(), 1):
            for link in LINK.findall(line):
                if not link.startswith(("http:", "https:")) and not (root / page).parent.joinpath(link).exists():
                    problems.append(f"{page}:{number}: links to {link}, which is not there: name the file that is")
            for span in SPAN.findall(line):
                for path in PATH.findall(span):
                    if path.split("/")[0] in tops and not any((root / (path + end)).exists() for end in ("", ".h", ".cpp")):
                        problems.append(f"{page}:{number}: names {path}, which is not there: name the file that is")
    return problems


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    if not (root / ".git").exists():
        print("skipped: no git here")
        return 77
    problems = check(root)
    print("\n".join(problems + [f"{len(problems)} problems"]))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
