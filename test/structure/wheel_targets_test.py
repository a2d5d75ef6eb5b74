#!/usr/bin/env python3
"""What a wheel builds (pip install ./python) links no library that only the tests define.

    wheel_targets_test.py      configures as for a wheel, in a temporary folder, and reads what would be linked
"""

import pathlib
import re
import subprocess
import sys
import tempfile

from report import report

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    with tempfile.TemporaryDirectory() as folder:
        configured = subprocess.run(["cmake", "-G", "Ninja", "-DSKBUILD=ON", "-DCMAKE_BUILD_TYPE=Release", "-S", ROOT, "-B", folder],
                                    capture_output=True, text=True)
        if configured.returncode != 0:
            return report([configured.stderr[-2000:]])
        rules = (pathlib.Path(folder) / "build.ninja").read_text()
    missing = sorted(set(re.findall(r"-l(twinbus_\w+)", rules)))
    return report([f"{name}: no target of a wheel; programs link it: add its folder to the rooms that are built without tests (CMakeLists.txt)"
                   for name in missing])


if __name__ == "__main__":
    sys.exit(main())
