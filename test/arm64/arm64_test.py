#!/usr/bin/env python3
"""twinbus for arm64: built by the preset arm64, run by qemu-user; stands and walks, and its figures are those of this machine but for rounding.

    arm64_test.py [--no-build] [--unit|--every-unit]      --unit: also unit tests of geometry and messages; --every-unit: of everything,
                                                          after half an hour of building

Skipped with a sentence where the root (test/arm64/root.sh), the cross compiler or qemu-user is missing.
"""

import argparse
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "test/campaign"))
BUILD = ROOT / "build/arm64"
LARGEST = 0.001  # of a figure, relative: rounding that 3 s of contact have let grow
UNIT = ("geometry_test", "wire_test")
TEXT = "scenes: [stand, sway, walk_forward]\nseeds: 1..2\nfor: 3\npath: baseline\nlimit: 1800\nlogs: 0\n"


def skip(sentence):
    print(f"skipped: {sentence}")
    sys.exit(77)


def require(root):
    import shutil
    if not (root / "usr/include").is_dir():
        skip(f"{root} holds no libraries of arm64; run: test/arm64/root.sh")
    for program, package in (("aarch64-linux-gnu-g++", "g++-aarch64-linux-gnu"), ("qemu-aarch64", "qemu-user")):
        if not shutil.which(program):
            skip(f"{program} is missing; run: apt-get install {package}")
    try:
        import yaml  # noqa: F401
    except ImportError:
        skip("campaigns need python3-yaml; run: apt-get install python3-yaml")


def build(targets):
    for words in (["cmake", "--preset", "arm64"], ["ninja", "-C", BUILD, "-j2", *targets]):
        done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"arm64: {' '.join(map(str, words))}: {done.stdout[-1500:]}{done.stderr[-1500:]}")


def every_unit():
    """{program of unit tests: its arguments}, as ctest of this machine's build knows them."""
    listed = subprocess.run(["ctest", "--test-dir", ROOT / "build/release", "-L", "unit", "--show-only=json-v1"], capture_output=True, text=True)
    if listed.returncode != 0:
        skip("build/release is not configured; run: ./twinbus test --quick")
    commands = [test["command"] for test in json.loads(listed.stdout)["tests"] if test.get("command")]
    return {pathlib.Path(program).name: [word for word in words if not word.startswith("--gtest")] for program, *words in sorted(commands)
            if pathlib.Path(program).parent == ROOT / "build/release/bin" and program.endswith("_test")}


def unit(name, words, root, folder):
    """Runs a program of unit tests; what fails and what is skipped is named.  Whether all passes.

    folder: empty, for its files: where a folder is large, qemu-user lists only its beginning."""
    environment = dict(os.environ, TWINBUS_CACHE=str(BUILD / "cache"), TWINBUS_CONFIG=str(ROOT / "config"), TMPDIR=str(folder))
    done = subprocess.run(["qemu-aarch64", "-L", str(root), str(BUILD / "bin" / name), *(words or ["--gtest_brief=1"])], cwd=BUILD,
                          capture_output=True, text=True, env=environment)
    lines = done.stdout.splitlines()
    for line in lines:
        if line.startswith(("[  SKIPPED ]", "[  FAILED  ]")) and "." in line:
            print(f"    {line}")
    print(f"{name}: {'passes' if done.returncode == 0 else f'FAILED, exit status {done.returncode}: ' + (lines or ['?'])[-1]}", flush=True)
    return done.returncode == 0


def campaign(*words, program):
    environment = dict(os.environ, TWINBUS_PROGRAM=str(program), TWINBUS_CONFIG=str(ROOT / "config"))
    return subprocess.run([sys.executable, ROOT / "campaign/campaign.py", *map(str, words)], env=environment, capture_output=True, text=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--no-build", action="store_true")
    parser.add_argument("--unit", action="store_true")
    parser.add_argument("--every-unit", action="store_true")
    given = parser.parse_args()
    root = pathlib.Path(os.environ.get("TWINBUS_ARM64_ROOT", pathlib.Path.home() / ".cache/twinbus/roots/arm64"))
    require(root)
    here = pathlib.Path(os.environ.get("TWINBUS_BIN", ROOT / "build/release/bin")) / "twinbus"
    if not here.exists():
        skip(f"{here} is not built")
    units = every_unit() if given.every_unit else dict.fromkeys(UNIT, []) if given.unit else {}
    if not given.no_build:
        build(["twinbus", *units])
    bad = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        there = folder / "twinbus"
        there.write_text(f"#!/bin/sh\nexec qemu-aarch64 -L '{root}' '{BUILD}/bin/twinbus' \"$@\"\n")
        there.chmod(0o755)
        (folder / "c.yaml").write_text(TEXT)
        for out, program in (("here", here), ("arm64", there)):
            done = campaign(folder / "c.yaml", "--out", folder / out, program=program)
            print(f"{out}: {done.stdout.splitlines()[0] if done.stdout else done.stderr[-500:]}", flush=True)
            with open(folder / out / "results.csv", newline="", encoding="utf-8") as file:
                # walk_forward is asked for more than it walks in 3 s.
                wrong = [row["id"] for row in csv.DictReader(file) if row["fell"] != "false" or row["scene"] != "walk_forward" and row["status"] != "passed"]
            if wrong:
                print(f"FAILED {out}: {', '.join(wrong)}")
                bad += 1
        done = campaign("compare", folder / "here", folder / "arm64", program=here)
        print(done.stdout, end="")
        with open(folder / "here/compare.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            if float(row["largest_relative_difference"]) > LARGEST:
                print(f"FAILED {row['id']}: {row['of']} differs by {100 * float(row['largest_relative_difference']):.3g} %")
                bad += 1
            if "architecture: x86_64 / aarch64" not in row["differs_in"]:
                print(f"FAILED {row['id']}: does not say that the architectures differ: {row['differs_in']}")
                bad += 1
        bad += len(rows) != 6
    for name, words in units.items():
        with tempfile.TemporaryDirectory() as folder:
            bad += not unit(name, words, root, folder)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
