"""What kinematics_bench prints, a block per posture, for peers that compute the same."""

import numpy

LIMIT = 1e-10  # of relative differences


def blocks(text):
    block = {}
    for line in text.splitlines():
        name, *values = line.split()
        if name == "end":
            yield block
            block = {k: block[k] for k in ("joints", "link")}
        else:
            block[name] = values if name in ("joints", "link") else numpy.array([float(v) for v in values])
