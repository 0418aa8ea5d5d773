"""Exports graphs to Blender and to glTF and reads both in Blender: normals, colors and roughness of
its Principled BSDF are those of `wrinkle eval`, within the limits of maps.

Writes blender.json: rows of judge.py.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

import graphs
import judge
import pixels

HERE = pathlib.Path(__file__).parent
OBJECTS = ["plain", "mirrored", "scaled", "back"]
DISPLACED = "materials/hammered_gold"  # of these graphs the one with displacement
NODES = "../tests/hosts/proof/nodes"  # color and roughness are computed by a node group
FAULT = "normals of a displaced mesh follow its vertices"
SIZE = "2048"


def version():
    text = subprocess.run(["blender", "--version"], check=True, stdout=subprocess.PIPE,
                          text=True).stdout
    return text.splitlines()[0]


def blender(*words):
    """Debian's Blender takes the library of the first python3 of PATH; its own has numpy."""
    done = subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", *words],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env=os.environ | {"PATH": "/usr/bin:/bin"})
    assert done.returncode == 0, done.stdout


def values_of(graph):
    return [word for value in graphs.OF_MAPS.get(graph, []) for word in ("--set", value)]


def exported(proof, graph, host):
    """The file that Blender opens: it, or the material and the mesh by the exported script."""
    name = pathlib.Path(graph).name
    out = proof.work / host / name
    subprocess.run([proof.wrinkle, "export", proof.graphs / (graph + ".json"), "--to", host,
                    "--mesh", proof.work / "torus.glb", "--size", SIZE, "-o", out, *values_of(graph)],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    if host == "gltf":
        return out / (name + ".glb")
    blender("-P", out / (name + ".py"), "--", "--save", out / (name + ".blend"))
    return out / (name + ".blend")


def compare(proof, graph, host, object_name, points):
    """Back faces have the negated normal, the rule `flip` of Blender and of glTF."""
    side = -1 if object_name == "back" else 1
    points = [point for point in points if point[2] == side]
    assert len(points) > 500, (graph, object_name, len(points))
    displaced = graph == DISPLACED and "glTF" not in host
    if displaced:
        object_name += ", displaced"
    if graph == NODES:
        object_name += ", nodes"
    proof.compare(graph, host, object_name,
                  [*values_of(graph), "--mesh", "torus.glb", "--size", SIZE], ["uv0.x", "uv0.y"],
                  [point[:2] for point in points],
                  [{"normal": [side * x for x in point[3:6]], "color": point[6:9],
                    "roughness": point[9:]} for point in points], FAULT if displaced else "")


def limits(made):
    """Of nodes the color is arithmetic; the roughness reads an sRGB image, which Blender filters
    before it decodes it."""
    if made["object"].endswith("nodes") and made["unit"].startswith("color"):
        return {"max": 0.01}
    return judge.map_limits(16) if made["unit"] == "degrees" else {"p90": 2}


def main():
    wrinkle, source, build = map(pathlib.Path, sys.argv[1:4])
    work = (build / "blender").resolve()
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    pixels.write_torus(work / "torus.glb")
    proof, label = judge.Proof(wrinkle, source / "graphs", work), version()
    hosts = {"blender": label, "gltf": label + ", glTF"}
    files = [(graph, host, exported(proof, graph, host))
             for host in hosts for graph in graphs.OF_MAPS]
    files.append((NODES, "blender", exported(proof, NODES, "blender")))
    jobs = [(graph, host, name, file) for graph, host, file in files for name in OBJECTS]
    (work / "jobs.json").write_text(json.dumps([(str(file), name) for _, _, name, file in jobs]))
    blender("-P", HERE / "read_blender.py", "--", work / "jobs.json", work / "points.json")
    found = json.loads((work / "points.json").read_text())
    for (graph, host, name, _), points in zip(jobs, found):
        compare(proof, graph, hosts[host], name, points)
    sys.exit(1 if judge.end(proof, limits, "blender", "tests/hosts/proof/blender_test.py", build)
             else 0)


main()
