#!/usr/bin/env python3
"""Logs from Python: several parts, a last message that was not finished, damaged bytes, channels as arrays."""
import pathlib
import struct
import tempfile
import unittest

from package_of_tree import SKIPPED  # noqa: F401
import twinbus

try:
    import numpy
except ImportError:
    numpy = None
try:
    import pandas
except ImportError:
    pandas = None


def event(number, utime, channel, body):
    return struct.pack(">IqqII", 0xEDA1DA01, number, utime, len(channel), len(body)) + channel.encode() + body


def state(tick):
    message = twinbus.robot_state_t(tick=tick)
    message.q[3], message.wrench[1][2] = 0.5 * tick, 100.0 + tick
    return message.encode()


class Logs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.log = pathlib.Path(self.folder.name) / "run.log"
        first = b"".join(event(k, 1000000 + 2000 * k, "STATE", state(k)) for k in range(5))
        other = event(5, 1010000, "STATE", twinbus.stop_t().encode()) + event(6, 1010000, "STOP", twinbus.stop_t(kind=2).encode())
        self.log.write_bytes(first + other + event(7, 1, "STATE", state(9))[:-1])
        self.log.with_name("run-0002.log").write_bytes(event(0, 1020000, "STATE", state(5)))

    def tearDown(self):
        self.folder.cleanup()

    def test_messages_of_all_parts_in_order(self):
        found = list(twinbus.read_log(self.log))
        self.assertEqual([channel for _, channel, _ in found], ["STATE"] * 6 + ["STOP", "STATE"])
        log = twinbus.Log(self.log)
        self.assertEqual(log.counts, {"STATE": 7, "STOP": 1})
        self.assertEqual([message.tick for message in log.messages("STATE")], [0, 1, 2, 3, 4, 5])  # that of another type is left out
        with self.assertRaisesRegex(KeyError, "POWER"):
            log.messages("POWER")

    def test_an_older_status_is_read(self):
        now = twinbus.source_status_t(run_id=7, faded_in=0.25).encode()
        older = bytes.fromhex("a10fffc4d8b72360") + now[8:144] + now[148:]
        self.log.write_bytes(event(0, 5, "SOURCE_STATUS", older) + event(1, 6, "SOURCE_STATUS", now) + event(2, 7, "SOURCE_STATUS", older[:-1]))
        self.log.with_name("run-0002.log").unlink()
        found = twinbus.Log(self.log).messages("SOURCE_STATUS")
        self.assertEqual([(message.run_id, message.faded_in) for message in found], [(7, 1.0), (7, 0.25)])

    def test_a_state_of_two_feet_is_read_with_its_hands_behind_the_feet(self):
        state = twinbus.robot_state_t(tick=5, joint_count=29)
        for row, force in ((0, 1.0), (1, 2.0), (6, 3.0), (7, 4.0)):
            state.wrench[row][2], state.wrench_kind[row] = force, 1
        now = state.encode()  # as it was: no rows 2 to 5, of one byte each in kinds, of 24 bytes in wrench
        kinds, wrench = 8 + 9 * 8 + 5 * 4 + 2 + 3, len(now) - 8 * 24
        older = bytes.fromhex("2c552651dafa2de4") + now[8:kinds + 2] + now[kinds + 6:wrench + 48] + now[wrench + 144:]
        self.assertEqual(len(older), 1013)
        self.assertEqual(twinbus.robot_state_t.decode(older), state)
        self.log.write_bytes(event(0, 5, "STATE", older) + event(1, 6, "STATE", now) + event(2, 7, "STATE", older[:-1]))
        self.log.with_name("run-0002.log").unlink()
        log = twinbus.Log(self.log)
        self.assertEqual([message == state for message in log.messages("STATE")], [True, True])
        with self.assertRaisesRegex(ValueError, "robot_state_t: 1012 bytes"):
            twinbus.robot_state_t.decode(older[:-1])

    @unittest.skipIf(numpy is None, "no numpy")
    def test_arrays(self):
        found = twinbus.Log(self.log).arrays("STATE")
        self.assertEqual((found["q"].shape, found["q"].dtype, found["wrench"].shape), ((6, 48), numpy.float64, (6, 4, 6)))
        self.assertTrue(found["q"].dtype.isnative)
        numpy.testing.assert_allclose(found["time"], [0.0, 0.002, 0.004, 0.006, 0.008, 0.02])
        numpy.testing.assert_array_equal(found["q"][:, 3], 0.5 * found["tick"])
        numpy.testing.assert_array_equal(found["wrench"][:, 1, 2], [100, 101, 102, 103, 104, 105])
        self.assertEqual(twinbus.Log(self.log).arrays("GUARD")["tick"].shape, (0,))

    @unittest.skipIf(pandas is None, "no pandas")
    def test_frame(self):
        frame = twinbus.Log(self.log).frame("STATE")
        self.assertEqual(list(frame["wrench[1,2]"]), [100, 101, 102, 103, 104, 105])
        self.assertEqual(list(frame["q[3]"]), [0, 0.5, 1, 1.5, 2, 2.5])
        self.assertEqual(frame.index.name, "time")

    def test_damage_is_said_with_its_place(self):
        whole = self.log.read_bytes()
        for at, value in ((0, 1), (20, 255), (24, 255)):  # mark, length of the name, of the body
            bad = bytearray(whole)
            bad[at] = value
            self.log.write_bytes(bad)
            with self.assertRaisesRegex(ValueError, "byte 0: no log, or a damaged one"):
                twinbus.Log(self.log)
        self.log.write_bytes(b"")
        self.assertEqual(twinbus.Log(self.log).counts, {"STATE": 1})


if __name__ == "__main__":
    unittest.main()
