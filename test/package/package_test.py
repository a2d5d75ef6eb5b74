#!/usr/bin/env python3
"""twinbus installed, as a Debian package where one can be made: programs run from there, and a project outside the tree finds the
libraries, builds, links, and commands a joint of the installed simulator.

    package_test.py BUILD
"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import urllib.request

HERE = pathlib.Path(__file__).resolve().parent
TREE = str(HERE.parents[1])
sys.path.insert(0, str(HERE.parent / "process"))
import harness  # noqa: E402
from harness import Bus  # noqa: E402


def run(*words, **options):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


def install(build, folder):
    """The prefix: of an unpacked Debian package, or of cmake --install where no package can be made."""
    if all(map(shutil.which, ("dpkg-deb", "dpkg-shlibdeps", "file"))):
        run("cpack", "--config", f"{build}/CPackConfig.cmake", "-B", folder / "cpack", "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip")
        package, = (folder / "cpack").glob("twinbus_*.deb")
        needs = run("dpkg-deb", "--field", package, "Depends")
        assert "libode" in needs and "liblcm" in needs, f"the package needs {needs}"
        run("dpkg-deb", "--extract", package, folder / "root")
        print(f"{package.name}, {package.stat().st_size / 1e6:.0f} MB, needs {needs.strip()}")
        return folder / "root" / "usr"
    print("no Debian package: apt-get install dpkg-dev file")
    run("cmake", "--install", build, "--prefix", folder / "installed")
    return folder / "installed"


def words(prefix, clean):
    """An installation speaks of `twinbus`, says what it leaves out, and knows its commit."""
    twinbus = prefix / "bin" / "twinbus"
    commit = subprocess.run(["git", "-C", TREE, "rev-parse", "HEAD"], capture_output=True, text=True).stdout.strip() or "unknown"
    assert f"commit {commit}" in run(twinbus, "--version", env=clean), commit
    said = run(twinbus, "--help", env=clean)
    commands = re.findall(r"^  ([a-z]+) +\S", said, re.M)
    assert len(commands) > 25 and not {"bench", "chart", "test"} & set(commands) and "leaves out" in said, said
    tries = [[command, "--help"] for command in commands] + [[command] for command in ("bench", "chart", "run", "check", "log", "campaign")]
    tries += [["walk", "0.3", "0", "0"], ["stop"], ["clear"], ["status"], ["reach", "left", "0", "0", "0"], ["sim", "go"], ["sim", "reset"],
              ["up", "--stack", "replay"], ["run", "no_such_scene"], ["restart", "guard"], ["switch", "sim"], ["doctor"], ["spy", "--no"],
              ["env", "--no"], ["campaign", "--out"], ["log", "--help"], ["scenes", "no", "such", "words"]]
    for line in tries:
        done = subprocess.run([twinbus, *line], env=clean, capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL)
        assert "./twinbus" not in done.stdout + done.stderr, f"{line}: {done.stdout}{done.stderr}"
    for command in ("bench", "chart"):
        done = subprocess.run([twinbus, command], env=clean, capture_output=True, text=True)
        assert done.returncode == 1 and "checkout of the source tree" in done.stderr, done.stderr


def programs(prefix, clean):
    twinbus = prefix / "bin" / "twinbus"
    assert "up" in run(twinbus, "--help", env=clean)
    said = run(twinbus, "run", "stand", "--for", "0.2", env=clean, cwd=prefix)
    assert "passed" in said or "state_hash" in said, said
    said = run(twinbus, "check", "hrp1s", env=clean, cwd=prefix)
    assert str(prefix / "share/twinbus/config") in said or "hrp1s" in said, said
    python = run(sys.executable, "-c", "import twinbus; print(len(twinbus.robot_state_t().encode()))",
                 env=dict(clean, PYTHONPATH=str(prefix / "lib/twinbus/lib/python")))
    assert int(python) > 1000, python
    said = run(twinbus, "env", env=clean)
    assert f"{prefix}/share/twinbus/python" in said, said
    said = run(sys.executable, "-c", "import twinbus; print(twinbus.home.program(), len(twinbus.messages.ALL))",
               env=dict(clean, PYTHONPATH=str(prefix / "share/twinbus/python")))
    assert said.startswith(str(prefix / "lib/twinbus/bin/twinbus")), said
    assert (prefix / "lib/twinbus/lib/adaptors/emulated_robot.so").is_file()
    assert (prefix / "share/twinbus/viewer_log/web/dist/index.html").is_file()
    assert (prefix / "share/twinbus/lcmtypes/robot_state_t.lcm").is_file()


def compiled(build, prefix, clean):
    """The package's compiled part is there where CMake found nanobind, and simulates in the Python that it was built for."""
    cache = (pathlib.Path(build) / "CMakeCache.txt").read_text()
    modules = list(prefix.glob("lib/twinbus/lib/native/_native*.so"))
    if re.search(r"^nanobind_DIR:PATH=.*NOTFOUND$|^TWINBUS_PYTHON_MODULE:BOOL=OFF$", cache, re.M) or "nanobind_DIR" not in cache:
        assert not modules, modules
        print("without the compiled part of the Python package: no nanobind where it was built")
        return
    assert len(modules) == 1, f"nanobind was found, and the package has {modules}"
    python = re.search(r"^_?Python_EXECUTABLE:\w+=(.+)$", cache, re.M)[1]
    paths = dict(clean, PYTHONPATH=str(prefix / "share/twinbus/python"))
    said = run(python, "-c", "import twinbus; print(twinbus.home.native().__file__)", env=paths)
    assert pathlib.Path(said.strip()).resolve() == modules[0].resolve(), said
    if subprocess.run([python, "-c", "import numpy"], capture_output=True).returncode != 0:
        print(f"no numpy in {python}: nothing is simulated in it")
        return
    said = run(python, "-c", "import twinbus; s = twinbus.Simulation('stand', 'hrp1s'); [s.step() for _ in range(50)]; print(s.time)", env=paths)
    assert 0.09 < float(said) < 0.11, said


def page(prefix, clean):
    """So does the page, and gives it to who has no token yet."""
    viewer = subprocess.Popen([prefix / "lib/twinbus/bin/twinbus_viewer", "--port", "0", "--no-open"], env=clean, stdout=subprocess.PIPE, text=True)
    try:
        port = next(found for found in (re.search(r"ready at http://127.0.0.1:(\d+)/", line) for line in viewer.stdout) if found)[1]
        for path in ("", "index.html"):
            with urllib.request.urlopen(f"http://127.0.0.1:{port}/{path}", timeout=10) as answer:
                html = answer.read().decode()
            assert 'data-command="twinbus"' in html and "./twinbus" not in html, html[:300]
    finally:
        viewer.terminate()
        viewer.wait(10)


def command_a_joint(prefix, program, clean):
    """The installed stack without a controller, and the program outside as one."""
    client = subprocess.Popen([program], env=clean)
    bus = Bus()
    stack = subprocess.Popen([prefix / "bin" / "twinbus", "up", "stand_python", "--stack", "client", "--no-viewer", "--for", "6"], env=clean,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, stdin=subprocess.DEVNULL)
    said = stack.communicate(timeout=60)[0]
    client.send_signal(signal.SIGTERM)
    client.wait(10)
    time.sleep(0.2)
    states = [state for _, state in bus.messages("STATE")]
    bus.close()
    joint = next((j for j in range(29) if states and max(s.q[j] for s in states) - min(s.q[j] for s in states) > 0.15), None)
    assert joint is not None, f"no joint moved; {len(states)} STATEs\n{said[-2000:]}"
    moved = max(s.q[joint] for s in states) - min(s.q[joint] for s in states)
    assert moved < 0.25 and {s.stop_kind for s in states} == {0}, f"joint {joint} moved {moved:.3f} rad\n{said[-2000:]}"
    return f"joint {joint} moved {moved:.3f} rad in {len(states)} ticks"


def main():
    build = sys.argv[1]
    harness.require("twinbus", "twinbus_simulator", "twinbus_bridge", "twinbus_viewer")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefix = install(build, folder)
        clean = {key: value for key, value in os.environ.items() if not key.startswith("TWINBUS_")}
        clean.update(XDG_DATA_HOME=str(folder / "home"), XDG_CACHE_HOME=str(folder / "cache"))
        for file in [*prefix.rglob("*.cmake"), *prefix.rglob("*.sh"), *prefix.rglob("*.py")]:
            # A whole path, not the end of another: a tree in /twinbus is not meant by share/twinbus.
            points = re.search(r"((?<![\w.})-])|(?<=-[IL]))" + re.escape(TREE) + r"(?![\w.-])", file.read_text())
            assert not points, f"{file} points into the source tree"
        programs(prefix, clean)
        compiled(build, prefix, clean)
        words(prefix, clean)
        page(prefix, clean)
        outside = folder / "build"
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []  # `make` need not be installed
        said = run("cmake", *generator, "-S", HERE / "outside", "-B", outside, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release")
        assert len(re.findall(rf"^-- [A-Z_]+: {re.escape(str(prefix))}/", said, re.M)) == 6, said
        run("cmake", "--build", outside)
        lines = (HERE / "outside/command_joint.cpp").read_text().splitlines()
        assert len([line for line in lines if line.strip() and not line.startswith("//")]) <= 21, "longer than 20 lines"
        config = prefix / "share/twinbus/config"
        shutil.copytree(config, folder / "other")
        for place, settings in ((config, {}), (folder / "other", {"TWINBUS_CONFIG": str(folder / "other")})):
            said, where = run(outside / "outside", env=dict(clean, **settings)).splitlines()
            assert said.startswith("130.8 kg, scene of 10 s, STATE has "), said
            assert pathlib.Path(where).resolve() == place.resolve(), f"reads {where}, not {place}"
        moved = command_a_joint(prefix, outside / "command_joint", clean)
        assert (folder / "home/twinbus/runs").is_dir(), "runs of an installed program are not at home"
    print("ok:", said.strip(), "--", moved)


main()
