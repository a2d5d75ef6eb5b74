"""Closed surfaces of triangles in place of boxes, balls and rods: what a viewer shows of a robot.

Rounded and a little bulged, so that links look like covered mechanisms.  Numbers are rounded to a micrometre before they
are written, so that every machine writes the same bytes.
"""
import math
import struct


def closed_rings(rings, low, high):
    """Triangles between rings of points from low to high (points at both ends)."""
    n = len(rings[0])
    out = []
    for k in range(n):
        out.append((low, rings[0][(k + 1) % n], rings[0][k]))
        out.append((high, rings[-1][k], rings[-1][(k + 1) % n]))
    for a, b in zip(rings, rings[1:]):
        for k in range(n):
            m = (k + 1) % n
            out.append((a[k], a[m], b[m]))
            out.append((a[k], b[m], b[k]))
    return out


def turned(profile, segments, low, high):
    """A surface of revolution about z: profile is (radius, z) from below; low, high: z of its ends."""
    rings = [[(r * math.cos(2 * math.pi * k / segments), r * math.sin(2 * math.pi * k / segments), z)
              for k in range(segments)] for r, z in profile]
    return closed_rings(rings, (0.0, 0.0, low), (0.0, 0.0, high))


def ball(radius, segments=12, rings=6):
    profile = []
    for i in range(1, rings + 1):
        angle = math.pi * i / (rings + 1)
        profile.append((radius * math.sin(angle), -radius * math.cos(angle)))
    return turned(profile, segments, -radius, radius)


def rod(radius, length, segments=14):
    """Rounded at its rims; a long one is slimmer towards its ends."""
    edge = min(0.3 * radius, 0.3 * length)
    slim = 0.10 if length > 1.5 * radius else 0.0
    half = 0.5 * length
    profile = [(radius * (1 - slim) - edge, -half), (radius * (1 - slim) - 0.3 * edge, -half + 0.3 * edge)]
    for i in range(3):
        t = i / 2
        profile.append((radius * (1 - slim * (2 * t - 1) ** 2), (-half + edge) * (1 - t) + (half - edge) * t))
    profile += [(r, -z) for r, z in reversed(profile[:2])]
    return turned(profile, segments, -half, half)


def box(x, y, z, segments=12):
    """A column of rounded rectangles, smaller at both ends: all edges are rounded."""
    edge = 0.22 * min(x, y, z)

    def outline(shrink):
        r = max(edge - shrink, 0.2 * edge)
        points = []
        for corner in range(4):
            sx, sy = ((1, 1), (-1, 1), (-1, -1), (1, -1))[corner]
            for i in range(segments // 4):
                angle = math.pi / 2 * (corner + i / (segments // 4 - 1))
                points.append((sx * (0.5 * x - shrink - r) + r * math.cos(angle),
                               sy * (0.5 * y - shrink - r) + r * math.sin(angle)))
        return points
    rings = []
    for shrink, height in ((0.9, 0.0), (0.35, 0.12), (0.0, 0.6), (0.0, 1.0)):
        rings.append([(px, py, -0.5 * z + edge * height) for px, py in outline(edge * shrink)])
    rings += [[(px, py, -pz) for px, py, pz in ring] for ring in reversed(rings)]
    return closed_rings(rings, (0.0, 0.0, -0.5 * z), (0.0, 0.0, 0.5 * z))


def placed(triangles, at, axis="z"):
    """Moved to `at`; the z axis of the shape becomes the named one."""
    turn = {"z": lambda p: p, "x": lambda p: (p[2], p[1], -p[0]), "y": lambda p: (p[0], -p[2], p[1])}[axis]

    def move(p):
        q = turn(p)
        return tuple(round(q[i] + at[i], 6) for i in range(3))
    return [tuple(move(p) for p in triangle) for triangle in triangles]


def of_shape(shape):
    """Triangles of a shape of robot_writer, in the link's frame."""
    kind, size, at = shape[:3]
    if kind == "box":
        return placed(box(*size), at)
    if kind == "sphere":
        return placed(ball(size[0]), at)
    return placed(rod(size[0], size[1]), at, size[2])


def write_stl(path, triangles):
    with open(path, "wb") as stl:
        stl.write(b"twinbus link shell".ljust(80, b" ") + struct.pack("<I", len(triangles)))
        for a, b, c in triangles:
            u = [b[i] - a[i] for i in range(3)]
            v = [c[i] - a[i] for i in range(3)]
            n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            length = math.sqrt(sum(x * x for x in n)) or 1.0
            normal = [round(x / length, 4) + 0.0 for x in n]
            stl.write(struct.pack("<12fH", *normal, *a, *b, *c, 0))
