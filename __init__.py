"""Beside a clone that is called twinbus, `import twinbus` of a script means the Python package in it, not the folder of the clone."""

import importlib.util
import pathlib
import sys

_package = pathlib.Path(__file__).resolve().parent / "python/twinbus"
_spec = importlib.util.spec_from_file_location(__name__, _package / "__init__.py", submodule_search_locations=[str(_package)])
assert _spec is not None and _spec.loader is not None
_module = importlib.util.module_from_spec(_spec)
sys.modules[__name__] = _module
_spec.loader.exec_module(_module)
