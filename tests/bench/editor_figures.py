#!/usr/bin/env python3
"""How fast the editor is: its start, frames, edits until their pixels, and what it does when idle.

usage: editor_figures.py EDITOR [ROUNDS]      wants Xvfb; takes a minute a round

Every program starts with an empty cache of shaders, so each picture is one that was never drawn. A
figure is the median of the rounds, with the least and the greatest. Measure on a machine that does
nothing else; nothing here passes or fails.
"""
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

STEPS = [("multiply", {"b": 3.1}, "a"), ("sine", {}, "angle"), ("add", {"b": 0.2}, "a")]


def chain(count):
    """A height of `count` nodes in a chain, laid out in rows of ten, and its normal."""
    nodes = {"uv": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}}}
    layout = {"depth": [0, -400], "normal": [400, -400], "uv": [0, -200]}
    last = "uv.x"
    for i in range(count - 3):
        kind, values, port = STEPS[i % 3]
        nodes[f"n{i}"] = {"type": kind, "in": {**values, port: {"from": last}}}
        layout[f"n{i}"] = [i % 10 * 240, i // 10 * 160]
        last = f"n{i}.result"
    nodes["depth"] = {"type": "multiply", "in": {"a": {"from": last}, "b": 0.05}}
    nodes["normal"] = {"type": "resolve", "in": {"gradient": {"from": "depth.result"}}}
    return {"wrinkle": 1, "nodes": nodes, "layout": layout,
            "outputs": {"normal": {"from": "normal.normal"}}}


SCRIPT = """
key 1
double node:depth
key Escape
click node:depth
key F
section edit
double field:depth.b
type 0.04
key Enter
section cut
drag pin:depth.a canvas+0,320
section rewire
key Escape
key Ctrl+Z
section drag
drag field:depth.b field:depth.b+40,0
section node
click node:depth
key P
section outputs
key P
section rest
assert picture
"""


class Screen:
    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1920x1080x24", "-nolisten", "tcp"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            self.display = ":" + number.readline().strip()
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


def environment(screen, folder):
    cache = tempfile.mkdtemp(dir=folder)
    return {**os.environ, "DISPLAY": screen.display, "MESA_SHADER_CACHE_DIR": cache}


def play(editor, screen, folder, graph, script):
    """The figures of one run, by section; `start` holds those of the program."""
    paths = {}
    for name, text in (("graph.json", json.dumps(graph)), ("script.txt", script)):
        paths[name] = os.path.join(folder, name)
        with open(paths[name], "w", encoding="utf8") as file:
            file.write(text)
    out = os.path.join(folder, "figures.json")
    subprocess.run([editor, paths["graph.json"], "--size", "1280", "720", "--script",
                    paths["script.txt"], "--timings", out], check=True,
                   env=environment(screen, folder))
    with open(out, encoding="utf8") as file:
        figures = json.load(file)
    sections = {section["section"]: section for section in figures["sections"]}
    sections["start"].update(first_frame_ms=figures["first_frame_ms"],
                             first_picture_ms=figures["first_picture_ms"])
    return sections


def ticks(process):
    with open(f"/proc/{process}/stat", encoding="utf8") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return int(fields[11]) + int(fields[12])


def idle(editor, screen, folder, graph):
    """Percent of a core, over five seconds without input."""
    path = os.path.join(folder, "graph.json")
    with open(path, "w", encoding="utf8") as file:
        json.dump(graph, file)
    program = subprocess.Popen([editor, path, "--size", "1280", "720", "--state", folder],
                               env=environment(screen, folder))
    time.sleep(4)
    before = ticks(program.pid)
    time.sleep(5)
    used = (ticks(program.pid) - before) / os.sysconf("SC_CLK_TCK")
    program.kill()
    program.wait()
    return used / 5 * 100


def measure(editor, screen, folder):
    figures = {}
    for count in (20, 50, 200):
        near = count < 200  # of 200 nodes the fields are too small to be dragged
        script = SCRIPT if near else "section rewire\nkey Ctrl+A\nkey M\nkey Ctrl+Z\nsection rest\nwait 1\n"
        sections = play(editor, screen, folder, chain(count), script)
        start = sections["start"]
        figures[f"{count} nodes: first frame"] = start["first_frame_ms"]
        figures[f"{count} nodes: first picture"] = start["first_picture_ms"]
        for name in ("cut", "rewire", "node", "outputs"):
            values = sections.get(name, {}).get("structure_to_pixels_ms")
            if values:
                figures[f"{count} nodes: {name} to pixels"] = max(values)
        if near:
            figures[f"{count} nodes: drag to pixels"] = max(sections["drag"]["value_to_pixels_ms"])
        rest = [s["longest_frame_ms"] for n, s in sections.items() if n != "start"]
        figures[f"{count} nodes: longest frame"] = max(rest)
    figures["2,000 nodes: first frame"] = play(editor, screen, folder, chain(2000),
                                               "wait 1\n")["start"]["first_frame_ms"]
    figures["idle, % of a core"] = idle(editor, screen, folder, chain(20))
    return figures


def main():
    editor = os.path.abspath(sys.argv[1])
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    collected = {}
    with Screen() as screen, tempfile.TemporaryDirectory() as folder:
        for _ in range(rounds):
            for name, value in measure(editor, screen, folder).items():
                collected.setdefault(name, []).append(value)
    for name, values in collected.items():
        print(f"{name:34} {statistics.median(values):8.1f}   {min(values):.1f} to {max(values):.1f}")


if __name__ == "__main__":
    main()
