#!/usr/bin/env python3
"""The bus on a real network stack: no loss and no allocation at 1 kHz, malformed datagrams and foreign machines dropped.

Runs inside tools/private_bus.sh.  TWINBUS_BIN says where bus_probe is.
"""
import json
import os
import random
import socket
import struct
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from namespaces import URL, Cable

PROBE = os.path.join(os.environ.get('TWINBUS_BIN', 'build/release/bin'), 'bus_probe')
GROUP = ('239.255.76.67', 17667)
UNSPLIT, SPLIT = 0x4C433032, 0x4C433033  # "LC02", "LC03"
SEED = int(os.environ.get('TWINBUS_SEED', '1'))


def start(*arguments, machine=None):
    words = [PROBE, *arguments]
    process = (machine.start(words) if machine
               else subprocess.Popen(words, stdout=subprocess.PIPE, text=True))
    assert process.stdout.readline() == 'ready\n'
    return process


def result(process):
    out, _ = process.communicate(timeout=30)
    assert process.returncode == 0, f'bus_probe ended with {process.returncode}'
    return json.loads(out)


# A sender of anything, run in whatever namespace: datagrams come on its standard input as hex lines.
SENDER = '''
import socket, sys
s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
s.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 1)
for line in sys.stdin:
    where, _, data = line.partition(' ')
    s.sendto(bytes.fromhex(data), (where, 17667))
'''


def unsplit(channel, body, sequence=1):
    return struct.pack('>II', UNSPLIT, sequence) + channel + b'\0' + body


def fragment(sequence, size, offset, number, count, payload):
    return struct.pack('>IIIIHH', SPLIT, sequence, size, offset, number, count) + payload


def nasty():
    """What once crashed liblcm or got past it."""
    yield from ((b'LC02\0\0\0\1STATE\0')[:n] for n in range(13))
    yield from ((struct.pack('>IIIIHH', SPLIT, 9, 100, 0, 0, 2) + b'STATE\0')[:n] for n in range(26))
    yield unsplit(b'STATE', b'A' * 200)                       # wrong size
    yield struct.pack('>II', UNSPLIT, 2) + b'STA'               # the channel name never ends
    yield struct.pack('>II', UNSPLIT, 3) + b'STATE'
    yield struct.pack('>II', UNSPLIT, 3) + b'X' * 3000
    for _ in range(3):                                          # delivered with a hole of rubbish
        yield fragment(7, 3000, 0, 0, 3, b'STATE\0' + b'A' * 1000)
        yield fragment(7, 3000, 1000, 1, 3, b'A' * 1000)
        yield fragment(7, 3000, 1000, 1, 3, b'A' * 1000)
    yield fragment(8, 3000, 0, 0, 3, b'STATE\0' + b'A' * 1000)  # writes 4 GB out of place
    yield fragment(8, 3000, 0xFFFFF000, 1, 3, b'B' * 0x1800)
    yield b''
    yield b'\0' * 60000


class OneMachine(unittest.TestCase):
    def test_a_thousand_states_arrive_at_1_khz_without_loss_or_allocation(self):
        listener = start('--for', '2.5')
        sender = start('--send', '1000', '--rate', '1000', '--for', '1.5')
        sent, heard = result(sender), result(listener)
        print('heard', heard, '\nsent', sent)
        self.assertEqual(sent['sent'], 1000)
        self.assertEqual(heard['states'], 1000)
        self.assertEqual(heard['lost'] + heard['rejected'] + heard['dropped'], 0)
        self.assertEqual(sent['allocations'], 0)      # sending, and hearing what it sends itself
        self.assertLessEqual(heard['allocations'], 4)  # LCM remembers a channel when it first hears it

    def test_channels_that_nobody_listens_to_never_reach_the_process(self):
        listener = start('--for', '2.5')
        sender = start('--send', '200', '--rate', '200', '--for', '1.5')
        sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
        others = (b'STAT', b'STATES', b'STATE_', b'STATE_BRIDGE', b'STOPS', b'S', b'', b'WALK', b'R1_STATE')
        for _ in range(100):
            for channel in others:
                sock.sendto(unsplit(channel, b'A' * 1001), GROUP)
        sock.close()
        sent, heard = result(sender), result(listener)
        print('heard', heard)
        self.assertEqual(heard['states'], sent['sent'])
        self.assertEqual(heard['rejected'], 0)
        self.assertEqual(heard['dropped'], 100 * len(others))

    def test_malformed_datagrams_are_dropped_and_counted_and_nothing_else_is_lost(self):
        listener = start('--for', '4')
        good = start('--send', '1000', '--for', '3')
        sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
        rng = random.Random(SEED)
        garbage = split = 0
        for data in nasty():
            sock.sendto(data, GROUP)
            sock.sendto(data, ('127.0.0.1', GROUP[1]))
            split += 2 * data.startswith(b'LC03')
        for i in range(20000):
            body = rng.randbytes(rng.choice([0, 8, 1000, 1001, 1001, 1200, 34, 1400]))
            channel = rng.choice([b'STATE', b'STOP', b'COMMAND', b'HEARTBEAT'])
            sock.sendto(unsplit(channel, body, i), GROUP)
            garbage += 1
            if i % 100 == 0:
                time.sleep(0.01)
        sock.close()
        sent, heard = result(good), result(listener)
        print('seed', SEED, 'garbage', garbage, 'split', split, '\nheard', heard)
        self.assertEqual(heard['states'], sent['sent'])
        self.assertEqual(heard['stops'], 0)
        self.assertGreaterEqual(heard['rejected'], garbage)
        self.assertGreaterEqual(heard['dropped'], split // 2)  # unicast reaches one of the two listeners


class ThreeMachinesOnOneCable(unittest.TestCase):
    def test_the_allowed_one_is_heard_and_the_third_one_is_not(self):
        with Cable() as cable:
            robot, desk, stranger = (cable.machine(f'10.77.0.{n}') for n in (1, 2, 3))
            listener = start('--url', URL, '--allow', robot.address, '--for', '4', machine=desk)
            stock = start('--url', URL, '--allow', '10.77.0.1,10.77.0.2,10.77.0.3', '--for', '4', machine=desk)
            source = start('--url', URL, '--allow', desk.address, '--send', '500', '--for', '3', machine=robot)
            intruder = start('--url', URL, '--send', '500', '--run-id', '666', '--term', '9', '--for', '3',
                             machine=stranger)
            forged = stranger.start([sys.executable, '-c', SENDER], stdin=subprocess.PIPE)
            lines = [f'{where} {data.hex()}\n' for data in nasty() if len(data) < 1500
                     for where in (GROUP[0], desk.address)]
            forged.communicate(''.join(lines), timeout=20)
            self.assertEqual(forged.returncode, 0)
            heard, open_door = result(listener), result(stock)
            sent, intruded = result(source), result(intruder)
        print('heard', heard, '\nall allowed', open_door, '\nsent', sent, '\nintruder', intruded)
        self.assertEqual(heard['states'], sent['sent'])
        self.assertEqual(heard['run_id'], 77)
        self.assertEqual(heard['rejected'], 0)                       # nothing foreign reached the process
        self.assertGreaterEqual(heard['dropped'], intruded['sent'])  # the kernel dropped it
        # The cable does carry the stranger's datagrams: who allows him hears him, and does not believe him.
        self.assertGreaterEqual(open_door['ignored'], 400)
        self.assertEqual(open_door['run_id'], 77)

    def test_ttl_0_stays_on_the_machine(self):
        with Cable() as cable:
            one, other = (cable.machine(f'10.77.0.{n}') for n in (1, 2))
            listener = start('--allow', one.address, '--for', '2.5', machine=other)
            sender = start('--send', '300', '--for', '1.5', machine=one)
            sent, heard = result(sender), result(listener)
        self.assertEqual(sent['sent'], 300)
        self.assertEqual(sent['states'], 300)  # its own come back: looped multicast passes the filter
        self.assertEqual(heard['states'] + heard['dropped'], 0)


if __name__ == '__main__':
    unittest.main(verbosity=2)
