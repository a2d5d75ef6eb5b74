"""The arguments of ./twinbus policy.  Nothing here needs numpy or onnxruntime: --help always answers."""
from __future__ import annotations

import argparse
import pathlib
from typing import Sequence

from ..home import as_typed

REMEDY = ('onnxruntime, numpy or PyYAML is missing: python3 -m venv ~/twinbus-policy && ~/twinbus-policy/bin/pip install onnxruntime pyyaml, '
          'then TWINBUS_POLICY_PYTHON=~/twinbus-policy/bin/python3 ./twinbus policy ...')
ABOUT = '''Runs a learned policy (ONNX) as the controller: STATE in, COMMAND out.  Start it first, then the stack:

  ./twinbus policy walk.onnx &  ./twinbus up stand_python --stack client --robot g1

What it reads and moves is said by, in this order: --spec FILE, MODEL.spec.yaml or SPEC.yaml beside it, the metadata of the ONNX file
(mjlab, holosoma), deploy.yaml (Unitree), env.yaml (Isaac Lab) beside it or in params/.  doc/policy.md has every key.
./twinbus walk and the gamepad say how fast; a balanced stop brings it to rest; NaN, wrong shapes and late inference stop the robot.'''


def parse(words: Sequence[str] | None = None) -> argparse.Namespace:
    """Exit status 2 for words that do not go together."""
    made = parser()
    found = made.parse_args(words)
    if sentence := contradiction(found):
        made.error(sentence)
    return found


def contradiction(words: argparse.Namespace) -> str:
    """Of words that would be left out without a word; empty: none."""
    if words.play_spec and not words.play:
        return '--play-spec is of the policy that --play names, and there is no --play'
    instead = next((word for word in ('propose', 'check', 'map') if getattr(words, word)), '')
    if words.play and instead:
        return f'--{instead} looks at one policy: leave --play out, and look at {words.play} by itself'
    if words.fade and words.no_fade:
        return '--fade and --no-fade contradict each other'
    if words.fade and words.wait == 0.0:
        return '--wait 0 begins at once, not faded in: --fade wants a longer one'
    return ''


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(prog=as_typed('./twinbus policy'), description=as_typed(ABOUT), formatter_class=argparse.RawDescriptionHelpFormatter)
    made.add_argument('model', metavar='MODEL.onnx', type=pathlib.Path)
    made.add_argument('--spec', default='', metavar='FILE', help='SPEC.yaml, deploy.yaml or env.yaml')
    made.add_argument('--motion', default='', metavar='FILE', help='of a tracking policy: NPZ or CSV (doc/motion.md); default: the one inside of its network')
    made.add_argument('--play', default='', metavar='TRACK.onnx', help=as_typed('a tracking policy beside this one, which walks: ./twinbus mode play changes to it'))
    made.add_argument('--play-spec', default='', metavar='FILE', help='its specification; default: found as that of MODEL.onnx')
    made.add_argument('--robot', default='', metavar='ROBOT', help='a name under config/robots or a folder; default: the robot on the bus')
    what = made.add_argument_group('instead of running it')
    what.add_argument('--propose', action='store_true', help='prints the SPEC.yaml that was found, or begins one')
    what.add_argument('--check', action='store_true', help='holds it against the robot, and lets it stand and walk in a simulator')
    what.add_argument('--map', action='store_true', help='its answer to velocities, over seeds, in a simulator: dead zone, drift, largest speed')
    trial = made.add_argument_group('--propose, --check, --map')
    trial.add_argument('--output', default='', metavar='FILE', help='of --propose (default MODEL.spec.yaml, - prints) or the drawing of --map (SVG)')
    trial.add_argument('--no-trial', action='store_true', help='--check by numbers alone')
    trial.add_argument('--seconds', type=float, metavar='S', help='of each trial; default 4, of a tracking policy its motion')
    trial.add_argument('--seeds', type=int, default=3, metavar='N', help='of --map; default 3')
    trial.add_argument('--seed', type=int, default=1, metavar='N', help='the first')
    trial.add_argument('--steps', type=int, default=3, metavar='N', help='of --map, from zero to each end; default 3')
    trial.add_argument('--axes', nargs='+', choices=('vx', 'vy', 'wz'), default=('vx', 'vy', 'wz'), help='of --map')
    trial.add_argument('--engine', default='', metavar='E', help='of the trials; default the scene\'s')
    trial.add_argument('--jobs', type=int, default=2, metavar='N', help='trials at once; default 2')
    run = made.add_argument_group('running')
    run.add_argument('--command', nargs=3, type=float, default=(0.0, 0.0, 0.0), metavar=('VX', 'VY', 'WZ'),
                     help='[m/s, rad/s], while neither WALK nor GAMEPAD says one')
    run.add_argument('--wait', type=float, metavar='S', help='hold its default posture for so long at first; default 0.3, with --no-fade 0; 0: begin at once, not faded in')
    run.add_argument('--fade', action='store_true', help='fade its first commands in, which is done where a joint is over 1 rad from its posture')
    run.add_argument('--no-fade', action='store_true', help='its commands are not faded in (flag 2): for a start in its own posture')
    run.add_argument('--for', dest='duration', type=float, default=float('inf'), metavar='S', help='seconds of the robot, then it ends')
    run.add_argument('--no-fifo', action='store_true', help='ordinary priority, also where FIFO is allowed')
    run.add_argument('--url', default=None, help='of the bus')
    run.add_argument('--prefix', default='', help='before the name of every channel')
    return made
