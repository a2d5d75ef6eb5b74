"""A first SPEC.yaml for a policy that says nothing of itself: names in the order of the robot, terms by the size of its input.

Every guess is written under `assumed`.  It is a beginning, for somebody who knows the training."""
from __future__ import annotations

from .errors import PolicyError
from .network import Network
from .robot import Robot
from .spec import Joint, Phase, Spec, Term

MOTION = ('joint_position', 'joint_velocity', 'last_action')
TURNING = ('base_angular_velocity', 'projected_gravity', 'velocity_command')
# what velocity policies read, by the size of one age: 3 n and so many numbers
LAYOUTS: dict[int, tuple[str, ...]] = {
    9: TURNING + MOTION, 12: ('base_linear_velocity', *TURNING, *MOTION), 11: (*TURNING, *MOTION, 'gait_phase'),
    13: (*TURNING, *MOTION, 'phase_sin', 'phase_cos'), 16: ('base_linear_velocity', *TURNING, *MOTION, 'phase_cos', 'phase_sin')}
MOST_HISTORY = 20


def propose(network: Network, robot: Robot) -> Spec:
    """PolicyError when not even a guess fits."""
    names, count = robot.names(), network.action_size
    if count != len(names):
        raise PolicyError(f'{network.path}: it moves {count} joints, {robot.name} has {len(names)}; which ones, only a specification can say '
                          '(doc/policy.md)')
    posture = robot.poses.get('half_sitting', {})
    joints = [Joint(joint.name, posture.get(joint.name, 0.0), 0.25, joint.kp, joint.kd) for joint in robot.bus]
    for history in range(1, MOST_HISTORY + 1):
        extra = network.observation_size / history - 3 * count
        if extra in LAYOUTS:
            terms = [Term(name, history=history, period=1.0 if name == 'gait_phase' else 0.0) for name in LAYOUTS[int(extra)]]
            break
    else:
        raise PolicyError(f'{network.path}: it reads {network.observation_size} numbers, which is no usual observation of {count} joints; '
                          'write which they are (doc/policy.md)')
    spec = Spec(network.path.stem, 0.02, joints, terms, network.input, network.output, source=str(network.path),
                phase=Phase(1.0, [0.0, 3.14159265]) if any(term.term.startswith('phase_') for term in terms) else None)
    spec.assumed = [f'joints are in the order of {robot.name}', 'default angles are those of half_sitting, kp and kd those of robot.yaml, '
                    'the scale of an action is 0.25', f'the {network.observation_size} observations are guessed by their number; they are not '
                    'scaled', 'a new action every 0.02 s']
    spec.validate()
    return spec
