"""Exports graphs to glTF and reads them in three.js: the normals that it shades with are those of
`wrinkle eval`, within the limits of maps. glTF-Validator (npm) finds nothing.

Writes gltf.json: a row for each graph and object.
"""
import json
import pathlib
import shutil
import subprocess
import sys

import graphs
import judge

PACKAGES = ["three@0.187.0", "puppeteer-core@24.43.1", "gltf-validator@2.0.0-dev.3.10"]
OBJECTS = ["plain", "mirrored", "scaled", "back"]
# Rows with the name of a fault of the host, no passes.
FAULTS = {"mirrored": "three.js does not turn the bitangent of maps with the object",
          "scaled": "the tangent frame is not that of the unscaled object"}

VALIDATE = """import fs from 'fs';
import validator from 'gltf-validator';
const found = {};
for (const file of process.argv.slice(2))
  found[file] = (await validator.validateBytes(new Uint8Array(fs.readFileSync(file)),
                                               {uri: file})).issues.messages;
console.log(JSON.stringify(found));
"""


def values_of(graph):
    return [word for value in graphs.OF_MAPS[graph] for word in ("--set", value)]


def export(wrinkle, folder, work):
    for graph in graphs.OF_MAPS:
        subprocess.run([wrinkle, "export", folder / (graph + ".json"), "--to", "gltf", "--mesh",
                        "torus", "--size", "2048", "-o", work / pathlib.Path(graph).name,
                        *values_of(graph)],
                       check=True, stdout=subprocess.DEVNULL)
    names = [pathlib.Path(graph).name for graph in graphs.OF_MAPS]
    return [f"{name}/{name}.glb" for name in names]


def validate(files, work):
    (work / "validate.mjs").write_text(VALIDATE)
    found = json.loads(subprocess.run(["node", "validate.mjs", *files], cwd=work, check=True,
                                      stdout=subprocess.PIPE).stdout)
    for file, messages in found.items():
        assert not messages, (file, messages)


def compare(proof, graph, object_name, points):
    """Back faces have the negated normal: glTF's rule, `flip`."""
    side = -1 if object_name == "back" else 1
    points = [point for point in points if point[5] == side]
    assert len(points) > 500, (graph, object_name, len(points))
    options = [*values_of(graph), "--mesh", "torus", "--size", "2048"]
    proof.compare(graph, "three.js r187, glTF", object_name, options, ["uv0.x", "uv0.y"],
                  [point[:2] for point in points],
                  [{"normal": [side * x for x in point[2:5]]} for point in points],
                  FAULTS.get(object_name, ""))


def main():
    wrinkle, source, build, chromium = map(pathlib.Path, sys.argv[1:])
    work = build / "gltf"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    for name in ["gltf.html", "read.mjs"]:
        shutil.copy(source / "tests/hosts/proof" / name, work)
    judge.install(PACKAGES, work)
    files = export(wrinkle, source / "graphs", work)
    validate(files, work)
    jobs = [(graph, file, name) for graph, file in zip(graphs.OF_MAPS, files) for name in OBJECTS]
    points = judge.drawn("gltf.html", [job[1:] for job in jobs], chromium, work)
    proof = judge.Proof(wrinkle, source / "graphs", work)
    for (graph, _, name), found in zip(jobs, points):
        compare(proof, graph, name, found)
    failed = judge.end(proof, lambda made: judge.map_limits(8), "gltf",
                       "tests/hosts/proof/gltf_test.py", build)
    sys.exit(1 if failed else 0)


main()
