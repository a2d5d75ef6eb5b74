"""The robot's description from the bus: URDF, SRDF and robot.yaml in numbered pieces on MODEL_TEXT."""
from __future__ import annotations

from typing import Any

from . import robot
from .errors import PolicyError
from .yaml_file import parse

URDF, SRDF, ROBOT_YAML = 1, 2, 3
LARGEST = 16 << 20  # [bytes]


class ModelText:
    """Collects pieces of one robot."""

    def __init__(self) -> None:
        self._pieces: dict[tuple[int, int], dict[int, bytes]] = {}
        self._count: dict[tuple[int, int], tuple[int, int]] = {}

    def hear(self, piece: Any) -> None:
        """A message of MODEL_TEXT; what cannot be is left out."""
        if piece.kind not in (URDF, SRDF, ROBOT_YAML) or not 0 < piece.pieces <= 20000 or not 0 <= piece.piece < piece.pieces \
                or not 0 <= piece.count <= len(piece.text) or not 0 <= piece.size <= LARGEST:
            return
        key = (piece.model_hash, piece.kind)
        if self._count.get(key) != (piece.pieces, piece.size):
            if len(self._count) > 24:
                self._count.clear()
                self._pieces.clear()
            self._count[key], self._pieces[key] = (piece.pieces, piece.size), {}
        self._pieces[key][piece.piece] = bytes(int(value) & 0xFF for value in piece.text[:piece.count])

    def whole(self, model_hash: int) -> bool:
        """Whether URDF and robot.yaml have come, and the SRDF where a piece of one has."""
        return all(self._is_whole((model_hash, kind)) for kind in (URDF, ROBOT_YAML)) and \
            ((model_hash, SRDF) not in self._count or self._is_whole((model_hash, SRDF)))

    def _is_whole(self, key: tuple[int, int]) -> bool:
        return key in self._count and len(self._pieces[key]) >= self._count[key][0]

    def text(self, model_hash: int, kind: int) -> str | None:
        """None until every piece has come."""
        key = (model_hash, kind)
        if not self._is_whole(key):
            return None
        data = b''.join(self._pieces[key][number] for number in range(self._count[key][0]))
        return data.decode('utf-8', 'replace') if len(data) == self._count[key][1] else None

    def robot(self, model_hash: int) -> robot.Robot | None:
        """The robot of that hash, or None until its texts are whole.  PolicyError when they are no robot."""
        texts = [self.text(model_hash, kind) for kind in (URDF, SRDF, ROBOT_YAML)]
        urdf, srdf, settings = texts
        if urdf is None or settings is None:
            return None
        found = robot.from_texts(urdf, srdf or '', parse(settings, 'robot.yaml'))
        if not found.names():
            raise PolicyError('the robot on the bus has no joints')
        return found
