"""Which specification a policy has: the one that is named, one that lies beside it, or the metadata of its file."""
from __future__ import annotations

import pathlib

from . import deploy_yaml, env_yaml, metadata, spec
from .errors import PolicyError
from .network import Network
from .robot import Robot
from .yaml_file import Field, load_map

BESIDE = ('{stem}.spec.yaml', 'SPEC.yaml', 'deploy.yaml', 'params/deploy.yaml', '../params/deploy.yaml', 'env.yaml', 'params/env.yaml',
          '../params/env.yaml')


def read_file(path: pathlib.Path, robot: Robot) -> spec.Spec:
    """A file of any of the three kinds; which one is told by its keys."""
    root = Field(load_map(path), str(path), '')
    keys = root.mapping()
    if 'spec' in keys:
        return spec.from_map(root)
    if 'joint_ids_map' in keys:
        return deploy_yaml.read(root, robot)
    if 'decimation' in keys and 'scene' in keys:
        return env_yaml.read(root, robot)
    raise PolicyError(f'{path}: it is no SPEC.yaml (key spec), no deploy.yaml (joint_ids_map) and no env.yaml (decimation, scene); '
                      './twinbus policy MODEL --propose --robot ROBOT writes a SPEC.yaml')


def find(network: Network, robot: Robot, named: str = '') -> spec.Spec:
    """named: a file, empty: look for it.  PolicyError says where was looked."""
    found = _look(network, named)
    return read_file(found, robot) if isinstance(found, pathlib.Path) else found


def without_robot(network: Network, named: str = '') -> spec.Spec | None:
    """As find(), where it can be read before a robot is known: metadata and SPEC.yaml."""
    found = _look(network, named)
    if not isinstance(found, pathlib.Path):
        return found
    root = Field(load_map(found), str(found), '')
    return spec.from_map(root) if 'spec' in root.mapping() else None


def _look(network: Network, named: str) -> spec.Spec | pathlib.Path:
    if named:
        return pathlib.Path(named)
    folder = network.path.parent
    places = [folder / place.format(stem=network.path.stem) for place in BESIDE]
    own = [place for place in places[:2] if place.is_file()]
    if not own and (found := metadata.read(network.metadata, str(network.path), network.observation_size)) is not None:
        return found
    for place in own or places:
        if place.is_file():
            return place
    keys = ', '.join(sorted(network.metadata)) or 'none'
    raise PolicyError(f'{network.path}: nothing says what it reads and moves: no {network.path.stem}.spec.yaml, SPEC.yaml, deploy.yaml or '
                      f'env.yaml beside it (or in params/), and its metadata has none (keys: {keys}); name one with --spec, or begin one with '
                      f'./twinbus policy {network.path} --propose --robot ROBOT')
