#!/usr/bin/env python3
"""A script beside a clone that is called twinbus, with no package installed, imports the Python package of that clone."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = """import twinbus
from twinbus.log import Log
import twinbus.home
print(twinbus.Bus.__module__, twinbus.robot_state_t(tick=3).tick, Log.__module__, twinbus.home.data())
"""


class CloneFolder(unittest.TestCase):
    def test_a_script_beside_it_gets_the_package(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "twinbus").symlink_to(ROOT)
            (folder / "mine.py").write_text(SCRIPT)
            done = subprocess.run([sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, {name!r}); exec(open({name!r} + '/mine.py').read())"],
                                  capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, f"twinbus.bus 3 twinbus.log {ROOT}\n"), done.stderr)


if __name__ == "__main__":
    unittest.main()
