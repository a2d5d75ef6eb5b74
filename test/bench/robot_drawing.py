"""A robot whose links are boxes, cylinders and balls, drawn as SVG outlines from its URDF, its joint angles and its base.

Matrices are rows of rows, (rotation, origin) is a pose.  Each shape is the outline of its corners as the camera sees them; what is
nearer to the camera is drawn later.
"""

import math

ROUND = [2.0 * math.pi * k / 24 for k in range(24)]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def moved(pose, point):
    turn, origin = pose
    return [origin[i] + sum(turn[i][k] * point[k] for k in range(3)) for i in range(3)]


def chained(a, b):
    return product(a[0], b[0]), moved(a, b[1])


def about(axis, angle):
    x, y, z = axis
    c, s = math.cos(angle), math.sin(angle)
    return [[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
            [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
            [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]]


def of_quaternion(w, x, y, z):
    angle = 2.0 * math.atan2(math.hypot(x, y, z), w)
    length = math.hypot(x, y, z) or 1.0
    return about((x / length, y / length, z / length), angle)


def numbers(element, name, default="0 0 0"):
    text = element.get(name, default) if element is not None else default
    return [float(word) for word in text.split()]


def origin_of(element):
    origin = element.find("origin")
    roll, pitch, yaw = numbers(origin, "rpy")
    turn = product(about((0, 0, 1), yaw), product(about((0, 1, 0), pitch), about((1, 0, 0), roll)))
    return turn, numbers(origin, "xyz")


def link_poses(urdf, angles, base):
    """{link: pose in the world}; joints that are not in angles are at zero."""
    joints = list(urdf.iter("joint"))
    children = {joint.find("child").get("link") for joint in joints}
    poses = {link.get("name"): base for link in urdf.findall("link") if link.get("name") not in children}
    waiting = [joint for joint in joints if joint.find("child") is not None]
    while waiting:
        joint = next(one for one in waiting if one.find("parent").get("link") in poses)
        waiting.remove(joint)
        pose = chained(poses[joint.find("parent").get("link")], origin_of(joint))
        if joint.get("type") in ("revolute", "continuous"):
            axis = numbers(joint.find("axis"), "xyz", "1 0 0")
            pose = chained(pose, (about(axis, angles.get(joint.get("name"), 0.0)), [0.0, 0.0, 0.0]))
        poses[joint.find("child").get("link")] = pose
    return poses


def corners(geometry):
    shape = geometry[0]
    if shape.tag == "box":
        x, y, z = (0.5 * side for side in numbers(shape, "size"))
        return [[i * x, j * y, k * z] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
    radius = float(shape.get("radius"))
    if shape.tag == "cylinder":
        half = 0.5 * float(shape.get("length"))
        return [[radius * math.cos(a), radius * math.sin(a), z] for a in ROUND for z in (-half, half)]
    return [[radius * math.cos(a) * math.cos(b), radius * math.sin(a) * math.cos(b), radius * math.sin(b)]
            for a in ROUND for b in ROUND[:13:2] + [-b for b in ROUND[2:7:2]]]


def outline(points):
    """Corners of the convex hull, in order."""
    points = sorted(set(points))

    def half(way):
        chain = []
        for p in way:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (p[1] - chain[-2][1])
                                      - (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-2][0])) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]
    return half(points) + half(reversed(points))


class Camera:
    """Far away, looking at the robot from its right front: azimuth from x, height above the ground [rad]."""

    def __init__(self, azimuth=math.radians(-50.0), height=math.radians(10.0)):
        self.toward = [math.cos(azimuth) * math.cos(height), math.sin(azimuth) * math.cos(height), math.sin(height)]
        self.right = [-math.sin(azimuth), math.cos(azimuth), 0.0]
        self.up = [-math.cos(azimuth) * math.sin(height), -math.sin(azimuth) * math.sin(height), math.cos(height)]

    def seen(self, point):
        """(to the right, upwards) [m]."""
        return tuple(sum(a * p for a, p in zip(axis, point)) for axis in (self.right, self.up))

    def depth(self, point):
        return -sum(a * p for a, p in zip(self.toward, point))


def outlines(urdf, angles, base, camera):
    """[(fill, [(right, up)])], the farthest first."""
    colors = {material.get("name"): numbers(material.find("color"), "rgba") for material in urdf.findall("material")}
    poses, found = link_poses(urdf, angles, base), []
    for link in urdf.findall("link"):
        for visual in link.findall("visual"):
            pose = chained(poses[link.get("name")], origin_of(visual))
            material = visual.find("material")
            rgb = colors.get(material.get("name") if material is not None else "", [0.8, 0.8, 0.8])
            points = [moved(pose, corner) for corner in corners(visual.find("geometry"))]
            fill = "#" + "".join(f"{round(255 * part):02x}" for part in rgb[:3])
            found.append((camera.depth(pose[1]), fill, outline([camera.seen(point) for point in points])))
    return [(fill, shape) for _, fill, shape in sorted(found, key=lambda one: -one[0])]
