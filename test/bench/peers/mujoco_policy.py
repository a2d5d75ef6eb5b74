"""A policy in MuJoCo itself, on the model in which it was trained: what bench_policy.py holds our walks against.

Nothing of twinbus moves here: MuJoCo's own actuators, step and contacts; only the observation is built by the package."""
import numpy as np

from twinbus.policy.controller import Controller
from twinbus.policy.observation import Measured
from twinbus.policy.rotation import rotation_of

SETTLED = 2.0  # of the beginning does not count, as in twinbus.policy.trial [s]


def compiled(mujoco, file):
    """The model; without meshes, which only draw it, where their files are missing."""
    try:
        return mujoco.MjModel.from_xml_path(str(file))
    except ValueError as error:
        if 'Error opening file' not in str(error):
            raise
    spec = mujoco.MjSpec.from_file(str(file))
    for geom in [geom for geom in spec.geoms if geom.type == mujoco.mjtGeom.mjGEOM_MESH]:
        spec.delete(geom)
    for mesh in list(spec.meshes):
        spec.delete(mesh)
    return spec.compile()


def keyframe_of(model, spec):
    """The number of the keyframe that is nearest to the policy's posture."""
    index = [model.joint(joint.name).qposadr[0] for joint in spec.joints]
    default = np.array([joint.default for joint in spec.joints])
    return int(np.argmin([np.abs(model.key_qpos[key][index] - default).max() for key in range(model.nkey)]))


def velocity_of(network, spec, robot, file, command, seconds, step=None):
    """Mean vx, vy [m/s] and wz [rad/s] in its heading frame, and whether it fell; None where this Python has no mujoco.  step: of MuJoCo
    [s], None: the model's own."""
    try:
        import mujoco
    except ImportError:
        return None
    model = compiled(mujoco, file)
    model.opt.timestep = step or model.opt.timestep
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, keyframe_of(model, spec))
    controller = Controller(spec, robot, network)
    controller.reset()
    joints = [model.joint(name) for name in robot.names()]
    at_q, at_v = ([int(place[0]) for place in places] for places in ([j.qposadr for j in joints], [j.dofadr for j in joints]))
    actuator = {int(model.actuator_trnid[number, 0]): number for number in range(model.nu)}
    moved = [actuator[model.joint(joint.name).id] for joint in spec.joints]
    total, count = np.zeros(3), 0
    each = round(spec.period / model.opt.timestep)
    for tick in range(round(seconds / spec.period)):
        q, qd = data.qpos[at_q], data.qvel[at_v]
        base = rotation_of(data.qpos[3:7])
        imu = robot.motion(robot.imu, q, qd)
        attitude = np.zeros(4)
        mujoco.mju_mat2Quat(attitude, (base @ imu.rotation).flatten())
        gyro = imu.rotation.T @ (data.qvel[3:6] + imu.turning)
        data.ctrl[moved] = controller.step(Measured(q.copy(), qd.copy(), attitude, gyro, base.T @ data.qvel[:3]), np.array(command))
        for _ in range(each):
            mujoco.mj_step(model, data)
            if tick * spec.period >= SETTLED:
                ahead = rotation_of(data.qpos[3:7])[:, 0]
                ahead = ahead[:2] / np.linalg.norm(ahead[:2])
                turn = rotation_of(data.qpos[3:7]) @ data.qvel[3:6]
                total += [ahead @ data.qvel[:2], ahead[0] * data.qvel[1] - ahead[1] * data.qvel[0], turn[2]]
                count += 1
    fell = rotation_of(data.qpos[3:7])[2, 2] < 0.5
    return total / max(1, count), bool(fell)
