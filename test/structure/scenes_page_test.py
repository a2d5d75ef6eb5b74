#!/usr/bin/env python3
"""doc/scenes.md has every key of a scene and every setting, with the ranges and defaults of the code that reads them, and
config/scenes/scene.schema.json has the same for editors.

    scenes_page_test.py            says what is missing or old
    scenes_page_test.py --write    writes both anew
    scenes_page_test.py FOLDER     looks at another tree (the test of this test does)

Keys, kinds, ranges and defaults are read from the calls in sim/scene (ConfigNode), settings from the table kEntries of
sim/scene/settings.cpp; what a key means is said here. A key without a meaning, or a meaning without a key, is a failure.
"""

import json
import pathlib
import re
import sys

ROOT = pathlib.Path(next((word for word in sys.argv[1:] if not word.startswith("--")), pathlib.Path(__file__).parents[2])).resolve()
PAGE = ROOT / "doc/scenes.md"
SCHEMA = ROOT / "config/scenes/scene.schema.json"
SOURCES = sorted(str(file.relative_to(ROOT)) for file in (ROOT / "sim/scene").glob("*.cpp")) + ["robot/description/loops.cpp",
                                                                                            "lcmtypes/msg/step_list.cpp"]
HEADERS = ["sim/scene/scene.h", "sim/scene/scene_criteria.h", "sim/scene/fidelity.h", "sim/world/world.h", "robot/description/loops.h", "sim/world/link_hull.h"]

# (function, variable) that reads -> maps that it reads. None: any variable of that function.
READERS = {
    ("load_scene", "top"): ["scene"], ("load_scene", "ground"): ["ground"], ("read_loose", None): ["loose[]"],
    ("read_mesh", None): ["loose[]"], ("read_covered", None): ["obstacles[]"], ("beside_scene", None): ["obstacles[]", "loose[]"],
    ("read_obstacle", None): ["obstacles[]"], ("read_robot", None): ["robots[]"], ("read_grasp", None): ["grasps[]"],
    ("read_push", None): ["pushes[]"], ("read_place", None): ["grasps[]", "pushes[]"], ("read_mode", None): ["modes[]"], ("read_goal", None): ["goals[]"],
    ("read_walk", None): ["walks[]"], ("read_pad", None): ["pads[]"], ("read_timed_steps", None): ["footsteps[]"],
    ("read_timed_motion", None): ["motions[]"], ("read_steps", "node"): ["footsteps[]"], ("read_steps", "step"): ["footsteps[].steps[]"], ("read_terrain", None): ["terrain"],
    ("read_push_round", None): ["push_round"], ("read_disturbance", None): ["disturbance"], ("read_body", None): ["bodies[]"],
    ("read_loop", None): ["loops[]"], ("read_criteria", "node"): ["criteria"], ("read_criteria", "swing"): ["criteria.swing"],
    ("read_loose_end", None): ["criteria.loose[]"], ("loose_name", None): ["criteria.loose[]", "criteria.spins[]"],
    ("read_robot_end", None): ["criteria.robots[]"], ("read_joint_end", None): ["criteria.joints[]"],
    ("read_spin", None): ["criteria.spins[]"], ("read_touch", None): ["criteria.touch"], ("loops_of", None): [], ("rpy", None): [],  # robot.yaml; helper
}

MAPS = {
    "scene": "The top of the file.", "ground": "Of the flat ground.", "obstacles[]": "What stands fixed; simulator, guard and planner know it.",
    "pushes[]": "A constant force on a link for a while.", "modes[]": "What the controller is asked for, and when.",
    "goals[]": "Where a hand is to go.", "walks[]": "A velocity to walk at, in mode walk.", "pads[]": "A gamepad that is held.",
    "footsteps[]": "Footsteps one after the other, in mode walk.", "footsteps[].steps[]": "One footstep, in the frame of the sole that stands then.",
    "motions[]": "A motion file that is played by the standing robot (doc/motion.md); refused if its check fails.",
    "terrain": "Square tiles of random height and slope, which planner and guard do not know.",
    "push_round": "Pushes one after the other, each in the next of eight directions.",
    "disturbance": "How far each seed draws the start from what the scene says, evenly within + and - this.",
    "bodies[]": "The simulated robot is not the one that the controller knows.",
    "loose[]": "A body that nothing holds; planner and guard do not know it.", "robots[]": "A further robot, which stands in a pose.",
    "loops[]": "Two points held together, beside the `loops:` of robot.yaml.", "grasps[]": "A link grips something as it then lies in it.",
    "criteria": "When a run has passed. What is not asked is not judged, but falls and self-collisions.",
    "criteria.loose[]": "Where a loose body is at the end.", "criteria.robots[]": "A further robot ends about where it began, upright.",
    "criteria.joints[]": "Where a joint is at the end.", "criteria.spins[]": "A loose body on which no torque acts turns on as it did.",
    "criteria.touch": "The robot is touched at so many points, everywhere by the same force.",
    "criteria.swing": "After the scene's one push a joint's torque swings as the linear model of the standing robot does.",
}

AT, FOR = "when, scene time [s]", "for how long [s]"
POSE = {"position": "in world [m]", "rpy_deg": "turn about x, then y, then z [degrees]"}
FORCE = {"stiffness": "[N/m]", "damping": "[N s/m]"}
MEANING = {
    "scene": {
        "about": "one sentence", "robot": "a name under config/robots, or a folder", "engine": "physics engine; mujoco: where MuJoCo is installed (`pip install mujoco`, or `TWINBUS_MUJOCO`)", "contact": "how what touches pushes back; patch: soles, links and what is convex with their area (engine ode: the robot on what is fixed); rigid: engine ode only; soft: MuJoCo's under the robot, which creeps (engines articulated and mujoco)",
        "duration": "of `run` and `up --for` [s]", "step": "physics step, a whole part of the control period; 0: the period [s]",
        "accuracy": "error that `run` holds by its choice of order and step, such as 1 mm", "start_pose": "named pose of the SRDF",
        "fidelity": "how much is modelled; auto: no more than the accuracy needs (`run`), legs: all other joints are held, rigid: all are", "held": "joints that stand still for good, by name; `base` holds the base, the name of a further robot all of it",
        "rigid": "further robots that are one rigid body, by name", "aloft": "links of the robot of which nothing but soles touches the ground or an obstacle, by name", "untouched": "links of the robot that meet nothing loose and no further robot, by name",
        "start_velocity": "of joints at the start, by name [rad/s or m/s]", "origin": "where in the simulated world all of the scene begins, x and y [m]", "base": "whether the base is free", "lengths": "in which obstacles, loose bodies and their ends are given: metres, or lengths of the right arm (or the only one) from its shoulder, and then all is turned about the shoulder, shifted, made smaller and hands turned otherwise, no more than is needed, until the robot begins clear of it and reaches its goals", "self_contact": "links of one robot touch one another", "robust": "it holds in worlds that differ a little: `run --seeds` draws starts, masses and friction of each seed", "asleep": "loose bodies that lie still are not modelled until something touches them",
        "settings": "see Settings; --set wins over them", **{name.split("[")[0]: f"see {name}" for name in (
            "ground", "obstacles[]", "pushes[]", "modes[]", "goals[]", "walks[]", "pads[]", "footsteps[]", "motions[]", "terrain", "push_round", "disturbance",
            "bodies[]", "loose[]", "robots[]", "loops[]", "grasps[]", "criteria")}},
    "ground": {"friction": "Coulomb, combined with the sole's as geometric mean"},
    "obstacles[]": {"shape": "what it is", "size": "box: edges; sphere: radius; cylinder: radius, length [m]", "position": "of its middle, or of the file's origin, ground frame [m]", "rpy_deg": POSE["rpy_deg"],
                    "file": "beside the scene or below: STL, OBJ, DAE; points; heights", "scale": "of a mesh file", "cell": "of the boxes that cover a mesh, points or heights [m]",
                    "spacing": "of a height map [m]"},
    "pushes[]": {"link": "name", "point": "in the link's frame [m]", "impulse": "in world [N s]", "force": "the same as impulse over duration, in world [N]", "at": AT, "duration": FOR, "for": "another word for duration"},
    "modes[]": {"at": AT, "mode": "as in mode_request_t", "motion": "in mode balance", "duration": "of a pose [s]", "amplitude": "of a motion [m]", "frequency": "of a motion [Hz]", "pose": "named pose, for mode pose"},
    "goals[]": {"at": AT, "hand": "left, right, or as robot.yaml calls an arm", "speed": "share of the joint velocity limits", "pose": "named pose: the arm's joints of it", "cancel": "ends the motion under way",
                "position": "of the hand, ground frame [m]", "reach": "the same from the shoulder, in lengths of the stretched arm, for an arm of any size", "rpy_deg": "its turn too [degrees]; of a `reach` in lengths of an arm for axes whose z points away from the wrist"},
    "walks[]": {"at": AT, "for": FOR, "vx": "forward [m/s]", "vy": "left [m/s]", "wz": "turn left [rad/s]"},
    "pads[]": {"at": AT, "for": FOR, "left_x": "left stick, left positive", "left_y": "left stick, forward positive", "right_x": "right stick, left positive"},
    "footsteps[]": {"at": AT, "steps": "see footsteps[].steps[]"},
    "footsteps[].steps[]": {"foot": "that moves; they take turns", "x": "forward [m]", "y": "left [m]", "yaw": "[rad]"},
    "motions[]": {"at": AT, "file": "CSV or NPZ, beside the scene or a path", "columns": "of a CSV without names: lafan1, or a file of names", "rate": "frames a second of a file that does not say [Hz]",
                  "speed": "how fast it is played", "from": "the part that is taken [s]", "until": "its end; 0: the file's [s]", "upper": "nothing of what the legs do"},
    "terrain": {"tile": "edge of a tile [m]", "height": "of a tile, from 0 to this [m]", "slope_deg": "about x and y, up to this [degrees]",
                "ramp_deg": "the first third goes up so steeply, the last down [degrees]", "from": "along x [m]", "length": "along x [m]", "width": "along y [m]"},
    "push_round": {"link": "name; empty: the base", "at": AT, "every": "from push to push [s]", "count": "how many", "phase": "a push comes up to so much later [s]",
                   "forward": "change of velocity of the whole robot [m/s]", "back": "the same [m/s]", "sideways": "the same [m/s]", "duration": FOR},
    "disturbance": {"position": "of each loose body [m]", "angle_deg": "of each loose body [degrees]", "velocity": "of each loose body [m/s]", "spin": "of each loose body [rad/s]",
                    "mass": "of each loose body and the robot, relative", "friction": "of each loose body and the ground, relative", "joints": "speed of the robot's joints [rad/s or m/s]"},
    "bodies[]": {"link": "name", "mass": "added [kg]", "at": "where, in the link's frame [m]", "shift": "of the link's own centre of mass [m]"},
    "loose[]": {"name": "of the body", "shape": "what it is", "size": "box: edges; sphere: radius; cylinder, capsule: radius, length [m]", "mass": "[kg]", **POSE,
                "file": "closed mesh beside the scene or below", "scale": "of a mesh file", "velocity": "in world [m/s]", "angular_velocity": "in world [rad/s]",
                "friction": "Coulomb", **FORCE},
    "robots[]": {"name": "of the robot in this scene", "robot": "as at the top", "pose": "named pose", "position": "x, y of the middle between its soles [m]", "yaw_deg": "[degrees]"},
    "loops[]": {"link": "name", "point": "in its frame [m]", "to": "another link, a loose body, or world", "at": "in its frame [m]", **FORCE, "length": "of a spring between the points [m]"},
    "grasps[]": {"link": "name", "point": "in its frame [m]", "to": "a loose body, a link, NAME/LINK of a further robot, or world", "at": AT, "until": "lets go then [s]",
                 "reach": "of the three points that hold, from that one [m]", **FORCE},
    "criteria": {"max_tilt_deg": "of the base, at most [degrees]", "zmp_margin_min_mm": "of the ZMP to the edge of the support polygon, at least [mm]", "slip_max_mm": "of a sole, at most [mm]",
                 "sole_tilt_max_deg": "at most [degrees]", "zmp_margin_p5_mm": "5th percentile, at least [mm]", "step_slip_max_mm": "of a sole while it stands, in any step, at most [mm]",
                 "force_rms_percent": "normal force of a foot against what was wanted, of the weight, at most", "velocity_error_percent": "of what was commanded, over each walk, at most",
                 "travel_min_m": "of the base, at least [m]", "drift_max_m": "of the base, at most [m]", "energy_drift_j": "of the robot while no servo works on it, at most [J]",
                 "loose_energy_drift_j": "of all loose bodies together, at most [J]", "loose_energy_gain_j": "the same, upward only [J]",
                 "goals_reached_min": "of the arm goals: the path done, then the hand within 5 mm or the joints within 0.01 rad of it, at least",
                 "max_doubted_steps": "physics steps that the engine does not trust, at most", "no_fall": "a fall fails the run", "no_self_collision": "links that touch fail the run",
                 "loose": "see criteria.loose[]", "robots": "see criteria.robots[]", "joints": "see criteria.joints[]", "spins": "see criteria.spins[]", "touch": "see criteria.touch", "swing": "see criteria.swing"},
    "criteria.loose[]": {"name": "of the body", "position": "of its middle, from the scene's origin [m]", "within_m": "of that [m]", "speed_m_s": "at most [m/s]"},
    "criteria.robots[]": {"name": "of the robot", "within_m": "of where its base began, level [m]", "max_tilt_deg": "of its base [degrees]"},
    "criteria.joints[]": {"name": "of the joint", "position": "[rad or m]", "within": "of that [rad or m]", "speed": "[rad/s or m/s]", "speed_within": "of that [rad/s or m/s]"},
    "criteria.spins[]": {"name": "of the body", "energy_drift": "of turning, at most, relative", "momentum_drift": "angular, in world, at most, relative",
                         "flips": "how often its middle axis points the other way"},
    "criteria.touch": {"points": "how many", "force_n": "upward, at each [N]", "within": "relative", "from": "in every tick from here on [s]"},
    "criteria.swing": {"joint": "name", "period_percent": "of the model's", "decay_percent": "of the model's"},
}

# What a regular expression does not see.
DEFAULT = {
    ("obstacles[]", "size"): "required of box, sphere, cylinder", ("obstacles[]", "file"): "required of mesh, points, height_map",
    ("obstacles[]", "spacing"): "required of height_map", ("loose[]", "size"): "required unless mesh", ("loose[]", "file"): "required of mesh",
    ("goals[]", "position"): "required without pose or cancel", ("modes[]", "pose"): "required of mode pose", ("robots[]", "robot"): "the scene's",
    ("grasps[]", "until"): "never", ("pushes[]", "impulse"): "required without force", ("pushes[]", "force"): "", ("pushes[]", "for"): "",
}


def arguments(text, at):
    """The arguments of a call, from behind its opening bracket."""
    depth, start, found = 0, at, []
    for i in range(at, len(text)):
        c = text[i]
        if c in "([{":
            depth += 1
        elif c in ")]}" and depth:
            depth -= 1
        elif c == "," and not depth or c == ")":
            found.append(" ".join(text[start:i].split()))
            start = i + 1
            if c == ")":
                return found
    raise ValueError("a call that does not end")


def constants():
    """Of headers and sources: constants, lists of names, and defaults of members by struct."""
    numbers, names, members = {}, {}, {}
    for file in HEADERS + SOURCES:
        text = re.sub(r"//[^\n]*", "", (ROOT / file).read_text())
        numbers.update(re.findall(r"constexpr (?:double|int|std::size_t) (\w+) = ([-+.\de]+);", text))
        for name, body in re.findall(r"(\w+)\[\] = \{([^}]*)\}", text):
            names[name] = re.findall(r'"(\w+)"', body)
        for struct, body in re.findall(r"^struct (\w+) \{(.*?)^\};", text, re.MULTILINE | re.DOTALL):
            for line in re.findall(r"^\s*(?:double|int|bool|std::string) ([^;]+);", body, re.MULTILINE):
                for member, value in re.findall(r"(\w+)\s*=\s*([^,]+)", line):
                    members[(struct, member)] = value.strip().strip('"')
    return numbers, names, members


def default_of(expression, variables, known):
    numbers, _, members = known
    value = expression
    if found := re.fullmatch(r"([a-z]\w*)\.(\w+)", expression):
        value = members.get((variables.get(found[1]), found[2]), "")
    value = numbers.get(value, value)
    value = value.strip('"')
    if value in ("kNan", "kNotAsked", "-1", "-1.0", "1e9") or value.startswith("&") or re.search(r"[*:(]", value):
        return "" if "*" not in value and "(" not in value else "from the others"
    try:
        return f"{float(value):g}"
    except ValueError:
        return value


def number(text, known):
    sign, name = ("-", text[1:]) if re.match("-k", text) else ("", text)
    try:
        return f"{float(sign + known[0].get(name, name)):g}"
    except ValueError:
        return text.split(".")[-1]  # another key


def keys():
    """{map: {key: (value, default)}} as the code reads them."""
    known = constants()
    found, problems = {name: {} for name in MAPS}, []
    for file in SOURCES:
        text = re.sub(r"//[^\n]*", "", (ROOT / file).read_text())
        starts = [(m.start(), m[1]) for m in re.finditer(r"^[A-Za-z][\w:<>&* ]*?[ &*](\w+)\([^;{]*\{", text, re.MULTILINE)]
        for (start, function), (end, _) in zip(starts, starts[1:] + [(len(text), "")]):
            body = text[start:end]
            variables = dict((b, a) for a, b in re.findall(r"\b([A-Z]\w+)&? (\w+)(?:;| =)", body))
            for call in re.finditer(r'(\w+)\.(number|integer|flag|text|choice|numbers|texts|map|list)\(\s*"(\w+)"|(bounded|point_of)\((\w+), "(\w+)"|\b(rpy)\((\w+)\)', body):
                variable, kind, key = (call[1], call[2], call[3]) if call[2] else (call[5], call[4], call[6]) if call[4] else (call[8], "rpy", "rpy_deg")
                maps = READERS.get((function, variable), READERS.get((function, None)))
                if maps is None:
                    problems.append(f"{file}: {function}() reads `{key}` of {variable}: say in READERS of this test of which map")
                    continue
                args = [] if kind == "rpy" else arguments(body, body.rindex("(", 0, call.end()) + 1)[1 if call[2] else 2:]
                value, default = described(kind, args, variables, known)
                if default == "required" and f'has("{key}")' in body:
                    default = ""
                for name in maps:
                    found[name].setdefault(key, (value, DEFAULT.get((name, key), default)))
    return found, problems


def described(kind, args, variables, known):
    if kind in ("number", "integer"):
        return (f"{number(args[0], known)} .. {number(args[1], known)}" + (", whole" if kind == "integer" else ""),
                default_of(args[2], variables, known) if len(args) > 2 else "required")
    if kind == "choice":
        choices = re.findall(r'"(\w+)"', args[0])
        for constant in re.findall(r"\bk\w+", args[0]):
            choices += [c for c in known[1].get(constant, []) if c not in choices]
        return ", ".join(choices), "required" if args[1] == "-1" else choices[int(args[1])]
    if kind == "numbers":
        return (f"{args[0]} numbers" if args[0].isdigit() else "numbers"), "required"
    if kind == "bounded":
        return f"3 numbers within {number(args[0], known)}", "required" if args[1] == "nullptr" else "0, 0, 0"
    return {"point_of": ("3 numbers", "0, 0, 0"), "rpy": ("3 numbers", "0, 0, 0"), "flag": ("true, false", args[0] if args else ""), "map": ("map", ""), "list": ("list of maps", ""), "texts": ("list of names", ""),
            "text": ("text", default_of(args[0], variables, known) if args else "required")}[kind]


def settings():
    text = (ROOT / "sim/scene/settings.cpp").read_text()
    limits = dict(re.findall(r"constexpr double (\w+) = ([-+.\de]+);", text))
    for key, low, high, meaning in re.findall(r'\{"([a-z_.]+)",\s*([-+.\w]+),\s*([-+.\w]+),\s*((?:"[^"]*"\s*)+),', text):
        yield key, f"{float(limits.get(low, low)):g} .. {float(limits.get(high, high)):g}", "".join(re.findall(r'"([^"]*)"', meaning))


def page():
    found, problems = keys()
    lines = ["# Scenes", "", "<!-- Written by test/structure/scenes_page_test.py --write: do not edit. -->", "",
             "A scene is a YAML file: what stands where, what is asked of the robot and when, and when a run has passed. `./twinbus run FILE` runs and",
             "judges it, `./twinbus up FILE` shows it. An unknown key is refused with its line and the nearest valid key. A short one is",
             "`examples/11_scene.yaml`; all are in `config/scenes`. An editor completes and checks one that begins with",
             "`# yaml-language-server: $schema=scene.schema.json` (the file is in `config/scenes`). `name[]` is a list, one map per entry; a key without a default may be left out unless it says required.", ""]
    for name, about in MAPS.items():
        lines += [f"## {name}", "", about, "", "| key | value | default | meaning |", "| --- | --- | --- | --- |"]
        order = list(MEANING[name])
        for key, (value, default) in sorted(found[name].items(), key=lambda row: order.index(row[0]) if row[0] in order else len(order)):
            if key not in MEANING[name]:
                problems.append(f"{name}: the code reads `{key}`; say in MEANING of test/structure/scenes_page_test.py what it means")
            lines.append(f"| `{key}` | {value} | {default} | {MEANING[name].get(key, '')} |")
        problems += [f"{name}: nothing reads `{key}` any more; take it out of MEANING of test/structure/scenes_page_test.py"
                     for key in MEANING[name] if key not in found[name]]
        lines.append("")
    lines += ["## Settings", "", "`settings: {KEY: value}` of a scene, or `--set KEY=value` of `run`, `up` and `twinbus_simulator`. Beside these: `engine`, `contact`.", "",
              "| key | range | meaning |", "| --- | --- | --- |"]
    lines += [f"| `{key}` | {span} | {meaning} |" for key, span, meaning in settings()]
    return "\n".join(lines) + "\n", problems


def shape_of(name, key, value, default):
    """One key for an editor: JSON schema, draft 7."""
    inner = key if name == "scene" else f"{name}.{key}"
    shape = {}
    if value == "map":
        shape = {"$ref": f"#/definitions/{inner}"} if inner in MAPS else {"type": "object"}
    elif value == "list of maps":
        shape = {"type": "array", "items": {"$ref": f"#/definitions/{inner}[]"}}
    elif found := re.match(r"(\S+) \.\. (\S+?)(, whole)?$", value):
        shape = {"type": "integer" if found[3] else "number"}
        for word, limit in (("minimum", found[1]), ("maximum", found[2])):
            if re.fullmatch(r"-?[\d.]+(e[-+]?\d+)?", limit):
                shape[word] = float(limit)
    elif value == "true, false":
        shape = {"type": "boolean"}
    elif "numbers" in value:
        shape = {"type": "array", "items": {"type": "number"}}
        if value[0].isdigit():
            shape.update(minItems=int(value.split()[0]), maxItems=int(value.split()[0]))
    elif value == "list of names":
        shape = {"type": "array", "items": {"type": "string"}}
    elif value != "text":
        shape = {"enum": value.split(", ")}
    meaning = MEANING[name].get(key, "")
    return shape if "$ref" in shape else {**shape, "description": meaning + (f"; default {default}" if default and not default.startswith("required") else "")}


def schema():
    """What an editor completes and checks while a scene is written."""
    found, _ = keys()
    definitions = {}
    for name, about in MAPS.items():
        required = sorted(key for key, (_, default) in found[name].items() if default == "required")
        definitions[name] = {"type": "object", "description": about, "additionalProperties": False,
                             "properties": {key: shape_of(name, key, *row) for key, row in sorted(found[name].items())},
                             **({"required": required} if required else {})}
    definitions["scene"]["properties"]["settings"] = {
        "type": "object", "additionalProperties": False, "properties": {
            "engine": {"type": "string"}, "contact": {"type": "string"},
            **{key: {"description": f"{meaning}; {span}"} for key, span, meaning in settings()}}}
    whole = {"$schema": "http://json-schema.org/draft-07/schema#", "title": "a scene of twinbus",
             "$comment": "Written by test/structure/scenes_page_test.py --write: do not edit.",
             "allOf": [{"$ref": "#/definitions/scene"}], "definitions": definitions}
    return json.dumps(whole, indent=1, ensure_ascii=False) + "\n"


def differences():
    """Scenes of ours that the schema refuses, where a checker is installed."""
    try:
        import jsonschema
        import yaml
    except ImportError:
        return []
    checker = jsonschema.Draft7Validator(json.loads(schema()))
    return [f"{file.name}: the schema refuses it: {error.message[:120]}"
            for file in sorted((ROOT / "config/scenes").glob("*.yaml")) for error in checker.iter_errors(yaml.safe_load(file.read_text()))]


def main():
    text, problems = page()
    problems += differences()
    if "--write" in sys.argv and not problems:
        PAGE.write_text(text)
        SCHEMA.write_text(schema())
    elif not SCHEMA.exists() or SCHEMA.read_text() != schema():
        problems.append("config/scenes/scene.schema.json is not what the code reads: test/structure/scenes_page_test.py --write")
    elif not PAGE.exists() or PAGE.read_text() != text:
        problems.append("doc/scenes.md is not what the code reads: test/structure/scenes_page_test.py --write")
    print("\n".join(problems + [f"{len(problems)} problems"]))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
