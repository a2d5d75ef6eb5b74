#!/usr/bin/env python3
"""`pip install ./python` as a stranger does it: the wheel is built and installed into a virtual environment of its own, and everything is
asked of it outside the tree: simulations, environments, types (mypy --strict), the examples that need it, the programs, the commands of
python/README.md and every block of doc/python.md, in its order.

    wheel_test.py WERROR [MORE WORDS FOR PIP]

Skipped where there is no pip, no venv or no way to the packages it needs.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77
NEEDED = ["nanobind>=2.4", "scikit-build-core>=0.10", "gymnasium>=1.0", "mypy"]


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: status {done.returncode}\n{done.stdout[-6000:]}")
    return done.stdout


def blocks(page, language):
    return re.findall(rf"^```{language}\n(.*?)^```", (ROOT / page).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def pages(folder, clean):
    """What python/README.md and doc/python.md say, word by word; ~ is a folder of its own, and its python the one of the page."""
    home = folder / "stranger"
    home.mkdir()
    there = dict(clean, HOME=str(home), XDG_DATA_HOME=str(folder / "home"), MPLBACKEND="Agg")
    words, = blocks("doc/python.md", "sh")
    run("bash", "-e", "-c", words, cwd=ROOT, env=there)
    installed = home / "twinbus-python/bin"
    readme, = (block for block in blocks("python/README.md", "sh") if "pip install ./python" in block)
    said = run("bash", "-e", "-c", readme, cwd=ROOT, env=dict(there, PATH=f"{installed}:{clean['PATH']}"))
    assert "10.0 seconds without a fall" in said, f"python/README.md: {said}"
    work = folder / "notebook"
    work.mkdir()
    cells = blocks("doc/python.md", "python")
    assert len(cells) > 5, cells
    (work / "cells.py").write_text("\n".join(cells))
    print(run(installed / "python", "cells.py", cwd=work, env=there), flush=True)
    for picture in ("push.png", "log.png"):
        assert (work / picture).stat().st_size > 5000, picture


def main():
    werror = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        made = subprocess.run([sys.executable, "-m", "venv", folder / "venv"], capture_output=True, text=True)
        if made.returncode != 0:
            skip("no virtual environment can be made: apt-get install python3-venv")
        python = folder / "venv/bin/python"
        pip = [python, "-m", "pip", "--disable-pip-version-check", "--quiet"]
        got = subprocess.run([*map(str, pip), "install", "--retries", "1", "--timeout", "20", *NEEDED], capture_output=True, text=True)
        if got.returncode != 0:
            skip(f"no way to the packages {', '.join(NEEDED)}: {got.stderr.strip().splitlines()[-1:]}")
        clean = {key: value for key, value in os.environ.items() if not key.startswith("TWINBUS_") and key != "PYTHONPATH"}
        # The compiler cache has the rooms from the build beside this test when warnings are treated alike.
        clean["CMAKE_BUILD_PARALLEL_LEVEL"] = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        run(*pip, "wheel", "--no-deps", "--no-build-isolation", "-w", folder / "wheels", f"-Ccmake.define.TWINBUS_WERROR={werror}",
            *sys.argv[2:], ROOT / "python", env=dict(clean, PATH=f"{folder / 'venv/bin'}:{clean['PATH']}"))
        wheel, = (folder / "wheels").glob("twinbus-*.whl")
        print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB", flush=True)
        run(*pip, "install", wheel)
        there = dict(clean, PATH=f"{folder / 'venv/bin'}:{clean['PATH']}", XDG_DATA_HOME=str(folder / "home"))
        asked = dict(cwd=folder, env=there)
        said = run(python, "-c", "import twinbus; print(twinbus.__file__, twinbus.config(), twinbus.home.program())", **asked)
        for path in said.split():
            assert path.startswith(str(folder / "venv")), f"{path} is not in the wheel"
        assert "passed" in run("twinbus", "run", "stand", "--for", "0.5", **asked)
        tests = folder / "tests"
        tests.mkdir()
        shutil.copy(ROOT / "test/python/compiled_test.py", tests)
        print(run(python, tests / "compiled_test.py", **asked).strip().splitlines()[-1], flush=True)
        (folder / "mine.py").write_text("import twinbus\n\nsimulation = twinbus.Simulation('stand', control=None)\n"
                                        "x: float = float(simulation.step().q[0]) + simulation.time\nstate = twinbus.robot_state_t(tick=3)\n"
                                        "print(x, state.q.shape, twinbus.Log)\n")
        print(run(python, "-m", "mypy", "--strict", "-p", "twinbus", **asked).strip(), flush=True)
        print(run(python, "-m", "mypy", "--strict", "mine.py", **asked).strip(), flush=True)
        wrong = folder / "wrong.py"
        wrong.write_text("import twinbus\n\ntwinbus.robot_state_t(tock=3)\ntwinbus.Simulation(7)\n")
        found = subprocess.run([python, "-m", "mypy", "--strict", wrong], capture_output=True, text=True, **asked).stdout
        assert found.count("error:") == 2, f"mypy finds what is wrong: {found}"
        examples = folder / "examples"
        examples.mkdir()
        for file in (ROOT / "examples").glob("*.py"):
            shutil.copy(file, examples)
        # torch and the vendor's SDK are not installed here.
        print(run(python, "-m", "mypy", "--strict", "--disable-error-code", "import-not-found", *sorted(examples.glob("*.py")), **asked).strip(), flush=True)
        said = run(python, examples / "17_simulation.py", **asked)
        assert "10.0 seconds without a fall" in said, f"17_simulation.py says {said}"
        print(f"17_simulation.py: {said.strip().splitlines()[-1]}", flush=True)
        pages(folder, clean)


main()
