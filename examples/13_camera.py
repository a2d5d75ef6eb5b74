#!/usr/bin/env python3
"""13 Camera: shows pictures as those of the robot's camera: files one after the other, or a test picture; the viewer draws them (key E).

    13_camera.py [--rate HZ] [--for S] [FILE.jpg or .png ...]
"""
import argparse
import itertools
import random
import struct
import time
import zlib
from collections.abc import Iterator

import twinbus

PIECE = 1300  # bytes of a picture in a message


def test_picture(number: int, width: int = 160, height: int = 120) -> bytes:
    """A PNG with a bar that wanders."""
    bar = number * 4 % width
    row = b''.join(b'\xff\xb0\x20' if abs(x - bar) < 6 else bytes((x, 90, 160 - x // 2)) for x in range(width))

    def part(kind: bytes, body: bytes) -> bytes:
        return struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body))
    return (b'\x89PNG\r\n\x1a\n' + part(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0))
            + part(b'IDAT', zlib.compress((b'\0' + row) * height)) + part(b'IEND', b''))


def pieces_of(picture: bytes, sender: int) -> Iterator[twinbus.model_text_t]:
    message = twinbus.model_text_t()
    message.utime, message.run_id, message.kind = time.time_ns() // 1000, sender, 8
    message.size, message.pieces = len(picture), -(-len(picture) // PIECE)
    for message.piece in range(message.pieces):
        part = picture[message.piece * PIECE:(message.piece + 1) * PIECE]
        message.count = len(part)
        message.text = part  # type: ignore[assignment]  # bytes are taken too
        yield message


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--rate', type=float, default=10.0)
    parser.add_argument('--for', type=float, default=float('inf'), dest='duration')
    parser.add_argument('files', nargs='*')
    arguments = parser.parse_args()
    bus, sender = twinbus.Bus(), random.randrange(1, 1 << 53)
    files = [open(name, 'rb').read() for name in arguments.files]
    pictures = itertools.cycle(files) if files else map(test_picture, itertools.count())
    end = time.monotonic() + arguments.duration
    while time.monotonic() < end:
        for message in pieces_of(next(pictures), sender):
            bus.send('CAMERA', message)
        time.sleep(1.0 / arguments.rate)


if __name__ == '__main__':
    main()
