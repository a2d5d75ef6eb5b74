"""The network: an ONNX file in onnxruntime, on one thread.  Its shapes are held against the specification before it runs."""
from __future__ import annotations

import pathlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .arguments import REMEDY
from .errors import PolicyError, Refused

Array = NDArray[np.float64]

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
        self.input, self.output = self._choose(inputs, input_name, 'input'), self._choose(outputs, output_name, 'output')
        self.memory: dict[str, str] = {}  # input of a recurrent network: the output that it gets in the next tick
        self._zero: dict[str, Any] = {}
        for name, entry in inputs.items():
            if name == self.input:
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
        return next(iter(there))

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

    def reset(self) -> None:
        """Forgets what a recurrent network remembers."""
        self._now = dict(self._zero)

    def run(self, observation: Array) -> Array:
        """observation [observation_size] -> action [action_size].  PolicyError when it does not come out as promised."""
        feed = {self.input: np.asarray(observation, dtype=np.float32).reshape(self.input_shape), **self._now}
        wanted = [self.output, *self.memory.values()]
        try:
            results = self._session.run(wanted, feed)
        except Exception as error:
            raise PolicyError(f'the inference failed: {str(error).splitlines()[0][:200]}') from None
        self._now = dict(zip(self.memory, results[1:]))
        action = np.asarray(results[0], dtype=np.float64).reshape(-1)
        return action
