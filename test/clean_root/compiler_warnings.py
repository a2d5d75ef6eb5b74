#!/usr/bin/env python3
"""Does every file compile without a warning with another compiler?  Only looks: no code is made, so this takes a third of a build.

    compiler_warnings.py COMPILER [PATTERN]

Configures build/warnings-COMPILER as CI does (warnings are errors), writes the message types and gives each command of its
compile_commands.json to COMPILER with -fsyntax-only.  PATTERN: only files whose path matches.  Exit status 1 where a file has
a warning.
"""

import argparse
import json
import pathlib
import re
import shlex
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("compiler", help="clang++, clang++-19, g++-14 ...")
    parser.add_argument("pattern", nargs="?", default="", help="only files whose path matches")
    arguments = parser.parse_args()
    build = ROOT / f"build/warnings-{pathlib.Path(arguments.compiler).name}"
    subprocess.run(["cmake", "--preset", "release", "-B", build, f"-DCMAKE_CXX_COMPILER={arguments.compiler}",
                    "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DTWINBUS_WERROR=ON"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build, "--target", "twinbus_messages_generated"], check=True, stdout=subprocess.DEVNULL)
    failed, looked, start = [], 0, time.monotonic()
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = str(pathlib.Path(entry["file"]).relative_to(ROOT))
        if not file.endswith(("pp", ".cxx")) or not re.search(arguments.pattern, file):
            continue  # C is compiled by another compiler
        words = shlex.split(entry["command"])
        words = words[words.index(next(w for w in words if pathlib.Path(w).name == pathlib.Path(arguments.compiler).name)):]
        place = words.index("-o")
        del words[place:place + 2]
        words[words.index("-c")] = "-fsyntax-only"
        done = subprocess.run(words, cwd=entry["directory"], capture_output=True, text=True)
        looked += 1
        if done.returncode != 0:
            failed.append(file)
            print(f"{file}\n{done.stderr}", flush=True)
    print(f"{arguments.compiler}: {looked} files in {time.monotonic() - start:.0f} s, {len(failed)} with warnings")
    return 1 if failed or not looked else 0


sys.exit(main())
