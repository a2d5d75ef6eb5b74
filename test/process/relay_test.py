#!/usr/bin/env python3
"""The relay of the fault tests carries everything when asked for nothing, and exactly the faults it is asked for."""
import json
import os
import subprocess
import unittest

BIN = os.environ.get('TWINBUS_BIN', 'build/release/bin')
LEFT, RIGHT = 'udpm://239.255.76.67:17667?ttl=0', 'udpm://239.255.76.67:17668?ttl=0'


def start(program, *arguments):
    process = subprocess.Popen([os.path.join(BIN, program), *arguments], text=True, stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE)
    assert process.stdout.readline() == 'ready\n', program
    return process


def through(*relay_arguments, send=500):
    relay = start('relay', '--left', '17667', '--right', '17668', *relay_arguments)
    heard = start('bus_probe', '--url', RIGHT, '--for', '2')
    sent = start('bus_probe', '--url', LEFT, '--send', str(send), '--for', '1.5')
    counts = json.loads(heard.communicate(timeout=20)[0])
    sent.communicate(timeout=20)
    relay.terminate()
    stats = json.loads(relay.communicate(timeout=20)[0])
    print(relay_arguments, 'heard', counts['states'], 'lost', counts['lost'], 'repeated', counts['repeated'], stats)
    return counts, stats


class RelayTest(unittest.TestCase):
    def test_transparent_by_default(self):
        counts, stats = through()
        self.assertEqual((counts['states'], counts['repeated'], counts['ignored']), (500, 0, 0))

    def test_exactly_one_message_is_dropped_and_one_doubled(self):
        counts, stats = through('--rule', 'STATE:7:drop', '--rule', 'STATE:9:double:from-left')
        self.assertEqual((counts['states'], counts['lost'], counts['repeated'], stats['matched']), (499, 1, 1, 2))

    def test_loss_follows_its_seed(self):
        first, second = (through('--loss', '0.2', '--seed', '5')[0]['states'] for _ in range(2))
        self.assertEqual(first, second)
        self.assertTrue(340 < first < 460, first)

    def test_nothing_counts_before_it_is_armed(self):
        counts, _ = through('--arm', 'SOURCE_REQUEST', '--rule', 'STATE:*:drop')
        self.assertEqual(counts['states'], 500)

    def test_a_delayed_message_arrives_late_and_is_refused_as_old(self):
        counts, stats = through('--rule', 'STATE:20:delay=30')
        self.assertEqual((counts['states'], counts['rejected'], stats['delayed']), (499, 1, 1))


if __name__ == '__main__':
    unittest.main(verbosity=2)
