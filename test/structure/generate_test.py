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
  float   load[2];   // {0..1, = 0.5}
  int8_t  role;      // 0 none "nobody", 1 standby track (it follows, or not), 2 active {enum Role}
  int8_t  before;    // {Role}
  int8_t  rows;      // {count 3 kRows}
  int8_t  on;        // {flag}
  int8_t  text[4];   // {text}
}
"""


OLDER = """package twinbus;
struct ping_t {
  int64_t from;
  int32_t number;
  float   gain[48];
  int16_t count;
}
"""


def generate(text, older=None):
    """(exit code, errors, {header: text}) of generate.py for one .lcm text, and one of before."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "ping_t.lcm"
        file.write_text(text)
        files = [file]
        if older:
            files.append(file.parent / "older/ping_t.lcm")
            files[1].parent.mkdir()
            files[1].write_text(older)
        run = subprocess.run([sys.executable, ROOT / "lcmtypes/generate.py", folder, *files], capture_output=True, text=True)
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
        self.assertIn("kBytes = 230;", made["wire_table.h"])  # 8 + 8 + 4 + 2 + 192 + 8 + 4 + 4
        self.assertIn("return x.from;", made["wire_table.h"])
        self.assertIn("return x.number;", made["wire_table.h"])

    def test_the_struct_and_its_enumerations_are_made(self):
        code, errors, made = generate(GOOD)
        self.assertEqual(code, 0, errors)
        for line in ("struct Ping {", "std::array<float, 48> gain{};  // [N m/rad]", "std::array<float, 2> load{0.5f, 0.5f};", "kNone = 0,",
                     "kStandbyTrack = 1,  // it follows, or not", "kActive = 2,", "Role before{};", "bool on = false;", "std::array<char, 4> text{};",
                     "inline constexpr int kRows = 3;"):
            self.assertIn(line, made["messages.h"])
        self.assertIn('{"nobody", "standby track", "active"}', made["labels.h"])
        self.assertIn("last_of(Role) { return 2; }", made["labels.h"])

    def test_a_message_of_before_becomes_one_of_now(self):
        code, errors, made = generate(GOOD.replace("{0..1, = 0.5}", "{0..1, older 1}"), OLDER)
        self.assertEqual(code, 0, errors)
        parts = "kPartsPingT[] = {{8, 8, 12}, {212, 20, 2}, {20, 22, 192}};"  # count stood behind gain
        self.assertIn(parts, made["older_messages.h"])
        self.assertIn("0, 63, 128, 0, 0, 63, 128, 0, 0, 0, 0", made["older_messages.h"])  # load, 1.0 twice
        for older, said in ((OLDER.replace("ping", "pong"), "older/ping_t.lcm: there is no pong_t now"), (OLDER.replace("float", "double"), "ping_t: gain was double[48]")):
            code, errors, made = generate(GOOD, older)
            self.assertEqual((code, made), (1, {}))
            self.assertIn(said, errors)

    def test_a_mistake_is_named_with_its_place(self):
        for wrong, right, said in (("0..1,", "0..l,", "ping_t.lcm: load: no rule '0..l'"), ("{id, sender}", "{ids, sender}", "from: no rule 'ids'"),
                                   ("{Ping}", "", "does not end with its C++ struct in braces"), ("48]", "n]", "ping_t.lcm:7:"),
                                   ("{Role}", "{Rolle}", "before: no field says enum Rolle"), ("2 active", "3 active", "role: the comment of an enumeration"),
                                   ("(it follows, or not)", "it follows, or not", "it is not read from 'or not")):
            code, errors, made = generate(GOOD.replace(wrong, right))
            self.assertEqual(code, 1)
            self.assertIn(said, errors)
            self.assertEqual(made, {})


if __name__ == "__main__":
    unittest.main()
