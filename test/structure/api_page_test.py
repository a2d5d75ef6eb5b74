#!/usr/bin/env python3
"""The API page that doc/Doxyfile describes can be made, and has every header with its comments.  Skipped, and said, without Doxygen."""

import html
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from report import files_of, report

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEFT_OUT = re.compile(r"_lanes\.h$|/self_collision_[^/]*$")  # EXCLUDE_PATTERNS of doc/Doxyfile
ROOMS = re.search(r"^ +(common .*)$", (ROOT / "doc/Doxyfile").read_text(), re.MULTILINE).group(1).split()
# A class, and a sentence of its header that its page is to have: a plain comment that doc/doxygen.sed made one of Doxygen's.
SENTENCES = {"classtwinbus_1_1robot_1_1Collision": "Stops at the first hit and says which.", "structtwinbus_1_1robot_1_1Joint": "reflected through the gear"}


def words_of(file):
    return " ".join(html.unescape(re.sub(r"<[^>]*>", " ", file.read_text(errors="replace"))).split())


def check(made):
    problems = []
    if not (made / "index.html").is_file():
        return ["doxygen wrote no index.html"]
    listed = words_of(made / "files.html")
    for header in files_of(ROOT):
        if header.endswith(".h") and header.split("/")[0] in ROOMS and not LEFT_OUT.search(header):
            if not re.search(rf"(?<![\w.]){re.escape(header.rsplit('/', 1)[1])}(?!\w)", listed):
                problems.append(f"{header} is not in the API page: see INPUT and EXCLUDE_PATTERNS of doc/Doxyfile")
    for page, sentence in SENTENCES.items():
        file = made / f"{page}.html"
        if not file.is_file() or sentence not in words_of(file):
            problems.append(f"the API page {page}.html lacks '{sentence}': doc/doxygen.sed no longer makes comments of ours those of Doxygen")
    return problems


def main():
    if shutil.which("doxygen") is None:
        print("skipped: no doxygen; apt-get install doxygen")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        settings = (ROOT / "doc/Doxyfile").read_text() + f"\nOUTPUT_DIRECTORY = {folder}\n"
        done = subprocess.run(["doxygen", "-"], input=settings, cwd=ROOT, capture_output=True, text=True, check=False)
        problems = [f"doxygen: {line}" for line in done.stderr.splitlines() if "error:" in line]
        if done.returncode != 0:
            problems.append(f"doxygen ended with {done.returncode}")
        return report(problems + check(pathlib.Path(folder) / "html"))


if __name__ == "__main__":
    sys.exit(main())
