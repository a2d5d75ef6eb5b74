"""Rotations of quaternions."""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .errors import PolicyError

Array = NDArray[np.float64]


def rotation_of(quaternion: Array) -> Array:
    """[3 x 3] of w x y z.  PolicyError when it is none."""
    norm = float(np.linalg.norm(quaternion))
    if not 0.5 < norm < 2.0:
        raise PolicyError('an attitude is no rotation')
    w, x, y, z = quaternion / norm
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
