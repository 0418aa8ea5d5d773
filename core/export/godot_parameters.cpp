// Parameters of a shader of Godot: exposed inputs of the graph, with hints for the inspector.
#include <algorithm>
#include <cmath>

#include "base/srgb.h"
#include "base/text.h"
#include "export/godot.h"
#include "ir/op.h"
#include "lower/types.h"

namespace wrinkle {
namespace {

std::string value_text(double number) {
    const std::string text = shortest(static_cast<float>(number));
    return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

// "A( 1.0, 2.0 )" of the first `count` values.
std::string vector_text(std::string_view type, const std::array<double, 4>& values, size_t count) {
    std::string text(type);
    for (size_t i = 0; i < count; ++i)
        text += (i == 0 ? "(" : ", ") + value_text(values[i]);
    return text + ")";
}

class InspectorParameters {
public:
    InspectorParameters(const ExportRequest& request, const GodotVersion& version)
        : document_(request.project.files[0].document),
          types_(request.project, request.registry),
          three_(version.major == 3) {}

    GodotParameter of(const UniformInfo& uniform) const {
        const size_t lanes = info(uniform.type).lanes;
        const std::string type(info(uniform.type).name);
        GodotParameter made{uniform.name, "uniform " + type + " " + uniform.name, {}, {}};
        if (is_color(uniform)) return color(std::move(made), uniform);
        if (lanes == 1) {
            made.declaration += range(uniform) + " = " + value_text(uniform.value[0]);
            made.value = value_text(uniform.value[0]);
            return made;
        }
        made.declaration += " = " + vector_text(type, uniform.value, lanes);
        const std::string four = three_ ? "Plane" : "Vector4";
        const std::string constructor = lanes == 4 ? four : "Vector" + std::to_string(lanes);
        made.value = vector_text(constructor, uniform.value, lanes);
        return made;
    }

private:
    const GraphInput* input(const UniformInfo& uniform) const {
        for (const GraphInput& input : document_.inputs)
            if (uniform.graph_input && input.name == uniform.port) return &input;
        return nullptr;
    }
    bool is_color(const UniformInfo& uniform) const {
        const GraphInput* found = input(uniform);
        return found && found->type == "color" && info(uniform.type).lanes == 3;
    }

    // Godot decodes colors of the inspector from sRGB. Godot 3 does so for vec4 only, and not for
    // the value in the shader.
    GodotParameter color(GodotParameter made, const UniformInfo& uniform) const {
        std::array<double, 4> coded = uniform.value;
        for (double& channel : coded)
            channel = srgb_from_linear(channel);
        coded[3] = 1;
        made.value = vector_text("Color", coded, 4);
        if (!three_) {
            made.declaration += " : source_color = " + vector_text("vec3", coded, 3);
            return made;
        }
        std::array<double, 4> linear = uniform.value;
        linear[3] = 1;
        made.declaration =
            "uniform vec4 " + made.name + " : hint_color = " + vector_text("vec4", linear, 4);
        made.expression = made.name + ".rgb";
        return made;
    }

    std::string range(const UniformInfo& uniform) const {
        const GraphInput* found = input(uniform);
        if (!found) return "";
        const auto index = static_cast<size_t>(found - &*document_.inputs.begin());
        const Port& port = types_.graph_input(0, index);
        double low = port.soft_min, high = port.soft_max;
        if (!port.has_soft_range()) low = port.hard_min, high = port.hard_max;
        if (!(low < high) || !std::isfinite(low) || !std::isfinite(high)) return "";
        low = std::min(low, uniform.value[0]), high = std::max(high, uniform.value[0]);
        return " : hint_range(" + value_text(low) + ", " + value_text(high) + ")";
    }

    const Document& document_;
    Types types_;
    bool three_;
};

}  // namespace

std::vector<GodotParameter> godot_parameters(const ExportRequest& request,
                                             const GodotVersion& version,
                                             const GodotShader& shader) {
    const InspectorParameters parameters(request, version);
    std::vector<GodotParameter> made;
    for (const UniformInfo& uniform : shader.inputs)
        made.push_back(parameters.of(uniform));
    return made;
}

}  // namespace wrinkle
