#!/usr/bin/env python3
"""Damaged robot files: what an XML checker rejects is never loaded, nor a name that is misspelt; both are told with the line.

mutated_files_test.py [MALFORMED MISSPELT [SEED]]: how many of each; default 600 and 300, seed 1.
The checker is the expat of Python, and xmllint where it is installed.
"""

import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import xml.parsers.expat

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ.get("TWINBUS_BIN", ROOT / "build/release/bin"))
LETTERS = "abcdefghijklmnopqrstuvwxyz_"


def rejected(text):
    try:
        xml.parsers.expat.ParserCreate().Parse(text, True)
    except xml.parsers.expat.ExpatError:
        return True
    return False


def malformed(rng, text):
    """The text after one to three edits such as a hand or a disk makes."""
    data = bytearray(text)
    for _ in range(rng.randint(1, 3)):
        if not data:
            break
        at = rng.randrange(len(data))
        kind = rng.randrange(8)
        if kind == 0:
            del data[at:at + rng.choice((1, 1, 2, 20, 400))]
        elif kind == 1:
            data[at] = rng.randrange(1, 256)
        elif kind == 2:
            data[at:at] = bytes([rng.choice(b"<>&\"'/=;-!?]\x01\x7f\xff")])
        elif kind == 3:  # inside a number
            at = rng.choice([m.start() + 1 for m in re.finditer(rb"[0-9][0-9]", data)] or [at])
            data[at:at] = rng.choice((b"&", b"<", b"\"", b"&#", b"&amp", b"&;"))
        elif kind == 4:
            quotes = [m.start() for m in re.finditer(rb"[\"'<>/=]", data)]
            del data[rng.choice(quotes or [at])]
        elif kind == 5:
            at2 = rng.randrange(len(data))
            data[at:at] = data[at2:at2 + rng.randrange(1, 60)]
        elif kind == 6:  # cut off
            data[at:] = b"\n"
        else:  # an attribute twice
            found = list(re.finditer(rb" [a-z_]+=\"[^\"]*\"", data))
            if found:
                one = rng.choice(found)
                data[one.end():one.end()] = one.group()
    return bytes(data)


def other_name(rng, name):
    letters = list(name)
    for _ in range(rng.randint(1, 2)):
        at = rng.randrange(len(letters))
        kind = rng.randrange(3)
        if kind == 0 and len(letters) > 3:
            del letters[at]
        elif kind == 1:
            letters.insert(at, rng.choice(LETTERS))
        else:
            letters[at] = rng.choice(LETTERS)
    return "".join(letters)


def names_of(text):
    """Where names of elements and attributes stand: (begin, end, name, end tag or None)."""
    found = []
    for tag in re.finditer(r"<([A-Za-z_][\w]*)((?:\s+[\w:]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*)\s*(/?)>", text):
        found.append((tag.start(1), tag.end(1), tag.group(1), tag))
        for attribute in re.finditer(r"\s([A-Za-z_]\w*)\s*=\s*(?:\"[^\"]*\"|'[^']*')", tag.group(2)):
            if len(attribute.group(1)) > 2:
                begin = tag.start(2) + attribute.start(1)
                found.append((begin, begin + len(attribute.group(1)), attribute.group(1), None))
    return found


def end_of(text, tag):
    """Where the name in the end tag of this start tag stands."""
    depth = 0
    for other in re.finditer(r"<(/?)" + tag.group(1) + r"\b[^>]*?(/?)>", text[tag.start():]):
        if other.group(1):
            depth -= 1
        elif not other.group(2):
            depth += 1
        if depth == 0:
            return tag.start() + other.start() + 2
    return None


def misspelt(rng, text, known):
    places = [p for p in names_of(text) if p[2] in known]
    begin, end, name, tag = rng.choice(places)
    wrong = other_name(rng, name)
    while wrong in known or wrong.lower() == name.lower():
        wrong = other_name(rng, name)
    line = text.count("\n", 0, begin) + 1
    if tag is not None and not tag.group(3):
        close = end_of(text, tag)
        text = text[:close] + wrong + text[close + len(name):]
    return text[:begin] + wrong + text[end:], line, name, wrong


def judge(files):
    probe = subprocess.run([str(BIN / "robot_text_probe")], input="\n".join(map(str, files)) + "\n", capture_output=True, text=True,
                           errors="replace", timeout=1800)
    answers = probe.stdout.splitlines()
    if probe.returncode != 0 or len(answers) != len(files):
        print(f"FAILED: the probe ended with {probe.returncode} after {len(answers)} of {len(files)} files\n{probe.stderr[-2000:]}")
        sys.exit(1)
    return answers


def main():
    numbers = [int(word) for word in sys.argv[1:]] + [600, 300, 1][len(sys.argv) - 1:]
    rng = random.Random(numbers[2])
    urdfs = sorted((ROOT / "config/robots").glob("*/*.urdf"))
    files = urdfs + sorted((ROOT / "config/robots").glob("*/*.srdf"))
    texts = {f: f.read_bytes() for f in files}
    # A name that URDF or SRDF have anywhere is no misspelling, though it may stand where it says nothing.
    known = set(re.findall(r"\"([A-Za-z_]\w*)\"", (ROOT / "robot/names/known_names.cpp").read_text()))
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        made, tries = [], 0
        while len(made) < numbers[0]:
            tries += 1
            source = rng.choice(files)
            text = malformed(rng, texts[source])
            if not rejected(text) or b"\0" in text or not text:
                continue
            name = folder / f"m{len(made)}{source.suffix}"
            name.write_bytes(text)
            made.append(name)
        for name, answer in zip(made, judge(made)):
            if not re.match(r"refused .*\.[us]rdf:\d+: ", answer):
                failures.append(f"malformed {name.name}: {answer[:200]}")
                shutil.copy(name, tempfile.gettempdir())
        print(f"{len(made)} files that an XML checker rejects, of {tries} mutated: {len(failures)} loaded or without line", flush=True)
        if shutil.which("xmllint"):
            # The other way round: a second checker agrees that they are malformed (names with a colon are none of its business).
            agreed = sum(subprocess.run(["xmllint", "--noout", str(n)], capture_output=True).returncode != 0 for n in made[:200])
            print(f"xmllint rejects {agreed} of the first {len(made[:200])}")
        made, why = [], []
        while len(made) < numbers[1]:
            source = rng.choice(files)
            robot = folder / source.parent.name
            if not robot.exists():
                shutil.copytree(source.parent, robot)
            text, line, name, wrong = misspelt(rng, texts[source].decode(), known)
            made.append(robot / f"n{len(made)}{source.suffix}")
            made[-1].write_text(text)
            why.append((line, name, wrong))
        before = len(failures)
        for file, (line, name, wrong), answer in zip(made, why, judge(made)):
            told = re.match(r"refused .*\.[us]rdf:(\d+): ", answer)
            if not told or int(told.group(1)) != line:
                failures.append(f"misspelt {wrong} for {name} on line {line}: {answer[:300]}")
        print(f"{len(made)} files with one misspelt name: {len(failures) - before} loaded or with another line", flush=True)
    for failure in failures[:20]:
        print("FAILED:", failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
