"""A campaign file becomes a table of tasks.

A task is one run of `twinbus run`.  Its id hashes the scene's text and files, the robot's folder, the settings, the seed, the time, and
the program's bytes: the same id is the same run, on whatever machine.
"""

import hashlib
import itertools
import json
import os
import pathlib
import re

import yaml

import sampling
import strict
from errors import CampaignError
from run_task import hash_of

KEYS = ("about", "scenes", "program", "arguments", "output", "repeats", "cases", "robots", "controllers", "seeds", "for", "limit", "path", "settings", "draws", "rounds", "draw_seed", "logs",
        "search", "gate")
MOST_TASKS = 2_000_000
IN_SCENE = "scene."  # a setting that begins so is a key of the scene: scene.pushes.0.impulse.0


class Campaign:
    """What a file asks for."""

    def __init__(self):
        self.file = ""
        self.scenes = []       # [(name, text, path or None)]
        self.program = None    # path of a program that is no `twinbus run`
        self.arguments, self.output, self.repeats = [], False, 1
        self.seeded = False    # whether the file names seeds
        self.cases = {}        # name -> {settings, robot, program, arguments}: combinations that are no grid
        self.robots = [None]   # a name, a folder, or None: the scene's
        self.controllers = {"built_in": {}}
        self.seeds = [1]
        self.seconds = None
        self.limit = 600.0
        self.path = "any"
        self.grid = {}         # key -> [value]
        self.drawn = {}        # key -> (low, high)
        self.how = "random"    # or sobol, adaptive
        self.draws, self.rounds, self.draw_seed = 16, 4, 1
        self.logs = 20
        self.search = self.gate = None  # Value
        self.lines = {}        # key of a setting -> Value, for errors


def find_program():
    """The program `twinbus`: $TWINBUS_PROGRAM, $TWINBUS_BIN, that which started this ($TWINBUS_BUILD), or the build of this checkout."""
    root = pathlib.Path(__file__).resolve().parents[1]
    builds = pathlib.Path(os.environ.get("TWINBUS_BUILDS", root / "build"))
    named = [os.environ.get("TWINBUS_PROGRAM"), os.path.join(os.environ["TWINBUS_BIN"], "twinbus") if "TWINBUS_BIN" in os.environ else None,
             os.path.join(os.environ["TWINBUS_BUILD"], "bin/twinbus") if "TWINBUS_BUILD" in os.environ else None,
             str(builds / "release/bin/twinbus")]
    for path in named:
        if path and os.access(path, os.X_OK):
            return str(pathlib.Path(path).resolve())
    raise CampaignError("the program twinbus is not built; run ./twinbus run stand once, or name it with TWINBUS_PROGRAM")


def config_folder():
    return pathlib.Path(os.environ.get("TWINBUS_CONFIG") or pathlib.Path(__file__).resolve().parents[1] / "config")


def read_seeds(value):
    """7, [1, 2, 5] or 1..4."""
    seeds = []
    for entry in value.entries():
        span = re.fullmatch(r"(\d{1,9})\.\.(\d{1,9})", entry.text())
        if span and int(span[1]) <= int(span[2]) < int(span[1]) + MOST_TASKS:
            seeds += range(int(span[1]), int(span[2]) + 1)
        elif span:
            raise entry.error(f"{entry.text()} runs backwards or is longer than {MOST_TASKS}; write FIRST..LAST")
        else:
            seeds.append(entry.number(0, 1e9, whole=True))
    return list(dict.fromkeys(seeds))


def read_scene(value, beside):
    """(name, text, path where it must be used because it names files)."""
    name = value.text()
    named = pathlib.Path(name)
    tried = [beside / named, named] if named.suffix in (".yaml", ".yml") else [config_folder() / "scenes" / f"{name}.yaml"]
    for file in tried:
        if file.is_file():
            text = file.read_text(encoding="utf-8", errors="replace")
            names_files = re.search(r"\bfile:", text) is not None
            return file.stem, text, str(file.resolve()) if names_files else None
    known = ", ".join(sorted(f.stem for f in (config_folder() / "scenes").glob("*.yaml"))[:8])
    raise value.error(f"there is no scene '{name}'; use a name of config/scenes ({known}, ...) or a file that ends in .yaml")


def read_robot(value, beside):
    name = value.text()
    for folder in (config_folder() / "robots" / name, beside / name, pathlib.Path(name)):
        if (folder / "robot.yaml").is_file():
            return name if folder.parent == config_folder() / "robots" else str(folder.resolve())
    raise value.error(f"there is no robot '{name}'; use a name of config/robots or a folder with a robot.yaml")


def read_controllers(value, beside):
    found = {}
    for name, entry in value.items():
        keys = entry.keys(("program", "guard"))
        controller = {}
        if "program" in keys:
            program = beside / keys["program"].text()
            if not os.access(program, os.X_OK) or program.is_dir():
                raise keys["program"].error(f"{program} is no program; name the twinbus of another build")
            controller["program"] = str(program.resolve())
        if "guard" in keys:
            controller["guard"] = keys["guard"].truth()
        found[name] = controller
    if not found:
        raise value.error("is empty; leave it out for the controller of this program")
    return found


def find_beside(value, beside):
    """A program by its name, beside `twinbus`, or by its path."""
    name = value.text()
    found = beside / name if "/" in name else pathlib.Path(find_program()).with_name(name)
    if not os.access(found, os.X_OK) or found.is_dir():
        raise value.error(f"{found} is no program; build it, or name it by its path")
    return str(found.resolve())


def read_cases(value, campaign, beside):
    """{NAME: {settings: {KEY: VALUE}, robot: R, program: P, arguments: [...]}}."""
    for name, entry in value.items():
        keys = entry.keys(("settings", "robot", "program", "arguments"))
        case = campaign.cases[name] = {"settings": {}}
        if "settings" in keys:
            for key, each in keys["settings"].items():
                campaign.lines[key] = each
                case["settings"][key] = each.text()
        if "robot" in keys:
            case["robot"] = read_robot(keys["robot"], beside)
        for key in ("program", "arguments"):
            if key in keys and campaign.program is None:
                raise keys[key].error("is for campaigns of a program:; scenes are run by controllers:")
        if "program" in keys:
            case["program"] = find_beside(keys["program"], beside)
        if "arguments" in keys:
            case["arguments"] = [each.text() for each in keys["arguments"].entries()]
    if not campaign.cases:
        raise value.error("is empty; leave it out")


def read_settings(value, campaign):
    hows = set()
    for key, entry in value.items():
        campaign.lines[key] = entry
        if not re.fullmatch(r"[\w.]{1,200}", key):
            raise entry.error("a setting is a key of --set, or scene.KEY")
        if not entry.is_map():
            campaign.grid[key] = [each.text() for each in entry.entries()]
            if not campaign.grid[key]:
                raise entry.error("is empty; give values")
            continue
        keys = entry.keys(("grid", "random", "sobol", "adaptive"))
        if len(keys) != 1:
            raise entry.error("wants one of grid, random, sobol, adaptive")
        (how, span), = keys.items()
        if how == "grid":
            parts = span.keys(("from", "to", "count"), ("from", "to", "count"))
            low, high, count = parts["from"].number(), parts["to"].number(), parts["count"].number(2, 10000, whole=True)
            campaign.grid[key] = [repr(round(low + (high - low) * i / (count - 1), 12)) for i in range(count)]
            continue
        ends = span.entries()
        if len(ends) != 2 or not ends[0].number() < ends[1].number():
            raise span.error("wants [LEAST, MOST]")
        campaign.drawn[key] = (ends[0].number(), ends[1].number())
        hows.add(how)
    if len(hows) > 1:
        raise value.error(f"{' and '.join(sorted(hows))} in one campaign; draw all settings the same way")
    campaign.how = hows.pop() if hows else "random"


def read_program(keys, campaign, beside):
    for key in ("scenes", "controllers", "for", "path"):
        if key in keys:
            raise keys[key].error("is for campaigns of scenes:, and this one has a program:")
    campaign.program = find_beside(keys["program"], beside)
    campaign.scenes = [(pathlib.Path(campaign.program).name, "", None)]
    if "arguments" in keys:
        campaign.arguments = [entry.text() for entry in keys["arguments"].entries()]
    if "output" in keys:
        campaign.output = keys["output"].truth()
    if "repeats" in keys:
        campaign.repeats = keys["repeats"].number(1, 1e6, whole=True)


def read(path):
    """The campaign of a file.  Throws CampaignError."""
    top = strict.load(path)
    beside = pathlib.Path(path).resolve().parent
    keys = top.keys(KEYS, () if top.is_map() and "program" in dict(top.items()) else ("scenes",))
    campaign = Campaign()
    campaign.file = str(path)
    if "program" in keys:
        read_program(keys, campaign, beside)
    else:
        for key in ("arguments", "output", "repeats"):
            if key in keys:
                raise keys[key].error("is for campaigns of a program:" + ("; runs of a scene repeat to the last bit" if key == "repeats" else ""))
        campaign.scenes = [read_scene(entry, beside) for entry in keys["scenes"].entries()]
    if not campaign.scenes:
        raise keys["scenes"].error("is empty; name at least one scene")
    names = [name for name, _, _ in campaign.scenes]
    if len(set(names)) < len(names):
        raise keys["scenes"].error("two scenes have one name; rename one file")
    if "robots" in keys:
        campaign.robots = [read_robot(entry, beside) for entry in keys["robots"].entries()]
    if "controllers" in keys:
        campaign.controllers = read_controllers(keys["controllers"], beside)
    if "cases" in keys:
        read_cases(keys["cases"], campaign, beside)
    if "seeds" in keys:
        campaign.seeds, campaign.seeded = read_seeds(keys["seeds"]), True
    if "for" in keys:
        campaign.seconds = keys["for"].number(0.002, 1e6)
    if "limit" in keys:
        campaign.limit = keys["limit"].number(0.01, 1e6)
    if "path" in keys:
        campaign.path = keys["path"].word_of(("any", "baseline", "avx2", "avx512"))
    if "settings" in keys:
        read_settings(keys["settings"], campaign)
    if "draws" in keys:
        campaign.draws = keys["draws"].number(1, 1_000_000, whole=True)
    if "rounds" in keys:
        campaign.rounds = keys["rounds"].number(1, 1000, whole=True)
    if "draw_seed" in keys:
        campaign.draw_seed = keys["draw_seed"].number(0, 1e9, whole=True)
    if "logs" in keys:
        campaign.logs = keys["logs"].number(0, 1e6, whole=True)
    campaign.search, campaign.gate = keys.get("search"), keys.get("gate")
    count = campaign.repeats * len(campaign.scenes) * len(campaign.robots) * len(campaign.controllers) * len(campaign.seeds)
    for values in [*campaign.grid.values(), *([campaign.cases] if campaign.cases else [])]:
        count *= len(values)
    count *= campaign.draws if campaign.drawn else 1
    if count > MOST_TASKS:
        raise top.error(f"{count} tasks, {MOST_TASKS} at most; divide the campaign, or draw instead of a grid")
    return campaign


def change_scene(text, changes, error):
    """The YAML text of a scene with some of its keys changed; error(key, sentence) makes the exception."""
    tree = yaml.safe_load(text) or {}
    for key, value in changes.items():
        node, way = tree, key[len(IN_SCENE):].split(".")
        for depth, word in enumerate(way):
            last = depth == len(way) - 1
            if isinstance(node, list):
                if not word.isdigit() or int(word) >= len(node):
                    raise error(key, f"the list has {len(node)} entries; '{word}' is none of them (they count from 0)")
                word = int(word)
            elif not isinstance(node, dict):
                raise error(key, f"'{word}' is below a single value; take it out")
            elif not last and word not in node:
                raise error(key, f"the scene has no '{word}' there; it has {', '.join(map(str, node))}")
            if last:
                try:
                    node[word] = float(value)  # 1e-05 is text to YAML
                except ValueError:
                    node[word] = yaml.safe_load(str(value))
            else:
                node = node[word]
    return yaml.safe_dump(tree, default_flow_style=None, sort_keys=False, width=1000)


class TaskMaker:
    """Hashes each scene, robot and program once."""

    def __init__(self, campaign):
        self.campaign, self.program, self.scenes, self.robots = campaign, find_program(), {}, {}

    def scene(self, scene, changes):
        name, text, path = scene
        key = (name, tuple(changes.items()))
        if key not in self.scenes:
            if changes:
                if path:
                    raise CampaignError(f"{path}: a scene that names mesh files cannot have keys changed by settings scene.KEY; "
                                        "write a scene per value")

                def error(key, sentence):
                    value = self.campaign.lines.get(key)
                    return value.error(f"{name}: {sentence}") if value else CampaignError(f"{key}: {name}: {sentence}")
                text = change_scene(text, changes, error)
            digest = hashlib.sha256(text.encode())
            if path:  # and what may lie beside it
                digest.update("".join(hash_of(f) for f in sorted(pathlib.Path(path).parent.rglob("*.*"))
                                      if f.suffix.lower() in (".stl", ".obj", ".dae", ".txt", ".xyz", ".csv", ".pcd")).encode())
            self.scenes[key] = (text, digest.hexdigest()[:16])
        return self.scenes[key]

    def robot(self, robot, text):
        """(name, folder or None, hash) of the robot that runs."""
        name = robot or (re.search(r"^robot:\s*[\"']?([^\s\"'#]+)", text, re.MULTILINE) or [None, "hrp1s"])[1]
        if name not in self.robots:
            inside = config_folder() / "robots" / name
            self.robots[name] = hash_of(inside if inside.is_dir() else name)
        return name, (name if "/" in name else None), self.robots[name]

    def make(self, scene, robot, controller, settings, seed, seconds=None, limit=None, case=""):
        campaign = self.campaign
        changes = {k: v for k, v in settings.items() if k.startswith(IN_SCENE)}
        given = {k: str(v) for k, v in settings.items() if not k.startswith(IN_SCENE)}
        text, scene_hash = self.scene(scene, changes)
        name, folder, robot_hash = self.robot(robot, text)
        how = campaign.controllers[controller]
        program = how.get("program", self.program)
        seconds = campaign.seconds if seconds is None else seconds
        identity = {"scene": scene_hash, "robot": robot_hash, "settings": given, "seed": seed, "for": seconds,
                    "guard": how.get("guard", True), "program": hash_of(program), "path": campaign.path}
        task = {"id": hashlib.sha256(json.dumps(identity, sort_keys=True).encode()).hexdigest()[:16],
                "scene": scene[0], "scene_hash": scene_hash if not scene[2] else hash_of(scene[2]), "robot": name, "robot_hash": robot_hash,
                "controller": controller, "settings": given, "varied": {**({"case": case} if case else {}), **{k: str(v) for k, v in settings.items()}},
                "seed": seed, "for": seconds, "guard": how.get("guard", True), "program": program, "program_hash": identity["program"],
                "limit": campaign.limit if limit is None else limit, "simd": campaign.path}
        if folder:
            task["robot_path"] = folder
        if scene[2] and not changes:
            task["scene_path"] = scene[2]
        else:
            task["scene_text"] = text
        return task

    def make_of_program(self, robot, settings, seed, case, repeat):
        """A task of a program of its own: arguments, settings as --KEY VALUE, and --seed."""
        campaign, how = self.campaign, self.campaign.cases.get(case, {})
        program, arguments = how.get("program", campaign.program), how.get("arguments", campaign.arguments)
        given = {k: str(v) for k, v in settings.items()}
        name, folder, robot_hash = self.robot(robot, "") if robot else ("", None, "")
        # What it reads decides what it finds.
        files = {word: hash_of(word) for word in arguments if word.startswith("/") and os.path.exists(word) and word != os.devnull}
        identity = {"program": hash_of(program), "arguments": [files.get(word, word) for word in arguments], "settings": given,
                    "seed": seed, "robot": robot_hash, "repeat": repeat}
        return {"id": hashlib.sha256(json.dumps(identity, sort_keys=True).encode()).hexdigest()[:16], "scene": pathlib.Path(program).name,
                "scene_hash": "", "robot": name, "robot_hash": robot_hash, **({"robot_path": folder} if folder else {}), "controller": "",
                "settings": given, "varied": {**({"case": case} if case else {}), **({"repeat": str(repeat)} if campaign.repeats > 1 else {}), **given},
                "seed": seed, "seeded": campaign.seeded,
                "for": None, "program": program, "program_hash": identity["program"], "arguments": arguments, "files": files,
                "limit": campaign.limit, "output": campaign.output}

    def product(self, points):
        """Tasks of every scene, robot, controller, case, grid value, point and seed."""
        campaign = self.campaign
        keys, cases = list(campaign.grid), campaign.cases or {"": {"settings": {}}}
        if campaign.program:  # all cases with one seed, then with the next: what measures time takes turns
            for repeat, seed, robot, (case, how), values, point in itertools.product(range(1, campaign.repeats + 1), campaign.seeds, campaign.robots,
                                                                                    cases.items(), itertools.product(*campaign.grid.values()), points):
                yield self.make_of_program(how.get("robot", robot), {**how["settings"], **dict(zip(keys, values)), **point}, seed, case, repeat)
            return
        for scene, robot, controller, (case, how) in itertools.product(campaign.scenes, campaign.robots, campaign.controllers, cases.items()):
            for values in itertools.product(*campaign.grid.values()):
                for point in points:
                    settings = {**how["settings"], **dict(zip(keys, values)), **point}
                    for seed in campaign.seeds:
                        yield self.make(scene, how.get("robot", robot), controller, settings, seed, case=case)

    def first(self):
        """Every task that is known before anything ran; of an adaptive campaign its first round."""
        campaign = self.campaign
        if not campaign.drawn:
            return unique(self.product([{}]))
        count = campaign.draws if campaign.how != "adaptive" else max(1, campaign.draws // campaign.rounds)
        points = sampling.draw(campaign.how, campaign.drawn, count, campaign.draw_seed)
        return unique(self.product(points))


def unique(tasks):
    """Two lines of a file may ask for the same run: it is run once."""
    found = {}
    for task in tasks:
        found.setdefault(task["id"], task)
    return list(found.values())
