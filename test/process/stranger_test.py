#!/usr/bin/env python3
"""The page `bring your own humanoid` on robots that no one has described: URDFs only, nothing edited.

hrp1s and hrp2p without their robot.yaml, and JVRC-1 where the test data is, must stand; a fixed robot is told that it does
not; what the simulator refuses, check refuses.
"""

import json
import math
import os
import pathlib
import re
import sys
import tempfile

import harness
from harness import Checks, cli

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "test/bench"))
from bench_any_robot import walk_scene  # noqa: E402
DATA = pathlib.Path(os.environ.get("TWINBUS_DATA", ROOT.parent / "shared/data")) / "robots"


def stands(checks, urdf, scratch, walks=False):
    folder = os.path.join(scratch, urdf.stem)
    status, out, err = cli("check", str(urdf), "--propose", folder, timeout=240)
    checks.that(status == 0 and "\nstands: " in out, f"check of {urdf.name} says that it stands: {out[-600:]}{err}")
    if walks:
        yaml = (pathlib.Path(folder) / "robot.yaml").read_text()
        checks.that("\nwalks: " in out and "fastest: " in yaml.partition("\nwalking: {")[2],
                    f"{urdf.name} walks, and robot.yaml says how fast: {out[-600:]}")
        status, out, err = cli("run", "walk_forward", "--robot", folder, "--for", "6", timeout=120)
        checks.that("speeds x" in out and "the robot fell" not in out and "stopped" not in out, f"{urdf.name} walks in its own measure: {out}{err}")
    status, out, err = cli("run", "stand", "--robot", folder, "--for", "1", timeout=120)
    checks.that(status == 0 and "passed" in out, f"{urdf.name} stands: {out}{err}")
    status, out, err = cli("check", folder, timeout=120)
    checks.that(status == 0 and "missing: nothing" in out, f"nothing is missing in the folder of {urdf.name}: {out[-600:]}{err}")


def legs_of(joints):
    """biped12 with legs of five joints, whose soles are as narrow as they must be without an ankle that rolls, or of seven."""
    text = (ROOT / "config/robots/biped12/biped12.urdf").read_text()
    if joints == 5:
        text = re.sub(r'(<joint name="[RL]LEG_ANKLE_R" type=")revolute', r"\1fixed", text)
        assert '<box size="0.24 0.138 0.02"/>' in text
        return text.replace('<box size="0.24 0.138 0.02"/>', '<box size="0.24 0.04 0.02"/>')
    for side in "RL":
        knee = f'<joint name="{side}LEG_KNEE" type="revolute"><parent link="{side}LEG_'
        assert knee + "HIP_P" in text
        text = text.replace(knee + "HIP_P", knee + "THIGH")
        text = re.sub(rf'(<joint name="{side}LEG_KNEE"[^\n]*\n\s*<origin xyz="0 0 )-0.3', r"\g<1>-0.15", text)
        text = text.replace("</robot>", f"""<link name="{side}LEG_THIGH"><inertial><mass value="0.5"/>
<inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="{side}LEG_THIGH" type="revolute"><parent link="{side}LEG_HIP_P"/><child link="{side}LEG_THIGH"/><origin xyz="0 0 -0.15"/>
<axis xyz="0 0 1"/><limit lower="-0.8" upper="0.8" effort="120" velocity="6"/></joint></robot>""")
    return text


def climbs(scratch, folder, walk, degrees):
    """What `run` says of walking up so steep a ramp at half of the speed, which is not scaled as the scene is of this robot."""
    half = 0.5 * walk["fastest_m_s"]
    tile = 7.5 * half
    scene = pathlib.Path(scratch) / "ramp.yaml"
    scene.write_text(f"robot: {folder}\n" + walk_scene(8.5, 5, half, 10, 20) +
                     f"terrain: {{tile: {tile:.3f}, ramp_deg: {degrees}, from: {0.5 * walk['leg_m']:.3f}, length: {3 * tile:.3f}, width: {tile:.3f}}}\n")
    return cli("run", str(scene), timeout=120)


def bounds(checks, scratch, folder, walk):
    """The steepest slope is walked, a clearly steeper one is not, and what ends it there is said; likewise of pushes."""
    slope = walk["slope_deg"]
    status, out, err = climbs(scratch, folder, walk, slope["most"])
    checks.that(slope["most"] > 0 and status == 0, f"walks up the slope that check reports: {slope} {out}{err}")
    checks.that(bool(slope["why"]) or slope["most"] == 20, f"what ends it above that is said: {slope}")
    if slope["most"] <= 10:
        status, out, err = climbs(scratch, folder, walk, 2 * slope["most"])
        checks.that(status == 1 and "FAILED" in out, f"not one twice as steep: {slope} {out}{err}")
    for push in (walk["push_m_s"], walk["push_aside_m_s"]):
        most = 0.35 * math.sqrt(9.81 * walk["leg_m"])
        checks.that(0 < push["most"] < 1.001 * most and (bool(push["why"]) or push["most"] > 0.999 * most), f"pushed while it walks: {push}")


def other_legs(checks, scratch):
    """Half of the speed that is reported is walked, and is at least 0.08 sqrt(g leg)."""
    for joints in (5, 7):
        urdf = pathlib.Path(scratch) / f"legs{joints}.urdf"
        urdf.write_text(legs_of(joints))
        folder = os.path.join(scratch, urdf.stem)
        status, out, err = cli("check", str(urdf), "--propose", folder, "--json", timeout=240)
        walk = json.loads(out)["trial"]["walk"] if status == 0 else {}
        half = 0.5 * walk.get("fastest_m_s", 0.0)
        checks.that(half > 0 and half >= 0.08 * math.sqrt(9.81 * walk["leg_m"]), f"legs of {joints} joints walk: {walk} {err}")
        scene = pathlib.Path(scratch) / f"walk{joints}.yaml"
        scene.write_text(walk_scene(13.5, 10, half, 5, 20))
        status, out, err = cli("run", str(scene), "--robot", folder, timeout=120)
        checks.that(status == 0 and "passed" in out, f"legs of {joints} joints walk for 10 s: {out}{err}")
        bounds(checks, scratch, folder, walk)
        status, out, err = cli("run", "walk_forward", "--robot", folder, timeout=120)
        checks.that("no ZMP margin is asked" in out if joints == 5 else "no ZMP margin" not in out, f"a margin is asked of soles that hold one: {out}{err}")
        checks.that("ZMP came as near" not in out or joints == 7, f"and not of others: {out}")


def refusals(checks, scratch):
    link = "<link name='{0}'><inertial><mass value='{1}'/><inertia ixx='{2}' iyy='{2}' izz='{2}' ixy='0' ixz='0' iyz='0'/></inertial></link>"
    joint = ("<joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 1 0'/>"
             "<limit lower='-1' upper='1' effort='10' velocity='5'/></joint>")
    folder = pathlib.Path(scratch) / "weightless"
    folder.mkdir()
    (folder / "r.urdf").write_text("<robot name='r'>" + link.format("a", 5, 0.1) + link.format("b", 1, 0) + joint + "</robot>")
    (folder / "r.srdf").write_text("<robot name='r'><group_state name='half_sitting' group='all'><joint name='j' value='0'/></group_state></robot>")
    (folder / "robot.yaml").write_text("urdf: r.urdf\nsrdf: r.srdf\nbase: fixed\n")
    status, out, err = cli("run", "walk_forward", "--robot", "table")
    checks.that(status == 1 and "does not apply to the robot" in err and not out, f"a robot without legs is refused before it walks: {out}{err}")
    for command in (["check", str(folder)], ["run", "stand", "--robot", str(folder)]):
        status, _, err = cli(*command)
        checks.that(status == 1 and "link 'b' cannot be simulated" in err, f"{command[0]} refuses a link without inertia: {status} {err}")
    status, out, err = cli("check", str(folder / "r.urdf"))
    checks.that(status == 0 and "inertia_from_shape: [b]" in out and "no arm that reaches, on a fixed base: " in out,
                f"of the URDF a remedy is proposed, and one joint on a fixed base is told what holds it: {out[-600:]}{err}")


def cells(checks):
    """Found once, read again; a damaged file is said in one line and found anew."""
    with tempfile.TemporaryDirectory() as folder:
        before = os.environ.get("TWINBUS_CACHE")
        os.environ["TWINBUS_CACHE"] = folder
        for damaged, word in ((False, "found"), (False, "read"), (True, "found"), (False, "read")):
            if damaged:
                file = next(pathlib.Path(folder).glob("*.cells"))
                file.write_bytes(file.read_bytes()[:-1])
            status, out, err = cli("check", "biped12", "--cells", timeout=120)
            checks.that(status == 0 and f" {word} " in out, f"check --cells: {out}{err}")
            checks.that(len(err.splitlines()) == damaged, f"check --cells says one line of a damaged file: {err}")
        os.environ["TWINBUS_CACHE"] = "off"
        status, out, err = cli("check", "biped12", "--cells", timeout=120)
        checks.that(status == 1 and "not kept" in out, f"check --cells without a cache: {out}{err}")
        os.environ.pop("TWINBUS_CACHE")
        if before is not None:
            os.environ["TWINBUS_CACHE"] = before


def main():
    harness.require("twinbus")
    checks = Checks()
    with tempfile.TemporaryDirectory() as scratch:
        for name in ("hrp1s", "hrp2p"):
            stands(checks, ROOT / f"config/robots/{name}/{name}.urdf", scratch)
        if (DATA / "jvrc1/jvrc1.urdf").is_file():
            stands(checks, DATA / "jvrc1/jvrc1.urdf", scratch, walks=True)
        other_legs(checks, scratch)
        refusals(checks, scratch)
        for name, file, words in (("panda", "panda.urdf", ("arm_hold, arm_reach, arm_scan and arm_pick are its scenes", "next: ./twinbus run arm_reach")),
                                  ("go1", "go1.urdf", ("point feet: ", "stands: ", "trots: ", "up a slope of ", "pushed to the side by ", "next: ./twinbus run stand"))):
            if (DATA / name / file).is_file():
                _, out, err = cli("check", str(DATA / name / file), "--propose", os.path.join(scratch, name), timeout=120)
                checks.that(all(one in out for one in words), f"{name} is told what can be done with it: {out[-600:]}{err}")
                if name == "panda":
                    status, out, err = cli("run", "arm", "--robot", os.path.join(scratch, name), timeout=120)
                    checks.that(status == 0 and "passed" in out, f"run arm holds it: {out[-300:]}{err}")
    cells(checks)
    checks.exit()


if __name__ == "__main__":
    main()
