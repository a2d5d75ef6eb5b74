"""The client side of a WebSocket, as far as tests need it: text messages of any size, no extensions."""
import base64
import os
import socket
import struct


class WebSocket:
    def __init__(self, port, path, origin=None, small_buffer=False, timeout=5, host="127.0.0.1"):
        self.socket = socket.socket()
        if small_buffer:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        self.socket.settimeout(timeout)
        self.socket.connect((host, port))
        origin_line = f"Origin: {origin}\r\n" if origin else ""
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET {path} HTTP/1.1\r\nHost: {host}:{port}\r\n{origin_line}Upgrade: websocket\r\n"
                             f"Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n\r\n").encode())
        self.data = b""
        while b"\r\n\r\n" not in self.data:
            chunk = self.socket.recv(4096)
            if not chunk:
                break
            self.data += chunk
        head, _, self.data = self.data.partition(b"\r\n\r\n")
        if not head:
            raise ConnectionError("closed without an answer")
        self.status = int(head.split()[1])

    def _take(self, count):
        parts, have = [self.data], len(self.data)
        while have < count:
            chunk = self.socket.recv(65536)
            if not chunk:
                raise ConnectionError("closed")
            parts.append(chunk)
            have += len(chunk)
        whole = b"".join(parts)
        self.data = whole[count:]
        return whole[:count]

    def receive(self):
        """The next text message; ConnectionError when the other side has closed."""
        message = b""
        while True:
            first, size = self._take(2)
            if size == 126:
                size = struct.unpack(">H", self._take(2))[0]
            elif size == 127:
                size = struct.unpack(">Q", self._take(8))[0]
            payload = self._take(size)
            if first & 15 in (0, 1):
                message += payload
                if first & 0x80:
                    return message.decode()
            if first & 15 == 8:
                raise ConnectionError("closed")

    def send(self, text, opcode=1):
        data = text.encode() if isinstance(text, str) else text
        head = bytes([0x80 | opcode])
        head += (bytes([0x80 | len(data)]) if len(data) < 126 else bytes([0xFE]) + struct.pack(">H", len(data)) if len(data) < 65536
                 else bytes([0xFF]) + struct.pack(">Q", len(data)))
        mask = os.urandom(4)
        self.socket.sendall(head + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(data)))

    def close(self):
        self.socket.close()
