"""Exports graphs to Godot 3 and to glTF, and draws both in Godot under Xvfb: normals, colors and
roughness are those of `wrinkle eval` at the points of the pixels, for shaders with the pixels' own
differentials.

Godot draws the exported files; only the end of fragment() is replaced, by one that shows NORMAL,
ALBEDO or ROUGHNESS. 24 bits of a value come in three images: Godot's buffer of half floats cuts off
all but the first 8 bits. Writes godot.json: rows of judge.py.
"""
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import graphs
import judge
import pixels

HERE = pathlib.Path(__file__).parent
SCENE = """[gd_scene load_steps=2 format=2]
[ext_resource path="res://read.gd" type="Script" id=1]
[node name="Read" type="Spatial"]
script = ExtResource( 1 )
"""
UV = ["uv0.x", "uv0.y"]
# Compressed uvs are half floats, which are as coarse as the texels.
IMPORT = """[remap]
importer="scene"
type="PackedScene"
[params]
meshes/compress=false
"""
FAULTS = {"scaled": "imported materials lack Ensure Correct Normals"}  # in Godot's inspector
FAULT = "16-bit normals are cut to 8 bits, and z is computed from x and y"
PROJECT = "config_version=4\n[rendering]\nquality/filters/msaa=0\n"
# Values in [0, 1], and the parts of 255 times a value that an image shows in 1/255.
VALUES = {"normal": "0.5 + 0.5 * (CAMERA_MATRIX * vec4(NORMAL, 0.0)).xyz",
          "color": "clamp(ALBEDO, 0.0, 1.0)", "roughness": "vec3(clamp(ROUGHNESS, 0.0, 1.0))"}
# Godot applies a material's normal map after fragment(), by this formula (its scene.glsl).
MAPPED = """    vec2 slope = NORMALMAP.xy * 2.0 - 1.0;
    NORMAL = normalize(mix(NORMAL, TANGENT * slope.x + BINORMAL * slope.y +
        NORMAL * sqrt(max(0.0, 1.0 - dot(slope, slope))), NORMALMAP_DEPTH));
"""
PARTS = ("floor(shown)", "floor(fract(shown) * 255.0)", "fract(fract(shown) * 255.0) * 254.0")


def version():
    text = subprocess.run(["godot3", "--version"], stdout=subprocess.PIPE, text=True).stdout
    return "Godot " + ".".join(text.split(".")[:3])


def export(wrinkle, graph, host, folder, mesh, *options):
    subprocess.run([wrinkle, "export", graph, "--to", host, "--mesh", mesh, "-o", folder, *options],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def end_of(value, part):
    """The end of fragment() that shows a part of a value; 0.3, because the buffer truncates."""
    return (f"    vec3 shown = ({VALUES[value]}) * 255.0;\n"
            f"    ALBEDO = ({PARTS[part]} + 0.3) / 255.0;\n}}\n")


def jobs_of(objects, first):
    """The jobs for read.gd: all objects, values and parts; `first` is put before the end."""
    jobs = []
    for object_name in objects:
        columns = pixels.OBJECTS[object_name]
        camera = pixels.Camera(columns)
        modes = "unshaded, " + ("cull_front, " if object_name == "back" else "")
        for value in VALUES:
            for part in range(len(PARTS)):
                jobs.append({"name": f"{object_name}_{value}{part}", "columns": columns,
                             "eye": camera.eye, "target": camera.target, "modes": modes,
                             "end": first + end_of(value, part)})
    return jobs


def godot(folder, *words):
    """Runs Godot in a project and returns its log."""
    return subprocess.run(["timeout", "300", "xvfb-run", "-a", "-s", "-screen 0 640x640x24",
                           "godot3", "--path", folder, "--audio-driver", "Dummy", *words],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env=os.environ | {"HOME": str(folder)}).stdout


def drawn(folder, objects, files, first=""):
    """The bytes of the images of all jobs by their names; `files` names a material or a scene."""
    jobs = jobs_of(objects, first)
    shutil.copy(HERE / "read.gd", folder)
    (folder / "read.tscn").write_text(SCENE)
    (folder / "jobs.json").write_text(json.dumps({
        "jobs": jobs, "field_of_view": math.degrees(pixels.FIELD_OF_VIEW)} | files))
    size = f"{pixels.SIZE}x{pixels.SIZE}"
    log = godot(folder, "--resolution", size, "read.tscn")
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


def seen(images, mesh, object_name):
    """The points of the pixels that show the object, and the values drawn there."""
    side = -1 if object_name == "back" else 1
    surface = pixels.Pixels(*mesh, pixels.OBJECTS[object_name], side).rows
    points = {at: point_of(images, object_name, at) for at in surface}
    drawn_at = [at for at, point in points.items() if point]
    assert len(drawn_at) > 1000 and len(drawn_at) > 0.99 * len(points), (object_name, len(drawn_at))
    return [surface[at] for at in drawn_at], [points[at] for at in drawn_at]


def imported(folder):
    """Has Godot's editor import the files of a project; the editor does not end by itself."""
    editor = subprocess.Popen(["timeout", "120", "xvfb-run", "-a", "godot3", "--editor", "--path",
                               folder, "--audio-driver", "Dummy"], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, env=os.environ | {"HOME": str(folder)},
                              start_new_session=True)
    while editor.poll() is None and not list(folder.glob(".import/*.md5")):
        time.sleep(0.2)
    os.killpg(editor.pid, signal.SIGTERM)
    assert list(folder.glob(".import/*.md5")), folder


def compare(proof, graph, mesh, host):
    name = pathlib.Path(graph).name
    folder = proof.work / name
    export(proof.wrinkle, proof.graphs / (graph + ".json"), "godot3", folder,
           proof.work / "torus.glb")
    project = folder / "project.godot"
    project.write_text(project.read_text().replace("msaa=2", "msaa=0"))
    images = drawn(folder, pixels.OBJECTS,
                   {"scene": "", "material": f"res://{name}/{name}_material.tres"})
    for object_name in pixels.OBJECTS:
        surface, points = seen(images, mesh, object_name)
        proof.compare(graph, host, object_name, [], pixels.COLUMNS, surface, points)


def compare_gltf(proof, graph, mesh, host):
    """Draws the imported file with the material that Godot makes of it."""
    name = pathlib.Path(graph).name
    folder = proof.work / "gltf" / name
    values = [word for value in graphs.OF_MAPS[graph] for word in ("--set", value)]
    torus, options = proof.work / "torus.glb", [*values, "--size", "2048"]
    export(proof.wrinkle, proof.graphs / (graph + ".json"), "gltf", folder, torus, *options)
    (folder / "project.godot").write_text(PROJECT)
    (folder / (name + ".glb.import")).write_text(IMPORT)
    imported(folder)
    objects = ["plain", "mirrored", "scaled"]
    images = drawn(folder, objects, {"scene": f"res://{name}.glb"}, MAPPED)
    for object_name in objects:
        surface, points = seen(images, mesh, object_name)
        at = [pixels.COLUMNS.index(column) for column in UV]
        proof.compare(graph, host, object_name, [*options, "--mesh", "torus.glb"], UV,
                      [[row[i] for i in at] for row in surface], points,
                      FAULTS.get(object_name, FAULT))


def limits(made):
    if "glTF" not in made["host"]:
        return judge.shader_limits(made)
    return judge.map_limits(8) if made["unit"] == "degrees" else {"p90": 2}


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
    for graph in graphs.OF_MAPS:
        compare_gltf(proof, graph, mesh, host + ", glTF")
    sys.exit(1 if judge.end(proof, limits, "godot", "tests/hosts/proof/godot_test.py", build) else 0)


main()
