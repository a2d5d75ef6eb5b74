#!/usr/bin/env python3
"""The Python package says of messages and channels what lcmtypes/ says: messages.pyi, which type checkers read, the table of
channels, and the version.

    python_test.py [--write]     --write makes python/twinbus/messages.pyi anew
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
from twinbus import channels, lcm_types  # noqa: E402

import lcm_channels  # noqa: E402

VERSIONS = {"CMakeLists.txt": r"project\(twinbus VERSION ([0-9.]+)", "python/pyproject.toml": r'(?m)^version = "([0-9.]+)"',
            "python/twinbus/__init__.py": r"(?m)^__version__ = '([0-9.]+)'"}
STUBS = ROOT / "python/twinbus/messages.pyi"


def channel_table():
    """{channel: type} of lcmtypes/bus."""
    return {channel: kind for channel, (kind, _) in lcm_channels.channels(ROOT).items()} | {"LOG_TEXT": "model_text_t"}


def main():
    stubs = lcm_types.stubs(lcm_types.read_folder(ROOT / "lcmtypes"))
    if "--write" in sys.argv:
        STUBS.write_text(stubs)
    failed = []
    if STUBS.read_text() != stubs:
        failed.append("python/twinbus/messages.pyi is not what lcmtypes/*.lcm say: python3 test/structure/python_test.py --write")
    there, here = channel_table(), {channel: kind.__name__ for channel, kind in channels.TYPES.items()}
    assert len(there) > 25, there
    for channel in sorted(there.keys() | here.keys()):
        if there.get(channel) != here.get(channel):
            failed.append(f"python/twinbus/channels.py: {channel} is {here.get(channel)}, in lcmtypes/bus {there.get(channel)}")
    said = {file: re.search(pattern, (ROOT / file).read_text())[1] for file, pattern in VERSIONS.items()}
    if len(set(said.values())) != 1:
        failed.append(f"versions differ: {said}")
    for problem in failed:
        print(problem)
    print(f"{len(there)} channels, {len(failed)} problems")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
