"""The message types of the bus, as dataclasses: robot_state_t, joint_command_t, ...  Made from the .lcm files when this is imported,
so a field is written once; messages.pyi tells them to type checkers.  ALL has them by name."""
from __future__ import annotations

from . import home
from .lcm_types import Message, make_type, read_folder

ALL: dict[str, type[Message]] = {said.name: make_type(said, __name__) for said in read_folder(home.data() / 'lcmtypes')}
globals().update(ALL)
__all__ = ['ALL', *ALL]
