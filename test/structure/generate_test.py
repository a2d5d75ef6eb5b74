#!/usr/bin/env python3
"""lcmtypes/generate.py: the code of a message follows its rules, and a rule that says nothing is refused with file and field."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
GOOD = """package twinbus;
// Of the test. {Ping}
struct ping_t {
  int64_t from;      // {id, sender}
  int32_t number;    // counts up {counter, sequence}
  int16_t count;     // {joints}
  float   gain[48];  // [N m/rad] {per joint, 0..}
  float   load[2];   // {0..1}
}
"""


def generate(text):
    """(exit code, errors, {header: text}) of generate.py for one .lcm text."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "ping_t.lcm"
        file.write_text(text)
        run = subprocess.run([sys.executable, ROOT / "lcmtypes/generate.py", folder, file], capture_output=True, text=True)
        made = {path.name: path.read_text() for path in pathlib.Path(folder).rglob("*.h")}
    return run.returncode, run.stderr, made


class Generate(unittest.TestCase):
    def test_a_field_is_judged_by_its_rule(self):
        code, errors, made = generate(GOOD)
        self.assertEqual(code, 0, errors)
        fields = made["message_fields.h"]
        for line in ("c.id(m.from, s.from);", "c.counter(m.number, s.number);", "c.joint_count(m.count, s.count);",
                     "c.per_joint(m.gain, s.gain, s.count);", "c.judge(s.gain, 0.0f,", "c.within(m.load, s.load, 0.0f, 1.0f);"):
            self.assertIn(line, fields)
        self.assertIn("kBytes = 222;", made["wire_table.h"])  # 8 + 8 + 4 + 2 + 192 + 8
        self.assertIn("return x.from;", made["wire_table.h"])
        self.assertIn("return x.number;", made["wire_table.h"])

    def test_a_mistake_is_named_with_its_place(self):
        for wrong, right, said in (("{0..1}", "{0..l}", "ping_t.lcm: load: no rule '0..l'"), ("{id, sender}", "{ids, sender}", "from: no rule 'ids'"),
                                   ("{Ping}", "", "does not end with its C++ struct in braces"), ("48]", "n]", "ping_t.lcm:7:")):
            code, errors, made = generate(GOOD.replace(wrong, right))
            self.assertEqual(code, 1)
            self.assertIn(said, errors)
            self.assertEqual(made, {})


if __name__ == "__main__":
    unittest.main()
