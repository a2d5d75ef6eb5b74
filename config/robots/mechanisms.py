"""Mechanisms, most with closed loops on a fixed base, as robots: URDF, SRDF and robot.yaml of each are written by its make_urdf.py.

Rods are 1 m and 1 kg unless said otherwise; the tree of the URDF leaves one joint of each loop out, `loops` of robot.yaml puts it back.
"""

import pathlib

BAR = 1.0 / 12.0  # of a rod about its middle, across [kg m^2]
THIN = 1e-4  # along itself


class Mechanism:
    def __init__(self, name, about, base="fixed"):
        self.name, self.about, self.base = name, about, base
        self.links, self.joints, self.loops, self.poses = [], [], [], {}
        if base == "fixed":
            self.link("base", 1.0, (0, 0, 0), (0.1, 0.1, 0.1))

    def link(self, name, mass, com, inertia, *seen, touched=()):
        """seen: (shape of URDF, where its middle is); touched: the same."""
        visual = "".join(f'<visual><origin xyz="{words(at)}"/><geometry>{shape}</geometry></visual>' for shape, at in seen)
        visual += "".join(f'<collision><origin xyz="{words(at)}"/><geometry>{shape}</geometry></collision>' for shape, at in touched)
        self.links.append(
            f'  <link name="{name}"><inertial><origin xyz="{words(com)}"/><mass value="{mass:g}"/><inertia ixx="{inertia[0]:.9g}" '
            f'iyy="{inertia[1]:.9g}" izz="{inertia[2]:.9g}" ixy="0" ixz="0" iyz="0"/></inertial>{visual}</link>')

    def joint(self, name, parent, child, at, axis, kind="continuous", friction=0.0, reach=2):
        ends = f' lower="-{reach}" upper="{reach}"' if kind == "prismatic" else ""
        rubs = f'<dynamics friction="{friction:g}"/>' if friction else ""
        self.joints.append(
            (name, f'  <joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{words(at)}"/>'
             f'<axis xyz="{words(axis)}"/><limit effort="1000" velocity="100"{ends}/>{rubs}</joint>'))

    def rod(self, name, parent, at, axis, along):
        middle = [0.5 * a for a in along]
        self.link(name, 1.0, middle, [THIN if a else BAR for a in along], (bar(along), middle))
        self.joint(name.upper(), parent, name, at, axis)

    def pose(self, name, **q):
        self.poses[name] = q

    def loop(self, link, point, to, at, stiffness="1.0e+8", damping="1.0e+6", more=""):
        self.loops.append(
            f"  - {{link: {link}, point: {list(point)}, to: {to}, at: {list(at)}, stiffness: {stiffness}, damping: {damping}{more}}}")

    def write(self, folder):
        names = [name for name, _ in self.joints]
        lines = [f'<robot name="{self.name}">', *self.links, *[text for _, text in self.joints], "</robot>", ""]
        (folder / f"{self.name}.urdf").write_text("\n".join(lines))
        lines = [f'<robot name="{self.name}">', '  <group name="all">' + "".join(f'<joint name="{n}"/>' for n in names) + "</group>"]
        for pose, q in self.poses.items():
            values = "".join(f'<joint name="{n}" value="{q.get(n, 0.0):.12g}"/>' for n in names)
            lines.append(f'  <group_state name="{pose}" group="all">{values}</group_state>')
        (folder / f"{self.name}.srdf").write_text("\n".join(lines + ["</robot>", ""]))
        (folder / "robot.yaml").write_text("\n".join([f"# {self.about}", f"urdf: {self.name}.urdf", f"srdf: {self.name}.srdf", f"base: {self.base}",
                                                      "period: 0.002  # [s]", "off: torque_off", *(["loops:", *self.loops] if self.loops else []), ""]))


def bar(along):
    return f'<box size="{words([max(abs(a), 0.04) for a in along])}"/>'


def words(three):
    return " ".join(f"{x:g}" for x in three)


X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)


def four_bars(name, count, about):
    m = Mechanism(name, about)
    for i in range(count + 1):
        m.rod(f"upright{i}", "base", (i, 0, 0), Y, Z)
    for i in range(count):
        m.rod(f"across{i}", f"upright{i}", Z, Y, X)
        m.loop(f"across{i}", X, f"upright{i + 1}", Z)
    m.pose("up")
    return m


def bricard():
    m = Mechanism("bricard", "Bricard's mechanism: five rods along the edges of a cube on six hinges, one more than it could need.")
    along = (X, Y, Z, (-1, 0, 0), (0, -1, 0))
    axis = (Y, Z, X, Y, Z)
    end = [0.0, 0.0, 0.0]
    for i in range(5):
        m.rod(f"rod{i}", "base" if i == 0 else f"rod{i - 1}", (0, 0, 0) if i == 0 else along[i - 1], axis[i], along[i])
        end = [e + a for e, a in zip(end, along[i])]
    for side in (-0.1, 0.1):  # the sixth hinge: two points of its axis
        m.loop("rod4", [a + side * x for a, x in zip(along[4], X)], "base", [e + side * x for e, x in zip(end, X)])
    m.pose("cube")
    return m


def governor():
    """Watt's: two arms with a ball at each end swing out from a turning shaft, rods from their middles lift a collar."""
    m = Mechanism("governor", "A flyball governor: two arms of 1 m with balls of 5 kg on a turning shaft, and a collar of 2 kg that their rods lift.")
    m.link("shaft", 5.0, (0, 0, -0.5), (0.5, 0.5, 0.02), (bar((0, 0, 1.6)), (0, 0, -0.8)))
    m.joint("SHAFT", "base", "shaft", (0, 0, 2), Z)
    m.link("collar", 2.0, (0, 0, 0), (0.01, 0.01, 0.02), ('<box size="0.14 0.14 0.06"/>', (0, 0, 0)))
    m.joint("COLLAR", "shaft", "collar", (0, 0, -3 ** 0.5 / 2), Z, "prismatic")
    for name, side in (("left", 1), ("right", -1)):
        # Hanging straight down at zero; the rod from the middle of the arm back to the shaft.
        m.link(f"{name}_arm", 5.5, (0, 0, -0.95), (0.08, 0.08, 0.02), (bar(Z), (0, 0, -0.5)),
               ('<sphere radius="0.1"/>', (0, 0, -1)))
        m.joint(f"{name.upper()}_ARM", "shaft", f"{name}_arm", (0, 0, 0), (0, -side, 0))
        m.link(f"{name}_rod", 0.2, (0, 0, -0.25), (0.0042, 0.0042, 1e-4), (bar((0, 0, 0.5)), (0, 0, -0.25)))
        m.joint(f"{name.upper()}_ROD", f"{name}_arm", f"{name}_rod", (0, 0, -0.5), (0, side, 0))
        for across in (-0.05, 0.05):  # a hinge on the collar: two points of its axis
            m.loop(f"{name}_rod", (0, across, -0.5), "collar", (0, across, 0))
    m.pose("out", LEFT_ARM=0.523598775598, RIGHT_ARM=0.523598775598, LEFT_ROD=1.047197551197, RIGHT_ROD=1.047197551197)
    return m


def pendulum():
    """From 90 degrees its period is 4 sqrt(l / g) K(sin 45 degrees) = 2 s, with l = I / (m c) about the hinge."""
    m = Mechanism("pendulum", "A pendulum that takes 2 s from 90 degrees and back.")
    length = 9.81 * (2.0 / (4.0 * 1.8540746773013719)) ** 2
    about = 0.7 * (length - 0.7)  # of 1 kg, about its middle 0.7 m below the hinge
    m.link("bob", 1.0, (0, 0, -0.7), (about, about, about), (bar((0, 0, 0.7)), (0, 0, -0.35)), ('<sphere radius="0.06"/>', (0, 0, -0.7)))
    m.joint("SWING", "base", "bob", (0, 0, 0), Y)
    m.pose("level", SWING=1.5707963267948966)
    m.pose("down")
    return m


def chain(count):
    m = Mechanism(f"chain_{count}", f"{count} rods of 0.1 m and 0.1 kg, one hanging from the other.")
    for i in range(count):
        across = 0.1 * 0.1 ** 2 / 12
        m.link(f"link{i}", 0.1, (0, 0, -0.05), (across, across, 1e-6), ('<box size="0.02 0.02 0.1"/>', (0, 0, -0.05)))
        m.joint(f"HINGE{i}", f"link{i - 1}" if i else "base", f"link{i}", (0, 0, -0.1 if i else 0), Y if i % 2 else X)
    m.pose("bent", **{f"HINGE{i}": 0.1 for i in range(count)})
    return m


def andrews():
    """Hairer and Wanner, Solving Ordinary Differential Equations II, chapter VI.9, ten times slower: spring and torque a hundredth.

    The torque of 0.33 N mm is the friction of the crank on a flywheel that always turns faster.
    """
    m = Mechanism("andrews", "Andrews' squeezing mechanism: seven bodies in a plane, three loops, a spring.")
    a, b, c = (-0.06934, -0.00227, 0), (-0.03635, 0.03273, 0), (0.014, 0.072, 0)

    def body(name, parent, at, mass, inertia, com, joint, friction=0.0):
        m.link(name, mass, com, (inertia, inertia, inertia), ('<sphere radius="0.003"/>', com))
        m.joint(joint, parent, name, at, Z, friction=friction)

    body("flywheel", "base", (0, 0, 0), 1.0, 10.0, (0, 0, 0), "FLYWHEEL")
    body("crank", "flywheel", (0, 0, 0), 0.04325, 2.194e-6, (92e-5, 0, 0), "CRANK", 0.00033)
    body("rod", "crank", (7e-3, 0, 0), 0.00365, 4.410e-7, (-115e-4, 0, 0), "THETA")
    body("spring_arm", "base", b, 0.02373, 5.255e-6, (1043e-5, -1874e-5, 0), "GAMMA")
    body("upper_lever", "base", a, 0.07050, 1.169e-5, (2308e-5, 916e-5, 0), "DELTA")
    body("upper_link", "upper_lever", (4e-2, 0, 0), 0.00706, 5.667e-7, (0, -579e-5, 0), "PHI")
    body("lower_lever", "base", a, 0.05498, 1.912e-5, (-449e-5, -1228e-5, 0), "EPSILON")
    body("lower_link", "lower_lever", (0, -4e-2, 0), 0.00706, 5.667e-7, (579e-5, 0, 0), "OMEGA")
    for link, point in (("spring_arm", (0, -35e-3, 0)), ("upper_link", (0, -2e-2, 0)), ("lower_link", (2e-2, 0, 0))):
        m.loop("rod", (-28e-3, 0, 0), link, point, "1.0e+9", "1.0e+4")
    m.loop("spring_arm", (2e-2, -18e-3, 0), "base", c, "45.3", "0", ", length: 0.07785")
    m.pose("start", CRANK=-0.0617138900142765, GAMMA=0.45527981916307, DELTA=0.487364979543843, PHI=0.222668390165886,
           EPSILON=1.23054744454982, OMEGA=-0.222668390165886)
    return m


def table():
    m = Mechanism("table", "A table of 40 kg on four legs, with a turning tray in its middle.", "floating")
    legs = [(x, y, 0.35) for x in (-0.5, 0.5) for y in (-0.5, 0.5)]
    shapes = [('<box size="1.1 1.1 0.04"/>', (0, 0, 0.72)), *(('<sphere radius="0.05"/>', (x, y, 0.05)) for x, y, _ in legs)]
    m.link("top", 38.0, (0, 0, 0.6), (5.0, 5.0, 8.0), *shapes, *(('<cylinder radius="0.04" length="0.7"/>', at) for at in legs),
           touched=shapes)
    m.link("tray", 2.0, (0, 0, 0.01), (0.05, 0.05, 0.1), ('<cylinder radius="0.3" length="0.02"/>', (0, 0, 0.01)))
    m.joint("TRAY", "top", "tray", (0, 0, 0.75), Z)
    m.pose("half_sitting")
    return m


def belt():
    m = Mechanism("belt", "A belt so heavy that nothing on it slows it down.")
    m.link("belt", 1e6, (0, 0, 0), (1e6, 1e6, 1e6), ('<box size="8 0.5 0.1"/>', (0, 0, -0.05)), touched=(('<box size="8 0.5 0.1"/>', (0, 0, -0.05)),))
    m.joint("BELT", "base", "belt", (0, 0, 1), X, "prismatic", reach=20)
    m.pose("start")
    return m


ALL = {
    "four_bar": lambda: four_bars("four_bar", 1, "Three rods of 1 m and 1 kg in a square with the ground."),
    "n_four_bar": lambda: four_bars("n_four_bar", 10, "Ten squares of rods in a row, which lie flat in a line twice a turn."),
    "bricard": bricard,
    "governor": governor,
    "pendulum": pendulum,
    "chain_30": lambda: chain(30),
    "andrews": andrews,
    "table": table,
    "belt": belt,
}


def write(script):
    folder = pathlib.Path(script).resolve().parent
    ALL[folder.name]().write(folder)
