extends Spatial
# Draws the material of job.json on the mesh below an environment, and writes an image.
func _ready():
    var file = File.new()
    file.open("res://job.json", File.READ)
    var job = parse_json(file.get_as_text())
    file.close()
    var image = Image.new()
    image.load(job["environment"])
    var texture = ImageTexture.new()
    texture.create_from_image(image, Texture.FLAG_FILTER | Texture.FLAG_REPEAT)
    var sky = PanoramaSky.new()
    sky.panorama = texture
    sky.radiance_size = Sky.RADIANCE_SIZE_256
    var environment = Environment.new()
    environment.background_mode = Environment.BG_SKY
    environment.background_sky = sky
    var world = WorldEnvironment.new()
    world.environment = environment
    add_child(world)
    var camera = Camera.new()
    camera.near = 0.05
    camera.fov = job["field_of_view"]
    add_child(camera)
    camera.current = true
    camera.look_at_from_position(Vector3(job["eye"][0], job["eye"][1], job["eye"][2]),
        Vector3(0, 0, 0), Vector3(0, 1, 0))
    var shape = MeshInstance.new()
    shape.mesh = load("res://mesh.tres")
    shape.material_override = load(job["material"])
    add_child(shape)
    for frame in range(30):
        yield(get_tree(), "idle_frame")
    var drawn = get_viewport().get_texture().get_data()
    drawn.flip_y()
    drawn.convert(Image.FORMAT_RGB8)
    drawn.save_png(job["out"])
    get_tree().quit()
