#!/usr/bin/env python3
"""What is written twice: pairs of places that share six lines or more, the same or the same but for names, numbers and texts.

    duplicates_test.py            checks the tree this file is in
    duplicates_test.py FOLDER     checks another one (the test of this test does)

Blank lines, comments, includes and lone brackets are passed over.  Rows of declarations, tables and lists of arguments have few
shapes and count for nothing: of six lines four are to differ in more than names.  What stands in more than eight places is an idiom.
At most MOST_PAIRS pairs of files are let stand, and no place that is the same to the letter over more than MOST_SAME lines.
"""

import collections
import pathlib
import re
import sys

from report import files_of, report

LINES, SHAPES = 6, 4
MOST_PAIRS, MOST_SAME = 40, 8
TOO_COMMON = 8  # places: an idiom, such as how a command begins
CODE = {".h", ".cpp", ".py", ".js", ".sh", ".cmake"}
MADE = re.compile(r"^viewer_log/web/dist/|\.pyi$")  # by other files
PASSED_OVER = re.compile(r"(#\s*(include|pragma|if|endif|define)|//|#|import |from \S+ import |using |namespace |}\s*//|[\W_]*$|\"\"\")")
WORD = re.compile(r"\"(?:[^\"\\]|\\.)*\"|'(?:[^'\\]|\\.)*'|[A-Za-z_]\w*|\d[\w.]*")
KEYWORDS = set("""if else for while do return switch case default break continue const constexpr static auto void bool int double float
    struct class enum template typename public private override noexcept new delete throw try catch true false nullptr this
    def in not and or is None True False with as raise except finally lambda yield let function assert EXPECT_EQ EXPECT_NEAR EXPECT_LT
    EXPECT_GT EXPECT_TRUE EXPECT_FALSE ASSERT_EQ ASSERT_TRUE TEST std""".split())


class Line:
    """One line of a file: its number, its text, and its shape, which names, numbers and texts do not change."""

    def __init__(self, number, text):
        self.number, self.text = number, text
        self.shape = WORD.sub(lambda match: match.group(0) if match.group(0) in KEYWORDS else "x", text)


def lines_of(text):
    lines = []
    for number, line in enumerate(text.splitlines(), 1):
        folded = " ".join(line.split())
        if not PASSED_OVER.match(folded):
            lines.append(Line(number, folded))
    return lines


def runs(files):
    """((file, first, last), (file, first, last), same lines) of the longest alike runs, each pair of places once."""
    places = collections.defaultdict(list)
    for name, lines in files.items():
        for i in range(len(lines) - LINES + 1):
            shapes = tuple(line.shape for line in lines[i:i + LINES])
            if len(set(shapes)) >= SHAPES:
                places[shapes].append((name, i))
    found, taken = [], set()
    for here in places.values():
        if not 1 < len(here) <= TOO_COMMON:
            continue
        for n, (file_a, a) in enumerate(here):
            for file_b, b in here[n + 1:]:
                if (file_a, a, file_b, b) in taken or (file_a == file_b and b - a < LINES):
                    continue
                one, other = files[file_a], files[file_b]
                length = LINES
                while (a + length < len(one) and b + length < len(other) and one[a + length].shape == other[b + length].shape
                       and (file_a != file_b or a + length < b)):
                    length += 1
                for step in range(length):
                    taken.add((file_a, a + step, file_b, b + step))
                same = longest(one[a + k].text == other[b + k].text for k in range(length))
                found.append(((file_a, one[a].number, one[a + length - 1].number),
                              (file_b, other[b].number, other[b + length - 1].number), length, same))
    return found


def longest(flags):
    most = now = 0
    for flag in flags:
        now = now + 1 if flag else 0
        most = max(most, now)
    return most


def check(root):
    files = [file for file in files_of(root) if pathlib.PurePath(file).suffix in CODE and not MADE.search(file)]
    found = runs({file: lines_of((root / file).read_text(encoding="utf-8", errors="replace")) for file in files})
    longest_of = {}  # of each pair of files
    for run in sorted(found, key=lambda run: run[2]):
        longest_of[run[0][0], run[1][0]] = run
    sentence = "{}:{}-{} and {}:{}-{} say the same in {} lines: let one piece of code serve both"
    problems = [sentence.format(*a, *b, length) + f" ({same} of them to the letter, the most are {MOST_SAME})"
                for a, b, length, same in found if same > MOST_SAME]
    rows = [sentence.format(*a, *b, length) for a, b, length, _ in sorted(longest_of.values(), key=lambda run: -run[2])]
    if len(rows) > MOST_PAIRS:
        problems += rows + [f"{len(rows)} pairs of places are alike, the most are {MOST_PAIRS}"]
    return problems, rows


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    problems, rows = check(root)
    return report(problems, f", {len(rows)} pairs of places are alike (at most {MOST_PAIRS})")


if __name__ == "__main__":
    sys.exit(main())
