#!/usr/bin/env python3
"""19 Environment: learns to balance under pushes in 64 worlds at once (plain PyTorch, augmented random search), for the real stack.

    python3 examples/19_environment.py               minutes on two cores; needs ./python[gym], torch and onnx; writes balance.onnx, balance.spec.yaml
    ./twinbus policy balance.onnx &  ./twinbus up stand_python --stack client      and then, in another terminal: ./twinbus push"""
import argparse
import pathlib

import torch
import twinbus
from twinbus.gym import Many, VectorEnv

FEATURES, STEPS, SPREAD, RATE, BEST = 9, 250, 0.1, 0.05, 12  # features: gravity, angular velocity, velocity of the base; steps of 20 ms


def lasts(worlds: VectorEnv, weights: torch.Tensor, seeds: list[int | None]) -> tuple[torch.Tensor, float]:
    """Mean reward of a step and share that stood; weights [worlds, joints, FEATURES]; equal seeds, equal pushes."""
    seen, _ = worlds.reset(seed=seeds)
    total, stands = torch.zeros(worlds.num_envs), torch.ones(worlds.num_envs)
    for _ in range(STEPS):
        action = torch.tanh(torch.einsum('wjf,wf->wj', weights, torch.from_numpy(seen)[:, :FEATURES]))
        seen, reward, fell, _, _ = worlds.step(action.numpy())
        stands *= 1.0 - torch.from_numpy(fell).float()
        total += stands * torch.from_numpy(reward).float() / STEPS
    return total, float(stands.mean())


def write(name: str, many: Many, weights: torch.Tensor) -> None:
    """The network, and the specification by which ./twinbus policy shows it what the environment does."""
    layer = torch.nn.Linear(many.observation_space.shape[0], len(many.robot.joints), bias=False)
    layer.weight.data = torch.nn.functional.pad(weights, (0, layer.in_features - FEATURES))
    torch.onnx.export(torch.nn.Sequential(layer, torch.nn.Tanh()), (torch.zeros(1, layer.in_features),), f'{name}.onnx', dynamo=False)
    rows = [f'  - {{name: {joint}, default: {many.start[0, k]:.9g}, scale: {many.action_scale}, kp: {many.robot.kp[k]:g}, '
            f'kd: {many.robot.kd[k]:g}}}' for k, joint in enumerate(many.robot.joints)]
    terms = ['projected_gravity, frame: imu', 'base_angular_velocity, frame: imu', 'base_linear_velocity', 'constant, values: [0, 0, 0, 0, 0, 0]',
             'joint_position', 'joint_velocity, scale: 0.05', 'last_action']
    pathlib.Path(f'{name}.spec.yaml').write_text('\n'.join(['spec: 1', f'name: {name}', f'period: {many.dt:g}', 'joints:', *rows, 'observations:',
                                                            *(f'  - {{term: {term}}}' for term in terms), '']))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--rounds', type=int, default=40, help='a few seconds each')
    worlds = VectorEnv('Stand', num_envs=64, push=0.7)  # [m/s]; as gymnasium.make_vec('twinbus/Stand-v0', ...)
    # Ankles and hips that pitch: others bring links near each other, and the guard of a stack stops that.
    legs = torch.tensor([[float(joint.endswith(('ANKLE_P', 'ANKLE_R', 'HIP_P')))] for joint in worlds.many.robot.joints])
    best = torch.zeros(len(legs), FEATURES)
    for number in range(parser.parse_args().rounds):
        tried = legs * torch.randn(32, *best.shape, generator=torch.Generator().manual_seed(number))
        reward, stood = lasts(worlds, best + SPREAD * torch.cat([tried, -tried]), [number] * 64)
        chosen = torch.maximum(reward[:32], reward[32:]).topk(BEST).indices
        best += RATE / (BEST * reward.std()) * torch.einsum('d,djf->jf', (reward[:32] - reward[32:])[chosen], tried[chosen])
        print(f'round {number}: reward {reward.mean():.3f}, {stood:.0%} stood', flush=True)
    for name, weights in (('without it', torch.zeros_like(best)), ('learned', best)):
        print(f'{name}: {lasts(worlds, weights.expand(64, -1, -1), list(range(1000, 1064)))[1]:.0%} of 64 new pushes stood')
    write('balance', worlds.many, best)


if __name__ == '__main__':
    twinbus.run(main)
