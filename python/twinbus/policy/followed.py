"""The motion that a tracking policy follows: joints and the orientation of an anchor link in every tick of the policy.

It lies in the ONNX file (exports of holosoma, mjlab and BeyondMimic: input time_step, outputs joint_pos, joint_vel and the anchor), or in a
file beside it: NPZ (joint_pos, body_quat_w or root_rot, fps) or CSV (doc/motion.md).  A Follower (follower.py) goes along it."""
from __future__ import annotations

import csv
import math
import pathlib
import zipfile
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import PolicyError, Refused
from .follower import Followed
from .names import MOTORS
from .network import JOINT_OUTPUTS, Network
from .rotation import rotation_of
from .robot import Robot
from .spec import Spec

Array = NDArray[np.float64]
LONGEST = 100000        # frames
SAMPLED = 20            # frames between two looks for the end of a motion inside
QUIET = 3000            # frames that are looked at one by one behind it
SLOWEST, FASTEST = 1.0, 1e4  # frames a second, of files
LARGEST = 1 << 28       # of what is read of a file [bytes]
REMEDY = 'a motion to follow is an NPZ with joint_pos, body_quat_w or root_rot, and fps, or a CSV with names (doc/motion.md)'
POSITIONS, NAMES = ('joint_pos', 'dof_pos', 'joint_positions'), ('joint_names', 'dof_names')
QUATERNIONS = ('body_quat_w', 'body_rotations', 'root_quat', 'root_rot')  # the first three w x y z, of the first body
RATES = ('fps', 'rate', 'framerate', 'frame_rate', 'mocap_framerate')
LAFAN1_RATE = 30.0      # of the retargeted data set, whose columns are root, quaternion with w last, 29 joints of G1


def load(spec: Spec, robot: Robot, network: Network) -> Followed:
    """PolicyError when the motion is no motion of this policy; Refused when there is none."""
    if spec.motion:
        return _from_file(pathlib.Path(spec.motion), spec, robot)
    if not network.carries_motion:
        raise Refused(f'{spec.source or spec.name}: the policy follows a motion, and there is none in {network.path}; --motion FILE (NPZ or CSV) '
                      'names it')
    return _from_network(spec, network)


def _from_network(spec: Spec, network: Network) -> Followed:
    """All frames of the motion inside; its time_step stays at the last one."""
    last = network.motion_frame(LONGEST)
    for what, part in zip(JOINT_OUTPUTS, last):
        if part.shape != (len(spec.joints),):
            raise PolicyError(f'{network.path}: {what} of its motion has {part.size} joints, the policy {len(spec.joints)}')
    if not all(np.isfinite(part).all() for part in last):
        raise PolicyError(f'{network.path}: a number of the motion is not finite')

    def differs(number: int) -> bool:
        return not all(np.array_equal(a, b) for a, b in zip(network.motion_frame(number), last))
    if differs(LONGEST - 1):
        raise PolicyError(f'{network.path}: the motion inside has more than {LONGEST} frames, or none')
    # The first frame from which on nothing changes any more.  A motion may come back to its last frame before its end, and be held there.
    end = max((number + 1 for number in range(0, LONGEST, SAMPLED) if differs(number)), default=0)
    number = end
    while number < min(end + QUIET, LONGEST):
        end = number + 1 if differs(number) else end
        number += 1
    frames = [network.motion_frame(number) for number in range(end + 1)]
    return _checked(np.array([f[0] for f in frames]), np.array([f[1] for f in frames]), _rotations([f[2] for f in frames], str(network.path)),
                    str(network.path))


def _rotations(quaternions: Any, source: str) -> Array:
    try:
        return np.array([rotation_of(one) for one in quaternions])
    except PolicyError as error:
        raise PolicyError(f'{source}: {error}') from None


def _checked(q: Array, qd: Array, anchor: Array, source: str) -> Followed:
    if not (np.isfinite(q).all() and np.isfinite(qd).all() and np.isfinite(anchor).all()):
        raise PolicyError(f'{source}: a number of the motion is not finite')
    return Followed(q, qd, anchor, source)


def _from_file(path: pathlib.Path, spec: Spec, robot: Robot) -> Followed:
    names = spec.names()
    if not path.is_file():
        raise PolicyError(f'{path}: no such file')
    kind = 'NPZ' if path.suffix == '.npz' else 'table'
    try:
        rate, joints, root = _npz(path, names) if kind == 'NPZ' else _csv(path, names)
    except PolicyError:
        raise
    except Exception as error:  # zipfile, zlib, numpy and csv have types of their own
        raise PolicyError(f'{path}: no {kind} of numbers: {str(error)[:120] or type(error).__name__}; {REMEDY}') from None
    if not SLOWEST <= rate <= FASTEST:
        raise PolicyError(f'{path}: {rate:g} frames a second are outside of {SLOWEST:g} to {FASTEST:g}')
    if not (np.isfinite(joints).all() and np.isfinite(root).all()):
        raise PolicyError(f'{path}: a number is not finite')
    count = int(max(0, len(joints) - 1) / rate / spec.period + 1e-6) + 1
    if not 2 <= len(joints) <= LONGEST or not 2 <= count <= LONGEST:
        raise PolicyError(f'{path}: {len(joints)} frames at {rate:g} a second are {count} of the policy, one every {1e3 * spec.period:g} ms; '
                          f'a motion has 2 to {LONGEST}')
    at = np.arange(count) * spec.period * rate
    before = np.minimum(at.astype(int), len(joints) - 2)
    share = (at - before)[:, None]
    q = (1.0 - share) * joints[before] + share * joints[before + 1]
    after = np.where(np.sum(root[before] * root[before + 1], axis=1, keepdims=True) < 0.0, -root[before + 1], root[before + 1])
    base = _rotations((1.0 - share) * root[before] + share * after, str(path))  # frames are near each other: rotation_of normalises
    qd = np.gradient(q, spec.period, axis=0)
    index = [robot.names().index(name) for name in names]
    on_bus, still = np.zeros(len(robot.names())), np.zeros(len(robot.names()))
    anchor = np.zeros((count, 3, 3))
    for number in range(count):
        on_bus[index] = q[number]
        anchor[number] = base[number] @ robot.motion(spec.anchor, on_bus, still).rotation
    return _checked(q, qd, anchor, str(path))


def _npz(path: pathlib.Path, names: list[str]) -> tuple[float, Array, Array]:
    """Frames a second, joints in the order of the policy, attitude of the base w x y z.  Without names the joints are in that order."""
    wanted = (*POSITIONS, *QUATERNIONS, *RATES, *NAMES)
    with zipfile.ZipFile(path) as packed:
        size = sum(entry.file_size for entry in packed.infolist() if entry.filename.removesuffix('.npy') in wanted)
        if size > LARGEST:
            raise PolicyError(f'{path}: {size >> 20} MB of numbers, at most {LARGEST >> 20} are read; {REMEDY}')
    with np.load(path, allow_pickle=False) as there:
        every = list(there.files)
        arrays: dict[str, Any] = {key: there[key] for key in every if key in wanted}
    key = next((key for key in POSITIONS if key in arrays), None)
    rate = next((float(np.asarray(arrays[key], dtype=np.float64).reshape(-1)[0]) for key in RATES if key in arrays and arrays[key].size), 0.0)
    turned = next((key for key in QUATERNIONS if key in arrays), None)
    if key is None or turned is None or not rate > 0.0:
        raise PolicyError(f'{path}: a motion to follow has joint_pos, {" or ".join(QUATERNIONS)}, and fps; there are: {", ".join(every[:20])}')
    joints = np.asarray(arrays[key], dtype=np.float64)
    root = np.asarray(arrays[turned], dtype=np.float64)
    root = root[:, 0] if root.ndim == 3 else root
    if joints.ndim != 2 or root.shape != (len(joints), 4):
        raise PolicyError(f'{path}: {key} is {joints.shape}, {turned} {root.shape}; each has a row for each frame')
    if turned == 'root_rot':
        root = root[:, [3, 0, 1, 2]]
    said = next((arrays[key].astype(str).reshape(-1).tolist() for key in NAMES if key in arrays), None)
    if said is not None:
        if len(said) != joints.shape[1]:
            raise PolicyError(f'{path}: {len(said)} names for {joints.shape[1]} joints')
        return rate, joints[:, _columns(path, said, names)], root
    if joints.shape[1] == len(names) + 7:  # root and joints in one row
        joints = joints[:, 7:]
    if joints.shape[1] != len(names):
        raise PolicyError(f'{path}: {joints.shape[1]} joints without names, the policy has {len(names)}')
    return rate, joints, root


def _columns(path: pathlib.Path, there: list[str], wanted: list[str]) -> list[int]:
    missing = [name for name in wanted if name not in there]
    if missing:
        raise PolicyError(f'{path}: no column {missing[0]}')
    return [there.index(name) for name in wanted]


def _csv(path: pathlib.Path, names: list[str]) -> tuple[float, Array, Array]:
    """With a row of names, or the columns of the retargeted LAFAN1 data set."""
    if path.stat().st_size > LARGEST:
        raise PolicyError(f'{path}: larger than {LARGEST >> 20} MB; {REMEDY}')
    with path.open(newline='', encoding='utf-8') as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith('#')]
    if len(rows) < 2:
        raise PolicyError(f'{path}: no table of numbers: it has {len(rows)} rows; {REMEDY}')
    table, head = np.array([[float(cell) for cell in row] for row in rows[1:]]), [cell.strip() for cell in rows[0]]
    without_names = all(_is_number(cell) for cell in head)
    table = np.vstack([[float(cell) for cell in head], table]) if without_names else table
    if without_names:
        if table.shape[1] != 7 + len(MOTORS['G1']):
            raise PolicyError(f'{path}: {table.shape[1]} columns without names; those of LAFAN1 for G1 are {7 + len(MOTORS["G1"])}')
        return LAFAN1_RATE, table[:, [7 + k for k in _columns(path, MOTORS['G1'], names)]], table[:, [6, 3, 4, 5]]
    times = table[:, _columns(path, head, ['time'])[0]]
    if not np.isfinite(times).all() or not np.all(np.diff(times) > 0.0) or np.ptp(np.diff(times)) > 1e-3 * float(np.diff(times).mean()) + 1e-6:
        raise PolicyError(f'{path}: the times of a motion to follow go on evenly')
    root = table[:, _columns(path, head, ['root_qw', 'root_qx', 'root_qy', 'root_qz'])]
    return 1.0 / float(np.diff(times).mean()), table[:, _columns(path, head, names)], root


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
