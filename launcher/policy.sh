#!/bin/sh
# Runs python/twinbus/policy.  TWINBUS_POLICY_PYTHON: an interpreter that has onnxruntime and PyYAML, as that of a virtual environment.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
python=${TWINBUS_POLICY_PYTHON:-python3}
command -v "$python" >/dev/null || { echo "policy: no program $python; TWINBUS_POLICY_PYTHON names a Python 3" >&2; exit 1; }
[ -z "${TWINBUS_BUILD:-}" ] || export TWINBUS_BIN="${TWINBUS_BIN:-$TWINBUS_BUILD/bin}"
PYTHONPATH=$root/python${PYTHONPATH:+:$PYTHONPATH} exec "$python" -m twinbus.policy "$@"
