#!/usr/bin/env python3
"""A height of SIZE x SIZE to six-channel slopes with all mip levels, in tiles of 64: `wrinkle
convert` beside OpenImageIO's `maketx --bumpslopes`, whole processes by turns, for each type and
compression; maketx's own choice for these heights is float and zip. Prints the median seconds of
both, their ratio, the sizes of the files, and the largest difference that `idiff` sees over all
levels.

    slopes_figures.py FOLDER_OF_PROGRAMS [--size 4096] [--rounds 5]
"""
import argparse
import array
import math
import pathlib
import re
import statistics
import subprocess
import tempfile
import time

KINDS = [("half", "zip"), ("half", "none"), ("float", "zip"), ("float", "none")]


def write_height(path, size):
    """Slow waves with grain, as scanned heights have it."""
    grain = [[(i * 7919 + j * 104729) % 1000 / 100000 for i in range(size)] for j in range(16)]
    with open(path, "wb") as file:
        file.write(b"Pf\n%d %d\n-1.0\n" % (size, size))
        for y in range(size):
            base, row = 0.5 + 0.3 * math.sin(y * 0.01), grain[y % 16]
            array.array("f", [base + 0.2 * math.sin(x * 0.013 + y * 0.003) + row[x]
                              for x in range(size)]).tofile(file)


def seconds(command):
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def difference(ours, theirs):
    text = subprocess.run(["idiff", "-a", "-fail", "1", ours, theirs], capture_output=True,
                          text=True).stdout
    return max([0.0] + [float(number) for number in re.findall(r"Max error\s+= (\S+)", text)])


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("programs", type=pathlib.Path)
    options.add_argument("--size", type=int, default=4096)
    options.add_argument("--rounds", type=int, default=5)
    given = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        height, ours, theirs = (str(pathlib.Path(folder) / name)
                                for name in ("h.pfm", "ours.exr", "theirs.exr"))
        write_height(height, given.size)
        print("| type | compression | wrinkle s | maketx s | ratio | MB | MB of maketx | "
              "largest difference |\n|---|---|---:|---:|---:|---:|---:|---:|")
        for kind, compression in KINDS:
            convert = [str(given.programs / "wrinkle"), "convert", height, "-o", ours, "--from",
                       "height", "--to", "slopes", "--mips", "--type", kind, "--compression",
                       compression]
            maketx = ["maketx", "--bumpslopes", "--format", "openexr", "-d", kind,
                      "--compression", compression, height, "-o", theirs]
            times = ([], [])
            for _ in range(given.rounds):
                for command, file, list_ in ((convert, ours, times[0]), (maketx, theirs, times[1])):
                    pathlib.Path(file).unlink(missing_ok=True)
                    list_.append(seconds(command))
            mine, peer = (statistics.median(list_) for list_ in times)
            sizes = [pathlib.Path(file).stat().st_size / 1e6 for file in (ours, theirs)]
            print(f"| {kind} | {compression} | {mine:.2f} | {peer:.2f} | {peer / mine:.2f} | "
                  f"{sizes[0]:.0f} | {sizes[1]:.0f} | {difference(ours, theirs):.1e} |", flush=True)


if __name__ == "__main__":
    main()
