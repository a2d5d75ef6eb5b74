"""twinbus from Python: the bus and its message types, logs, stacks, and the simulation in this process.

    import twinbus
    bus = twinbus.Bus()                            # $LCM_DEFAULT_URL, or this project's own port
    bus.listen('STATE')
    state = twinbus.newest_state(bus.receive(0.1))
    bus.send('COMMAND', twinbus.command_for(state, me, state.q, kp=[1000.0] * state.joint_count))

and for operators, whose messages name the run that they are for and count up:

    bus.listen('STATE', 'CONTROLLER_STATUS')
    state = bus.wait('STATE')
    request = twinbus.mode_request_t()
    request.mode = 4                               # balance
    bus.ask('MODE_REQUEST', request, state)
    bus.wait('CONTROLLER_STATUS', lambda status: status.mode_sequence == request.sequence)

and for arms, by their names:

    twinbus.Arm(bus, 'left').reach((0.35, 0.25, 0.75))
    twinbus.Arm(bus, 'north', twinbus.Robot('FOLDER').info).grip(1.0)

and in this process, without a bus, a simulation (see twinbus.simulation), many of them, and questions to a robot:

    simulation = twinbus.Simulation('walk_forward')
    simulation.step(500)
    twinbus.Robot('hrp1s').nearest(simulation.state.q)

The bus needs the standard library alone; arrays of messages are numpy arrays where numpy is installed, else lists.
"""
from typing import TYPE_CHECKING, Any

from . import messages
from .arm import Arm
from .bus import JOINTS, Bus, Obedience, command_for, decode, new_id, newest_state, padded, run, text
from .channels import TYPES
from .home import config
from .lcm_types import Message, message_type
from .log import Log, read_log
from .messages import *  # noqa: F401,F403  (the types themselves: twinbus.robot_state_t)
from .stack import Stack

if TYPE_CHECKING:
    from .robot import ArmPath as ArmPath, Obstacle as Obstacle, Reached as Reached, Robot as Robot
    from .simulation import RobotInfo as RobotInfo, Simulation as Simulation, Worlds as Worlds

_COMPILED = {'Simulation': 'simulation', 'Worlds': 'simulation', 'RobotInfo': 'simulation', 'Robot': 'robot', 'ArmPath': 'robot', 'Reached': 'robot',
             'Obstacle': 'robot'}


def __getattr__(name: str) -> Any:
    """What needs numpy is loaded when it is asked for: the bus does without."""
    if name not in _COMPILED:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    import importlib
    return getattr(importlib.import_module(f'{__name__}.{_COMPILED[name]}'), name)


__version__ = '0.1'
__all__ = ['JOINTS', 'TYPES', 'Arm', 'Bus', 'Log', 'Message', 'Obedience', 'Stack', 'command_for', 'config', 'decode', 'message_type', 'messages',
           'new_id', 'newest_state', 'padded', 'read_log', 'run', 'text']
