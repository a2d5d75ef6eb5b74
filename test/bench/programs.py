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


HELP_ASKED = bool({"-h", "--help"} & set(sys.argv))


def on_own_bus(script, who):
    """`twinbus bench` became the script: it goes on with the programs of the newest build, on a bus of its own."""
    if "TWINBUS_BIN" not in os.environ and not HELP_ASKED:
        os.environ["TWINBUS_BIN"] = str(folder_of("twinbus", who))
        os.execv(ROOT / "test/tools/private_bus.sh", ["private_bus.sh", sys.executable, script, *sys.argv[1:]])


def help_is(doc):
    """Where --help is asked for, before what only a build has is imported."""
    if HELP_ASKED:
        print(doc.strip())
        sys.exit(0)
