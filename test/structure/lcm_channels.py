"""What lcmtypes/ says of channels and messages, for the tests of this folder."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from twinbus import lcm_types  # noqa: E402


def channels(root):
    """{channel: (type, encoded size)} of the channels that processes of twinbus speak of."""
    types = {struct.strip(): (said.name, 8 + sum(lcm_types.KINDS[field.kind][2] * field.count for field in said.fields))
             for said in lcm_types.read_folder(root / "lcmtypes") for struct in said.rule.split(",")}
    typed = re.findall(r'Channel<(\w+)> k\w+\{"(\w+)"\}', (root / "lcmtypes/bus/channels.h").read_text())
    return {name: types[struct] for struct, name in typed}
