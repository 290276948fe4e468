#!/usr/bin/env python3
# A flight that is watched over Foxglove's WebSocket protocol, by a client of our own: the stream, and abuse.
# SPDX-License-Identifier: MIT
"""Usage: foxglove.py ROOT PROGRAMS."""

import base64
import json
import os
import pathlib
import re
import signal
import socket
import struct
import subprocess
import sys
import threading
import time

import cases

ROOT, PROGRAMS = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
PROTOCOL = "foxglove.websocket.v1"
TIMEOUT = 60

# It blinks by itself: a reading changes in every cycle.
BLINKER = """component Blinker {
  output light : { dark, bright };
  initial unlit;
  mode unlit { light = dark };
  mode lit   { light = bright };
  unlit -> lit;
  lit   -> unlit;
}
component Switch { input cmd : { none, on }; initial off; mode off; mode on; off -> on when cmd = on; }
plant Lamp {
  blinker : Blinker;
  switch  : Switch;
  control switch.cmd default none;
  observe blinker.light;
}
"""
WATCH = "Watch() :: { switch = on; t = 0; when t >= 100 h donext true }\n"
PLANT = """import json, sys
for line in sys.stdin:
    cycle = json.loads(line)["cycle"]
    light = "bright" if cycle % 2 else "dark"
    print(json.dumps({"cycle": cycle, "observations": {"blinker.light": light}}), flush=True)
"""


def same(found, expected, what=""):
    assert found == expected, f"{what}\n  found    {found}\n  expected {expected}"


class Flight:
    """`rmpl-run execute` with --foxglove, and what it says on standard error."""

    def __init__(self, folder, *words, program=None, plant=None, address="0"):
        models = [program or ROOT / "examples/mars-entry/mars_entry.rmpl", plant or ROOT / "examples/mars-entry/mars_lander.tcca"]
        self.process = subprocess.Popen([PROGRAMS / "rmpl-run", "execute", *models, "--foxglove", address, *map(str, words)], cwd=folder,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.said = []
        self.told = threading.Condition()
        self.reader = threading.Thread(target=self._read, daemon=True)
        self.reader.start()

    def _read(self):
        for line in self.process.stderr:
            with self.told:
                self.said.append(line.rstrip("\n"))
                self.told.notify_all()

    def await_said(self, pattern):
        end = time.monotonic() + TIMEOUT
        with self.told:
            while True:
                for line in self.said:
                    if found := re.search(pattern, line):
                        return found
                assert self.told.wait(end - time.monotonic()), f"nobody said {pattern}: {self.said}"

    def port(self):
        return int(self.await_said(r"at ws://127\.0\.0\.1:(\d+)")[1])

    def end(self, status=0):
        same(self.process.wait(TIMEOUT), status, self.said)
        self.reader.join(TIMEOUT)


class Client:
    """A WebSocket, from the handshake on."""

    def __init__(self, port, protocol=PROTOCOL, origin=None, room=None):
        self.socket = socket.socket()
        if room:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, room)
        self.socket.settimeout(TIMEOUT)
        self.socket.connect(("127.0.0.1", port))
        key = base64.b64encode(os.urandom(16)).decode()
        lines = ["GET / HTTP/1.1", f"Host: 127.0.0.1:{port}", "Upgrade: websocket", "Connection: Upgrade", f"Sec-WebSocket-Key: {key}",
                 "Sec-WebSocket-Version: 13"]
        lines += [f"Sec-WebSocket-Protocol: {protocol}"] if protocol else []
        lines += [f"Origin: {origin}"] if origin else []
        self.socket.sendall("\r\n".join([*lines, "", ""]).encode())
        self.file = self.socket.makefile("rb")
        self.status = int(self.file.readline().split()[1])
        self.headers = {}
        while line := self.file.readline().strip():
            name, _, value = line.decode().partition(":")
            self.headers[name.lower()] = value.strip()

    def send(self, message, opcode=1):
        data = message if isinstance(message, bytes) else json.dumps(message).encode()
        mask = os.urandom(4)
        length = bytes([0x80 | len(data)]) if len(data) < 126 else bytes([0xFE]) + struct.pack(">H", len(data)) if len(data) < 65536 else bytes([0xFF]) + struct.pack(">Q", len(data))
        self.socket.sendall(bytes([0x80 | opcode]) + length + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(data)))

    def subscribe(self, *pairs):
        self.send({"op": "subscribe", "subscriptions": [{"id": one, "channelId": channel} for one, channel in pairs]})

    def frame(self):
        """(opcode, data), pings left aside; nothing where the connection has ended."""
        while True:
            head = self.file.read(2)
            if len(head) < 2:
                return None
            length = head[1] & 0x7F
            if length == 126:
                (length,) = struct.unpack(">H", self.file.read(2))
            elif length == 127:
                (length,) = struct.unpack(">Q", self.file.read(8))
            data = self.file.read(length)
            if head[0] & 0x0F == 9:
                self.send(data, opcode=10)
            elif head[0] & 0x0F != 10:
                return head[0] & 0x0F, data

    def message(self):
        """A text as its object; a binary one as ("time", ns) or (subscription, ns, object); nothing at the end."""
        frame = self.frame()
        if frame is None or frame[0] == 8:
            return None
        opcode, data = frame
        if opcode == 1:
            return json.loads(data)
        if data[0] == 2:
            return "time", struct.unpack("<Q", data[1:])[0]
        same(data[0], 1)
        subscription, when = struct.unpack("<IQ", data[1:13])
        return subscription, when, json.loads(data[13:])

    def status_message(self):
        while True:
            message = self.message()
            assert message is not None, "the connection has ended"
            if isinstance(message, dict) and message["op"] == "status":
                return message

    def close(self):
        self.file.close()
        self.socket.close()


def records(data):
    at = 0
    while at < len(data):
        opcode, length = data[at], struct.unpack("<Q", data[at + 1 : at + 9])[0]
        yield opcode, data[at + 9 : at + 9 + length]
        at += 9 + length


def mcap_messages(path):
    """(channel, ns, object) of a file whose chunks are not compressed."""
    for opcode, data in records(path.read_bytes()[8:-8]):
        if opcode != 6:
            continue
        for inner, fields in records(data[8 + 8 + 8 + 4 + 4 + 8 :]):
            if inner == 5:
                channel, _, when = struct.unpack("<HIQ", fields[:14])
                yield channel, when, json.loads(fields[22:])


def streams_what_mcap_holds(folder):
    """From the first cycle on, all messages, in their order; then how it ended."""
    address = f"unix:{folder}/lander.sock"
    flight = Flight(folder, "--listen", address, "--clock", "lock-step", "--duration", "120 s", "--mcap", "flight.mcap", "--trace",
                    "flight.jsonl")
    client = Client(flight.port())
    same((client.status, client.headers["sec-websocket-protocol"]), (101, PROTOCOL))
    info, offer = client.message(), client.message()
    same((info["op"], info["name"], info["capabilities"], info["metadata"]["plant"]),
         ("serverInfo", "rmpl-run: EntrySequence", ["time"], "MarsLander"))
    same([(c["id"], c["topic"], c["encoding"], c["schemaEncoding"]) for c in offer["channels"]],
         [(i + 1, f"/{name}", "json", "jsonschema")
          for i, name in enumerate(("estimate", "truth", "belief", "goal", "command", "reading", "marking", "event", "channel"))])
    schema = json.loads(offer["channels"][0]["schema"])
    assert "standby" in schema["properties"]["engine"]["enum"], schema
    client.subscribe(*((100 + c["id"], c["id"]) for c in offer["channels"]))
    client.send({"op": "unsubscribe", "subscriptionIds": [7]})  # whose answer says that the others are in force
    assert "no such subscription" in client.status_message()["message"]
    late = Client(flight.port())  # one that looks on without asking for anything
    plant = subprocess.Popen([sys.executable, ROOT / "examples/live/lander.py", "--connect", address])
    found, times, last = [], [], None
    while (message := client.message()) is not None:
        last = message
        if isinstance(message, tuple) and message[0] == "time":
            times.append(message[1])
        elif isinstance(message, tuple):
            found.append((message[0] - 101, message[1], message[2]))
    flight.end()
    plant.wait(TIMEOUT)
    same((last["op"], last["level"]), ("status", 0))
    assert "the duration ended" in last["message"], last
    same(times, [500_000_000 * cycle for cycle in range(len(times))])
    assert len(times) == 241, len(times)

    def without_ends(messages):  # what goes on has no end yet
        return [(channel, when, {k: v for k, v in data.items() if k != "until"}) for channel, when, data in messages]

    expected = list(mcap_messages(folder / "flight.mcap"))
    assert len(expected) > 10, expected
    for channel in range(9):
        told = [m for m in without_ends(found) if m[0] == channel]
        if channel != 7:  # what holds at a time is what was told last of that time
            told = list({when: (channel, when, data) for _, when, data in told}.values())
        same(told, [m for m in without_ends(expected) if m[0] == channel], f"channel {channel}")
    texts = [m for m in iter(late.message, None) if isinstance(m, dict)]
    same([m["op"] for m in texts], ["serverInfo", "advertise", "status"])


def who_comes_later(folder):
    """Gets what holds, once for each subscription, and then what changes; one that goes away is no matter."""
    flight = Flight(folder, "--exec", f"exec {sys.executable} {ROOT / 'examples/live/lander.py'}", "--cycle", "0.05 s")
    port = flight.port()
    for _ in range(3):
        Client(port).close()
    time.sleep(0.5)
    client = Client(port)
    client.subscribe((1, 1), (2, 6), (3, 1))
    seen = {}
    while len(seen) < 3:
        message = client.message()
        if isinstance(message, tuple) and message[0] != "time":
            seen[message[0]] = message
    same(seen[1][1:], seen[3][1:])
    same(seen[1][2]["engine"], "heating")
    same(seen[2][2]["engine.temp"], "low")
    client.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    client.close()  # by a reset
    another = Client(port)
    another.subscribe((9, 5))
    while not (isinstance(message := another.message(), tuple) and message[0] == 9):
        pass
    assert "command" in message[2], message
    flight.process.send_signal(signal.SIGINT)
    while another.message() is not None:
        pass
    flight.end(3)


def blinking(folder, *words):
    for name, text in (("lamp.tcca", BLINKER), ("watch.rmpl", WATCH), ("plant.py", PLANT)):
        (folder / name).write_text(text, encoding="utf-8")
    return Flight(folder, "--exec", f"exec {sys.executable} plant.py", *words, program="watch.rmpl", plant="lamp.tcca")


def slow_clients(folder):
    """One that does not read holds nobody up; it is told what it missed, and gets what holds."""
    flight = blinking(folder, "--cycle", "0.005 s", "--trace", "flight.jsonl", "--trace-detail", "cycles")
    port = flight.port()
    slow, quick = Client(port, room=4096), Client(port)
    slow.subscribe(*((i, 6) for i in range(1000)))
    quick.subscribe((1, 6))
    flight.await_said("reads too slowly")
    began = time.monotonic()
    got = 0
    while got < 100:
        message = quick.message()
        assert message is not None, flight.said
        got += isinstance(message, tuple) and message[0] == 1
    assert time.monotonic() - began < 5, "the others wait"
    # It is told as soon as there is room again: a thousand subscriptions leave none.
    slow.send({"op": "unsubscribe", "subscriptionIds": list(range(1000))})
    warned = slow.status_message()
    same(warned["level"], 1)
    assert re.fullmatch(r"\d+ messages were dropped: this client reads too slowly", warned["message"]), warned
    slow.close()
    flight.process.send_signal(signal.SIGINT)
    while quick.message() is not None:
        pass
    flight.end(3)
    lines = [json.loads(line) for line in (folder / "flight.jsonl").read_text(encoding="utf-8").splitlines()]
    same(lines[-1]["cycle"], len(lines) - 1)


def abuse(folder):
    flight = blinking(folder, "--cycle", "0.02 s", "--duration", "30 s")
    port = flight.port()

    def refused(status, **how):
        client = Client(port, **how)
        same(client.status, status, how)
        client.close()

    refused(400, protocol=None)
    refused(400, protocol="foxglove.websocket.v0, chat")
    refused(403, origin="https://example.org")
    refused(403, origin="null")
    refused(403, origin="http://localhost.example.org")
    for origin in ("http://localhost:8080", "https://app.foxglove.dev", "file://"):
        refused(101, origin=origin)
    plain = socket.create_connection(("127.0.0.1", port), TIMEOUT)
    plain.sendall(b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
    text = b"".join(iter(lambda: plain.recv(4096), b""))
    assert text.startswith(b"HTTP/1.1 426") and b"Foxglove" in text, text
    for garbage in (b"\x00" * 1000, b"GET " + b"a" * 100_000, b"\r\n\r\n", b"{}\n"):
        one = socket.create_connection(("127.0.0.1", port), TIMEOUT)
        try:
            one.sendall(garbage)
            one.shutdown(socket.SHUT_WR)
            while one.recv(4096):
                pass
        except OSError:
            pass
    client = Client(port)
    for wrong, why in ((b"{", "JSON object"), (b"[]", "JSON object"), (b'{"op":1}', "JSON object"), ({"op": "advertise", "channels": []}, "only watch"),
                       ({"op": "subscribe"}, "expected `subscriptions`"), ({"op": "subscribe", "subscriptions": [1]}, "channelId"),
                       ({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 99}]}, "channelId"),
                       ({"op": "subscribe", "subscriptions": [{"id": -1, "channelId": 1}]}, "channelId"),
                       ({"op": "subscribe", "subscriptions": [{"id": 2**32, "channelId": 1}]}, "channelId"),
                       ({"op": "unsubscribe", "subscriptionIds": ["a"]}, "no such subscription"),
                       (b"[" * 60_000, "JSON object")):
        client.send(wrong)
        told = client.status_message()
        assert told["level"] == 2 and why in told["message"], (wrong, told)
    client.send(b"\x01\x00\x00\x00\x00hello", opcode=2)
    assert "JSON object" in client.status_message()["message"]
    client.subscribe((5, 6), (5, 6))
    assert "exists already" in client.status_message()["message"]
    client.send({"op": "subscribe", "subscriptions": [1] * 200})
    while client.message() is not None:  # it has gone too far
        pass
    for too_much in (b"x" * 100_000, b'{"op":"\xff"}'):  # no text at all, by the protocol of WebSockets
        other = Client(port)
        try:
            other.send(too_much)
            while other.message() is not None:
                pass
        except OSError:
            pass
    unmasked = Client(port)
    unmasked.socket.sendall(b"\x81\x02{}")
    while unmasked.message() is not None:
        pass
    many = []
    try:
        while len(many) < 40:
            many.append(Client(port))
    except (OSError, IndexError):
        pass
    assert 24 <= len(many) <= 32, f"{len(many)} are let in"
    for one in many:
        one.close()
    time.sleep(1)
    client = Client(port)
    client.subscribe((1, 6))
    while not (isinstance(message := client.message(), tuple) and message[0] == 1):
        pass
    # Whatever ends the flight, who looks on notices.
    flight.process.kill()
    try:
        while client.message() is not None:
            pass
    except OSError:
        pass
    flight.process.wait(TIMEOUT)


def addresses(folder):
    def refused(address, why, *words):
        flight = Flight(folder, "--exec", "true", "--trace", "flight.jsonl", *words, address=address)
        flight.end(2)
        assert any("--foxglove: " + address in line and why in line for line in flight.said), (address, flight.said)
        assert not list(folder.iterdir()), list(folder.iterdir())

    with socket.create_server(("127.0.0.1", 0)) as taken:
        refused(str(taken.getsockname()[1]), "Address already in use")
    refused("0.0.0.0:0", "--foxglove-remote")
    refused("x", "no port")
    refused("99999", "no port")
    refused("", "no port")
    refused("no.such.host.invalid:1", "")
    flight = Flight(folder, "--exec", "true", "--duration", "0.5 s", "--foxglove-remote", address="0.0.0.0:0")
    flight.await_said(r"at ws://0\.0\.0\.0:(\d+)")
    flight.end()
    flight = Flight(folder, "--exec", "true", "--duration", "0.5 s", address="[::1]:0")
    end = time.monotonic() + TIMEOUT
    while flight.process.poll() is None and time.monotonic() < end:
        time.sleep(0.05)
    assert flight.process.returncode == 0 or any("--foxglove" in line for line in flight.said), flight.said  # without IPv6


sys.exit(cases.run([addresses, streams_what_mcap_holds, who_comes_later, slow_clients, abuse]))
