"""Engines and peers on the same scenes: what bench_physics.py and chart_physics.py share.

Ours are methods of build/.../bin/physics_cases.  Peers are built here from test/bench/peers against whatever is installed:
MuJoCo of the distribution (libmujoco-dev), MuJoCo of the running Python (pip install mujoco-core) and of the folders of
$TWINBUS_MUJOCO (wheels unpacked, separated by colons), Pinocchio (pip install pin), and where nothing touches Bullet, DART and
Simbody (TREE_PEERS).  What is missing is said once and left out.
"""

import importlib.util
import math
import os
import pathlib
import statistics
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

import programs

ROOT = pathlib.Path(__file__).resolve().parents[2]
PEERS = ROOT / "test/bench/peers"
DURATION = {"flight": 0.5, "arm": 0.5, "stand": 0.5, "push": 0.6, "push_soft": 0.6, "landing": 0.6, "slide": 0.4, "throw": 2.0}

TREE_PEERS = (  # program, name, package, libraries for pkg-config, methods
    ("bullet", "Bullet", "libbullet-dev", "bullet-float64", ("euler", "rk4")),
    ("dart", "DART", "libdart-dev", "dart", ("euler",)),
    ("simbody", "Simbody", "libsimbody-dev", "simbody", ("euler", "merson")),
)


def call(*words, timeout=300):
    """The lines that a program prints, or None if it fails."""
    try:
        # In its own folder: MuJoCo leaves its log where it stands.
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=timeout,
                              cwd=pathlib.Path(words[0]).parent)
    except subprocess.TimeoutExpired:
        return None
    return done.stdout.splitlines() if done.returncode == 0 else None


class Ours:
    def __init__(self, program, method, label):
        self.program, self.method, self.label = program, method, label

    def step_us(self, scene, h, seconds):
        return float(call(self.program, "step", scene, self.method, h, seconds)[0].split()[-1])

    def step_us_alone(self, scene, h, seconds):
        """Of steps that had the core to themselves, no hardware thread beside them; and which share these are."""
        words = call(self.program, "alone", scene, self.method, h, seconds)[0].split()
        return float(words[-1]), float(words[-3])

    def run(self, scene, h, repeats=3):
        return parse_run(call(self.program, "run", scene, self.method, h, repeats))


class Peer:
    """A program of PEERS that reads scenes as models(scene, gain) writes them."""

    def __init__(self, program, models, method, label):
        self.program, self.models, self.method, self.label = program, models, method, label

    def model(self, scene, gain=1.0):
        return self.models(scene, gain)

    def step_us(self, scene, h, seconds):
        lines = call(self.program, "step", self.model(scene), self.method, h, seconds)
        return float(lines[0].split()[-1]) if lines else None  # it reads no trees deeper than 100

    def run(self, scene, h, repeats=3):
        return parse_run(call(self.program, "run", self.model(scene), self.method, h, DURATION[scene], repeats))


class Mujoco(Peer):
    def stands(self, gain, h):
        lines = call(self.program, "map", self.model("stand", gain), self.method, h, 1.2)
        return lines[0] if lines else "diverged"


class Pinocchio:
    """Its algorithm and its integration step from Python; what an empty call costs is taken off."""

    def __init__(self, pinocchio, numpy, urdf):
        self.label = f"Pinocchio {pinocchio.__version__} ABA"
        self.lib, self.numpy = pinocchio, numpy
        self.model = pinocchio.buildModelFromUrdf(str(urdf), pinocchio.JointModelFreeFlyer())
        self.data = self.model.createData()

    def step_us(self, _scene, h, seconds):
        lib, model, data = self.lib, self.model, self.data
        q, v, tau = lib.neutral(model), self.numpy.full(model.nv, 0.3), self.numpy.zeros(model.nv)

        def batch(call):
            begin = time.thread_time()
            for _ in range(32):
                call()
            return 1e6 * (time.thread_time() - begin) / 32
        costs, empty, begun = [], [], time.thread_time()
        while time.thread_time() - begun < seconds:
            costs.append(batch(lambda: lib.aba(model, data, q, v, tau)))
            empty.append(batch(lambda: model.nq))
        return statistics.median(costs) - statistics.median(empty)


def turned(q, v):
    """A vector turned by a unit quaternion w x y z."""
    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    t = [2.0 * x for x in cross(q[1:], v)]
    return [x + q[0] * y + z for x, y, z in zip(v, t, cross(q[1:], t))]


def tree_of(mjcf):
    """A scene in the air, written for MuJoCo, as peers/tree_peer.h reads it: "fixed" or "free", velocity and angular velocity of
    the base in world; then a line for each link: parent (-1: none), placement in it as position and
    quaternion w x y z, axis of the hinge, mass, com, inertia xx yy zz xy xz yz about it, q, qd."""
    root = ElementTree.fromstring(mjcf)
    base, start = root.find("worldbody/body"), root.find("keyframe/key")
    free = base.find("freejoint") is not None
    q, qd = start.get("qpos").split()[7 if free else 0:], start.get("qvel").split()
    lines = ["fixed 0 0 0 0 0 0"]
    if root.find("worldbody/geom") is not None:
        raise ValueError("a tree has nothing to touch")
    if free:  # MuJoCo's turns in the axes of the body
        spin = turned([float(x) for x in base.get("quat").split()], [float(x) for x in qd[3:6]])
        lines, qd = [" ".join(["free", *qd[:3], *map(repr, spin)])], qd[6:]

    def add(body, parent):
        joint, mass, me = body.find("joint"), body.find("inertial"), len(lines) - 1
        if joint is not None and (joint.get("type") != "hinge" or float(joint.get("armature"))):
            raise ValueError("a tree has hinges without rotors")
        lines.append(" ".join([str(parent), body.get("pos"), body.get("quat"), "0 0 1" if joint is None else joint.get("axis"),
                               *(mass.get(name) for name in ("mass", "pos", "fullinertia")),
                               *(["0", "0"] if joint is None else [q.pop(0), qd.pop(0)])]))
        for child in body.findall("body"):
            add(child, me)
    add(base, -1)
    return lines


def parse_run(lines):
    """CPU ms per simulated second and the final centres of mass, or None."""
    if not lines:
        return None
    words = lines[-1].split()
    if "ms_per_s" not in words:
        return None
    at = words.index("at")
    end = words.index("counters") if "counters" in words else len(words)
    values = [float(word) for word in words[at + 1:end]]
    if not all(math.isfinite(value) for value in values):
        return None
    counters = [int(word) for word in words[end + 1:]]
    return {"cost": float(words[words.index("ms_per_s") + 1]), "at": values, "counters": counters}


def error(run, reference):
    """Largest distance of a link's centre of mass from where it should be [m]."""
    a, b = run["at"], reference["at"]
    return max(math.dist(a[i:i + 3], b[i:i + 3]) for i in range(0, len(a), 3))


def median_of(rounds, *contenders):
    """contenders: functions that measure once; measured in turn, so that a busy machine disturbs all alike."""
    rows = [[contender() for contender in contenders] for _ in range(rounds)]
    return [statistics.median(row[k] for row in rows) for k in range(len(contenders))], rows


def ratio(rows, ours, peer):
    return statistics.median(row[peer] / row[ours] for row in rows)


def cost_at(curve, wanted):
    """CPU ms/s at which an engine reaches an error: on the lower envelope of its curve [(error, cost)], log-log between
    points; beyond its smallest error by the slope of its last points.  None: never, and True if extrapolated."""
    points = sorted(((e, c) for e, c in curve if e > 0.0), reverse=True)
    hull = []
    for e, c in points:  # errors fall: keep those not beaten by a cheaper, better one
        while hull and hull[-1][1] >= c:
            hull.pop()
        hull.append((e, c))
    if not hull:
        return None, False
    if hull[0][0] <= wanted:
        return hull[0][1], False
    for (e0, c0), (e1, c1) in zip(hull, hull[1:]):
        if e1 <= wanted:
            t = math.log(e0 / wanted) / math.log(e0 / e1)
            return c0 * (c1 / c0) ** t, False
    if len(hull) < 2:
        return None, False
    (e0, c0), (e1, c1) = hull[-2:]
    slope = math.log(c1 / c0) / math.log(e0 / e1)
    return c1 * (e1 / wanted) ** slope, True


def slope(curve):
    """Least-squares order of error over step, curve: [(h, error)]."""
    points = [(math.log(h), math.log(e)) for h, e in curve if e > 0.0]
    n = len(points)
    mx, my = sum(x for x, _ in points) / n, sum(y for _, y in points) / n
    return sum((x - mx) * (y - my) for x, y in points) / sum((x - mx) ** 2 for x, _ in points)


def build(source, program, *words):
    if program.exists() and program.stat().st_mtime > max(file.stat().st_mtime for file in (source, PEERS / "tree_peer.h")):
        return True
    program.parent.mkdir(parents=True, exist_ok=True)
    compiler = os.environ.get("CXX", "g++")
    done = subprocess.run([compiler, "-std=c++17", "-O3", "-DNDEBUG", "-w", f"-I{ROOT}", str(source), "-o", str(program), *map(str, words)],
                          capture_output=True, text=True)
    if done.returncode != 0:
        print(f"{program.name}: does not build, left out: {done.stderr.strip().splitlines()[0] if done.stderr else ''}")
    return done.returncode == 0


class Lab:
    def __init__(self, who):
        self.bin = programs.folder_of("physics_cases", who)
        self.program = self.bin / "physics_cases"
        self.work = self.bin.parent / "peers"
        self.work.mkdir(parents=True, exist_ok=True)
        self.articulated = Ours(self.program, "articulated", "articulated, order 1")
        self.articulated2 = Ours(self.program, "articulated2", "articulated, order 2")
        self.articulated3 = Ours(self.program, "articulated3", "articulated, order 3")
        self.ode = Ours(self.program, "ode", "ODE direct")
        self.flight = [Ours(self.program, f"articulated-{m}", f"articulated, {m.upper()}") for m in ("ab4", "rk4", "rkf78", "gauss8")]
        # The other contact laws; spring_damper is above.
        self.laws = [Ours(self.program, f"{method}+{law}", f"{name}, {law}") for law in ("hunt_crossley", "patch")
                     for method, name in (("articulated", "articulated 1"), ("articulated2", "articulated 2"))]
        self.laws.append(Ours(self.program, "ode+patch", "ODE direct, patch"))
        # In as many parts as make no speed wrong by more [rad/s]; H may be the whole flight.
        self.parted = [Ours(self.program, f"articulated-gauss8-{most}", f"articulated, GAUSS8 to {most}") for most in ("1e-6", "3e-7", "1e-7", "3e-8", "1e-8")]
        self.mujocos = {}  # version -> program
        self._written = {}
        self._find_mujoco()
        self.trees = list(self._find_trees())
        self.pinocchio = self._find_pinocchio()

    def finest_of(self, engine):
        """The method of the same contact law whose finest run is nearest to its converged answer."""
        law = engine.method.partition("+")[2]
        return next(other for other in self.laws if other.method == f"articulated2+{law}")

    def models(self, scene, gain=1.0):
        if (scene, gain) not in self._written:
            path = self.work / f"{scene}_{gain:g}.xml"
            path.write_text("\n".join(call(self.program, "mjcf", scene, gain)) + "\n")
            self._written[scene, gain] = path
        return self._written[scene, gain]

    def tree(self, scene, gain=1.0):
        path = self.models(scene, gain).with_suffix(".tree")
        path.write_text("\n".join(tree_of(self.models(scene, gain).read_text())) + "\n")
        return path

    def stepped_trees(self):
        """Their cheapest step."""
        return [peer for peer in self.trees if peer.method == "euler"]

    def mujoco(self, version, method):
        return Mujoco(self.mujocos[version], self.models, method, f"MuJoCo {version} {method}")

    def packaged(self):
        return next((v for v in self.mujocos if v.startswith("2.")), None)

    def current(self):
        return next((v for v in self.mujocos if not v.startswith("2.")), None)

    def _find_mujoco(self):
        source = PEERS / "mujoco_peer.cpp"
        if pathlib.Path("/usr/include/mujoco/mujoco.h").exists():
            program = self.work / "mujoco_packaged"
            if build(source, program, "-lmujoco"):
                self.mujocos[call(program, "version")[0]] = program
        else:
            print("MuJoCo of the distribution: not installed, left out (apt install libmujoco-dev)")
        spec = importlib.util.find_spec("mujoco")
        own = pathlib.Path(spec.origin or list(spec.submodule_search_locations)[0]) if spec else None
        if own and own.is_file():
            own = own.parent
        others = [pathlib.Path(folder).resolve() for folder in os.environ.get("TWINBUS_MUJOCO", "").split(":") if folder]
        for folder in [own, *others] if own else others:
            self._add_mujoco(folder)
        if not self.current():
            print("current MuJoCo: not installed, left out (pip install mujoco-core)")

    def _add_mujoco(self, folder):
        """folder: as its wheel has it, the library beside include/."""
        libraries = sorted(folder.glob("libmujoco.so*"))
        if not libraries:
            print(f"{folder}: no libmujoco.so in it, left out")
            return
        program = self.work / f"mujoco_{libraries[-1].name.split('.so.')[-1]}"
        if build(PEERS / "mujoco_peer.cpp", program, f"-I{folder}/include", libraries[-1], f"-Wl,-rpath,{folder}"):
            self.mujocos[call(program, "version")[0]] = program

    def _find_trees(self):
        """Each method of the peers of free motion."""
        for file, name, package, libraries, methods in TREE_PEERS:
            flags = subprocess.run(["pkg-config", "--cflags", "--libs", libraries, "eigen3"], capture_output=True, text=True)
            program = self.work / file
            if flags.returncode != 0:
                print(f"{name}: not installed, left out (apt install {package})")
            elif build(PEERS / f"{file}_peer.cpp", program, *[flag for flag in flags.stdout.split() if not flag.startswith("-std=")]):
                version = call(program, "version")[0]
                for method in methods:
                    yield Peer(program, self.tree, method, f"{name} {version} {method}")

    def _find_pinocchio(self):
        try:
            import numpy
            import pinocchio
        except ImportError:
            print("Pinocchio: not installed, left out (pip install pin)")
            return None
        return Pinocchio(pinocchio, numpy, ROOT / "config/robots/hrp1s/hrp1s.urdf")
