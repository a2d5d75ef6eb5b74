#!/usr/bin/env python3
"""./twinbus bench switch [sway] [squat] [reach] [twosims] [--csv F]: the figures of live switches, on a bus of its own.

SWITCHES=N switches per motion (default 4).
"""

import os
import pathlib
import sys

import programs

ROOT = pathlib.Path(__file__).resolve().parents[2]

if "--help" in sys.argv or "-h" in sys.argv:
    print(__doc__.strip())
    sys.exit(0)
# `twinbus bench` became this script; the programs are those of the newest build.
os.environ["TWINBUS_BIN"] = str(programs.folder_of("twinbus", "bench switch"))
os.execv(ROOT / "test/tools/private_bus.sh",
         ["private_bus.sh", sys.executable, str(ROOT / "test/process/switch_test.py"), "bench", *sys.argv[1:]])
