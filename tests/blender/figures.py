#!/usr/bin/env python3
"""How fast a tangent-space normal map is baked: Blender's bake operator and `wrinkle bake`.

usage: figures.py BIN [TURNS]     BIN: the folder of wrinkle_bake_bench

One mesh, one sample a texel, 1024 x 1024 as floats, all cores, by turns in this run. Both start
from a scene and images in memory and end there. Measure on a machine that does nothing else.
"""
import json
import os
import statistics
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
TEXTURES = os.path.join(ROOT, "graphs/textures")
SIZE = 1024
# The graph and its map beside bake.py's case, and the name of both.
CASES = {"normal_map": ("graph", "normal_map", "a normal map"),
         "both": ("graph", "normal", "a normal map and a height"),
         "rust": ("rust", "normal", "six noises, mixed: the normal"),
         "rust_color": ("rust", "color", "six noises, mixed: the color")}


def blender_seconds(folder):
    subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1",
                    "--python", os.path.join(HERE, "bake.py"), "--", folder,
                    os.path.join(TEXTURES, "rivets_normal.png"),
                    os.path.join(TEXTURES, "weave_height.png"), str(SIZE), "3", *CASES],
                   check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "times.json")) as times:
        return json.load(times)["seconds"]


def write_rust(path):
    """graphs/rusty_steel.json without scratches, which Blender lacks."""
    with open(os.path.join(ROOT, "graphs/rusty_steel.json"), encoding="utf-8") as file:
        graph = json.load(file)
    nodes = graph["nodes"]
    scratches = {name for name, node in nodes.items() if node["type"] == "scratches"}
    for name in scratches:
        del nodes[name]
    for node in nodes.values():
        node["in"] = {port: value for port, value in node["in"].items()
                      if not isinstance(value, dict) or value["from"].split(".")[0] not in scratches}
    with open(path, "w", encoding="utf-8") as file:
        json.dump(graph, file)


def our_seconds(program, folder, case, times):
    name, output, _ = CASES[case]
    graph = os.path.join(HERE, "graph.json") if name == "graph" else folder + "/rust.json"
    root = ROOT if name == "graph" else folder
    out = subprocess.run([program, graph, root, os.path.join(folder, "mesh.obj"), output,
                          str(SIZE), str(times)],
                         check=True, capture_output=True, text=True).stdout
    return [float(line.split()[0]) for line in out.splitlines()]


def main():
    program = os.path.join(os.path.abspath(sys.argv[1]), "wrinkle_bake_bench")
    turns = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    times = {case: ([], []) for case in CASES}
    with tempfile.TemporaryDirectory() as folder:
        write_rust(folder + "/rust.json")
        for _ in range(turns):
            for case, seconds in blender_seconds(folder).items():
                times[case][0].extend(seconds)
                times[case][1].extend(our_seconds(program, folder, case, len(seconds)))
    print(f"milliseconds for {SIZE} x {SIZE}   {'Blender':>16} {'Wrinkle':>16} {'ratio':>14}\n"
          f"{'':30}" + f"{'median':>9} {'least':>7} " * 2 + f"{'median':>7} {'least':>6}")
    for case, (theirs, ours) in times.items():
        pairs = [(statistics.median(t) * 1e3, min(t) * 1e3) for t in (theirs, ours)]
        (their_median, their_least), (our_median, our_least) = pairs
        print(f"{CASES[case][2]:30}" + "".join(f"{m:9.1f} {l:7.1f} " for m, l in pairs) +
              f"{their_median / our_median:6.1f}x {their_least / our_least:5.1f}x")


if len(sys.argv) < 2:
    sys.exit(__doc__)
main()
