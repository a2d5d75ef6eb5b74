"""The answer of a policy to velocities: what it walks when it is asked for what, over seeds, as a table and a drawing (SVG)."""
from __future__ import annotations

import html
import math
from dataclasses import dataclass
from typing import Callable, Sequence

import numpy as np

from .spec import Spec
from .trial import Outcome

AXES = ('vx', 'vy', 'wz')
UNITS = ('m/s', 'm/s', 'rad/s')
NO_ANSWER = 0.2   # of what is asked: an answer below counts as none (dead zone)


@dataclass
class Figures:
    """Of one axis."""
    axis: int
    dead_zone: float     # largest command, upwards from zero, that is answered by less than a fifth [m/s or rad/s]
    drift: tuple[float, float, float]  # at zero: vx, vy, wz
    largest: float       # mean answer of the fastest command without a fall
    falls: int
    trials: int


def commands(spec: Spec, axes: Sequence[int], steps: int) -> list[tuple[float, float, float]]:
    """Zero, and steps to each end of each axis: of the ranges of the training, else 1 m/s, 0.5 m/s, 1 rad/s."""
    found = [(0.0, 0.0, 0.0)]
    for axis in axes:
        low, high = spec.commands.get(AXES[axis], ((-0.5, 1.0), (-0.5, 0.5), (-1.0, 1.0))[axis])
        for end in (low, high):
            for step in range(1, steps + 1):
                command = [0.0, 0.0, 0.0]
                command[axis] = end * step / steps
                if command[axis] != 0.0 and (entry := (command[0], command[1], command[2])) not in found:
                    found.append(entry)
    return found


def figures(outcomes: Sequence[Outcome], axis: int) -> Figures:
    """Of the outcomes whose command is zero but for this axis."""
    on_axis = [o for o in outcomes if all(o.command[k] == 0.0 for k in range(3) if k != axis)]
    still = [o.velocity for o in on_axis if o.command[axis] == 0.0 and not o.fell]
    drift = np.mean(still, axis=0) if still else np.full(3, math.nan)
    answers, dead = answers_of(on_axis, axis), 0.0
    rest = 0.0 if math.isnan(drift[axis]) else float(drift[axis])
    for asked in sorted(asked for asked in answers if asked > 0.0):
        if math.isnan(answers[asked]) or answers[asked] - rest >= NO_ANSWER * asked:
            break
        dead = asked
    good = [value for value in answers.values() if not math.isnan(value)]
    largest = max(good, default=math.nan)
    return Figures(axis, dead, (float(drift[0]), float(drift[1]), float(drift[2])), largest, sum(o.fell for o in on_axis), len(on_axis))


def answers_of(outcomes: Sequence[Outcome], axis: int) -> dict[float, float]:
    """Command: mean answer of the trials without a fall, nan where all fell."""
    found: dict[float, float] = {}
    for asked in sorted({o.command[axis] for o in outcomes}):
        values = [float(o.velocity[axis]) for o in outcomes if o.command[axis] == asked and not o.fell and not o.stopped]
        found[asked] = float(np.mean(values)) if values else math.nan
    return found


def in_words(outcomes: Sequence[Outcome], axes: Sequence[int], say: Callable[[str], None]) -> None:
    """A row per command, then a sentence per axis."""
    say(f'{"asked vx":>9} {"vy":>6} {"wz":>6}   {"walked vx":>9} {"vy":>7} {"wz":>7}   {"spread":>7}  tilt  falls')
    for command in dict.fromkeys(o.command for o in outcomes):
        same = [o for o in outcomes if o.command == command]
        stood = [o.velocity for o in same if not o.fell]
        mean, spread = (np.mean(stood, axis=0), float(np.max(np.ptp(stood, axis=0)))) if stood else (np.full(3, math.nan), math.nan)
        tilt = math.degrees(max(o.largest_tilt for o in same))
        say(f'{command[0]:9.2f} {command[1]:6.2f} {command[2]:6.2f}   {mean[0]:9.3f} {mean[1]:7.3f} {mean[2]:7.3f}   {spread:7.3f} '
            f'{tilt:5.1f}  {sum(o.fell for o in same)} of {len(same)}{"  " + same[0].stopped if same[0].stopped else ""}')
    for axis in axes:
        of = figures(outcomes, axis)
        dead = f'no answer up to {of.dead_zone:g} {UNITS[axis]}' if of.dead_zone else 'no dead zone'
        say(f'{AXES[axis]}: {dead}; at zero it drifts by {of.drift[0]:.3f}, {of.drift[1]:.3f} m/s, {of.drift[2]:.3f} rad/s; largest '
            f'{of.largest:.2f} {UNITS[axis]}; {of.falls} falls in {of.trials} trials')


def svg(outcomes: Sequence[Outcome], axes: Sequence[int], title: str) -> str:
    """One square per axis: asked to the right, walked upwards, a dot per trial, the diagonal is perfect."""
    size, gap = 300, 60
    width = gap + len(axes) * (size + gap)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{size + 110}" font-family="sans-serif" font-size="12">',
             f'<rect width="{width}" height="{size + 110}" fill="white"/><text x="{gap}" y="22" font-size="15">{html.escape(title)}</text>']
    for number, axis in enumerate(axes):
        shown = [o for o in outcomes if all(o.command[k] == 0.0 for k in range(3) if k != axis)]
        most = max([0.1] + [abs(o.command[axis]) for o in shown] + [abs(float(o.velocity[axis])) for o in shown if not o.fell]) * 1.1
        left, top = gap + number * (size + gap), 40

        def at(value: float, most: float = most) -> float:
            return size * (0.5 + 0.5 * value / most)
        parts.append(f'<g transform="translate({left},{top})"><rect width="{size}" height="{size}" fill="none" stroke="#888"/>')
        parts.append(f'<line x1="0" y1="{size}" x2="{size}" y2="0" stroke="#bbb" stroke-dasharray="4"/>')
        parts.append(f'<line x1="0" y1="{size / 2}" x2="{size}" y2="{size / 2}" stroke="#ddd"/>'
                     f'<line x1="{size / 2}" y1="0" x2="{size / 2}" y2="{size}" stroke="#ddd"/>')
        for o in shown:
            x, y = at(o.command[axis]), size - at(0.0 if o.fell else float(o.velocity[axis]))
            parts.append(f'<path d="M{x - 4:.1f} {y - 4:.1f}l8 8m0 -8l-8 8" stroke="#c00" stroke-width="2"/>' if o.fell else
                         f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="#06c" fill-opacity="0.6"/>')
        parts.append(f'<text x="{size / 2}" y="{size + 32}" text-anchor="middle">{AXES[axis]} asked [{UNITS[axis]}]</text>'
                     f'<text x="-8" y="{size / 2}" text-anchor="end">walked</text><text x="0" y="{size + 14}">{-most:.2f}</text>'
                     f'<text x="{size}" y="{size + 14}" text-anchor="end">{most:.2f}</text></g>')
    return '\n'.join(parts) + '\n</svg>\n'
