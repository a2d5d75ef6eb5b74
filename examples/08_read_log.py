#!/usr/bin/env python3
"""08 Read a log: what is in it, and how far a joint was from its command.

    python3 examples/08_read_log.py "$(ls -d runs/*/run.log | tail -1)" --joint 3

`./twinbus log` does the same and more without a program: info, events, csv, plot, compare, mcap, rerun.
"""
import argparse
import collections

import twinbus


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('log')
    parser.add_argument('--joint', type=int, default=3, help='joint index, in the order of the URDF')
    arguments = parser.parse_args()
    counts: collections.Counter[str] = collections.Counter()
    sources, commanded, errors = set(), {}, []
    for _, channel, body in twinbus.read_log(arguments.log):
        counts[channel] += 1
        if channel == 'COMMAND':
            command = twinbus.decode(channel, body)
            commanded[command.tick] = command.q[arguments.joint]
        elif channel == 'STATE':
            state = twinbus.decode(channel, body)
            sources.add((state.run_id, state.term))
            if state.tick - 1 in commanded:  # what was asked a tick before
                errors.append(state.q[arguments.joint] - commanded[state.tick - 1])
    for channel, count in sorted(counts.items()):
        print(f'{channel:20} {count:8}')
    print(f'{len(sources)} runs or terms on STATE')
    if errors:
        print(f'joint {arguments.joint}: {1e3 * max(map(abs, errors)):.3f} mrad from its command at most, '
              f'{1e3 * sum(map(abs, errors)) / len(errors):.3f} mrad on average')


if __name__ == '__main__':
    twinbus.run(main)
