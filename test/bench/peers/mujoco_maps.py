"""MuJoCo on the scenes of test/bench/maps: a line of JSON each, as `failure_maps mujoco` writes them, answered as failure_maps does.

Implicitfast, elliptic cone; said: a warning of MuJoCo, or a solver that used up its iterations.  `loaded()` is None without the
package mujoco.
"""

import math
import time

GRAVITY, WRONG_ENERGY, PATIENCE = 9.81, 0.05, 20.0


def loaded():
    try:
        import mujoco
    except ImportError:
        return None
    return mujoco


def through_of(name):
    """What asks whether something is behind what stopped it, of the bodies' places."""
    if name == "plate":
        return lambda x: x[0][0] > (x[1][0] if len(x) > 1 else 1.0)
    if name in ("throw", "stack"):
        return lambda x: x[0][2] < 0.0
    return None


def beams_apart(place, along, half=0.2):
    """Of the middle lines of the fixed beam, along x at 1 m, and of another."""
    r = (place[0], place[1], place[2] - 1.0)
    c, p, q = along[0], r[0], sum(a * b for a, b in zip(along, r))
    det = 1.0 - c * c
    if not det > 1e-6:
        return math.hypot(*r)
    s, t = (p - c * q) / det, (c * p - q) / det
    if abs(s) > half or abs(t) > half:
        return 1.0
    return math.hypot(r[0] + t * along[0] - s, r[1] + t * along[1], r[2] + t * along[2])


def run(mujoco, scene, cell):
    model = mujoco.MjModel.from_xml_string(scene["xml"])
    model.opt.timestep = h = scene["step"]
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_AUTORESET
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    for i, speeds in enumerate(scene["loose"]):
        data.qvel[6 * i:6 * i + 6] = speeds
    mujoco.mj_forward(model, data)
    first, begun = data.energy.sum(), time.process_time()
    bodies = range(1, model.nbody)
    steps, look = round(scene["duration"] / h), max(1, round(scene["every"] / h)) if scene["every"] > 0 else 0
    found = {"status": "ok", "said_at": None, "energy_at": None, "through_at": None, "gain": 0.0, "doubts_at": [], "at": {}}
    through = through_of(cell["map"])
    for i in range(1, steps + 1):
        now = i * h
        mujoco.mj_step(model, data)
        bad = any(data.warning[k].number for k in range(len(data.warning)))
        if bad or max(data.solver_niter) >= model.opt.iterations:
            found["doubts_at"].append((now, now))
            if found["said_at"] is None:
                found["said_at"], found["said"] = now, "warning" if bad else "unconverged"
        if bad or not math.isfinite(data.qpos.sum()) or abs(data.qvel).max() > 1e4:
            found["status"], found["ended"] = "diverged", now
            break
        if scene["scale"] > 0.0:  # of before the step
            change = (data.energy.sum() - first) / scene["scale"]
            found["gain"] = max(found["gain"], change)
            if found["energy_at"] is None and (change > WRONG_ENERGY or (scene["conservative"] and change < -WRONG_ENERGY)):
                found["energy_at"] = now
        places = data.xipos[1:]
        if found["through_at"] is None:
            if through and through(places):
                found["through_at"] = now
            elif cell["map"] == "edge" and beams_apart(places[0], data.xmat[1].reshape(3, 3)[:, 1]) < 0.03:
                found["through_at"] = now
        if look and i % look == 0:
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            found["at"][str(round(1e4 * now))] = data.xipos[1:].flatten().tolist()
        if time.process_time() - begun > PATIENCE:
            found["status"] = "slow"
            break
    found["cpu"] = time.process_time() - begun
    found["speed"] = max(float(abs(data.cvel[b][3:]).max()) for b in bodies) if found["status"] == "ok" else math.inf
    found["upright"] = min(float(data.xmat[b][8]) for b in (bodies if scene["loose"] else [1]))
    return found
