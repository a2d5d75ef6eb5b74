"""Where the rest of twinbus lies: in a checkout, in an installation (.deb, cmake --install), or inside the wheel."""
from __future__ import annotations

import importlib.util
import os
import pathlib
import shutil
import sys
from types import ModuleType

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


def _modules() -> list[pathlib.Path]:
    """Where the compiled module may lie: beside this file's home, or in an installed package while this one is of a checkout."""
    build = pathlib.Path(os.environ.get('TWINBUS_BUILD') or data() / 'build/release')
    folders = [INSIDE.joinpath('lib', 'twinbus', 'lib', 'native'), build / 'lib/native', data() / '../../lib/twinbus/lib/native']
    if os.environ.get('TWINBUS_BIN'):
        folders.insert(1, pathlib.Path(os.environ['TWINBUS_BIN']).parent / 'lib/native')
    folders += [pathlib.Path(folder or '.') / 'twinbus' / INSIDE.name / 'lib/twinbus/lib/native' for folder in sys.path]
    return [file for folder in folders for file in sorted(folder.glob('_native*.so'))]


def native() -> ModuleType:
    """The compiled module, twinbus._native.  ImportError with what to do when there is none for this Python."""
    name = f'{__package__}._native'
    if name in sys.modules:
        return sys.modules[name]
    problems: list[str] = []
    for file in _modules():
        spec = importlib.util.spec_from_file_location(name, file)
        if spec is None or spec.loader is None:
            continue
        try:
            module = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(module)
        except ImportError as error:
            problems.append(f'{file}: {error}')
            continue
        module.set_config_folder(str(config()))
        sys.modules[name] = module
        return module
    raise ImportError('the compiled part of twinbus is not there for this Python: pip install ./python in a checkout'
                      + ''.join(f'\n  {problem}' for problem in problems))


def main() -> None:
    """The command `twinbus` of an installed wheel."""
    where = str(program())
    os.execv(where, [where, *sys.argv[1:]])
