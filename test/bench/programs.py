"""Where the programs are that a bench or chart runs: $TWINBUS_BIN, or the newest build that has them."""

import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def folder_of(program, who):
    """who: says it when there is no build."""
    if "TWINBUS_BIN" in os.environ:
        return pathlib.Path(os.environ["TWINBUS_BIN"])
    builds = sorted(ROOT.glob(f"build/*/bin/{program}"), key=lambda path: path.stat().st_mtime)
    if not builds:
        how = "./twinbus up" if program == "twinbus" else "./twinbus bench"
        sys.exit(f"{who}: {program} is not built; run {how} once")
    return builds[-1].parent
