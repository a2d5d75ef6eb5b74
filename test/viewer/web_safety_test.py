#!/usr/bin/env python3
"""The viewer's server against those who mean it ill: foreign pages, wrong tokens, junk, huge frames, paths; nothing acts, it stays up.

    web_safety_test.py BIN_FOLDER [REQUESTS]        in a private network namespace; default 100000 requests of junk
"""
import json
import random
import re
import socket
import struct
import sys
import time

from process_tools import Checks, Process, binary
from web_socket import WebSocket

check = Checks()
bin_folder = sys.argv[1]
junk = int(sys.argv[2]) if len(sys.argv) > 2 else 100_000
fake = Process(binary(bin_folder, "fake_robot"))
fake.wait_for("ready")
viewer = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open")
PORT, TOKEN = re.search(r":(\d+)/#token=(\w+)", viewer.wait_for("ready at ", 20)).groups()
PORT = int(PORT)
HOST = f"127.0.0.1:{PORT}"
ACTS = ("clear", "source", "mode", "walk", "goal")  # what the fake robot says when somebody acts
random.seed(8)


def connect():
    return socket.create_connection(("127.0.0.1", PORT), timeout=10)


def ask(bytes_to_send, seconds=3.0):
    """All that comes back, until the server closes or is silent."""
    with connect() as s:
        s.settimeout(seconds)
        data = b""
        try:
            s.sendall(bytes_to_send)
            while chunk := s.recv(65536):
                data += chunk
        except OSError:
            pass
        return data


def status(target="/", host=HOST, extra=""):
    answer = ask(f"GET {target} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n{extra}\r\n".encode("latin-1"))
    return int(answer.split()[1]) if answer.startswith(b"HTTP/") else 0


def memory():
    return int(re.search(r"VmRSS:\s+(\d+)", open(f"/proc/{viewer.child.pid}/status").read())[1]) / 1024.0


def handshake(origin, token=""):
    try:
        page = WebSocket(PORT, "/ws" + (f"?token={token}" if token else ""), origin)
    except (OSError, IndexError, ValueError):
        return 0
    page.close()
    return page.status


# --- pages from elsewhere ---
for origin in ("http://evil.example", "https://127.0.0.1.evil.example", f"http://evil.example:{PORT}", f"https://{HOST}", "null",
               f"http://127.0.0.1:{PORT + 1}", f"http://user@{HOST}.evil.example", f"http://{HOST}/"):
    check(handshake(origin, TOKEN) != 101, f"a page of {origin} is refused, even with the token")
for host in ("evil.example", f"evil.example:{PORT}", "127.0.0.1", f"127.0.0.1:{PORT}.evil.example:{PORT}", ""):
    check(status("/", host) in (0, 400, 403), f"host '{host}' is refused (a name that was bound anew)")

# --- tokens ---
requests = [{"do": "clear"}, {"do": "switch", "run": 1002}, {"do": "mode", "mode": "walk"}, {"do": "walk", "vx": 0.3, "vy": 0, "wz": 0},
            {"do": "reach", "side": "left", "at": [0.4, 0.2, 1.0]}, {"do": "cancel"}]
fake.drain()
for token in ("", "0" * 32, TOKEN[:-1], TOKEN + "0", TOKEN.upper() if TOKEN.upper() != TOKEN else "x", TOKEN[::-1], "%00" + TOKEN):
    page = WebSocket(PORT, f"/ws?token={token}", f"http://{HOST}")
    for request in requests:
        page.send(json.dumps(request))
    time.sleep(0.05)
    page.close()
time.sleep(0.5)
acted = [line for line in fake.drain() if line.startswith(ACTS)]
check(not acted, f"with a wrong token nothing acts {acted[:3]}")

# --- paths ---
secrets = ("/../../../../etc/passwd", "/robot/../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%2f..%2fetc/passwd", "//etc/passwd",
           "/robot//etc/passwd", "/.git/config", "/robot/..%5c..%5cetc/passwd", "/%00/etc/passwd", "/index.html%00.txt", "/robot/%2e%2e%2fx.urdf",
           "/" + "a" * 5000, "/robot/meshes/../../../../../../etc/hostname", "http://evil.example/", "*", "/%", "/%zz", "\xff")
answers = [ask(f"GET {path} HTTP/1.1\r\nHost: {HOST}\r\nConnection: close\r\n\r\n".encode("latin-1")) for path in secrets]
leaked = [path for path, answer in zip(secrets, answers) if b"root:" in answer or b" 200 " in answer.split(b"\r\n")[0]]
check(not leaked, f"{len(secrets)} paths lead nowhere {leaked}")

# --- huge frames ---
def is_ended(*parts, seconds=10.0):
    """Whether the server ends a connection on which this is said.  What is sent may wait in the system's buffers, so its end is read;
    one that is only silent is not ended."""
    page = WebSocket(PORT, f"/ws?token={TOKEN}", f"http://{HOST}")
    try:
        for part in parts:
            page.socket.sendall(part)
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            page.receive()
        return False
    except TimeoutError:
        return False
    except OSError:
        return True
    finally:
        page.close()


fake.drain()
for name, head in (("2^63 - 1 bytes", bytes([0x81, 0xFF]) + struct.pack(">Q", 2**63 - 1)), ("2^64 - 1 bytes", bytes([0x81, 0xFF]) + struct.pack(">Q", 2**64 - 1)),
                   ("4 GB", bytes([0x82, 0xFF]) + struct.pack(">Q", 2**32)), ("a ping of 64 kB", bytes([0x89, 0xFE]) + struct.pack(">H", 65535)),
                   ("no mask", b"\x81\x05hello"), ("reserved bits", b"\xf1\x80\0\0\0\0"), ("an unknown kind", b"\x83\x80\0\0\0\0")):
    check(is_ended(head + b"\0\0\0\0" + b"x" * 10000), f"a frame of {name} ends that connection")
piece = struct.pack(">H", 1000) + b"\0" * 1004
check(is_ended(bytes([0x01, 0xFE]) + piece, *[bytes([0x00, 0xFE]) + piece] * 2000), "a message in pieces without end is ended")
check(not is_ended(bytes([0x01, 0xFE]) + piece, bytes([0x00, 0xFE]) + piece, seconds=2.0), "one that may still end is waited for")
check(ask(b"GET / HTTP/1.1\r\nHost: " + HOST.encode() + b"\r\nX: " + b"a" * 20_000 + b"\r\n\r\n")[9:12] in (b"413", b"400", b"431", b""), "headers of 20 kB are refused")
check(b" 200 " not in ask(b"POST / HTTP/1.1\r\nHost: " + HOST.encode() + b"\r\nContent-Length: 99999999999\r\n\r\n" + b"x" * 5000).split(b"\r\n")[0],
      "a body of 100 GB is refused")

# --- junk ---
first, begin, bad, answered = memory(), time.monotonic(), 0, 0
kinds = (lambda: random.randbytes(random.randrange(1, 400)),
         lambda: b"GET /" + random.randbytes(20).hex().encode() + b" HTTP/1.1\r\nHost: " + HOST.encode() + b"\r\n\r\n",
         lambda: b"GET /%2e%2e/x HTTP/1.1\r\nHost: " + HOST.encode() + b"\r\n\r\n",
         lambda: b"BREW /ws HTTP/9.9\r\nHost: " + HOST.encode() + b"\r\n\r\n",
         lambda: b"GET /ws?token=" + TOKEN[:-1].encode() + b" HTTP/1.1\r\nHost: evil\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\r\n",
         lambda: b'{"do":"walk","vx":1}\r\n\r\n')
sent = told = 0
while sent < junk:
    try:
        with connect() as s:
            # Well-formed ones go on one connection, up to twenty of them; the others end theirs.
            for _ in range(20):
                request = random.choice(kinds)()
                s.sendall(request)
                sent += 1
                if not request.startswith(b"GET"):
                    break
                data = s.recv(65536)
                answered += bool(data)
                bad += data.startswith(b"HTTP/1.1 200")
                if not data or b"close" in data.lower():
                    break
    except OSError:
        pass
    if sent >= told + 20_000:
        told = sent
        print(f"        {sent} of {junk} requests, {memory():.0f} MB", flush=True)
took = time.monotonic() - begin
check(bad == 0, f"{junk} requests of junk in {took:.0f} s, {answered} answered, none with 200")
check(memory() < first + 20.0, f"memory: {first:.1f} MB before, {memory():.1f} MB after")
acted = [line for line in fake.drain() if line.startswith(ACTS)]
check(not acted, f"nothing acted {acted[:3]}")

# --- and it still does what it is for ---
check(viewer.child.poll() is None and status("/") == 200, "the server is up")
page = WebSocket(PORT, f"/ws?token={TOKEN}", f"http://{HOST}")
page.send(json.dumps({"do": "mode", "mode": "squat"}))
check(fake.wait_for("mode 42 ", 5) is not None, "with the token it acts")
page.send(json.dumps({"do": "stop", "kind": 1}))
check(fake.wait_for("stop 1", 5) is not None, "and stops")
page.close()
stranger = WebSocket(PORT, "/ws", f"http://{HOST}")
stranger.send(json.dumps({"do": "stop", "kind": 2}))
check(fake.wait_for("stop 2", 5) is not None, "without one too")
stranger.close()
code = viewer.end()
check(code == 0, f"it ends cleanly ({code}) {viewer.drain()[-2:]}")
fake.end()
check.finish()
