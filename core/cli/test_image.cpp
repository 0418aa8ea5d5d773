#include "cli/test_image.h"

#include <cmath>
#include <mutex>

#include "base/checksum.h"
#include "cli/arguments.h"
#include "cli/identity.h"
#include "cli/meshes.h"

namespace wrinkle::cli {
namespace {

// Opens the mesh of a render case; a path is resolved like the image paths of the graph. Returns
// std::nullopt and reports an error on failure.
std::optional<Mesh> mesh_of(const RenderCase& render, const Project& project,
                            const CommonOptions& common, Diagnostics& diagnostics) {
    const std::string& name = render.options.mesh;
    if (!is_mesh_path(name)) return open_mesh(name, common, diagnostics);
    if (const auto path = resolve_file(project, 0, name))
        return open_mesh(path->string(), common, diagnostics);
    report_at(render.mesh, RuleId::outside_root,
              "mesh names " + json_quoted(name) + ", outside the root",
              "keep it below " + project.root.string() + ", or choose another root with --root",
              diagnostics);
    return {};
}

// Returns the name of the driver, from a context that is made for it; "" if there is none.
std::string driver_name() {
    static std::once_flag once;
    static std::string name;
    std::call_once(once, [] {
        Diagnostics ignored;
        auto context = gpu::Context::offscreen(ignored);
        if (!context || !context->make_current()) return;
        name = gpu::Context::renderer_name();
        context->release_current();
    });
    return name;
}

// An 8-bit image as fields: width, height, channels, values from 0 to 255.
std::string entry_of(const Image& image) {
    std::string bytes;
    for (const float value : image.data)
        bytes += static_cast<char>(std::lround(value * 255));
    return join_fields({std::to_string(image.width), std::to_string(image.height),
                        std::to_string(image.channels), bytes});
}

std::optional<Image> image_of(const std::string& entry) {
    const auto fields = split_fields(entry);
    uint32_t size[3];
    if (!fields || fields->size() != 4) return {};
    for (size_t i = 0; i < 3; ++i)
        if (!parse_number((*fields)[i], size[i]) || size[i] == 0) return {};
    const std::string& bytes = (*fields)[3];
    if (bytes.size() / size[0] / size[1] != size[2] || bytes.size() % size[0] != 0) return {};
    Image image = make_image(size[0], size[1], size[2], PixelType::u8);
    if (image.data.size() != bytes.size()) return {};
    for (size_t i = 0; i < bytes.size(); ++i)
        image.data[i] = static_cast<float>(static_cast<unsigned char>(bytes[i])) / 255;
    return image;
}

DrawnCase draw(const TestCase& test, const CaseMaterial& material, Diagnostics& diagnostics) {
    DrawnCase drawn;
    const RenderOptions& options = test.render->options;
    const auto still =
        mesh_of(*test.render, material.screen->project, material.common, diagnostics);
    std::optional<Mesh> moved;
    if (still && options.displace)
        moved = displaced_mesh(*still, *material.given, material.textures, diagnostics);
    if (diagnostics.has_errors()) return drawn;
    Diagnostics environment;
    auto renderer = OffscreenRenderer::make(options, *still, environment);
    if (!renderer) {
        drawn.environment = environment.list().front().message;
        return drawn;
    }
    drawn.driver = gpu::Context::renderer_name();
    if (moved) renderer->show(*moved);
    auto rendered = renderer->draw(material.shader, material.textures, diagnostics);
    if (rendered) drawn.image = std::move(rendered->image);
    return drawn;
}

}  // namespace

DrawnCase draw_case(const TestCase& test, const CaseMaterial& material, Cache* cache,
                    const std::string& inputs, Diagnostics& diagnostics) {
    if (!cache || driver_name().empty()) return draw(test, material, diagnostics);
    const std::string key = sha256(join_fields({"image", inputs, driver_name()}));
    if (const auto entry = cache->find(key))
        if (auto image = image_of(*entry)) return {std::move(image), driver_name(), ""};
    DrawnCase drawn = draw(test, material, diagnostics);
    std::string ignored;  // a cache that cannot be written only costs time
    if (drawn.image) cache->store(key, entry_of(*drawn.image), ignored);
    return drawn;
}

}  // namespace wrinkle::cli
