#include "import/mtlx_shader.h"

#include <algorithm>
#include <cmath>

#include "base/standard_outputs.h"
#include "import/mtlx_interface.h"

namespace wrinkle::materialx {
namespace {

// One nit of white is this part of an emission of 1: graphs have 100 nits without a luminance.
constexpr double white_luminance = 100;

// An input that becomes an output. `otherwise` is the default of MaterialX; it is written where
// Wrinkle's differs, and if the input `lobe` is set ("": always).
struct Row {
    const char* input;
    const char* output;
    double otherwise;
    const char* lobe = "";
    double factor = 1;
    double power = 1;
};

// Inputs without an output, and the number at which they do nothing.
struct LostRow {
    const char* input;
    double neutral;
};

// Names of standard_surface 1.0.1; numbers as in its translation to open_pbr_surface in the
// MaterialX library, but for the emission and the tint of the base under a coat.
constexpr std::array standard_surface_rows = {
    Row{"base", "base_weight", 1},
    Row{"base_color", "color", 0.8},
    Row{"diffuse_roughness", "base_diffuse_roughness", 0},
    Row{"metalness", "metalness", 0},
    Row{"specular", "specular_weight", 1},
    Row{"specular_color", "specular_color", 1},
    Row{"specular_roughness", "roughness", 0.2},
    Row{"specular_IOR", "specular_ior", 1.5},
    Row{"specular_anisotropy", "specular_roughness_anisotropy", 0},
    Row{"transmission", "transmission_weight", 0},
    Row{"transmission_color", "transmission_color", 1},
    Row{"transmission_depth", "transmission_depth", 0},
    Row{"transmission_scatter", "transmission_scatter", 0},
    Row{"transmission_scatter_anisotropy", "transmission_scatter_anisotropy", 0},
    Row{"subsurface", "subsurface_weight", 0},
    Row{"subsurface_color", "subsurface_color", 1, "subsurface"},
    Row{"subsurface_radius", "subsurface_radius_scale", 1, "subsurface"},
    Row{"subsurface_scale", "subsurface_radius", 1},
    Row{"subsurface_anisotropy", "subsurface_scatter_anisotropy", 0},
    Row{"sheen", "fuzz_weight", 0},
    Row{"sheen_color", "fuzz_color", 1},
    Row{"sheen_roughness", "fuzz_roughness", 0.3, "sheen", 1, 0.4},
    Row{"coat", "coat_weight", 0},
    Row{"coat_color", "coat_color", 1},
    Row{"coat_roughness", "coat_roughness", 0.1, "coat"},
    Row{"coat_anisotropy", "coat_roughness_anisotropy", 0},
    Row{"coat_IOR", "coat_ior", 1.5, "coat"},
    Row{"thin_film_thickness", "thin_film_thickness", 0, "thin_film_thickness", 0.001},
    Row{"thin_film_IOR", "thin_film_ior", 1.5, "thin_film_thickness"},
    Row{"emission_color", "emission", 1},
    Row{"emission", "emission_luminance", 0, "emission_color", white_luminance},
    Row{"thin_walled", "thin_walled", 0},
    Row{"normal", "normal", 0},
    Row{"coat_normal", "coat_normal", 0},
    Row{"tangent", "tangent", 0},
};
constexpr std::array standard_surface_lost = {
    LostRow{"specular_rotation", 0},
    LostRow{"transmission_dispersion", 0},
    LostRow{"transmission_extra_roughness", 0},
    LostRow{"coat_rotation", 0},
    LostRow{"coat_affect_color", 0},
    LostRow{"coat_affect_roughness", 0},
};

// Names of gltf_pbr 2.0.1. Sheen's roughness is OpenPBR's to the power of 1.5.
constexpr std::array gltf_rows = {
    Row{"base_color", "color", 1},
    Row{"metallic", "metalness", 1},
    Row{"roughness", "roughness", 1},
    Row{"occlusion", "occlusion", 1},
    Row{"transmission", "transmission_weight", 0},
    Row{"specular", "specular_weight", 1},
    Row{"specular_color", "specular_color", 1},
    Row{"ior", "specular_ior", 1.5},
    Row{"iridescence", "thin_film_weight", 0},
    Row{"iridescence_ior", "thin_film_ior", 1.3, "iridescence"},
    Row{"iridescence_thickness", "thin_film_thickness", 100, "iridescence", 0.001},
    Row{"sheen_color", "fuzz_color", 0, "sheen_color"},
    Row{"sheen_roughness", "fuzz_roughness", 0, "sheen_color", 1, 2.0 / 3},
    Row{"clearcoat", "coat_weight", 0},
    Row{"clearcoat_roughness", "coat_roughness", 0},
    Row{"clearcoat_normal", "coat_normal", 0},
    Row{"emissive", "emission", 0, "emissive"},
    Row{"emissive_strength", "emission_luminance", 1, "emissive", white_luminance},
    Row{"attenuation_color", "transmission_color", 1},
    Row{"attenuation_distance", "transmission_depth", 0},
    Row{"dispersion", "transmission_dispersion_scale", 0},
    Row{"anisotropy_strength", "specular_roughness_anisotropy", 0},
    Row{"normal", "normal", 0},
    Row{"tangent", "tangent", 0},
};
constexpr std::array gltf_lost = {
    LostRow{"thickness", 0},
    LostRow{"anisotropy_rotation", 0},
};

// Names of open_pbr_surface are those of the outputs.
const std::vector<Row>& open_pbr_rows() {
    static const std::vector<Row> rows = [] {
        std::vector<Row> made;
        for (const StandardOutput& output : standard_output_table) {
            if (output.name == "occlusion" || output.type == "height") continue;
            const std::string_view name = output.synonym.empty() ? output.name : output.synonym;
            const double otherwise = output.value[0];
            made.push_back({name.data(), output.name.data(), otherwise, name.data()});
        }
        for (Row& row : made)  // a graph's emission without a luminance is not 0
            if (std::string_view(row.input) == "emission_luminance") row.lobe = "emission_color";
        return made;
    }();
    return rows;
}

class ShaderImport {
public:
    ShaderImport(Importer& importer, NodeKey shader)
        : importer_(importer),
          graph_(importer.graph()),
          shader_(shader),
          element_(importer.document()[shader.element]) {}

    void run(std::span<const Row> rows, std::span<const LostRow> lost) {
        for (const Row& row : rows)
            import_row(row);
        for (const uint32_t child : element_.children)
            check_place(child, rows, lost);
    }

    bool has(std::string_view input) const {
        return importer_.document().has_child(shader_.element, input);
    }

    Value value(std::string_view input, Type type, double otherwise) {
        const Source source = importer_.sources().input(shader_, input);
        Value found = importer_.value(source, type, NodeContext::filled(type, otherwise));
        graph_.begin(input);
        return found;
    }

    // A value that does not change becomes an exposed input.
    void set(std::string_view name, const Value& value) {
        const auto row = std::ranges::find(standard_output_table, name, &StandardOutput::name);
        if (value.is_bad) return;
        if (row->type == "normal") return set_normal(*row, value);
        if (value.bump || value.is_surface_normal) {
            importer_.report(
                shader_.element, Severity::error, RuleId::materialx_unsupported,
                "the output '" + std::string(name) + "' reads the numbers of a normal");
            return;
        }
        if (value.is_literal())
            graph_.output(name, graph_.expose(output_input(*row, value)));
        else
            graph_.output(name, graph_.wire(value));
    }
    void set(std::string_view name, double number) {
        set(name, NodeContext::filled(Type::float_, number));
    }

    GraphBuilder& graph() { return graph_; }
    Importer& importer() { return importer_; }
    uint32_t element() const { return shader_.element; }

private:
    static Type type_of(const StandardOutput& output) {
        if (output.type == "color") return Type::color3;
        return output.type == "float" || output.type == "height" ? Type::float_ : Type::vector3;
    }

    void import_row(const Row& row) {
        const auto output = std::ranges::find(standard_output_table, std::string_view(row.output),
                                              &StandardOutput::name);
        const Type type = type_of(*output);
        const bool is_given = has(row.input);
        if (!is_given && (type == Type::vector3 || !is_default_needed(row, *output))) return;
        Value found = value(row.input, type, row.otherwise);
        if (found.is_bad || (type == Type::vector3 && found.text == "tangent")) return;
        if (row.factor != 1 || row.power != 1) found = scaled(found, row);
        set(row.output, found);
    }

    bool is_default_needed(const Row& row, const StandardOutput& output) const {
        const std::string_view lobe = row.lobe;
        if (!lobe.empty() && (lobe == row.input || !has(lobe))) return false;
        const bool is_luminance = output.name == "emission_luminance";
        const bool is_uneven = output.name == "subsurface_radius_scale";
        return is_luminance || is_uneven || row.otherwise * row.factor != output.value[0] ||
               row.power != 1;
    }

    Value scaled(const Value& value, const Row& row) {
        Numbers parts;
        for (int i = 0; i < size_of(value.type); ++i) {
            Number part = graph_.part(value, i);
            if (row.power != 1) {
                if (part.is_literal())
                    part.value = std::pow(std::max(part.value, 0.0), row.power);
                else
                    part = graph_.math("power", {"base", "exponent"}, {part, {row.power}});
            }
            parts.push_back(graph_.multiply(part, {row.factor}));
        }
        return graph_.from_parts(value.type, parts);
    }

    void set_normal(const StandardOutput& row, const Value& value) {
        if (value.is_surface_normal) return;
        if (value.bump && !value.is_encoded_bump) {
            graph_.begin(row.name);
            graph_.output(row.name,
                          graph_.add("resolve", "normal", {wire_input("gradient", *value.bump)}));
            return;
        }
        importer_.report(shader_.element, Severity::error, RuleId::materialx_unsupported,
                         "the output '" + std::string(row.name) + "' is not made by a normalmap",
                         "a normalmap or a bump");
    }

    void check_place(uint32_t child, std::span<const Row> rows, std::span<const LostRow> lost) {
        const Element& input = importer_.document()[child];
        if (input.category != "input") return;
        const auto is_named = [&](const auto& row) { return row.input == input.name; };
        if (std::ranges::any_of(rows, is_named) || is_special(input.name)) return;
        const auto row = std::ranges::find_if(lost, is_named);
        const auto number = parse_value(Type::float_, input.attribute("value"));
        if (row != lost.end() && number && number->literal(0) == row->neutral) return;
        importer_.report(
            child, Severity::warning, RuleId::materialx_unsupported,
            element_.category + ": input '" + input.name + "' has no equivalent and is left out");
    }

    bool is_special(std::string_view input) const {
        if (element_.category == "standard_surface") return input == "opacity";
        if (element_.category == "gltf_pbr")
            return input == "alpha" || input == "alpha_mode" || input == "alpha_cutoff";
        return false;
    }

    Importer& importer_;
    GraphBuilder& graph_;
    NodeKey shader_;
    const Element& element_;
};

// A coat of standard_surface and of glTF does not darken the base.
void set_coat(ShaderImport& shader, const char* weight) {
    if (shader.has(weight)) shader.set("coat_darkening", 0);
}

void import_standard_surface(ShaderImport& shader) {
    shader.run(standard_surface_rows, standard_surface_lost);
    const Element& element = shader.importer().document()[shader.element()];
    if (element.attribute("version") == "1.0.0") {
        if (!shader.has("base")) shader.set("base_weight", 0.8);
        if (!shader.has("base_color")) shader.set("color", NodeContext::filled(Type::color3, 1));
    }
    set_coat(shader, "coat");
    GraphBuilder& graph = shader.graph();
    if (shader.has("thin_film_thickness")) {
        const Value thickness = shader.value("thin_film_thickness", Type::float_, 0);
        Value weight = NodeContext::filled(Type::float_, 1);
        if (thickness.is_literal())
            weight = NodeContext::filled(Type::float_, thickness.literal(0) > 0 ? 1 : 0);
        else if (!thickness.is_bad)
            weight = wire_value(Type::float_,
                                graph.add("compare", "result", {graph.input("a", thickness)}));
        shader.set("thin_film_weight", weight);
    }
    if (!shader.has("opacity")) return;
    const Value opacity = shader.value("opacity", Type::color3, 1);
    if (opacity.is_bad) return;
    if (opacity.is_literal() && opacity.literal(0) == opacity.literal(1) &&
        opacity.literal(0) == opacity.literal(2))
        return shader.set("opacity", opacity.literal(0));
    shader.importer().report(shader.element(), Severity::warning, RuleId::materialx_approximate,
                             "the opacity is the luminance of the color");
    shader.set("opacity", wire_value(Type::float_, graph.add("luminance", "value",
                                                             {graph.input("color", opacity)})));
}

void import_gltf(ShaderImport& shader) {
    shader.run(gltf_rows, gltf_lost);
    if (shader.has("sheen_color")) shader.set("fuzz_weight", 1);
    if (shader.has("clearcoat")) {
        shader.set("coat_ior", 1.5);
        set_coat(shader, "clearcoat");
    }
    if (shader.has("anisotropy_strength"))
        shader.importer().report(
            shader.element(), Severity::warning, RuleId::materialx_approximate,
            "the strength of the anisotropy is OpenPBR's, which is not glTF's");
    const Value mode = shader.value("alpha_mode", Type::integer, 0);
    if (!mode.is_literal() || mode.literal(0) == 0) return;
    const Value alpha = shader.value("alpha", Type::float_, 1);
    if (mode.literal(0) == 2) return shader.set("opacity", alpha);
    const Value cutoff = shader.value("alpha_cutoff", Type::float_, 0.5);
    if (alpha.is_bad || cutoff.is_bad) return;
    GraphBuilder& graph = shader.graph();
    shader.set("opacity", wire_value(Type::float_, graph.add("step", "result",
                                                             {graph.input("edge", cutoff),
                                                              graph.input("x", alpha)})));
}

}  // namespace

bool is_shader(std::string_view category) {
    return category == "standard_surface" || category == "gltf_pbr" ||
           category == "open_pbr_surface";
}

void import_shader(Importer& importer, NodeKey key) {
    ShaderImport shader(importer, key);
    const std::string_view category = importer.document()[key.element].category;
    if (category == "standard_surface") import_standard_surface(shader);
    if (category == "gltf_pbr") import_gltf(shader);
    if (category == "open_pbr_surface") shader.run(open_pbr_rows(), {});
}

// displacement * scale
void import_displacement(Importer& importer, NodeKey key) {
    ShaderImport shader(importer, key);
    const Value height = shader.value("displacement", Type::float_, 0);
    const Value scale = shader.value("scale", Type::float_, 1);
    if (height.is_bad || scale.is_bad) return;
    GraphBuilder& graph = shader.graph();
    shader.set("displacement",
               graph.from_parts(Type::float_,
                                {graph.multiply(graph.part(height, 0), graph.part(scale, 0))}));
}

}  // namespace wrinkle::materialx
