#!/usr/bin/env python3
"""How fast graphs become shaders: wrinkle_bench, the whole process, and other programs beside.

usage: figures.py BIN [--quick | --peers]     BIN: the folder of wrinkle and wrinkle_bench

  --quick   small graphs once: whether all of this still works; exit code 1 where it does not
  --peers   three.js and Babylon.js too, in this run: npm installs what peers/package.json pins

Times are milliseconds, medians. Measure on a machine that does nothing else.
"""
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
GRAPHS = os.path.join(HERE, "../../graphs")

# MaterialX 1.39.6: generate() of both stages from a document in memory, one warm process on one of
# two vCPUs of an AMD Zen 5, 2026-11-20. `normal_maps` is a chain of image, normalmap and mix without
# a light model; `heights` sums images under one bump node of a lit surface; `nested` are definitions
# that use the one below twice, of the depths 19, 24 and 29; `process` starts, loads the libraries,
# validates, generates and ends.
MATERIALX = {
    "normal_maps": {2: 0.93, 10: 3.7, 100: 36, 1000: 454, 10000: 16600},
    "heights": {10: 5.8, 100: 38.5, 1000: 516},
    "nested": {20: 10, 30: 10000},
    "process": {2: 41},
}


def bench(folder, arguments, run_type=None):
    """{family: {size or name: its entry}}, medians where there are several; with "iteration" all."""
    out = subprocess.run([os.path.join(folder, "wrinkle_bench"), "--benchmark_format=json",
                          *arguments], check=True, capture_output=True, text=True).stdout
    entries = {}
    for entry in json.loads(out)["benchmarks"]:
        family, rest = entry["run_name"].split("/", 1)
        sizes, size = entries.setdefault(family, {}), int(rest) if rest.isdigit() else rest
        if run_type == entry["run_type"]:
            sizes.setdefault(size, []).append(entry)
        elif not run_type and entry.get("aggregate_name", "median") == "median":
            sizes[size] = entry
    return entries


def print_sizes(family, title, entries):
    print(f"\n{title:38} {'Wrinkle':>9} {'MaterialX':>10} {'ratio':>7} {'reads':>7} {'KB':>7}")
    for size, entry in entries.get(family, {}).items():
        if "error_occurred" in entry:
            print(f"{size:>38,} {entry['error_message'].splitlines()[0]}")
            continue
        peer = MATERIALX[family].get(size)
        beside = f"{peer:10,g} {peer / entry['real_time']:6,.0f}x" if peer else " " * 18
        print(f"{size:>38,} {entry['real_time']:9.3f} {beside} {entry['reads']:7,.0f} "
              f"{entry['glsl_bytes'] / 1000:7,.0f}")


def print_growth(folder):
    """Both sizes by turns: the ratio is of one state of the machine."""
    sizes = bench(folder, ["--benchmark_filter=normal_maps/(100|10000)$",
                           "--benchmark_enable_random_interleaving=true",
                           "--benchmark_repetitions=9", "--benchmark_min_time=0.3",
                           "--benchmark_report_aggregates_only=true"])["normal_maps"]
    growth = sizes[10000]["real_time"] / sizes[100]["real_time"] / 100
    print(f"per node, 10,000 layers to 100, by turns: {growth:.2f} x (at most 1.35)")


def print_samples(entries):
    samples = {name: entry for name, entry in entries.get("sample", {}).items()
               if "error_occurred" not in entry}
    if not samples:
        return
    times = sorted((entry["real_time"], name) for name, entry in samples.items())
    print(f"\n{len(times)} samples: median {statistics.median(t for t, _ in times):.3f}, "
          f"the dearest {', '.join(f'{name} {t:.2f}' for t, name in times[:-4:-1])}")


def whole_process(folder, rounds):
    """From start to exit, with the graph's file read and the text's written."""
    graph = os.path.join(GRAPHS, "base_and_detail.json")
    with tempfile.TemporaryDirectory() as work:
        words = [os.path.join(folder, "wrinkle"), "compile", graph, "-o",
                 os.path.join(work, "two.glsl")]
        times = []
        for _ in range(rounds):
            start = time.perf_counter()
            subprocess.run(words, check=True)
            times.append((time.perf_counter() - start) * 1e3)
    print(f"\nwhole process, 2 maps: median {statistics.median(times):.1f}, least {min(times):.1f} "
          f"(at most 10); MaterialX {MATERIALX['process'][2]}")


def script_times(script, work):
    """A name, and {layers: milliseconds} as median and least."""
    out = subprocess.run(["node", script], cwd=work, check=True, capture_output=True,
                         text=True).stdout
    lines = [json.loads(line) for line in out.splitlines() if line.startswith("{")]
    for line in lines:
        if line["reads"] < line["layers"]:
            sys.exit(f"{script}: {line['layers']} layers are read {line['reads']} times")
    return f"{lines[0]['peer']} {lines[0]['version']}", {
        line["layers"]: (line["ms"], line["least"]) for line in lines}


def our_times(folder):
    out = bench(folder, ["--benchmark_filter=normal_maps/(2|10|100)$", "--benchmark_min_time=0.05",
                         "--benchmark_repetitions=9"], "iteration")["normal_maps"]
    times = {size: [entry["real_time"] for entry in entries] for size, entries in out.items()}
    return "Wrinkle", {size: (statistics.median(t), min(t)) for size, t in times.items()}


PEER_GOAL = (100, 10)  # at so many layers, so many times as fast as each


def goal_lines(medians):
    """Whether that is met, of {name: {layers: milliseconds}}."""
    layers, least = PEER_GOAL
    for name, times in medians.items():
        if name == "Wrinkle":
            continue
        ratio = times[layers] / medians["Wrinkle"][layers]
        yield (f"at {layers} layers at least {least} x as fast as {name}: {ratio:.2f} x, "
               f"{'met' if ratio >= least else 'MISSED'}")


def peers(folder):
    """By turns, so that what else the machine does meets all; npm installs into build/peers."""
    work = os.path.join(HERE, "../../build/peers")
    os.makedirs(work, exist_ok=True)
    for name in os.listdir(os.path.join(HERE, "peers")):
        shutil.copy(os.path.join(HERE, "peers", name), work)
    subprocess.run(["npm", "ci", "--no-audit", "--no-fund", "--silent"], cwd=work, check=True)
    rounds = {}
    for _ in range(3):
        for name, times in (our_times(folder), script_times("three.mjs", work),
                            script_times("babylon.mjs", work)):
            rounds.setdefault(name, []).append(times)
    for which, title in ((0, "by turns in this run, medians"), (1, "the least times")):
        print(f"\n{title:38}" + "".join(f"{size:>18,}" for size in (2, 10, 100)) + "  layers")
        best = {name: {size: (min if which else statistics.median)(t[size][which] for t in turns)
                       for size in (2, 10, 100)} for name, turns in rounds.items()}
        for name, times in best.items():
            cells = (f"{t:9.3f} {t / best['Wrinkle'][size]:6.1f}x" for size, t in times.items())
            print(f"{name:38}" + "".join(f"{cell:>18}" for cell in cells))
        if not which:
            medians = best
    print("\n" + "\n".join(goal_lines(medians)))


def main():
    if len(sys.argv) < 2 or not set(sys.argv[2:]) <= {"--quick", "--peers"}:
        sys.exit(__doc__)
    folder = sys.argv[1]
    quick = "--quick" in sys.argv
    arguments = ["--benchmark_repetitions=5", "--benchmark_min_time=0.1",
                 "--benchmark_report_aggregates_only=true"]
    if quick:
        arguments = ["--benchmark_filter=(normal_maps|heights)/(2|10|100)$|nested/10$|^sample",
                     "--benchmark_min_time=0.001"]
    entries = bench(folder, arguments)
    print("milliseconds, JSON text in, GLSL text out")
    print_sizes("normal_maps", "normal maps, layers", entries)
    if not quick:
        print_growth(folder)
    print_sizes("heights", "heights, layers", entries)
    print_sizes("nested", "nested sub-graphs, depth", entries)
    print_samples(entries)
    whole_process(folder, 3 if quick else 100)
    if "--peers" in sys.argv:
        peers(folder)
    failed = [entry["error_message"] for family in entries.values() for entry in family.values()
              if "error_occurred" in entry]
    if failed and quick:
        sys.exit("\n".join(failed))


if __name__ == "__main__":
    main()
