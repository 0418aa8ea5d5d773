// wrinkle render FILE -o OUT: renders a graph on a mesh.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "base/file.h"
#include "base/printable.h"
#include "base/standard_outputs.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/meshes.h"
#include "cli/offscreen_renderer.h"
#include "cli/output.h"
#include "image/load.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

struct RenderCommand {
    CommonOptions common;
    std::string file, output;
    RenderOptions render;
    std::string size = "512x512", view = "shaded";
    std::string lighting = "ggx", phong, environment, camera;
    std::string mood, background, tone = "neutral";

    int run() const {
        gpu::Context::prefer_quick_programs();
        RenderOptions options = render;
        if (const std::string why = read_options(options); !why.empty())
            return fail(exit_usage, why);
        Diagnostics diagnostics;
        bool double_sided = false;
        std::vector<std::string> read;
        const auto drawn_on = open_mesh(render.mesh, common, diagnostics, &read, &double_sided);
        if (!environment.empty()) read.push_back(environment);
        if (!environment.empty())
            if (auto image = load_environment(environment, diagnostics))
                options.environment = std::move(*image);
        const Nodes nodes = load_nodes(common, diagnostics);
        const Overrides overrides = parse_overrides(common, diagnostics);
        if (overrides.is_sweep() && output == "-")
            return fail(exit_usage, "a sweep makes several images; standard output takes one");
        std::vector<Shader> shaders;
        std::vector<Mesh> meshes;
        TextureStore textures;
        const auto use = [&](size_t i, const MaterialRun& run, Diagnostics& problems) {
            if (i == 0) refuse_overwriting(run.project, nodes, overrides, read, problems);
            read_textures(textures, run.compiled, run.project, problems);
            shaders.push_back(emit_function(run, material_name(file), problems));
        };
        compile_runs(file, common, nodes.registry, overrides, {.runs_calls = "render"}, use,
                     diagnostics, double_sided ? render.mesh : "");
        if (render.displace && !diagnostics.has_errors())
            meshes = displaced(*drawn_on, nodes, overrides, textures, diagnostics);
        const int code = report(diagnostics, common.diagnostics);
        if (code != exit_success) return code;
        return draw(shaders, *drawn_on, meshes, textures, options, overrides);
    }

    void refuse_overwriting(const Project& project, const Nodes& nodes, const Overrides& overrides,
                            std::vector<std::string> read, Diagnostics& diagnostics) const {
        const std::vector<std::string> inputs = input_paths(project, nodes.registry);
        read.insert(read.end(), inputs.begin(), inputs.end());
        std::vector<std::string> paths;
        for (size_t i = 0; i < overrides.runs; ++i)
            paths.push_back(path_of_run(output, overrides, i));
        if (const std::string why = overwrite_fault_of_run(paths, read); !why.empty())
            diagnostics.error(RuleId::output_path, why);
    }

    // Returns the displaced mesh of each run; stops at the first error.
    std::vector<Mesh> displaced(const Mesh& still, const Nodes& nodes, const Overrides& overrides,
                                TextureStore& textures, Diagnostics& diagnostics) const {
        std::vector<Mesh> meshes;
        const auto use = [&](size_t, const MaterialRun& run, Diagnostics& problems) {
            if (problems.has_errors()) return;
            read_textures(textures, run.compiled, run.project, problems);
            auto mesh = displaced_mesh(still, run, textures, problems);
            if (mesh) meshes.push_back(std::move(*mesh));
        };
        compile_runs(file, common, nodes.registry, overrides,
                     {.given_differentials = true, .runs_calls = "eval"}, use, diagnostics);
        return meshes;
    }

    // Returns one sentence on wrong usage, otherwise "".
    std::string read_options(RenderOptions& options) const {
        options.view = gpu::view_named(view).value_or(gpu::View::output);
        if (options.view == gpu::View::output) options.output = output_name(view);
        options.tone = *gpu::tone_named(tone);
        options.behind = behind();
        options.mood = gpu::mood_named(mood).value_or(gpu::Mood::studio);
        options.lighting = lighting == "phong" ? gpu::Lighting::phong : gpu::Lighting::ggx;
        const std::string type = fs::path(output).extension().string();
        if (!parse_size(size, max_rendered_side, options.width, options.height))
            return "--size " + size + " is not a size such as 512 or 640x480, at most 16384 a side";
        if (!options.against.empty() && options.view != gpu::View::difference)
            return "--against goes with --view difference";
        if (options.view != gpu::View::shaded && !(environment.empty() && phong.empty()))
            return "--environment and --phong go with --view shaded";
        if (!environment.empty() && !mood.empty())
            return "--environment and --light exclude each other";
        if (!camera.empty() && !(options.eye = parse_camera(camera)))
            return "--camera " + camera + ": expected YAW,PITCH[,DISTANCE] such as 30,15,0.8";
        if (!(std::abs(options.exposure) <= 32) || !(std::abs(options.turn) <= 3600))
            return "--exposure takes -32 to 32 EV, --turn -3600 to 3600 degrees";
        if (!phong.empty() && options.lighting != gpu::Lighting::phong)
            return "--phong goes with --lighting phong";
        if (!phong.empty() && !parse_phong(phong, options.phong))
            return "--phong " + phong + " is not KA,KD,KS,SHININESS such as 0.1,0.7,0.4,32";
        if (!environment.empty() && options.lighting != gpu::Lighting::ggx)
            return "--environment goes with --lighting ggx; Phong's light reflects nothing";
        if (output != "-" && type != ".png" && type != ".jpg" && type != ".jpeg" &&
            type != ".tif" && type != ".tiff")
            return output + ": an image is written as .png, .jpg or .tif";
        return "";
    }

    gpu::Behind behind() const {
        if (background == "plain") return gpu::Behind::plain;
        if (background == "studio") return gpu::Behind::studio;
        return background.empty() && environment.empty() ? gpu::Behind::studio
                                                         : gpu::Behind::environment;
    }

    // Renders and saves the image of each run; returns the exit code. `still` determines the
    // camera; with --displace, run i is drawn on displaced[i].
    int draw(const std::vector<Shader>& shaders, const Mesh& still,
             const std::vector<Mesh>& displaced, const TextureStore& textures,
             const RenderOptions& options, const Overrides& overrides) const {
        Diagnostics environment, diagnostics;
        auto renderer = OffscreenRenderer::make(options, still, environment);
        if (!renderer) {
            report(environment, common.diagnostics);
            return exit_environment;
        }
        for (size_t i = 0; i < shaders.size(); ++i) {
            if (options.displace) renderer->show(displaced[i]);
            const auto drawn = renderer->draw(shaders[i], textures, diagnostics);
            if (!drawn) return report(diagnostics, common.diagnostics);
            const std::string path = path_of_run(output, overrides, i);
            if (!save(drawn->image, path)) return exit_environment;
            if (options.view == gpu::View::difference) print(drawn->angles, path);
        }
        return exit_success;
    }

    bool save(const Image& image, const std::string& path) const {
        Diagnostics environment;
        const bool saved = path == "-" ? save_to_stdout(image, environment)
                                       : save_image(image, path, {}, environment);
        if (!saved) report(environment, common.diagnostics);
        return saved;
    }

    // Writes a PNG through a temporary file, because the image library only writes files.
    static bool save_to_stdout(const Image& image, Diagnostics& environment) {
        std::error_code none, ignored;
        std::string folder = (fs::temp_directory_path(none) / "wrinkle-XXXXXX").string();
        if (none || !mkdtemp(folder.data())) {
            environment.error(RuleId::environment, "a temporary folder cannot be made: " + folder);
            return false;
        }
        const fs::path path = fs::path(folder) / "image.png";
        std::string why;
        std::optional<std::string> bytes;
        if (save_image(image, path, {}, environment)) bytes = read_file(path, why);
        fs::remove_all(folder, ignored);
        return bytes && write_result("-", std::move(*bytes)) == exit_success;
    }

    void print(const gpu::AngleStatistics& angles, const std::string& path) const {
        std::fprintf(path == "-" ? stderr : stdout, "%s: mean %.4f degrees, max %.4f degrees\n",
                     printable(path).c_str(), angles.mean_degrees, angles.max_degrees);
    }
};

}  // namespace

void declare_render(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<RenderCommand>(app, run, "render", "Renders a graph");
    sub.add_option("FILE", c.file, "A graph; - reads standard input")->required();
    sub.add_option("-o", c.output, "The image: .png, .jpg or .tif; - is standard output")
        ->type_name("OUT")
        ->required();
    declare_mesh(sub, c.render.mesh, "Mesh: ");
    sub.add_option("--size", c.size, "Size of the image in pixels: N or WxH")
        ->capture_default_str();
    sub.add_option("--view", c.view,
                   "Shown: " + joined(gpu::view_names(), ", ") + ", or an output by its name")
        ->type_name("VIEW")
        ->capture_default_str();
    sub.add_option("--camera", c.camera,
                   "Camera: degrees around the mesh and above it, and a factor of "
                   "the distance that shows all of it")
        ->type_name("YAW,PITCH[,DISTANCE]");
    sub.add_flag("--displace", c.render.displace,
                 "Moves the mesh, in fine triangles, by the output 'displacement'");
    sub.add_option("--against", c.render.against,
                   "The output that the difference is taken against; "
                   "default: the normal without bumps")
        ->type_name("OUTPUT");
    add_choice(sub, "--lighting", c.lighting, gpu::lighting_names(), "Lighting of the shaded view");
    sub.add_option("--phong", c.phong, "Parameters of that lighting; default: 0.1,0.7,0.4,32")
        ->type_name("KA,KD,KS,SHININESS");
    add_choice(sub, "--light", c.mood, gpu::mood_names(), "Reflected by GGX; default: studio");
    sub.add_option("--environment", c.environment,
                   "Likewise, an equirectangular .hdr or .exr, its middle behind the object")
        ->type_name("FILE");
    sub.add_option("--turn", c.render.turn, "Rotation of the light around the object, in degrees")
        ->type_name("DEGREES");
    sub.add_option("--exposure", c.render.exposure, "Radiance is multiplied by 2^EV")
        ->type_name("EV");
    add_choice(sub, "--tone", c.tone, gpu::tone_names(), "The curve from radiance to display");
    add_choice(sub, "--background", c.background, {"studio", "environment", "plain"},
               "Behind the object: paper with its shadow, the light, or a plain gray; default: "
               "environment with --environment, else studio");
    declare_common(sub, c.common);
}

}  // namespace wrinkle::cli
