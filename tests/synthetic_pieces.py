"""What a map of SIDE x SIDE cells costs without its runs: usage: synthetic_pieces.py PROGRAM SIDE

Writes the pieces as the program does, with made-up results, in the working folder; prints number, size and times.
"""

import json
import os
import resource
import subprocess
import sys
import time

MASK = (1 << 64) - 1


def key_hash(text):
    """As demos/base/text/text_hash.h."""
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = ((value ^ byte) * 0x100000001B3) & MASK
    value = ((value ^ (value >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    value = ((value ^ (value >> 27)) * 0x94D049BB133111EB) & MASK
    return value ^ (value >> 31)


def timed(words):
    begin = time.monotonic()
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    return time.monotonic() - begin


program, side = sys.argv[1], int(sys.argv[2])
axes = ["--x", f"beta={1 / side:g}:1:{1 / side:g}", "--y", f"friction={1 / side:g}:1:{1 / side:g}"]
report = [program, "report", "atlas", "--grid", "stack", *axes, "--set", "seconds=0.02", "--out", "out", "--jobs", "1"]
print(f"planning {side * side} pieces and making one share in a million: {timed(report + ['--shard', '7/1000000']):.1f} s")
template = timed([*report[:5], "--x", "beta=0.5,1", "--y", "friction=0.5,1", *report[9:-3], "one"])

[version] = os.listdir("one/pieces")
for folder, _, files in os.walk("one/pieces"):
    for name in files:
        if name != "report.json":
            piece = json.load(open(os.path.join(folder, name)))
            found = os.path.join(os.path.basename(folder), name)
assert "%016x" % key_hash(piece["key"]) == found.replace("/", "").replace(".json", ""), "another hash"
start = piece["key"][: piece["key"].index(" --beta")]

begin = time.monotonic()
base = f"out/pieces/{version}"
size = 0
values = ["%g" % (i / side) for i in range(1, side + 1)]
for folder in range(256):
    os.makedirs(f"{base}/{folder:02x}", exist_ok=True)
for y in values:
    for x in values:
        piece["key"] = f"{start} --beta {x} --friction {y}"
        piece["result"] = {"outcome": "rest", "value": float(x) * float(y) / 3}
        text = json.dumps(piece, separators=(",", ":")) + "\n"
        name = "%016x" % key_hash(piece["key"])
        size += len(text)
        path = f"{base}/{name[:2]}/{name[2:]}.json"
        with open(path + ".part", "w") as file:
            file.write(text)
        os.rename(path + ".part", path)
print(f"writing {side * side} pieces one by one, by Python: {time.monotonic() - begin:.1f} s")
counts = [len(os.listdir(f"{base}/{folder:02x}")) for folder in range(256)]
blocks = int(subprocess.run(["du", "-s", "-k", base], check=True, capture_output=True, text=True).stdout.split()[0])
print(f"bytes per piece: {size / side**2:.0f}; on disk {blocks * 1024 / 1e9:.2f} GB; files per folder: {min(counts)} to {max(counts)}")
seconds = timed([program, "report", "merge", "out"])
print(f"merge: {seconds:.1f} s; peak memory {resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1e3:.0f} MB")
