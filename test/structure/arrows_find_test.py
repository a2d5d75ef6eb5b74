#!/usr/bin/env python3
"""The arrow test finds every kind of planted mistake, and nothing in a clean tree."""

import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import arrows_test  # noqa: E402

PLANTED = {
    "robot/a.h": '#include "bridge/adaptor.h"\n',
    "control/b.cpp": '#include "lcmtypes/bus.h"\n',
    "planner/c.cpp": '#include "twinbus/robot_state_t.hpp"\n',
    "bridge/d.cpp": "#include <ode/ode.h>\n",
    "robot/e.h": "#include <fcl/fcl.h>\n",
    "sim/f.h": "\n" * 300,
    "test/bench/chart_h.py": "print()\n",
    "robot/g.cpp": "// see /ho" "me/someone/notes\n",
}
CLEAN = {
    "control/main.cpp": '#include "lcmtypes/bus.h"\n#include "robot/model.h"\n',
    "sim/ode_world.cpp": "#include <ode/ode.h>\n",
    "launcher/up.cpp": '#include "sim/scene.h"\n',
    "bridge/x.h": '#include "robot/model.h"\n',
}


def problems_of(files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return arrows_test.check(root)


def main():
    bad = 0
    for name, text in PLANTED.items():
        if not any(p.startswith(name) for p in problems_of({name: text})):
            print(f"not found: {name}")
            bad += 1
    for problem in problems_of(CLEAN):
        print(f"found in a clean tree: {problem}")
        bad += 1
    print("ok" if bad == 0 else f"{bad} wrong")
    return bad != 0


if __name__ == "__main__":
    sys.exit(main())
