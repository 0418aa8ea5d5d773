"""Exports graphs to MaterialX and reads them with three.js's MaterialXLoader: normals, colors and
roughness are those of `wrinkle eval` of the same bytes, within the limits of maps.

Writes materialx.json: a row for each graph and object.
"""
import pathlib
import shutil
import subprocess
import sys

import judge

PACKAGES = ["three@0.187.0", "puppeteer-core@24.43.1"]
# With values that leave detail which 2048 texels hold.
GRAPHS = {"base_and_detail": [], "woven_strap": ["tile.scale=[1, 1]"],
          "triplanar_rock": ["pebbles.tiling=0.5", "weave.tiling=1", "slopes.tiling=0.5"],
          "noise_rock": ["lumps.octaves=2", "cracks.scale=3"], "materials/chipped_paint": [],
          "materials/hammered_gold": []}
OBJECTS = ["unturned", "unturned, mirrored", "unturned, scaled", "unturned, back", "plain"]
HOST = "three.js r187, MaterialX"
# Rows with the name of a fault of the host, no passes.
FAULTS = {name: "three.js applies the object's matrix to the normals of documents twice"
          for name in ["unturned, mirrored", "unturned, scaled", "plain"]}
FAULTS["unturned, back"] = "three.js reverses the tangent frame of documents in part"


def values_of(graph):
    return [word for value in GRAPHS[graph] for word in ("--set", value)]


def export(wrinkle, graphs, work):
    for graph in GRAPHS:
        for host, size in [("gltf", "16"), ("materialx", "2048")]:  # the mesh is that of glTF
            subprocess.run([wrinkle, "export", graphs / (graph + ".json"), "--to", host, "--mesh",
                            "torus", "--size", size, "-o", work / pathlib.Path(graph).name,
                            *values_of(graph)],
                           check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def compare(proof, graph, object_name, points):
    """Back faces have the negated normal, as in glTF."""
    side = -1 if "back" in object_name else 1
    points = [point for point in points if point[4] == side]
    assert len(points) > 300, (graph, object_name, len(points))
    options = [*values_of(graph), "--mesh", "torus", "--size", "2048"]
    drawn = [{"normal": [side * x for x in point[5:8]], "color": point[8:11],
              "roughness": point[11:]} for point in points]
    proof.compare(graph, HOST, object_name, options, ["uv0.x", "uv0.y"],
                  [point[:2] for point in points], drawn, FAULTS.get(object_name, ""))


def limits(made):
    return judge.map_limits(8) if made["unit"] == "degrees" else {"p90": 2}


def with_eight_bits(graphs, work):
    """A copy of the graphs with textures of 8 bits, to which browsers cut images."""
    copy = work / "graphs"
    shutil.copytree(graphs, copy)
    for texture in copy.glob("textures/*.png"):
        subprocess.run(["oiiotool", texture, "-d", "uint8", "-o", texture], check=True)
    return copy


def main():
    wrinkle, source, build, chromium = map(pathlib.Path, sys.argv[1:])
    work = build / "materialx"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    for name in ["materialx.html", "three_scene.js", "read.mjs"]:
        shutil.copy(source / "tests/hosts/proof" / name, work)
    judge.install(PACKAGES, work)
    graphs = with_eight_bits(source / "graphs", work)
    export(wrinkle, graphs, work)
    jobs = [(graph, name) for graph in GRAPHS for name in OBJECTS]
    points = judge.drawn("materialx.html", [(pathlib.Path(graph).name, name)
                                            for graph, name in jobs], chromium, work)
    proof = judge.Proof(wrinkle, graphs, work)
    for (graph, name), found in zip(jobs, points):
        compare(proof, graph, name, found)
    failed = judge.end(proof, limits, "materialx", "tests/hosts/proof/materialx_test.py", build)
    sys.exit(1 if failed else 0)


main()
