#!/usr/bin/env python3
"""The structure tests find every kind of planted mistake, say what to do, and find nothing in a clean tree."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import arrows_test  # noqa: E402
import duplicates_test  # noqa: E402
import unity_test  # noqa: E402

CLEAN = {
    "robot/CMakeLists.txt": "twinbus_folder(robot/model)\n",
    "bridge/CMakeLists.txt": "twinbus_folder(bridge/gate PUBLIC robot/model)\n",
    "sim/CMakeLists.txt": "twinbus_folder(sim/engine PRIVATE robot/model)\n",
    "launcher/CMakeLists.txt": "twinbus_folder(launcher/up PRIVATE bridge/gate lcmtypes/bus)\n",
    "lcmtypes/CMakeLists.txt": "twinbus_folder(lcmtypes/bus)\n",
    "robot/model/model.h": "#pragma once\nnamespace twinbus::inline robot {\nstruct Model {\n};\n}\n",
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
    ("robot/model/i.h", "#pragma once\nnamespace twinbus::inline robot {\nstruct Model {\n};\n}\n", "Model is defined in"),
    ("sim/engine/r.h", "#pragma once\nnamespace twinbus::inline sim {\nstruct Model {\n};\n}\n", "twinbus::Model would be ambiguous"),
    ("robot/model/o.cpp", "namespace twinbus {\nint o() { return 1; }\n}\n", "open it with `namespace twinbus::inline robot {`"),
    ("robot/model/p.cpp", "namespace twinbus::inline sim {\nint p() { return 1; }\n}\n", "open it with `namespace twinbus::inline robot {`"),
    ("robot/model/q.cpp", "struct Q {\n};\n", "put it into `namespace twinbus::inline robot {`"),
    ("robot/model/j.h", "#pragma once\n", "no file of the product includes it"),
    ("robot/model/k.cpp", "\n" * 600, "the ceiling is"),
    ("robot/model/l.cpp", "// see doc/nowhere_page.m" "d\n", "write the page or name the one that is"),
    ("robot/model/m.cpp", "// see /ho" "me/someone/notes\n", "a path of one machine"),
    ("test/bench/chart_n.py", "print()\n", "chmod +x"),
]


def problems_of(files, check=arrows_test.check):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return check(root)


# Lines of a function; {}: what a copy calls otherwise.
WRITTEN_TWICE = ["double {}(const Limits& limits, double q) {{", "  if (!(q > limits.low)) return limits.low;", "  double {}_sum = 0.0;",
                 "  for (const Step& step : limits.steps) {}_sum += step.share * q;", "  const auto best = std::min({}_sum, limits.high);",
                 "  while (best > 1.0) limits.count(best, q);", "  return best - {}_sum;"]


def wrong_with_duplicates():
    """What the count of alike places gets wrong."""
    def pairs(*files):
        return problems_of({f"robot/{i}.cpp": text for i, text in enumerate(files)}, duplicates_test.check)
    of = ["\n".join(line.format(name) for line in WRITTEN_TWICE) + "\n" for name in ("least", "most")]
    if len(pairs(of[0], "int x;\n")[1]) != 0 or len(pairs(*of)[1]) != 1 or pairs(*of)[0]:
        yield "a place that is alike but for names is one pair, and no problem"
    if len(pairs(of[0], of[1].replace("std::min", "std::max(0.0)"))[1]) != 0:
        yield "five alike lines are no pair"
    long = of[0] + of[0].replace("while (best", "until (best")
    if not any("say the same in 14 lines" in problem for problem in pairs(long, long)[0]):
        yield "what is the same to the letter over eight lines is a problem"
    many = [of[0]] + [of[0].replace("Limits", f"L{i}") for i in range(7)]
    kinds = [[text.replace("while", word) for text in many] for word in ("a.b", "a->b")]
    if not any("the most are 40" in problem for problem in pairs(*kinds[0], *kinds[1])[0]):
        yield "more than 40 pairs are a problem"
    rows = "".join(f"  double member_{i} = {i}.0;  // [m]\n" for i in range(7))
    if pairs(rows, rows.replace("member", "other"))[1]:
        yield "rows of declarations are no pair"


def wrong_with_names_of_a_folder():
    """What the search for names that two files of a folder share gets wrong."""
    def shared(*lines):
        text = "namespace twinbus::inline robot {{\nnamespace {{\n{}\n}}  // namespace\n}}\n"
        return problems_of({f"robot/model/{i}.cpp": text.format(line) for i, line in enumerate(lines)}, unity_test.check)
    for line in ("constexpr double kShare = 0.5;", "struct Found {", "double between(double a, double b = 1.0) {"):
        if len(shared(line, line.replace(" a,", " c,"))) != 1:
            yield f"a folder that says twice: {line}"
        if shared(line):
            yield f"a folder that says once: {line}"
    if len(shared("constexpr double kOne = 1.0, kShare = 0.5;", "constexpr double kShare = 0.25;")) != 1:
        yield "a folder that says twice, once in a list"
    if len(shared("using Found = int;", "using Found = double;")) != 1 or shared("using Found = int;", "using Found = int;"):
        yield "one name for two types"
    if shared("double between(double a) {", "double between(int a) {"):
        yield "functions of one name whose parameters differ"
    header = "struct Standing {\n  int foot;\n};\n"
    hidden = {"sim/world/standing.h": header, "robot/model/0.cpp": "namespace {\nstruct Standing {\n};\n}  // namespace\n"}
    if problems_of(hidden | {"robot/model/1.cpp": "int foot_of(const Walking& feet);\n"}, unity_test.check):
        yield "a type of an unnamed namespace that hides none"
    if len(problems_of(hidden | {"robot/model/1.cpp": "int foot_of(const Standing& feet);\n"}, unity_test.check)) != 1:
        yield "a type of an unnamed namespace that hides another room's"


def wrong_with_scene_keys():
    """What a scene key without its line in doc/scenes.md passes by."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name in ("sim/scene", "sim/world", "robot/description", "lcmtypes/msg", "config/scenes"):
            shutil.copytree(HERE.parents[1] / name, root / name, ignore=shutil.ignore_patterns("*.yaml", "meshes"))
        (root / "doc").mkdir()
        shutil.copy(HERE.parents[1] / "doc/scenes.md", root / "doc/scenes.md")

        def said():
            return subprocess.run([sys.executable, HERE / "scenes_page_test.py", root], capture_output=True, text=True, check=False).stdout
        if "0 problems" not in said():
            yield "nothing is wrong with the scenes of this tree: " + said()
        page, source = root / "doc/scenes.md", root / "sim/scene/scene.cpp"
        text = page.read_text()
        page.write_text("".join(line for line in text.splitlines(True) if not line.startswith("| `duration`")))
        if "--write" not in said():
            yield "a line of doc/scenes.md that is missing"
        page.write_text(text)
        code = source.read_text()
        source.write_text(code.replace('top.number("duration"', 'top.number("gravity_tilt", 0.0, 1.0, 0.0);\n  top.number("duration"', 1))
        if "say in MEANING" not in said():
            yield "a key that the code reads and the page has not"


def main():
    bad = 0
    for name, text, sentence in PLANTED:
        if not any(sentence in problem for problem in problems_of({**CLEAN, name: text})):
            print(f"not found: {name}: '{sentence}'")
            bad += 1
    for sentence in (*wrong_with_duplicates(), *wrong_with_names_of_a_folder(), *wrong_with_scene_keys()):
        print(f"not held: {sentence}")
        bad += 1
    for problem in problems_of(CLEAN):
        print(f"found in a clean tree: {problem}")
        bad += 1
    print("ok" if bad == 0 else f"{bad} wrong")
    return bad != 0


if __name__ == "__main__":
    sys.exit(main())
