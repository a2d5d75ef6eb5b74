"""Robots whose joints are named as those of a G1 or a Go2, hanging in the air: enough for whatever is not about balance."""

LEGS = ("hip_pitch", "hip_roll", "hip_yaw", "knee", "ankle_pitch", "ankle_roll")
ARMS = ("shoulder_pitch", "shoulder_roll", "shoulder_yaw", "elbow", "wrist_roll", "wrist_pitch", "wrist_yaw")
# In another order than the motors: arms first.
G1 = ([f"{side}_{part}_joint" for side in ("right", "left") for part in ARMS] + [f"waist_{part}_joint" for part in ("pitch", "roll", "yaw")] +
      [f"{side}_{part}_joint" for side in ("right", "left") for part in LEGS])
GO2 = [f"{leg}_{part}_joint" for leg in ("FL", "FR", "RL", "RR") for part in ("hip", "thigh", "calf")]
# Of motor 3, which the peer moves.
MOVED = {"unitree_hg": "left_knee_joint", "unitree_go": "FL_hip_joint"}
JOINTS = {"unitree_hg": G1, "unitree_go": GO2}


def inertial(mass, moment):
    return (f'<inertial><origin xyz="0 0 0"/><mass value="{mass}"/>'
            f'<inertia ixx="{moment}" iyy="{moment}" izz="{moment}" ixy="0" ixz="0" iyz="0"/></inertial>')


def write_robot(folder, kind):
    """Every joint is a small weight of its own on the base, far from the others."""
    name = {"unitree_hg": "g1", "unitree_go": "go2"}[kind]
    lines = [f'<robot name="{name}">', f'  <link name="base">{inertial(10, 1)}</link>']
    for number, joint in enumerate(JOINTS[kind]):
        link = joint.replace("_joint", "_link")
        lines.append(f'  <link name="{link}">{inertial(0.5, 0.01)}</link>')
        lines.append(f'  <joint name="{joint}" type="revolute"><parent link="base"/><child link="{link}"/><origin xyz="0 {number} 0"/>'
                     '<axis xyz="0 1 0"/><limit lower="-2.5" upper="2.5" effort="80" velocity="20"/></joint>')
    lines.append("</robot>\n")
    (folder / f"{name}.urdf").write_text("\n".join(lines))
    pose = "".join(f'<joint name="{joint}" value="0"/>' for joint in JOINTS[kind])
    (folder / f"{name}.srdf").write_text(f'<robot name="{name}"><group_state name="half_sitting" group="all">{pose}</group_state></robot>\n')
    (folder / "robot.yaml").write_text(f"urdf: {name}.urdf\nsrdf: {name}.srdf\nbase: fixed\nperiod: 0.002\n"
                                       f"servos:\n  - joints: [{', '.join(JOINTS[kind])}]\n    kp: 60\n    kd: 2\n")
    return folder
