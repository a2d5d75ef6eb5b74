"""The network: an ONNX file in onnxruntime, on one thread.  Its shapes are held against the specification before it runs."""
from __future__ import annotations

import pathlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .arguments import REMEDY
from .errors import PolicyError, Refused

Array = NDArray[np.float64]
CLOCK, JOINT_OUTPUTS = 'time_step', ('joint_pos', 'joint_vel')
ANCHOR_OUTPUTS = ('ref_quat_xyzw', 'body_quat_w')  # holosoma: of its anchor; mjlab, BeyondMimic: w first, of all bodies of body_names


class Network:
    """PolicyError when the file is no network of one observation and one action, REMEDY when onnxruntime is not there."""

    def __init__(self, path: pathlib.Path, input_name: str = '', output_name: str = '') -> None:
        try:
            import onnxruntime  # type: ignore[import-untyped,import-not-found,unused-ignore]
        except ImportError:
            raise PolicyError(REMEDY) from None
        if not path.is_file():
            raise PolicyError(f'{path}: no such file')
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        options.log_severity_level = 4
        try:
            self._session = onnxruntime.InferenceSession(str(path), options, providers=['CPUExecutionProvider'])
        except Exception as error:  # onnxruntime has an exception type per status
            raise PolicyError(f'{path}: onnxruntime cannot load it: {str(error).splitlines()[0][:300]}') from None
        self.path = path
        self.metadata: dict[str, str] = dict(self._session.get_modelmeta().custom_metadata_map)
        inputs = {entry.name: entry for entry in self._session.get_inputs()}
        outputs = {entry.name: entry for entry in self._session.get_outputs()}
        # A motion is inside of it: the clock says which frame comes out beside the action.
        turned = next((name for name in ANCHOR_OUTPUTS if name in outputs), '')
        self.clock = CLOCK if CLOCK in inputs and turned and all(name in outputs for name in JOINT_OUTPUTS) else ''
        self._clock_shape, self._anchor_output, self.time_step = self._shape(inputs[self.clock]) if self.clock else (), turned, 0
        self.input, self.output = self._choose(inputs, input_name, 'input'), self._choose(outputs, output_name, 'output')
        self.memory: dict[str, str] = {}  # input of a recurrent network: the output that it gets in the next tick
        self._zero: dict[str, Any] = {}
        for name, entry in inputs.items():
            if name == self.input or name == self.clock:
                continue
            stem = name[:-3] if name.endswith('_in') else name
            back = next((other for other in (f'{stem}_out', f'{name}_out', f'{stem}n') if other in outputs), None)
            if back is None:
                what = 'the number of a tick of a motion that is inside of it' if name == 'time_step' else 'something that nobody gives it'
                raise Refused(f'{path}: beside {self.input} it reads {name}, {what}; only policies of one observation run')
            self.memory[name] = back
            self._zero[name] = np.zeros(self._shape(entry), dtype=np.float32)
        self.input_shape, self.output_shape = self._shape(inputs[self.input]), self._shape(outputs[self.output])
        if 'float' not in inputs[self.input].type or 'double' in inputs[self.input].type:
            raise PolicyError(f'{path}: {self.input} is {inputs[self.input].type}, not float32')
        self._now: dict[str, Any] = {}
        self.reset()
        self.run(np.zeros(self.observation_size))  # the first run takes longest
        self.reset()

    def _choose(self, there: dict[str, Any], wanted: str, what: str) -> str:
        if wanted:
            if wanted not in there:
                raise PolicyError(f'{self.path}: no {what} {wanted!r}; there are: {", ".join(there)}')
            return wanted
        if not there:
            raise PolicyError(f'{self.path}: it has no {what}')
        return next(name for name in [*(name for name in there if name != CLOCK), CLOCK] if name in there)

    @staticmethod
    def _shape(entry: Any) -> tuple[int, ...]:
        return tuple(size if isinstance(size, int) and size > 0 else 1 for size in entry.shape)

    @property
    def observation_size(self) -> int:
        """Numbers of one observation."""
        return int(np.prod(self.input_shape))

    @property
    def action_size(self) -> int:
        return int(np.prod(self.output_shape))

    @property
    def carries_motion(self) -> bool:
        return bool(self.clock)

    def _time(self, number: int) -> dict[str, Any]:
        return {self.clock: np.full(self._clock_shape, number, dtype=np.float32)} if self.clock else {}

    def motion_frame(self, number: int) -> tuple[Array, Array, Array]:
        """Of the motion inside: joints [rad], their speeds [rad/s], attitude of the anchor, w x y z.  PolicyError when there is none."""
        try:
            return self._motion_frame(number)
        except PolicyError:
            raise
        except Exception as error:
            raise PolicyError(f'{self.path}: frame {number} of the motion inside cannot be read: {(str(error).splitlines() or [""])[0][:200]}; '
                              '--motion FILE names another') from None

    def _motion_frame(self, number: int) -> tuple[Array, Array, Array]:
        feed = {self.input: np.zeros(self.input_shape, dtype=np.float32), **self._zero, **self._time(number)}
        q, qd, turned = (np.asarray(part, dtype=np.float64) for part in self._session.run([*JOINT_OUTPUTS, self._anchor_output], feed))
        turned = turned.reshape(-1, 4)
        if self._anchor_output == 'body_quat_w':
            bodies = [name.strip() for name in self.metadata.get('body_names', '').split(',')]
            anchor = self.metadata.get('anchor_body_name', '').strip()
            if anchor not in bodies or bodies.index(anchor) >= len(turned):
                raise PolicyError(f'{self.path}: its metadata does not say which of its {len(turned)} bodies is the anchor')
            return q.reshape(-1), qd.reshape(-1), turned[bodies.index(anchor)]
        return q.reshape(-1), qd.reshape(-1), turned[0, [3, 0, 1, 2]]

    def reset(self) -> None:
        """Forgets what a recurrent network remembers."""
        self._now = dict(self._zero)

    def run(self, observation: Array) -> Array:
        """observation [observation_size] -> action [action_size].  PolicyError when it does not come out as promised."""
        feed = {self.input: np.asarray(observation, dtype=np.float32).reshape(self.input_shape), **self._now, **self._time(self.time_step)}
        wanted = [self.output, *self.memory.values()]
        try:
            results = self._session.run(wanted, feed)
        except Exception as error:
            raise PolicyError(f'the inference failed: {(str(error).splitlines() or [""])[0][:200]}') from None
        self._now = dict(zip(self.memory, results[1:]))
        action = np.asarray(results[0], dtype=np.float64).reshape(-1)
        return action
