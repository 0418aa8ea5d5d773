// MaterialX: a document of an open_pbr_surface. Outputs are nodes of the standard library if it has
// them, else baked maps.
#include <algorithm>
#include <cmath>
#include <set>

#include "base/standard_outputs.h"
#include "base/text.h"
#include "export/baked_material.h"
#include "export/computed_outputs.h"
#include "export/files.h"
#include "export/hosts.h"
#include "export/mtlx_flatten.h"
#include "export/mtlx_textures.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

bool has_input(const StandardOutput& row) {
    return row.name != "occlusion" && row.name != "height" && row.type != "vec3";
}

std::string type_of(const StandardOutput& row) {
    return row.type == "color" ? "color3" : row.type == "normal" ? "vector3" : "float";
}

class MtlxExport {
public:
    MtlxExport(const ExportRequest& request, const fs::path& folder, Diagnostics& diagnostics)
        : request_(request),
          types_(request.project, request.registry),
          folder_(folder),
          diagnostics_(diagnostics),
          textures_(folder, diagnostics),
          nodes_(document_, "NG_" + request.name) {}

    bool run() {
        if (!lower_graph() || !bake()) return false;
        document_.set(0, "version", "1.39");
        document_.set(0, "colorspace", "lin_rec709");
        shader_ = document_.add(0, "open_pbr_surface", request_.name + "_shader");
        document_.set(shader_, "type", "surfaceshader");
        MtlxFlattener flattener(
            module_, nodes_, [&](const Parameter& parameter) { return interface_of(parameter); },
            [&](uint32_t resource) { return textures_.copy(module_.resources[resource].file); });
        flattener_ = &flattener;
        for (const StandardOutput& row : standard_output_table)
            write(row);
        add_material();
        if (diagnostics_.has_errors()) return false;
        return write_export_file(folder_ / (request_.name + ".mtlx"),
                                 materialx::write_document(document_), diagnostics_) &&
               write_readme(request_, "MaterialX", readme(), folder_, diagnostics_);
    }

private:
    bool lower_graph() {
        Module module = module_for_nodes(request_, types_, diagnostics_);
        if (diagnostics_.has_errors()) return false;
        const MtlxSupport support(module);
        std::erase_if(module.outputs, [&](const ModuleOutput& output) {
            const StandardOutput* row = find_standard_output(output.name);
            if (row && has_input(*row)) return false;
            warn_unsupported(request_, "MaterialX", output.name, diagnostics_);
            return true;
        });
        ComputedOutputs divided = computed_outputs(module, [&](const ModuleOutput& output) {
            const bool is_normal = find_standard_output(output.name)->type == "normal";
            return is_normal ? support.has_normal(output.value) : support.has(output.value);
        });
        module_ = std::move(divided.module);
        baked_ = std::move(divided.baked);
        return true;
    }

    bool bake() {
        if (!baked_.empty()) material_ = bake_outputs(request_, diagnostics_);
        return baked_.empty() || material_;
    }

    const ModuleOutput* computed(std::string_view name) const {
        const auto found = std::ranges::find(module_.outputs, name, &ModuleOutput::name);
        return found == module_.outputs.end() ? nullptr : &*found;
    }

    bool has(const char* name) const { return computed(name) || baked_.contains(name); }

    void write(const StandardOutput& row) {
        const std::string name(row.name);
        if (name == "emission_luminance" && has("emission") && !has("emission_luminance"))
            return set_value(shader_input(row), mtlx_text({nits_of_unit_emission}));
        const ModuleOutput* output = computed(name);
        if (!output && !baked_.contains(name)) return;
        const std::vector<double> constant =
            output ? mtlx_constant(module_, output->value) : baked_constant(row);
        if (name == "thin_walled") return write_thin_walled(row, constant);
        if (!constant.empty()) return set_value(input_of(row), text_of(row, constant));
        const std::string node = output ? node_of(row, output->value) : baked_node(row);
        if (!node.empty()) nodes_.connect_outside(input_of(row), type_of(row), node);
    }

    static std::string text_of(const StandardOutput& row, std::vector<double> numbers) {
        if (row.type == "color" && numbers.size() == 1) numbers.resize(3, numbers[0]);
        return mtlx_text(numbers);
    }

    void set_value(uint32_t input, const std::string& value) {
        document_.set(input, "value", value);
    }

    uint32_t shader_input(const StandardOutput& row, const std::string& type) {
        const std::string_view name = row.synonym.empty() ? row.name : row.synonym;
        const uint32_t input = document_.add(shader_, "input", std::string(name));
        document_.set(input, "type", type);
        return input;
    }
    uint32_t shader_input(const StandardOutput& row) { return shader_input(row, type_of(row)); }

    uint32_t input_of(const StandardOutput& row) {
        if (row.name != "displacement") return shader_input(row);
        displacement_ = document_.add(0, "displacement", request_.name + "_displacement");
        document_.set(displacement_, "type", "displacementshader");
        const uint32_t input = document_.add(displacement_, "input", "displacement");
        document_.set(input, "type", "float");
        return input;
    }

    // A boolean, which does not vary over the surface.
    void write_thin_walled(const StandardOutput& row, const std::vector<double>& constant) {
        if (constant.empty()) warn_unsupported(request_, "MaterialX", row.name, diagnostics_);
        if (!constant.empty())
            set_value(shader_input(row, "boolean"), constant[0] > 0.5 ? "true" : "false");
    }

    std::string node_of(const StandardOutput& row, Id value) {
        if (row.type == "normal") return flattener_->normal(value);
        return row.type == "color" ? flattener_->color(value) : flattener_->node(value);
    }

    std::vector<double> baked_constant(const StandardOutput& row) const {
        const BakedOutput* output = material_->find(row.name);
        if (!output || !output->constant || row.type == "normal") return {};
        return {output->value.begin(), output->value.begin() + output->channels};
    }

    std::string baked_node(const StandardOutput& row) {
        const std::string name(row.name), file = request_.name + "_" + name;
        const BakedOutput& output = *material_->find(name);
        const bool is_normal = row.type == "normal";
        const MtlxTextures::Map map =
            is_normal ? textures_.save_normal(*material_, file, output)
                      : textures_.save(*material_, file, output, row.type == "color");
        const std::string image = nodes_.add("image", name + "_map", type_of(row));
        nodes_.write_file(image, map.file, map.is_srgb);
        if (!is_normal) return image;
        const std::string normal = nodes_.add("normalmap", name + "_normalmap", "vector3");
        nodes_.connect(normal, "in", "vector3", image);
        return normal;
    }

    // An exposed input of the graph as an input of the node graph.
    std::string interface_of(const Parameter& parameter) {
        const auto& inputs = request_.project.files[0].document.inputs;
        const auto found = std::ranges::find(inputs, parameter.port, &GraphInput::name);
        const Port& port = types_.graph_input(0, static_cast<size_t>(found - inputs.begin()));
        const int size = info(parameter.type).lanes;
        std::vector<materialx::Attribute> attributes;
        const auto add = [&](const char* name, const std::string& value) {
            if (!value.empty()) attributes.push_back({name, value});
        };
        const auto all = [&](double number) {
            return mtlx_text(std::vector<double>(static_cast<size_t>(size), number));
        };
        add("uiname", found->label);
        add("uifolder", found->group);
        add("doc", port.doc);
        if (std::isfinite(port.soft_min) && std::isfinite(port.soft_max) && port.has_soft_range())
            add("uisoftmin", all(port.soft_min)), add("uisoftmax", all(port.soft_max));
        const std::string value =
            mtlx_text({parameter.value.begin(), parameter.value.begin() + size});
        inputs_.push_back(parameter.port);
        if (found->type != "color")
            return nodes_.add_interface(parameter.port, mtlx_type(size), value, attributes);
        const std::string color = nodes_.add_interface(parameter.port, "color3", value, attributes);
        const std::string vector = nodes_.add("convert", parameter.port + "_vector", "vector3");
        nodes_.connect(vector, "in", "color3", color);
        flattener_->add_color(vector, color);
        return vector;
    }

    void add_material() {
        const uint32_t material = document_.add(0, "surfacematerial", request_.name);
        document_.set(material, "type", "material");
        const auto connect = [&](const char* type, uint32_t element) {
            const uint32_t input = document_.add(material, "input", type);
            document_.set(input, "type", type);
            document_.set(input, "nodename", document_[element].name);
        };
        connect("surfaceshader", shader_);
        if (displacement_ != materialx::no_element) connect("displacementshader", displacement_);
    }

    std::string readme() const;

    const ExportRequest& request_;
    Types types_;
    const fs::path& folder_;
    Diagnostics& diagnostics_;
    MtlxTextures textures_;
    materialx::Document document_;
    MtlxNodes nodes_;
    Module module_;                // the outputs that nodes compute
    std::set<std::string> baked_;  // the other outputs
    std::optional<BakedMaterial> material_;
    MtlxFlattener* flattener_ = nullptr;
    std::vector<std::string> inputs_;  // inputs of the node graph
    uint32_t shader_ = 0, displacement_ = materialx::no_element;
};

std::string MtlxExport::readme() const {
    std::string text = request_.name + R"(.mtlx is a MaterialX 1.39 document with the material )" +
                       request_.name + R"(, an
open_pbr_surface of nodes of the standard library. Open it in a program that reads MaterialX, or
view it in MaterialX's own viewer:

    MaterialXView --material )" +
                       request_.name + R"(.mtlx

Images are files in textures/, relative to the document, with the origin of uv at the bottom left.
Normal maps have green up and need a mesh with tangents.
)";
    if (!baked_.empty())
        text += "\nBaked for the uv layout of " + request_.mesh_name + ": " +
                joined(std::vector<std::string>(baked_.begin(), baked_.end()), ", ") + ".\n";
    if (!inputs_.empty()) text += "\nInputs of the node graph: " + joined(inputs_, ", ") + ".\n";
    return text;
}

}  // namespace

bool write_materialx(const ExportRequest& request, const fs::path& folder,
                     Diagnostics& diagnostics) {
    return MtlxExport(request, folder, diagnostics).run();
}

}  // namespace wrinkle
