extends Spatial
# Draws each job of jobs.json and writes its image as bytes. The mesh and its material are mesh.tres
# and a file, or those of an imported scene. Of the material's shader a job replaces the render modes
# and the end of fragment().
func vector(list):
    return Vector3(list[0], list[1], list[2])

# The mesh of a scene that has one.
func mesh_of(scene):
    var nodes = [scene]
    while nodes:
        var node = nodes.pop_front()
        if node is MeshInstance:
            return node.mesh
        nodes += node.get_children()

# The code of the shader, and a material with the same parameters and another code.
func code_of(material):
    return VisualServer.shader_get_code(VisualServer.material_get_shader(material.get_rid()))

func with_code(material, code):
    var made = ShaderMaterial.new()
    made.shader = Shader.new()
    made.shader.code = code
    var rid = material.get_rid()
    for param in VisualServer.shader_get_param_list(VisualServer.material_get_shader(rid)):
        made.set_shader_param(param["name"], VisualServer.material_get_param(rid, param["name"]))
    return made

func _ready():
    var file = File.new()
    file.open("res://jobs.json", File.READ)
    var jobs = parse_json(file.get_as_text())
    file.close()
    get_viewport().keep_3d_linear = true
    VisualServer.set_default_clear_color(Color(0, 0, 0))
    var camera = Camera.new()
    camera.near = 0.05
    camera.fov = jobs["field_of_view"]
    add_child(camera)
    camera.current = true
    var shape = MeshInstance.new()
    add_child(shape)
    var material
    if jobs["scene"]:
        shape.mesh = mesh_of(load(jobs["scene"]).instance())
        material = shape.mesh.surface_get_material(0)
    else:
        shape.mesh = load("res://mesh.tres")
        material = load(jobs["material"])
    shape.material_override = material
    camera.look_at_from_position(Vector3(0, 0, 9), Vector3(0, 0, 0), Vector3(0, 1, 0))
    for frame in range(2):  # a material of the editor makes its shader when it is drawn
        yield(get_tree(), "idle_frame")
    var code = code_of(material).strip_edges()
    code = code.substr(0, code.find_last("}"))
    for job in jobs["jobs"]:
        var columns = job["columns"]
        shape.transform = Transform(vector(columns[0]), vector(columns[1]), vector(columns[2]),
            Vector3(0, 0, 0))
        camera.look_at_from_position(vector(job["eye"]), vector(job["target"]), Vector3(0, 1, 0))
        shape.material_override = with_code(
            material, code.replace("render_mode ", "render_mode " + job["modes"]) + job["end"])
        for frame in range(3):
            yield(get_tree(), "idle_frame")
        var image = get_viewport().get_texture().get_data()
        image.flip_y()
        image.convert(Image.FORMAT_RGBA8)
        var out = File.new()
        out.open("res://" + job["name"] + ".bin", File.WRITE)
        out.store_buffer(image.get_data())
        out.close()
    get_tree().quit()
