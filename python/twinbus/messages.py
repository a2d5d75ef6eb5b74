"""The message types of the bus, as dataclasses: robot_state_t, joint_command_t, ...  Made from the .lcm files when this is imported,
so a field is written once; messages.pyi tells them to type checkers.  ALL has them by name."""
from __future__ import annotations

from . import home
from .lcm_types import OLDER, Message, make_type, older_of, read_folder

ALL: dict[str, type[Message]] = {said.name: make_type(said, __name__) for said in read_folder(home.data() / 'lcmtypes')}
globals().update(ALL)
for _said in read_folder(home.data() / 'lcmtypes' / 'older'):
    _older = older_of(ALL[_said.name].LCM, _said)
    OLDER[_older.fingerprint] = _older
__all__ = ['ALL', *ALL]
