#!/usr/bin/env python3
"""--listen and hundreds of slow connections without a token: a phone that has one connects and stops the robot all the same.

    slow_strangers_test.py BIN_FOLDER [CONNECTIONS]        in a private network namespace
"""
import json
import multiprocessing
import re
import selectors
import socket
import sys
import time

from process_tools import FAR, Checks, Process, binary, fake_robot_seen_from_afar
from web_socket import WebSocket

MANY = int(sys.argv[2]) if len(sys.argv) > 2 else 500
STOPS = 100
check = Checks()
bin_folder = sys.argv[1]
fake = fake_robot_seen_from_afar(bin_folder)
viewer = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open", "--listen", "0.0.0.0")
watch = re.search(r"/#token=(\w+)", viewer.wait_for("watch and stop"))[1]
port = int(re.search(r":(\d+)/#token", viewer.wait_for("ready at "))[1])



def crowd(ended, opened):
    """Keeps MANY connections, each of which says a letter of its request now and then; one that is closed comes again after a second."""
    slow = selectors.DefaultSelector()
    again = [0.0] * MANY
    while not ended.value:
        now = time.monotonic()
        while again and again[0] <= now:
            again.pop(0)
            try:
                one = socket.create_connection((FAR, port), timeout=1)
            except OSError:
                again.append(now + 1.0)
                continue
            one.setblocking(False)
            slow.register(one, selectors.EVENT_READ)
            opened.value += 1
        for key, _ in slow.select(0.05):  # closed by the server
            slow.unregister(key.fileobj)
            key.fileobj.close()
            again.append(now + 1.0)
        for key in list(slow.get_map().values()):
            try:
                key.fileobj.send(b"G")
            except OSError:
                pass


ended, opened = multiprocessing.Value("b", 0), multiprocessing.Value("i", 0)
strangers = multiprocessing.Process(target=crowd, args=(ended, opened), daemon=True)
strangers.start()
time.sleep(1.0)
took, failed = [], 0
fake.drain()
for _ in range(STOPS):
    begin = time.monotonic()
    try:
        phone = WebSocket(port, f"/ws?token={watch}", f"http://{FAR}:{port}", host=FAR)
        phone.send(json.dumps({"do": "stop", "kind": 2}))
        heard = phone.status == 101 and fake.wait_for("stop 2", 2) is not None
    except OSError:
        heard = False
    failed += not heard
    took.append(time.monotonic() - begin)
    phone.socket.close()
    time.sleep(0.02)
    fake.drain()
ended.value = 1
strangers.join(5)
took.sort()
p99 = took[int(0.99 * len(took)) - 1]
print(f"{opened.value} slow connections were opened; {STOPS} phones connected anew and stopped: median {1e3 * took[len(took) // 2]:.0f} ms, p99 {1e3 * p99:.0f} ms")
check(opened.value >= MANY, "the crowd was there")
check(failed == 0, f"every stop was heard ({failed} were not)")
check(p99 <= 0.2, f"from the connection to the stop p99 is {1e3 * p99:.0f} ms")
viewer.end()
fake.end()
check.finish()
