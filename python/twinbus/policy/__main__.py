"""python3 -m twinbus.policy, as ./twinbus policy starts it."""
import sys

from .arguments import REMEDY, parse

words = parse()
try:
    import numpy  # noqa: F401
    import onnxruntime  # type: ignore[import-untyped,import-not-found,unused-ignore]  # noqa: F401
    import yaml  # type: ignore[import-untyped,unused-ignore]  # noqa: F401
except ImportError as error:
    sys.exit(f'policy: {error.name}: {REMEDY}')
from .command_line import main  # noqa: E402

sys.exit(main(words))
