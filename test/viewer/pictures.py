"""PNG pictures with nothing but the standard library: read, write with few colours, compare a screenshot with what it once was.

A screenshot is kept in BUILD/pictures and compared with the small picture of its name in test/viewer/pictures, in blocks: what moves
a little, or is written with another font, is no difference; what is missing or has another colour is.  TWINBUS_RENEW_PICTURES=1 writes the
small pictures anew, after somebody has looked at the large ones.
"""
import os
import pathlib
import struct
import sys
import zlib

START = os.getcwd()
REFERENCES = pathlib.Path(__file__).resolve().parent / "pictures"
ACROSS = 80          # blocks
FAR = 36             # of 255, between two blocks that differ
MOST_DIFFERENT = 0.08  # share of the blocks
MOST_MEAN = 9.0      # of 255, over all


def read_png(data):
    """Width, height and rows of RGB bytes; 8 bits per channel, not interlaced."""
    at, body = 8, b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        part = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, bits, color, _, _, interlaced = struct.unpack(">IIBBBBB", part)
            if bits != 8 or interlaced or color not in (2, 6):
                raise ValueError("not a PNG of this kind")
            step = 3 if color == 2 else 4
        elif kind == b"IDAT":
            body += part
        at += 12 + size
    raw, stride = zlib.decompress(body), width * step
    rows, last = [], bytearray(stride)
    for y in range(height):
        filtered = raw[y * (stride + 1)]
        line = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        if filtered == 1:
            for i in range(step, stride):
                line[i] = (line[i] + line[i - step]) & 255
        elif filtered == 2:
            line = bytearray((a + b) & 255 for a, b in zip(line, last))
        elif filtered == 3:
            for i in range(stride):
                line[i] = (line[i] + ((line[i - step] if i >= step else 0) + last[i]) // 2) & 255
        elif filtered == 4:
            for i in range(stride):
                a, b, c = (line[i - step] if i >= step else 0), last[i], (last[i - step] if i >= step else 0)
                p, q, r = abs(b - c), abs(a - c), abs(a + b - 2 * c)
                line[i] = (line[i] + (a if p <= q and p <= r else b if q <= r else c)) & 255
        last = line
        rows.append(bytes(line) if step == 3 else bytes(v for i, v in enumerate(line) if i % 4 != 3))
    return width, height, rows


def write_png(width, rows, palette=None):
    """Rows of RGB bytes, or of numbers of palette colours."""
    def part(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    head = struct.pack(">IIBBBBB", width, len(rows), 8, 3 if palette else 2, 0, 0, 0)
    body = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    colors = part(b"PLTE", b"".join(bytes(c) for c in palette)) if palette else b""
    return b"\x89PNG\r\n\x1a\n" + part(b"IHDR", head) + colors + part(b"IDAT", body) + part(b"IEND", b"")


def with_few_colours(data, count=200):
    """The same picture with a palette (median cut), a third as large."""
    width, _, rows = read_png(data)
    counted = {}
    for row in rows:
        for i in range(0, len(row), 3):
            key = (row[i] & 0xFC, row[i + 1] & 0xFC, row[i + 2] & 0xFC)
            counted[key] = counted.get(key, 0) + 1
    boxes = [list(counted.items())]
    while len(boxes) < count:
        def spread(box):
            return max(max(c[0][k] for c in box) - min(c[0][k] for c in box) for k in range(3)) * sum(c[1] for c in box) ** 0.3
        box = max((b for b in boxes if len(b) > 1), key=spread, default=None)
        if box is None:
            break
        axis = max(range(3), key=lambda k: max(c[0][k] for c in box) - min(c[0][k] for c in box))
        box.sort(key=lambda c: c[0][axis])
        half, seen, cut = sum(c[1] for c in box) / 2, 0, 1
        for i, (_, n) in enumerate(box[:-1]):
            seen += n
            cut = i + 1
            if seen >= half:
                break
        boxes.remove(box)
        boxes += [box[:cut], box[cut:]]
    palette, number = [], {}
    for i, box in enumerate(boxes):
        total = sum(n for _, n in box)
        palette.append(tuple(min(255, 2 + sum(c[k] * n for c, n in box) // total) for k in range(3)))
        for color, _ in box:
            number[color] = i
    few = [bytes(number[row[i] & 0xFC, row[i + 1] & 0xFC, row[i + 2] & 0xFC] for i in range(0, len(row), 3)) for row in rows]
    return write_png(width, few, palette)


def blocks(data):
    """The mean colours of square blocks, ACROSS in a row."""
    width, height, rows = read_png(data)
    edge = max(1, width // ACROSS)
    found = []
    for top in range(0, height - edge + 1, edge):
        line = []
        for left in range(0, edge * (width // edge), edge):
            sums = [0, 0, 0]
            for row in rows[top:top + edge]:
                part = row[3 * left:3 * (left + edge)]
                for k in range(3):
                    sums[k] += sum(part[k::3])
            line += [s // (edge * edge) for s in sums]
        found.append(bytes(line))
    return found


def compare(data, name, check):
    """check(ok, text) of a screenshot; it is kept beside the build that was tested."""
    kept = pathlib.Path(os.environ.get("TWINBUS_PICTURES") or pathlib.Path(START, sys.argv[1], "..", "pictures").resolve())
    kept.mkdir(parents=True, exist_ok=True)
    (kept / f"{name}.png").write_bytes(data)
    seen, reference = blocks(data), REFERENCES / f"{name}.png"
    if os.environ.get("TWINBUS_RENEW_PICTURES"):
        REFERENCES.mkdir(exist_ok=True)
        reference.write_bytes(write_png(len(seen[0]) // 3, seen))
    if not reference.is_file():
        return check(False, f"there is no {reference} yet: TWINBUS_RENEW_PICTURES=1 writes it")
    _, _, wanted = read_png(reference.read_bytes())
    if [len(row) for row in wanted] != [len(row) for row in seen]:
        return check(False, f"the picture '{name}' has the size of {reference}")
    differences = [abs(a - b) for one, other in zip(seen, wanted) for a, b in zip(one, other)]
    far = sum(max(differences[i:i + 3]) > FAR for i in range(0, len(differences), 3)) / (len(differences) / 3)
    mean = sum(differences) / len(differences)
    check(far <= MOST_DIFFERENT and mean <= MOST_MEAN,
          f"the picture '{name}' is what it was: {100 * far:.1f} % of the blocks differ, {mean:.1f} of 255 in the mean; kept in {kept}")
