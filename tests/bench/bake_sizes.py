#!/usr/bin/env python3
"""What a texel of a baked normal map costs at each size, and how much memory `wrinkle bake` takes.

usage: bake_sizes.py BIN [--turns 3] [--sizes 1024,2048,4096,8192,16384] [--graph FILE] [--mesh NAME]

The sizes go by turns in one run. `bake`: within a process that bakes again and again, from a graph,
a mesh and images in memory to the rows that a file would hold, the first bake left out; by the
wall's clock and as processor time over all threads. `program`: `wrinkle bake` as a whole, less its
own time for a map of 16 x 16, with an uncompressed TIFF written; the peak of its memory.
"""
import argparse
import os
import statistics
import subprocess
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SMALL = 16


def bakes(given, size):
    """Pairs of seconds, wall and processor, of all bakes but the first."""
    times = 2 + (4096 // size) ** 2
    out = subprocess.run([os.path.join(given.bin, "wrinkle_bake_bench"), given.graph,
                          os.path.dirname(given.graph), given.mesh, "normal", str(size),
                          str(times)], check=True, capture_output=True, text=True).stdout
    return [tuple(map(float, line.split())) for line in out.splitlines()][1:]


def program(given, size, folder):
    """Seconds and the peak of memory in MB."""
    start = time.perf_counter()
    process = subprocess.Popen([os.path.join(given.bin, "wrinkle"), "bake", given.graph, "--mesh",
                                given.mesh, "--size", str(size), "--compression", "none", "-o",
                                os.path.join(folder, "map.tif")])
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise SystemExit("wrinkle bake failed")
    return time.perf_counter() - start, usage.ru_maxrss / 1024


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("bin")
    options.add_argument("--turns", type=int, default=3)
    options.add_argument("--sizes", default="1024,2048,4096,8192,16384")
    options.add_argument("--graph", default=os.path.join(ROOT, "graphs/base_and_detail.json"))
    options.add_argument("--mesh", default="sphere")
    given = options.parse_args()
    sizes = [int(size) for size in given.sizes.split(",")]
    walls, processors, wholes, peaks = ({size: [] for size in sizes} for _ in range(4))
    starts = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(given.turns):
            starts.append(program(given, SMALL, folder)[0])
            for size in sizes:
                for wall, processor in bakes(given, size):
                    walls[size].append(wall)
                    processors[size].append(processor)
                seconds, peak = program(given, size, folder)
                wholes[size].append(seconds)
                peaks[size].append(peak)
    start = min(starts)
    print(f"start of the program {start * 1e3:.0f} ms; nanoseconds a texel, median and least\n"
          "| size | bake, wall | | bake, processors | | program less start | | peak MB |\n"
          "|---:|---:|---:|---:|---:|---:|---:|---:|")
    for size in sizes:
        cells = []
        for seconds, less in ((walls, 0), (processors, 0), (wholes, start)):
            values = [(each - less) * 1e9 / size ** 2 for each in seconds[size]]
            cells += [f"{statistics.median(values):.1f}", f"{min(values):.1f}"]
        print(f"| {size} | " + " | ".join(cells) + f" | {max(peaks[size]):.0f} |")


main()
