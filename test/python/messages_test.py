#!/usr/bin/env python3
"""Message types made from .lcm texts: the same bytes as those of lcm-gen, hostile bytes and wrong fields refused with their names.

    messages_test.py LCM_GEN
"""
import importlib.util
import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import unittest

from package_of_tree import ROOT
import twinbus
from twinbus import lcm_types

try:
    import numpy
except ImportError:
    numpy = None

KINDS = {"int8_t": 8, "int16_t": 16, "int32_t": 32, "int64_t": 64, "byte": 8}
OWN = """package mine;
// Of my own.
struct mixed_t {
  boolean yes; byte raw[3];  /* three
  lines */
  int16_t table[2][3];  // rows
  const int32_t LEFT = 1, RIGHT = 0x2;
  float a, b;
  double last[1];
}
"""


def lcm_gen_types(folder, files):
    """{name: class} as lcm-gen writes them."""
    subprocess.run([sys.argv[1], "-p", "--ppath", folder, *files], check=True, stdout=subprocess.DEVNULL)
    found = {}
    for file in pathlib.Path(folder).rglob("*_t.py"):
        spec = importlib.util.spec_from_file_location("lcm_gen_" + file.stem, file)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        found[file.stem] = getattr(module, file.stem)
    return found


def drawn(field, luck):
    def one():
        if field.kind == "boolean":
            return luck.random() < 0.5
        if field.kind in ("float", "double"):
            return struct.unpack("f", struct.pack("f", luck.choice([0.0, -0.0, 1e-30, math.inf, luck.uniform(-1e6, 1e6)])))[0]
        low = 0 if field.kind == "byte" else -(1 << (KINDS[field.kind] - 1))
        return luck.choice([low, low + (1 << KINDS[field.kind]) - 1, luck.randrange(low, low + (1 << KINDS[field.kind]))])

    def nest(shape):
        return one() if not shape else [nest(shape[1:]) for _ in range(shape[0])]
    return nest(field.shape)


def plain(value):
    return value.tolist() if hasattr(value, "tolist") else value


class Messages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        own = pathlib.Path(cls.folder.name) / "mixed_t.lcm"
        own.write_text(OWN)
        cls.theirs = lcm_gen_types(cls.folder.name, [*(ROOT / "lcmtypes").glob("*.lcm"), own])
        cls.ours = dict(twinbus.messages.ALL, mixed_t=twinbus.message_type(OWN))

    def test_every_type_is_that_of_lcm_gen(self):
        self.assertEqual(set(self.ours), set(self.theirs))
        self.assertGreater(len(self.ours), 20)
        luck = random.Random(1)
        for name, kind in self.ours.items():
            if name != "mixed_t":  # lcm-gen's own zero of an array of bytes does not encode
                self.assertEqual(kind().encode(), self.theirs[name]().encode(), name)
            for _ in range(5):
                mine, their = kind(), self.theirs[name]()
                for field in kind.LCM.fields:
                    value = drawn(field, luck)
                    setattr(mine, field.name, value)
                    # lcm-gen packs arrays of bytes from bytes.
                    setattr(their, field.name, bytes(value) if field.kind == "byte" and field.shape else value)
                encoded = mine.encode()
                self.assertEqual(encoded, their.encode(), name)
                again = kind.decode(encoded)
                self.assertEqual(again, mine)
                self.assertEqual(again.encode(), encoded, name)
                for field in kind.LCM.fields:
                    self.assertEqual(plain(getattr(again, field.name)), getattr(mine, field.name), f"{name}.{field.name}")

    def test_arrays_have_their_shape(self):
        state = twinbus.robot_state_t.decode(twinbus.robot_state_t().encode())
        for message in (state, twinbus.robot_state_t()):
            self.assertEqual((len(message.q), len(message.wrench), len(message.wrench[0])), (48, 8, 6))
            if numpy is not None:
                self.assertEqual((message.q.dtype, message.qd.dtype, message.wrench.shape), (numpy.float64, numpy.float32, (8, 6)))
                self.assertTrue(message.q.dtype.isnative and message.q.flags.writeable)

    def test_hostile_bytes_are_refused(self):
        body = bytearray(twinbus.stop_t().encode())
        for bad in (b"", bytes(body[:-1]), bytes(body) + b"\0", bytes(8) + bytes(body[8:]), twinbus.gap_t().encode()):
            with self.assertRaisesRegex(ValueError, "stop_t: .*fingerprint"):
                twinbus.stop_t.decode(bad)
            self.assertIsNone(twinbus.decode("STOP", bad))
        with self.assertRaisesRegex(ValueError, "NOWHERE: no type"):
            twinbus.decode("NOWHERE", bytes(body))

    def test_a_field_that_does_not_fit_is_named(self):
        for field, value, said in (("kind", 300, "stop_t: kind = 300"), ("sequence", 1.5, "stop_t: sequence = 1.5"), ("kind", None, "kind = None")):
            with self.assertRaisesRegex(ValueError, said):
                twinbus.stop_t(**{field: value}).encode()
        for field, value in (("q", [0.0] * 47), ("q", [0.0]), ("wrench", [[0.0] * 6] * 3), ("wrench", [[0.0] * 5] * 8), ("wrench_kind", [0] * 7 + [200])):
            with self.assertRaisesRegex(ValueError, f"robot_state_t.{field}: "):
                twinbus.robot_state_t(**{field: value}).encode()
        with self.assertRaisesRegex(ValueError, "event_t.text: 201 bytes"):
            twinbus.event_t(text=bytes(201)).encode()

    def test_text_goes_in_and_out(self):
        event = twinbus.event_t.decode(twinbus.event_t(text="höher".encode()).encode())
        self.assertEqual(twinbus.text(event.text), "höher")

    def test_a_type_that_cannot_be_is_refused_with_its_line(self):
        for text, said in (("struct a_t {\n  string s;\n}", "x.lcm:2: expected one of .* not 'string'"), ("struct a_t {\n int8_t n;\n double q[n];\n}", "x.lcm:3: expected a fixed"),
                           ("struct a_t {\n  double q[48;\n}", r"x.lcm:2: expected \], not ';'"), ("struct a_t {\n int8_t a;", "x.lcm:2: .*text ends"), ("int8_t a;", "expected package or struct"),
                           ("struct a_t { int8_t a, a; }", "name of its own"), ("struct a_t { double a[99999][9]; }", "fit into a datagram"), ("struct a_t { int8_t ?; }", "no part of"),
                           ("package x;", "0 structs")):
            with self.assertRaisesRegex(ValueError, said):
                twinbus.message_type(text, "x.lcm")

    def test_a_command_answers_its_state(self):
        state = twinbus.robot_state_t(tick=7, run_id=9, term=3, model_hash=11, joint_count=2)
        command = twinbus.joint_command_t.decode(twinbus.command_for(state, 5, [0.1, 0.2], kp=(3,)).encode())
        self.assertEqual((command.tick, command.run_id, command.term, command.model_hash, command.joint_count, command.controller_id), (7, 9, 3, 11, 2, 5))
        self.assertEqual(plain(command.q)[:3], [0.1, 0.2, 0.0])
        self.assertEqual(plain(command.kp)[:2], [3.0, 0.0])
        self.assertIn("[rad or m]", twinbus.robot_state_t.__doc__)

    def test_comments_become_docstrings(self):
        self.assertEqual(lcm_types.parse(OWN)[0].about, "Of my own.")
        self.assertIn("table: int16_t[2, 3]  rows", self.ours["mixed_t"].__doc__)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
