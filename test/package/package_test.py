#!/usr/bin/env python3
"""An installed twinbus is found by a project outside the tree, which builds, links and runs.

    package_test.py BUILD
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def run(*words, **options):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


def main():
    with tempfile.TemporaryDirectory() as folder:
        prefix = pathlib.Path(folder) / "installed"
        run("cmake", "--install", sys.argv[1], "--prefix", prefix, "--component", "development")
        tree = str(HERE.parents[1])
        for header in prefix.glob("lib/cmake/twinbus/*.cmake"):
            assert tree not in header.read_text(), f"{header} points into the source tree"
        build = pathlib.Path(folder) / "build"
        run("cmake", "-S", HERE / "outside", "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release")
        run("cmake", "--build", build)
        config = dict(os.environ, TWINBUS_CONFIG=str(prefix / "share" / "twinbus" / "config"))
        said = run(build / "outside", env=config)
        assert said.startswith("130.8 kg, scene of 10 s, STATE has "), said
    print("ok:", said.strip())


main()
