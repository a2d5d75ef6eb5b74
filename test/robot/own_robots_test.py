#!/usr/bin/env python3
"""The files of our robots are what their scripts write, byte for byte; the shells are closed and small."""

import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

ROBOTS = pathlib.Path(__file__).resolve().parents[2] / "config" / "robots"


def triangles(path):
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0]
    assert len(data) == 84 + 50 * count, path
    for i in range(count):
        values = struct.unpack_from("<12f", data, 84 + 50 * i)
        yield values[3:6], values[6:9], values[9:12]


def open_edges(path):
    """Edges that are not run through once in each direction, shape by shape of the file."""
    edges = {}
    for corners in triangles(path):
        for k in range(3):
            edge = (corners[k], corners[(k + 1) % 3])
            edges[edge] = edges.get(edge, 0) + 1
    return sum(1 for a, b in edges if edges[(a, b)] != edges.get((b, a), 0))


def main():
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "robots"
        shutil.copytree(ROBOTS, copy, ignore=shutil.ignore_patterns("__pycache__"))
        for script in sorted(copy.glob("*/make_urdf.py")):
            robot = script.parent
            for written in [*robot.glob("*.urdf"), *robot.glob("*.srdf"), *robot.glob("meshes/*")]:
                written.unlink()
            subprocess.run([sys.executable, "-B", script], check=True, stdout=subprocess.DEVNULL)
            for here in [*robot.glob("*.*df"), *robot.glob("meshes/*")]:
                there = ROBOTS / here.relative_to(copy)
                assert there.exists() and here.read_bytes() == there.read_bytes(), f"{there}: run {robot.name}/make_urdf.py"
            for there in (ROBOTS / robot.name).glob("meshes/*"):
                assert (copy / there.relative_to(ROBOTS)).exists(), f"{there} is not written by make_urdf.py"
    meshes = sorted((ROBOTS / "hrp1s" / "meshes").glob("*.stl"))
    count = sum(1 for mesh in meshes for _ in triangles(mesh))
    size = sum(mesh.stat().st_size for mesh in meshes)
    assert 9000 <= count <= 12000 and size < 1_000_000, (count, size)
    for mesh in meshes:
        assert open_edges(mesh) == 0, f"{mesh}: {open_edges(mesh)} open edges"
    print(f"ok: hrp1s has {count} triangles in {len(meshes)} meshes, {size} bytes")


main()
