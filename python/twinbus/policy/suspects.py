"""Single changes of a contract, each a mistake that is often made: which of them lets a policy walk that fell, names the mistake."""
from __future__ import annotations

import copy
from typing import Callable, Iterator

from .mirror import pairs
from .robot import Robot
from .spec import Spec

Change = Callable[[Spec], None]


def _scale(term: str, factor: float) -> Change:
    def change(spec: Spec) -> None:
        for entry in spec.observations:
            if entry.term == term:
                entry.scale = [scale * factor for scale in entry.scale]
    return change


def _joints(key: str, factor: float) -> Change:
    def change(spec: Spec) -> None:
        for joint in spec.joints:
            setattr(joint, key, getattr(joint, key) * factor)
    return change


def _names(order: list[str]) -> Change:
    """The joints' numbers stay, their names come in another order."""
    def change(spec: Spec) -> None:
        for joint, name in zip(spec.joints, order):
            joint.name = name
    return change


def _posture(angles: dict[str, float]) -> Change:
    def change(spec: Spec) -> None:
        for joint in spec.joints:
            joint.default = angles.get(joint.name, 0.0)
    return change


def _sides(robot: Robot) -> Change:
    other = {pair.left: pair.right for pair in pairs(robot)}
    other |= {right: left for left, right in other.items()}

    def change(spec: Spec) -> None:
        for joint in spec.joints:
            joint.name = other.get(joint.name, joint.name)
    return change


def _exchange(first: str, second: str) -> Change:
    def change(spec: Spec) -> None:
        at = {term.term: number for number, term in enumerate(spec.observations)}
        one, two = at[first], at[second]
        spec.observations[one], spec.observations[two] = spec.observations[two], spec.observations[one]
    return change


def _set(key: str, value: object) -> Change:
    def change(spec: Spec) -> None:
        setattr(spec, key, value)
    return change


def _period(factor: float) -> Change:
    def change(spec: Spec) -> None:
        spec.period *= factor
    return change


def suspects(spec: Spec, robot: Robot) -> Iterator[tuple[str, str, Spec]]:
    """(about, sentence, changed specification), the most frequent mistakes first."""
    terms = [term.term for term in spec.observations]
    changes: list[tuple[str, str, Change]] = []
    if 'projected_gravity' in terms:
        changes.append(('gravity frame', 'with gravity pointing the other way', _scale('projected_gravity', -1.0)))
    for order, name in ((robot.breadth_first(set(spec.names())), 'level by level (Isaac Lab)'), (sorted(spec.names()), 'sorted by name'),
                        ([name for name in robot.names() if name in set(spec.names())], 'of the robot')):
        if order != spec.names() and len(order) == len(spec.names()):
            changes.append(('joint order', f'with the joints in the order {name}', _names(order)))
    for name, angles in robot.poses.items():
        if any(abs(angles.get(joint.name, 0.0) - joint.default) > 0.02 for joint in spec.joints):
            changes.append(('default angles', f'with the angles of {name}', _posture(angles)))
    for key, about in (('scale', 'scale'), ('kp', 'gains')):
        for factor in (-1.0, 2.0, 0.5) if key == 'scale' else (2.0, 0.5):
            changes.append(('sign' if factor < 0.0 else about, f'with {"the action" if key == "scale" else key} times {factor:g}',
                            _joints(key, factor)))
    for term, factors in (('joint_velocity', (0.05, 20.0, -1.0)), ('base_angular_velocity', (0.25, 4.0, 0.2, 5.0, -1.0)),
                          ('joint_position', (-1.0,)), ('velocity_command', (-1.0, 2.0, 0.5)), ('base_linear_velocity', (2.0, 0.5, -1.0)),
                          ('last_action', (-1.0,))):
        if term in terms:
            changes += [('sign' if factor < 0.0 else 'scale', f'with {term} times {factor:g}', _scale(term, factor)) for factor in factors]
    changes += [('rate', f'with an action every {1e3 * spec.period * factor:g} ms', _period(factor)) for factor in (0.5, 2.0)]
    if any(term.history > 1 for term in spec.observations):
        other = 'newest_first' if spec.history_order == 'oldest_first' else 'oldest_first'
        changes.append(('history length', f'with the history {other}', _set('history_order', other)))
        if len({term.history for term in spec.observations}) == 1:
            other = 'age' if spec.history_by == 'term' else 'term'
            changes.append(('history length', f'with the history by {other}', _set('history_by', other)))
    for first, second in (('joint_position', 'joint_velocity'), ('base_linear_velocity', 'base_angular_velocity'),
                          ('base_angular_velocity', 'projected_gravity'), ('projected_gravity', 'velocity_command'),
                          ('base_angular_velocity', 'velocity_command'), ('phase_sin', 'phase_cos'), ('joint_velocity', 'last_action')):
        if first in terms and second in terms:
            changes.append(('observations', f'with {first} and {second} exchanged', _exchange(first, second)))
    changes.append(('joint order', 'with left and right exchanged', _sides(robot)))
    for about, sentence, change in changes:
        changed = copy.deepcopy(spec)
        change(changed)
        yield about, sentence, changed
