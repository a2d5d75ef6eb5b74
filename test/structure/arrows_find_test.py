#!/usr/bin/env python3
"""The structure tests find every kind of planted mistake, say what to do, and find nothing in a clean tree."""

import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import arrows_test  # noqa: E402

CLEAN = {
    "robot/CMakeLists.txt": "twinbus_folder(robot/model)\n",
    "bridge/CMakeLists.txt": "twinbus_folder(bridge/gate PUBLIC robot/model)\n",
    "sim/CMakeLists.txt": "twinbus_folder(sim/engine PRIVATE robot/model)\n",
    "launcher/CMakeLists.txt": "twinbus_folder(launcher/up PRIVATE bridge/gate lcmtypes/bus)\n",
    "lcmtypes/CMakeLists.txt": "twinbus_folder(lcmtypes/bus)\n",
    "robot/model/model.h": "#pragma once\nstruct Model {\n};\n",
    "lcmtypes/bus/bus.h": "#pragma once\n",
    "bridge/gate/gate.h": '#pragma once\n#include "robot/model/model.h"\n',
    "sim/engine/ode_world.cpp": '#include <ode/ode.h>\n#include "robot/model/model.h"\n',
    "launcher/up/up.cpp": '#include "bridge/gate/gate.h"\n#include "lcmtypes/bus/bus.h"\n',
    "control/main.cpp": '#include "lcmtypes/bus/bus.h"\n#include "robot/model/model.h"\n',
}

# (file, text, what the sentence says)
PLANTED = [
    ("robot/model/a.cpp", '#include "bridge/gate/gate.h"\n', "no arrow leads from robot/model to bridge/gate"),
    ("robot/CMakeLists.txt", "twinbus_folder(robot/model PRIVATE bridge/gate)\n", "a circle of folders"),
    ("sim/engine/b.h", '#pragma once\n#include "robot/model/model.h"\n', "is PRIVATE in twinbus_folder(sim/engine"),
    ("robot/new_folder/c.cpp", "\n", "is in no twinbus_folder()"),
    ("bridge/gate/d.cpp", '#include "lcmtypes/bus/bus.h"\n', "know the bus"),
    ("bridge/gate/e.cpp", '#include "twinbus/robot_state_t.hpp"\n', "know the bus"),
    ("bridge/gate/f.cpp", "#include <ode/ode.h>\n", "its door is"),
    ("robot/model/g.h", "#pragma once\n#include <fcl/fcl.h>\n", "its door is"),
    ("robot/model/h.cpp", '#include "test/tools/x.h"\n', "the product needs no test"),
    ("robot/h_main.cpp", '#include "test/tools/x.h"\n', "the product needs no test"),
    ("robot/model/i.h", "#pragma once\nstruct Model {\n};\n", "Model is defined in"),
    ("robot/model/j.h", "#pragma once\n", "no file of the product includes it"),
    ("robot/model/k.cpp", "\n" * 600, "the ceiling is"),
    ("robot/model/l.cpp", "// see doc/nowhere_page.m" "d\n", "write the page or name the one that is"),
    ("robot/model/m.cpp", "// see /ho" "me/someone/notes\n", "a path of one machine"),
    ("test/bench/chart_n.py", "print()\n", "chmod +x"),
]


def problems_of(files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return arrows_test.check(root)


def main():
    bad = 0
    for name, text, sentence in PLANTED:
        if not any(sentence in problem for problem in problems_of({**CLEAN, name: text})):
            print(f"not found: {name}: '{sentence}'")
            bad += 1
    for problem in problems_of(CLEAN):
        print(f"found in a clean tree: {problem}")
        bad += 1
    print("ok" if bad == 0 else f"{bad} wrong")
    return bad != 0


if __name__ == "__main__":
    sys.exit(main())
