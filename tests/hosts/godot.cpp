#include "hosts/godot.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "hosts/pass.h"
#include "image/stored.h"

namespace wrinkle::test {
namespace {
namespace fs = std::filesystem;

constexpr const char* project = R"(config_version=4
[application]
run/main_scene="res://main.tscn"
[rendering]
quality/driver/driver_name="GLES3"
quality/driver/fallback_to_gles2=false
)";

constexpr const char* scene = R"([gd_scene load_steps=2 format=2]
[ext_resource path="res://main.gd" type="Script" id=1]
[node name="Main" type="Node"]
script = ExtResource( 1 )
)";

// jobs.txt has a line per job: its name, then the name and the texture flags of each image.
constexpr const char* godot_script = R"(extends Node
func _ready():
    var file = File.new()
    file.open("res://image.bin", File.READ)
    var image = Image.new()
    image.create_from_data(64, 64, true, Image.FORMAT_RGBAH, file.get_buffer(file.get_len()))
    var view = Viewport.new()
    view.size = Vector2(64, 64)
    view.usage = Viewport.USAGE_2D
    view.hdr = false
    view.render_target_update_mode = Viewport.UPDATE_ALWAYS
    add_child(view)
    var sheet = ColorRect.new()
    sheet.rect_size = Vector2(64, 64)
    view.add_child(sheet)
    file.open("res://jobs.txt", File.READ)
    while not file.eof_reached():
        var words = file.get_line().split(" ", false)
        if words.size() == 0: continue
        var text = File.new()
        text.open("res://" + words[0] + ".shader", File.READ)
        sheet.material = ShaderMaterial.new()
        sheet.material.shader = Shader.new()
        print("drawing ", words[0])
        sheet.material.shader.code = text.get_as_text()
        for i in range(1, words.size(), 2):
            var texture = ImageTexture.new()
            texture.create_from_image(image, int(words[i + 1]))
            sheet.material.set_shader_param(words[i], texture)
        for frame in range(3):
            yield(get_tree(), "idle_frame")
        var drawn = view.get_texture().get_data()
        drawn.convert(Image.FORMAT_RGBA8)
        drawn.flip_y()
        var out = File.new()
        out.open("res://" + words[0] + ".bin", File.WRITE)
        out.store_buffer(drawn.get_data())
        out.close()
    get_tree().quit()
)";

int flags_of(const TextureOptions& options) {
    constexpr int mipmaps = 1, repeat = 2, filter = 4, mirrored_repeat = 32;
    return mipmaps | (options.wrap == Wrap::repeat ? repeat : 0) |
           (options.wrap == Wrap::mirror ? mirrored_repeat : 0) |
           (options.filter == Filter::nearest ? 0 : filter);
}

void write_image(const fs::path& path) {
    std::ofstream file(path, std::ios::binary);
    for (const Image& level : pass_picture().levels)
        for (const float value : level.data) {
            const uint16_t half = half_from_float(value);
            file.put(static_cast<char>(half & 0xFF)).put(static_cast<char>(half >> 8));
        }
}

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::map<std::string, std::vector<uint8_t>> run_in_godot(const std::vector<GodotJob>& jobs,
                                                         const fs::path& folder, std::string& log) {
    std::ofstream(folder / "project.godot") << project;
    std::ofstream(folder / "main.tscn") << scene;
    std::ofstream(folder / "main.gd") << godot_script;
    write_image(folder / "image.bin");
    std::ofstream list(folder / "jobs.txt");
    for (const GodotJob& job : jobs) {
        std::ofstream(folder / (job.name + ".shader")) << job.shader;
        list << job.name;
        for (const SamplerInfo& sampler : job.samplers)
            list << ' ' << sampler.name << ' ' << flags_of(sampler.options);
        list << '\n';
    }
    list.close();
    const std::string command = "timeout 300 xvfb-run -a godot3 --path " + folder.string() +
                                " --no-window >" + (folder / "log").string() + " 2>&1";
    if (std::system(command.c_str()) != 0) log = "godot3 did not end well; ";
    log += read(folder / "log");
    std::map<std::string, std::vector<uint8_t>> results;
    for (const GodotJob& job : jobs) {
        const std::string bytes = read(folder / (job.name + ".bin"));
        results[job.name].assign(bytes.begin(), bytes.end());
    }
    return results;
}

}  // namespace wrinkle::test
