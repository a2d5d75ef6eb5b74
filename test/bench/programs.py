"""Where the programs are that a bench or chart runs: $TWINBUS_BIN, or the newest build that has them."""

import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


POLICY_RUNS = ("twinbus_simulator", "twinbus_guard")  # what a policy in lock-step starts


def folder_of(program, who, *others):
    """who: says it when there is no build, or when it lacks one of the others."""
    folder = pathlib.Path(os.environ["TWINBUS_BIN"]) if "TWINBUS_BIN" in os.environ else newest_with(program, who)
    missing = [name for name in others if not (folder / name).exists()]
    if missing:
        sys.exit(f"{who}: {', '.join(missing)} not in {folder}; run: cmake --build --preset release --target {' '.join(missing)}")
    return folder


def newest_with(program, who):
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
