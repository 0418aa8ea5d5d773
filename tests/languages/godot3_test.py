"""Compiles every sample in Godot 3 under Xvfb, called by a spatial shader of its own."""
import pathlib
import subprocess
import sys

from samples import compiled

PROJECT = """config_version=4
[application]
run/main_scene="res://main.tscn"
[rendering]
quality/driver/driver_name="GLES3"
quality/driver/fallback_to_gles2=false
"""
SCENE = """[gd_scene load_steps=2 format=2]
[ext_resource path="res://main.gd" type="Script" id=1]
[node name="Main" type="Spatial"]
script = ExtResource( 1 )
"""
# Draws a quad with each shader: Godot compiles a shader when it is first drawn.
SCRIPT = """extends Spatial
func _ready():
    var camera = Camera.new()
    camera.translation = Vector3(0, 0, 3)
    add_child(camera)
    camera.current = true
    var list = File.new()
    list.open("res://list.txt", File.READ)
    while not list.eof_reached():
        var path = list.get_line()
        if path == "": continue
        var file = File.new()
        file.open(path, File.READ)
        print("compiling ", path)
        var material = ShaderMaterial.new()
        material.shader = Shader.new()
        material.shader.code = file.get_as_text()
        var quad = MeshInstance.new()
        quad.mesh = QuadMesh.new()
        quad.material_override = material
        add_child(quad)
        yield(get_tree(), "idle_frame")
        yield(get_tree(), "idle_frame")
        quad.queue_free()
    get_tree().quit()
"""
ARGUMENTS = {"float": "1.0", "vec2": "UV", "vec3": "VERTEX", "vec4": "vec4(VERTEX, 1.0)"}
AS_VEC3 = {"float": "vec3({})", "vec2": "vec3({}, 0.0)", "vec3": "{}", "vec4": "{}.xyz"}


def spatial(text, reflection):
    """Returns a spatial shader that shows the sum of the material's outputs."""
    outputs = reflection["outputs"]
    arguments = [ARGUMENTS[member["type"]] for member in reflection["members"]]
    arguments += [output["member"] for output in outputs]
    variables = "".join(f"    {output['type']} {output['member']};\n" for output in outputs)
    total = " + ".join(AS_VEC3[output["type"]].format(output["member"]) for output in outputs)
    return (f"shader_type spatial;\nrender_mode unshaded;\n{text}void fragment() {{\n{variables}"
            f"    {reflection['function']}({', '.join(arguments)});\n    ALBEDO = {total};\n}}\n")


def errors_of(shaders, folder):
    """Returns Godot's messages about the shaders, by path."""
    for name, text in (("project.godot", PROJECT), ("main.tscn", SCENE), ("main.gd", SCRIPT),
                       ("list.txt", "".join(f"{path}\n" for path in shaders))):
        (folder / name).write_text(text)
    log = subprocess.run(["xvfb-run", "-a", "godot3", "--path", folder, "--no-window"],
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout
    errors, path = {}, None
    for line in log.splitlines():
        if line.startswith("compiling "):
            path = line.removeprefix("compiling ")
            errors[path] = ""
        elif "SHADER ERROR" in line:
            errors[path] += line + "\n"
    return errors


def main():
    wrinkle, graphs, build = sys.argv[1:]
    folder = pathlib.Path(build) / "godot3"
    folder.mkdir(parents=True, exist_ok=True)
    shaders = []
    for path, reflection in compiled(wrinkle, graphs, folder, "godot3", "function"):
        shader = path.with_suffix(".shader")
        shader.write_text(spatial(path.read_text(), reflection))
        shaders.append(str(shader))
    seeded = folder / "seeded.shader"
    seeded.write_text(pathlib.Path(shaders[0]).read_text().replace("normalize(", "normalise("))
    errors = errors_of([*shaders, str(seeded)], folder)
    assert errors.pop(str(seeded)), "Godot does not report the seeded error"
    assert sorted(errors) == sorted(shaders), "Godot did not compile every shader"
    refused = {path: text for path, text in errors.items() if text}
    assert not refused, refused
    print(f"{len(shaders)} shaders")


main()
