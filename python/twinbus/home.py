"""Where the rest of twinbus lies: in a checkout, in an installation (.deb, cmake --install), or inside the wheel."""
from __future__ import annotations

import os
import pathlib
import shutil

PACKAGE = pathlib.Path(__file__).resolve().parent
INSIDE = PACKAGE / 'home'  # of a wheel: an installation of its own


def data() -> pathlib.Path:
    """The folder that holds config/ and lcmtypes/."""
    for folder in (INSIDE / 'share/twinbus', PACKAGE.parents[1]):
        if (folder / 'lcmtypes/robot_state_t.lcm').is_file():
            return folder
    raise FileNotFoundError(f'{PACKAGE}: no lcmtypes/robot_state_t.lcm near it; the installation is not whole: pip install ./python again')


def config() -> pathlib.Path:
    """The folder of robots, scenes and stacks: $TWINBUS_CONFIG, or the one that came along."""
    said = os.environ.get('TWINBUS_CONFIG', '')
    return pathlib.Path(said) if said else data() / 'config'


def as_typed(sentence: str) -> str:
    """Where it is installed, the program is called twinbus, not ./twinbus."""
    return sentence if (PACKAGE.parents[1] / 'twinbus').is_file() else sentence.replace('./twinbus', 'twinbus')


def program(name: str = 'twinbus') -> pathlib.Path:
    """A program of twinbus: of $TWINBUS_BIN, of the wheel, of the checkout's release build, of the installation, or of PATH."""
    folders = [INSIDE / 'lib/twinbus/bin', data() / 'build/release/bin', data() / '../../lib/twinbus/bin']
    if os.environ.get('TWINBUS_BIN'):
        folders.insert(0, pathlib.Path(os.environ['TWINBUS_BIN']))
    for folder in folders:
        if os.access(folder / name, os.X_OK):
            return (folder / name).resolve()
    found = shutil.which(name)
    if found and name == 'twinbus':
        return pathlib.Path(found)
    raise FileNotFoundError(f'no program {name}; build it (./twinbus up in a checkout) or set TWINBUS_BIN to the folder that holds it')
