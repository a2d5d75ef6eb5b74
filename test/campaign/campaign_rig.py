"""A folder with a campaign file, run by the campaign program with a stand-in for twinbus."""

import contextlib
import csv
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "campaign/campaign.py"
sys.path.insert(0, str(ROOT / "campaign"))

try:
    import yaml  # noqa: F401  as campaign/ does
except ImportError:
    print("skipped: campaigns need python3-yaml; run: apt-get install python3-yaml")
    sys.exit(77)


@contextlib.contextmanager
def chdir(folder):
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


class Rig(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.fake = self.folder / "twinbus"
        shutil.copy(pathlib.Path(__file__).with_name("fake_twinbus.sh"), self.fake)
        self.environment = dict(os.environ, TWINBUS_PROGRAM=str(self.fake), TWINBUS_CONFIG=str(ROOT / "config"))

    def file(self, text, name="c.yaml"):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def words(self, *words):
        return [sys.executable, str(PROGRAM), *map(str, words)]

    def campaign(self, *words, status=0, timeout=100):
        done = subprocess.run(self.words(*words), capture_output=True, text=True, env=self.environment, timeout=timeout, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def here(self, *words, status=0):
        """The same in this process: a Python that starts takes most of a second on a busy machine."""
        import campaign
        said = io.StringIO()
        with unittest.mock.patch.dict(os.environ, self.environment), chdir(self.folder), contextlib.redirect_stdout(said), \
                contextlib.redirect_stderr(said):
            reached = campaign.main([str(word) for word in words])
        if status is not None:
            self.assertEqual(reached, status, said.getvalue())
        return said.getvalue()

    def table(self, out, name="results.csv"):
        with open(self.folder / out / name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))
