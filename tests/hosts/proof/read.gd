extends Spatial
# Draws each job of jobs.json, a shader on the mesh, and writes its image as bytes.
func vector(list):
    return Vector3(list[0], list[1], list[2])

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
    shape.mesh = load("res://mesh.tres")
    add_child(shape)
    for job in jobs["jobs"]:
        var columns = job["columns"]
        shape.transform = Transform(vector(columns[0]), vector(columns[1]), vector(columns[2]),
            Vector3(0, 0, 0))
        camera.look_at_from_position(vector(job["eye"]), vector(job["target"]), Vector3(0, 1, 0))
        var material = load(jobs["material"]).duplicate()
        var shader = Shader.new()
        file.open("res://" + job["name"] + ".txt", File.READ)
        shader.code = file.get_as_text()
        file.close()
        material.shader = shader
        shape.material_override = material
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
