#!/usr/bin/env python3
"""log mcap: what it writes is read back by the reference library, message for message; log plot draws.

    mcap_test.py BIN_FOLDER         exit 77 without the package mcap (pip install mcap)
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

from process_tools import Checks, binary

check = Checks()
twinbus = binary(sys.argv[1], "twinbus")
folder = pathlib.Path(tempfile.mkdtemp())
log, out = folder / "run.log", folder / "run.mcap"
subprocess.run([twinbus, "run", "sway", "--for", "3", "--log", log], stdout=subprocess.DEVNULL, check=False)
done = subprocess.run([twinbus, "log", "mcap", log, out], capture_output=True, text=True)
check(done.returncode == 0, "log mcap: " + done.stdout.strip() + done.stderr.strip())
svg = folder / "plot.svg"
done = subprocess.run([twinbus, "log", "plot", log, "STATE.q.LLEG_KNEE,COMMAND.q.LLEG_KNEE", "STATE.wrench[0]", "--out", svg],
                      capture_output=True, text=True)
check(done.returncode == 0 and svg.read_text().count("<polyline") == 8, "log plot: " + done.stdout.strip() + done.stderr.strip())
for wrong in (["STATE.qq"], ["STATES.q"], ["STATE.q.NO_SUCH"], ["q"]):
    done = subprocess.run([twinbus, "log", "plot", log, *wrong, "--out", svg], capture_output=True, text=True)
    check(done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr.strip())

# Bytes by hand, so that without the package something is said too.
data = out.read_bytes()
check(data[:8] == data[-8:] == b"\x89MCAP0\r\n", "it begins and ends as MCAP does")
summary = struct.unpack_from("<QQI", data, len(data) - 8 - 20)[0]
check(data[summary] == 3, "and the summary begins with a schema")
HEAD = struct.Struct(">IqqII")
raw, at = log.read_bytes(), 0
states = []
while at + HEAD.size <= len(raw):
    _, _, utime, name, size = HEAD.unpack_from(raw, at)
    if raw[at + 28:at + 28 + name] == b"STATE":
        body = at + 28 + name
        states.append((1000 * utime, struct.unpack_from(">q", raw, body + 8)[0], struct.unpack_from(">29d", raw, body + 109)))
    at += HEAD.size + name + size
try:
    from mcap.reader import make_reader
except ImportError:
    print("no package mcap: read by hand only")
    check.finish()
with open(out, "rb") as file:
    reader = make_reader(file, validate_crcs=True)
    summary = reader.get_summary()
    names = {c.topic for c in summary.channels.values()}
    check({"STATE", "COMMAND", "TRUTH", "CONTROLLER_STATUS"} <= names, f"channels: {sorted(names)}")
    schema = json.loads(next(s.data for s in summary.schemas.values() if s.name == "robot_state_t"))
    check(schema["properties"]["q"] == {"type": "array", "items": {"type": "number"}} and "wrench_0" in schema["properties"], "STATE has a JSON schema")
    flat = all(p["type"] in ("integer", "number", "string") or p["items"]["type"] in ("integer", "number")
               for s in summary.schemas.values() if not s.name.startswith("foxglove.") for p in json.loads(s.data)["properties"].values())
    check(flat, "and no schema has arrays of arrays, which Foxglove does not take")
    read = [(m.log_time, json.loads(m.data)) for _, _, m in reader.iter_messages(topics=["STATE"])]
    same = len(read) == len(states) and all(
        t == time and j["tick"] == tick and tuple(j["q"]) == q for (t, j), (time, tick, q) in zip(read, states))
    check(same, f"all {len(read)} states have the numbers of the log, to the last bit")
    middle = states[len(states) // 2][0]
    part = [m.log_time for _, _, m in reader.iter_messages(topics=["STATE"], start_time=middle, end_time=middle + 100_000_000)]
    check(len(part) == 50 and part[0] == middle, "a part is found by the index")
    indexes = summary.chunk_indexes
    check(indexes and all(i.compression == "zstd" for i in indexes) and sum(i.compressed_size for i in indexes) * 3 < sum(i.uncompressed_size for i in indexes),
          f"zstd: {sum(i.uncompressed_size for i in indexes)} bytes are {sum(i.compressed_size for i in indexes)}")
    frames = [json.loads(m.data) for _, _, m in reader.iter_messages(topics=["/tf"])]
    check(120 <= len(frames) <= 160, f"50 times a second where every link is: {len(frames)}")
    links = {t["child_frame_id"]: t for t in frames[-1]["transforms"]}
    check("WAIST" in links and len(links) == 30 and all(t["parent_frame_id"] == "world" for t in links.values()), f"{len(links)} frames")
    ground = min(t["translation"]["z"] for t in links.values())
    check(0.02 < ground < 0.2 and 0.5 < links["WAIST"]["translation"]["z"] < 1.2, f"it stands: lowest link at {ground} m")
    names = {s.name for s in summary.schemas.values()}
    check({"foxglove.FrameTransforms", "foxglove.SceneUpdate"} <= names, "schemas that Foxglove knows by name")
    scene = [json.loads(m.data) for _, _, m in reader.iter_messages(topics=["/scene"])]
    drawn = {e["id"]: e for e in scene[0]["entities"]}
    check(set(drawn) == set(links) and all(e["frame_locked"] and e["frame_id"] == e["id"] for e in drawn.values()), "shapes of every link, fixed to its frame")
    check(sum(len(e[kind]) for e in drawn.values() for kind in ("cubes", "spheres", "cylinders", "triangles")) > 20, "and there are shapes")
    pushed = [e for update in scene[1:] for e in update["entities"] if e["id"] == "forces" and e["arrows"]]
    check(len(pushed) > 50, f"contact forces are arrows: {len(pushed)}")
    texts = [json.loads(m.data)["text"] for _, _, m in reader.iter_messages(topics=["EVENT"])]
    check(all(isinstance(text, str) for text in texts), f"text is text: {texts[:1]}")
subprocess.run(["rm", "-rf", folder], check=False)
check.finish()
