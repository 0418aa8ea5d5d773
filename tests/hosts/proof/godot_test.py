"""Exports graphs to Godot 3 and draws them under Xvfb: normals, colors and roughness are those of
`wrinkle eval` at the points of the pixels, with the pixels' own differentials.

Godot draws the exported files; only the end of fragment() is replaced, by one that shows NORMAL,
ALBEDO or ROUGHNESS. 24 bits of a value come in three images: Godot's buffer of half floats cuts off
all but the first 8 bits. Writes godot.json: rows of judge.py.
"""
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys

import graphs
import judge
import pixels

HERE = pathlib.Path(__file__).parent
SCENE = """[gd_scene load_steps=2 format=2]
[ext_resource path="res://read.gd" type="Script" id=1]
[node name="Read" type="Spatial"]
script = ExtResource( 1 )
"""
# Values in [0, 1], and the parts of 255 times a value that an image shows in 1/255.
VALUES = {"normal": "0.5 + 0.5 * (CAMERA_MATRIX * vec4(NORMAL, 0.0)).xyz",
          "color": "clamp(ALBEDO, 0.0, 1.0)", "roughness": "vec3(clamp(ROUGHNESS, 0.0, 1.0))"}
PARTS = ("floor(shown)", "floor(fract(shown) * 255.0)", "fract(fract(shown) * 255.0) * 254.0")


def version():
    text = subprocess.run(["godot3", "--version"], stdout=subprocess.PIPE, text=True).stdout
    return "Godot " + ".".join(text.split(".")[:3])


def export(wrinkle, graph, host, folder, mesh):
    subprocess.run([wrinkle, "export", graph, "--to", host, "--mesh", mesh, "-o", folder],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def shader_of(text, value, part, back):
    """The exported shader, which shows a part of a value instead of light; 0.3, because the buffer
    truncates."""
    body, _ = text.rstrip().rsplit("}", 1)
    mode = "render_mode unshaded, " + ("cull_front, " if back else "")
    return (body.replace("render_mode ", mode, 1) +
            f"    vec3 shown = ({VALUES[value]}) * 255.0;\n"
            f"    ALBEDO = ({PARTS[part]} + 0.3) / 255.0;\n}}\n")


def jobs_of(folder, name):
    """Writes the shaders of all objects, values and parts; returns the jobs for read.gd."""
    text = (folder / f"{name}/{name}.shader").read_text()
    jobs = []
    for object_name, columns in pixels.OBJECTS.items():
        camera = pixels.Camera(columns)
        for value in VALUES:
            for part in range(len(PARTS)):
                job = f"{object_name}_{value}{part}"
                (folder / (job + ".txt")).write_text(
                    shader_of(text, value, part, object_name == "back"))
                jobs.append({"name": job, "columns": columns, "eye": camera.eye,
                             "target": camera.target})
    return jobs


def drawn(folder, name):
    """The bytes of the images of all jobs by their names."""
    jobs = jobs_of(folder, name)
    shutil.copy(HERE / "read.gd", folder)
    (folder / "read.tscn").write_text(SCENE)
    (folder / "jobs.json").write_text(json.dumps({
        "jobs": jobs, "field_of_view": math.degrees(pixels.FIELD_OF_VIEW),
        "material": f"res://{name}/{name}_material.tres"}))
    project = folder / "project.godot"
    project.write_text(project.read_text().replace("msaa=2", "msaa=0"))
    size = f"{pixels.SIZE}x{pixels.SIZE}"
    log = subprocess.run(["timeout", "300", "xvfb-run", "-a", "-s", "-screen 0 640x640x24", "godot3",
                          "--path", folder, "--audio-driver", "Dummy", "--resolution", size,
                          "read.tscn"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                         env=os.environ | {"HOME": str(folder)}).stdout
    assert "SHADER ERROR" not in log and "SCRIPT ERROR" not in log, log
    return {job["name"]: (folder / (job["name"] + ".bin")).read_bytes() for job in jobs}


def value_at(images, name, at):
    first = 4 * (at[1] * pixels.SIZE + at[0])
    parts = [images[name + str(part)][first:first + 3] for part in range(len(PARTS))]
    return [(a + (b + c / 254) / 255) / 255 for a, b, c in zip(*parts)]


def point_of(images, object_name, at):
    """The drawn values, the normal in object space; None: nothing was drawn at the pixel."""
    normal, color, roughness = (value_at(images, f"{object_name}_{value}", at) for value in VALUES)
    if not any(normal):
        return None
    return {"normal": pixels.normal_to_object(pixels.OBJECTS[object_name],
                                              [2 * x - 1 for x in normal]),
            "color": color, "roughness": roughness[:1]}


def compare(proof, graph, mesh, host):
    name = pathlib.Path(graph).name
    folder = proof.work / name
    export(proof.wrinkle, proof.graphs / (graph + ".json"), "godot3", folder,
           proof.work / "torus.glb")
    images = drawn(folder, name)
    for object_name, columns in pixels.OBJECTS.items():
        surface = pixels.Pixels(*mesh, columns, -1 if object_name == "back" else 1).rows
        points = {at: point_of(images, object_name, at) for at in surface}
        seen = [at for at, point in points.items() if point]
        assert len(seen) > 1000 and len(seen) > 0.99 * len(points), (name, object_name, len(seen))
        proof.compare(graph, host, object_name, [], pixels.COLUMNS, [surface[at] for at in seen],
                      [points[at] for at in seen])


def main():
    wrinkle, source, build = map(pathlib.Path, sys.argv[1:4])
    work = build / "godot"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    proof = judge.Proof(wrinkle, source / "graphs", work)
    pixels.write_torus(work / "torus.glb")
    export(wrinkle, proof.graphs / (graphs.PLAIN + ".json"), "godot", work / "mesh",
           work / "torus.glb")
    mesh = pixels.read_glb(work / "mesh/mesh.glb")  # with the tangents of the export
    host = version()
    for graph in graphs.ALL:
        compare(proof, graph, mesh, host)
    sys.exit(1 if judge.end(proof, judge.shader_limits, "godot", "tests/hosts/proof/godot_test.py",
                            build) else 0)


main()
