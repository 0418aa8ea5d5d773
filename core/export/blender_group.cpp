#include "export/blender_group.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.h"
#include "export/blender_nodes.h"
#include "export/computed_outputs.h"
#include "export/textures.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

// Returns true if an input of the Principled BSDF is the output itself.
bool is_direct(const BakedMaterial& baked, std::string_view output) {
    if (output == "color") return !baked.find("base_weight") && !baked.find("coat_weight");
    if (output == "roughness") return !baked.find("specular_roughness_anisotropy");
    constexpr std::string_view others[] = {"metalness", "opacity", "transmission_weight",
                                           "subsurface_weight", "subsurface_color"};
    return std::ranges::count(others, output) > 0;
}

// The images that values of the module read, by the index of their resource.
std::map<uint32_t, ExportedTexture> copied_images(const Module& module, const fs::path& folder,
                                                  Diagnostics& diagnostics) {
    std::set<uint32_t> read;
    const std::vector<bool> reached = reachable(module);
    for (Id id = 1; id < module.size(); ++id)
        if (reached[id] && module[id].op == Op::sample_) read.insert(module[id].extra);
    Reflection reflection;
    for (const uint32_t index : read) {
        const Resource& resource = module.resources[index];
        SamplerInfo sampler;
        sampler.name = resource.name;
        sampler.file = resource.file;
        sampler.options = resource.options;
        reflection.samplers.push_back(sampler);
    }
    std::map<uint32_t, ExportedTexture> images;
    const auto copies = copy_textures(reflection, folder, diagnostics);
    if (copies.size() != read.size()) return images;
    size_t at = 0;
    for (const uint32_t index : read)
        images[index] = copies[at++];
    return images;
}

std::string setting_of(const ExportedTexture& image) {
    const bool is_nearest = image.options.filter == Filter::nearest;
    const bool is_clamped = image.options.wrap == Wrap::clamp;
    return "{\"image\": " + json_quoted(image.file) + ", \"space\": \"" +
           (image.srgb ? "sRGB" : "Non-Color") + "\", \"interpolation\": \"" +
           (is_nearest ? "Closest" : "Linear") + "\", \"extension\": \"" +
           (is_clamped ? "EXTEND" : "REPEAT") + "\"}";
}

std::string socket_type(int size, bool is_color) {
    const char* type = size == 1 ? "Float" : is_color ? "Color" : "Vector";
    return "\"NodeSocket" + std::string(type) + "\"";
}

class GroupWriter {
public:
    GroupWriter(const ExportRequest& request, const Types& types, BlenderGroup& group)
        : request_(request), types_(types), group_(group) {}

    void add_input(const Parameter& parameter) {
        const auto& inputs = request_.project.files[0].document.inputs;
        const auto found = std::ranges::find(inputs, parameter.port, &GraphInput::name);
        const Port& port = types_.graph_input(0, static_cast<size_t>(found - inputs.begin()));
        const int size = info(parameter.type).lanes;
        const bool is_color = found->type == "color";
        const std::string& label = found->label.empty() ? found->name : found->label;
        std::vector<double> value(parameter.value.begin(), parameter.value.begin() + size);
        if (size > 1) value.resize(is_color ? 4 : 3, is_color ? 1 : 0);
        const std::string numbers = joined(value, ", ", number);
        const bool has_range = std::isfinite(port.soft_min) && std::isfinite(port.soft_max) &&
                               port.has_soft_range() && size == 1;
        group_.input_labels.push_back(label);
        group_.inputs_text +=
            "    (" + json_quoted(label) + ", " + socket_type(size, is_color) + ", " +
            (size == 1 ? numbers : "(" + numbers + ")") + ", " +
            (has_range ? "(" + number(port.soft_min) + ", " + number(port.soft_max) + ")"
                       : "None") +
            "),\n";
    }

    void add_output(const std::string& name, int size, const std::string& link) {
        group_.outputs.insert(name);
        group_.outputs_text += "    (\"" + name + "\", " +
                               socket_type(size, name.ends_with("color")) + ", " + link + "),\n";
    }

private:
    static std::string number(double value) { return shortest(static_cast<float>(value)); }

    const ExportRequest& request_;
    const Types& types_;
    BlenderGroup& group_;
};

}  // namespace

BlenderGroup blender_group(const ExportRequest& request, const BakedMaterial& baked,
                           const fs::path& folder, Diagnostics& diagnostics) {
    BlenderGroup group;
    Types types(request.project, request.registry);
    Module lowered = module_for_nodes(request, types, diagnostics);
    if (diagnostics.has_errors()) return group;
    const BlenderNodes all(lowered, {});
    const Module module = computed_outputs(lowered, [&](const ModuleOutput& output) {
                              return is_direct(baked, output.name) && all.has(output.value);
                          }).module;
    const auto images = copied_images(module, folder, diagnostics);
    if (diagnostics.has_errors()) return group;
    for (const auto& [index, image] : images)
        group.files.insert(image.file);
    BlenderNodes nodes(module, [&](uint32_t resource) { return setting_of(images.at(resource)); });
    GroupWriter writer(request, types, group);
    for (const ModuleOutput& output : module.outputs)
        if (!module.is_constant(output.value))
            writer.add_output(output.name, info(module.type(output.value)).lanes,
                              nodes.link(output.value));
    for (const uint32_t index : nodes.inputs())
        writer.add_input(module.parameters[index]);
    group.nodes_text = nodes.rows();
    return group;
}

}  // namespace wrinkle
