"""Exports graphs to three.js and draws them in Chromium by WebGL and WebGPU: normals, colors and
roughness are those of `wrinkle eval` at the points of the pixels, with the pixels' own
differentials.

Writes three.json: rows of degrees for each graph and object, and of 1/255 for colors and roughness.
"""
import pathlib
import shutil
import subprocess
import sys

import graphs
import judge

PACKAGES = ["three@0.187.0", "puppeteer-core@24.43.1"]
# Each graph with the angle of the camera. Images have no mips in the host, so where the graph's
# result depends on the steps between pixels the camera is near; elsewhere these are made small.
WIDE, NEAR = 30, 1.2
GRAPHS = {graph: NEAR if graph in (graphs.TRIPLANAR, graphs.PARALLAX) else WIDE
          for graph in graphs.ALL}
STEPS = {graphs.PLAIN: 2.0 ** -10, graphs.DETAIL_ON_UV1: 2.0 ** -10}
OBJECTS = ["plain", "mirrored", "scaled", "back", "instanced", "skinned", "no tangents"]
COLUMNS = [f"{way}{name}.{axis}" for name in ["position", "normal"] for way in ["", "dx.", "dy."]
           for axis in "xyz"]
COLUMNS += ["tangent." + axis for axis in "xyzw"]
COLUMNS += [f"{way}uv{number}.{axis}" for way in ["", "dx.", "dy."] for number in "01"
            for axis in "xy"]
COLUMNS += ["facing"] + ["view." + axis for axis in "xyz"]
# Each page with its host.
PAGES = {"three.html": "three.js r187", "three_webgpu.html": "three.js r187, WebGPU"}


def class_of(name):
    return "".join(part[:1].upper() + part[1:] for part in name.split("_")) + "Material"


def export(wrinkle, folder, work):
    for graph in GRAPHS:
        subprocess.run([wrinkle, "export", folder / (graph + ".json"), "--to", "three", "--mesh",
                        "torus", "-o", work / pathlib.Path(graph).name],
                       check=True, stdout=subprocess.DEVNULL)


def compare(proof, graph, page, object_name, points):
    side = -1 if object_name == "back" else 1
    facing, count = COLUMNS.index("facing"), len(COLUMNS)
    points = [point for point in points if point[facing] == side]
    assert len(points) > 300, (graph, object_name, len(points))
    steps = [STEPS.get(graph, 1) if column[:3] in ("dx.", "dy.") else 1 for column in COLUMNS]
    rows = [[x * step for x, step in zip(point, steps)] for point in points]
    drawn = [{"normal": point[count:count + 3], "color": point[count + 3:count + 6],
              "roughness": point[count + 6:]} for point in points]
    proof.compare(graph, PAGES[page], object_name, [], COLUMNS, rows, drawn)


def main():
    wrinkle, source, build, chromium = map(pathlib.Path, sys.argv[1:])
    work = build / "three"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    for name in [*PAGES, "three_scene.js", "read.mjs"]:
        shutil.copy(source / "tests/hosts/proof" / name, work)
    judge.install(PACKAGES, work)
    export(wrinkle, source / "graphs", work)
    jobs = [(graph, name) for graph in GRAPHS for name in OBJECTS]
    names = [pathlib.Path(graph).name for graph, _ in jobs]
    proof = judge.Proof(wrinkle, source / "graphs", work)
    for page in PAGES:
        points = judge.drawn(page, [(name, class_of(name), job[1], GRAPHS[job[0]])
                                    for name, job in zip(names, jobs)], chromium, work)
        for (graph, name), found in zip(jobs, points):
            compare(proof, graph, page, name, found)
    sys.exit(1 if judge.end(proof, judge.shader_limits, "three",
                            "tests/hosts/proof/three_test.py", build) else 0)


main()
