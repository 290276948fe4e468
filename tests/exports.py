#!/usr/bin/env python3
# What other tools read of a flight: the dump by GTKWave's reader, the table by Python's, MCAP by its own library, and each
# against the trace.
# SPDX-License-Identifier: MIT
"""Usage: exports.py ROOT PROGRAMS

What is not installed (vcd2fst of gtkwave, the npm package @mcap/core below build/node_modules) is left out, visibly.
"""

import csv
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

SCENARIO = "primary latch misfires, the backup answers"
READ_MCAP = """
const {McapIndexedReader} = require('@mcap/core'); const fs = require('fs');
const bytes = fs.readFileSync(process.argv[1]);
const readable = {size: async () => BigInt(bytes.length), read: async (at, n) => new Uint8Array(bytes.subarray(Number(at), Number(at + n)))};
(async () => {
  const reader = await McapIndexedReader.Initialize({readable});
  const topics = new Map([...reader.channelsById.values()].map(c => [c.id, c.topic]));
  for await (const m of reader.readMessages()) {
    console.log(JSON.stringify([topics.get(m.channelId), Number(m.logTime), JSON.parse(Buffer.from(m.data).toString())]));
  }
})();
"""


def run(command: list, **more) -> str:
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=60, **more)
    assert done.returncode == 0, (command, done.stdout[-500:], done.stderr[-500:])
    return done.stdout


def changes_of(trace: list[dict], key: str) -> list[tuple[int, dict]]:
    """The times in nanoseconds at which a key's value changes, and what it is then."""
    result: list[tuple[int, dict]] = []
    for line in trace:
        if not result or result[-1][1] != line[key]:
            result.append((round(line["time"] * 1e9), line[key]))
    return result


def read_vcd(text: str) -> dict[str, list[tuple[int, str]]]:
    """Changes of strings by full name."""
    names, scopes, changes, now = {}, [], {}, 0
    for line in text.splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] == "$scope":
            scopes.append(words[2])
        elif words[0] == "$upscope":
            scopes.pop()
        elif words[0] == "$var":
            names.setdefault(words[3], ".".join([*scopes, words[4]]))
        elif line[0] == "#":
            now = int(line[1:])
        elif line[0] == "s":
            value, code = words[0][1:], words[1]
            history = changes.setdefault(names[code], [])
            if history and history[-1][0] == now:
                history.pop()
            history.append((now, value))
    assert not scopes
    return changes


def check_vcd(text: str, trace: list[dict]) -> None:
    changes = read_vcd(text)
    estimates = {name.split(".")[-2]: history for name, history in changes.items() if name.endswith(".estimate")}
    for component in trace[0]["estimate"]:
        wanted: list[tuple[int, str]] = []
        for time, modes in changes_of(trace, "estimate"):
            if not wanted or wanted[-1][1] != modes[component]:
                wanted.append((time, modes[component]))
        assert estimates[component] == wanted, (component, estimates[component], wanted)


def check_csv(path: pathlib.Path, trace: list[dict]) -> None:
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["time"]) for row in rows] == sorted(float(row["time"]) for row in rows)
    state: dict[str, str] = {}
    found: list[tuple[int, dict]] = []
    for row in rows:
        if row["kind"] != "estimate":
            continue
        state[row["name"]] = row["value"]
        time = round(float(row["time"]) * 1e9)
        if found and found[-1][0] == time:
            found.pop()
        found.append((time, dict(state)))
    assert found == changes_of(trace, "estimate"), found
    assert {row["value"] for row in rows if row["kind"] == "verdict"} == {"met"}


def records(data: bytes):
    """Opcode, content and offset of each record of MCAP."""
    at = 0
    while at < len(data):
        opcode, length = struct.unpack_from("<BQ", data, at)
        yield opcode, data[at + 9:at + 9 + length], at
        at += 9 + length
    assert at == len(data)


def check_mcap(data: bytes, trace: list[dict]) -> list:
    """The structure, by the specification; what comes back are the messages: topic, time, content."""
    magic = b"\x89MCAP0\r\n"
    assert data.startswith(magic) and data.endswith(magic)
    body = data[8:-8]
    topics, schemas, messages, counted, metadata = {}, {}, [], None, b""
    for opcode, content, at in records(body):
        if opcode == 0x06:  # a chunk
            size, = struct.unpack_from("<Q", content, 16)
            inside = content[8 * 3 + 4 + 4 + 8:]
            assert len(inside) == size
            for inner, part, _ in records(inside):
                if inner == 0x03:
                    number, length = struct.unpack_from("<HI", part)
                    name, rest = part[6:6 + length].decode(), part[6 + length:]
                    length, = struct.unpack_from("<I", rest)
                    assert rest[4:4 + length] == b"jsonschema"
                    schemas[name] = json.loads(rest[4 + length + 4:])
                elif inner == 0x04:
                    channel, _, length = struct.unpack_from("<HHI", part)
                    topics[channel] = part[8:8 + length].decode()
                elif inner == 0x05:
                    channel, _, time, _ = struct.unpack_from("<HIQQ", part)
                    messages.append([topics[channel], time, json.loads(part[22:])])
        elif opcode == 0x0b:
            counted, = struct.unpack_from("<Q", content)
        elif opcode == 0x0c:
            metadata = content
        elif opcode == 0x02:
            summary, = struct.unpack_from("<Q", content)
            assert data[summary] == 0x03, "the summary begins with a schema"
    assert counted == len(messages)
    assert b"rmpl.flight" in metadata and b"verdict" in metadata, metadata
    for topic, _, message in messages:  # every field is declared, and every value is one of its
        fields = schemas["rmpl." + topic[1:]]["properties"]
        for key, value in message.items():
            assert key in fields and value in fields[key].get("enum", [value]), (topic, key, value, fields)
    assert [(m[1], m[2]) for m in messages if m[0] == "/estimate"] == changes_of(trace, "estimate")
    return messages


def main() -> int:
    root, programs = map(pathlib.Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        files = {kind: folder / f"flight.{kind}" for kind in ("vcd", "csv", "mcap", "html")}
        trace_file = folder / "trace.jsonl"
        options = [part for kind, path in files.items() for part in ("--report" if kind == "html" else f"--{kind}", path)]
        command = [programs / "rmpl-run", "scenario", "-q", root / "examples/mars-entry/mars_entry.scn", "--only", SCENARIO]
        run([*command, *options, "--trace", trace_file, "--trace-detail", "cycles"])
        first = {kind: path.read_bytes() for kind, path in files.items()}
        run([*command, *options])
        for kind, path in files.items():
            assert path.read_bytes() == first[kind], f"{kind}: another run has other bytes"
        trace = [json.loads(line) for line in trace_file.read_text().splitlines()]
        check_vcd(first["vcd"].decode(), trace)
        check_csv(files["csv"], trace)
        messages = check_mcap(first["mcap"], trace)
        if shutil.which("vcd2fst") and shutil.which("fst2vcd"):
            run(["vcd2fst", files["vcd"], folder / "flight.fst"])
            check_vcd(run(["fst2vcd", folder / "flight.fst"]), trace)
        else:
            print("left out: GTKWave's reader is not there; the package gtkwave has it")
        modules = root / "build/node_modules"
        if (modules / "@mcap/core").is_dir() and shutil.which("node"):
            read = run(["node", "-e", READ_MCAP, files["mcap"]], env={"NODE_PATH": str(modules), "PATH": "/usr/bin:/usr/local/bin"})
            assert [json.loads(line) for line in read.splitlines()] == messages
        else:
            print("left out: @mcap/core is not in build/node_modules; cmake/install-packages editors puts it there")
    print("the dump, the table and MCAP say what the trace says")
    return 0


if __name__ == "__main__":
    sys.exit(main())
