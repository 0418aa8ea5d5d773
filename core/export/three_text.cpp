#include "export/three_text.h"

#include <algorithm>
#include <cctype>

#include "base/text.h"
#include "emit/language.h"
#include "export/host_text.h"
#include "export/texts.h"
#include "ir/op.h"
#include "json/parse.h"
#include "json/write.h"
#include "lower/exposed.h"

namespace wrinkle {
namespace {

std::string uniform_value(const ExportRequest& request, const UniformInfo& uniform) {
    const auto& inputs = request.project.top().inputs;
    const auto input = std::ranges::find(inputs, uniform.port, &GraphInput::name);
    const bool is_color = input != inputs.end() && input->type == "color";
    const auto lanes = static_cast<size_t>(info(uniform.type).lanes);
    if (lanes == 1) return shortest(uniform.value[0]);
    std::string list;
    for (size_t i = 0; i < lanes; ++i)
        append_item(list, shortest(uniform.value[i]));
    if (is_color) return "new THREE.Color(" + list + ")";
    return "new THREE.Vector" + std::to_string(lanes) + "(" + list + ")";
}

}  // namespace

std::string three_class(const std::string& name) {
    std::string made;
    bool upper = true;
    for (const char c : name) {
        if (c == '_') {
            upper = true;
            continue;
        }
        made += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        upper = false;
    }
    const bool begins_with_letter =
        !made.empty() && std::isalpha(static_cast<unsigned char>(made[0]));
    return (begins_with_letter ? "" : "M") + made + "Material";
}

std::string template_literal_text(std::string_view text) {
    std::string made;
    for (const char c : text) {
        if (c == '`' || c == '\\' || c == '$') made += '\\';
        made += c;
    }
    return made;
}

Shader three_displacement(const ExportRequest& request, const Reflection& reflection,
                          const Target& target, Diagnostics& diagnostics) {
    if (!has_output(reflection, "displacement")) return {};
    ShaderOptions options;
    options.outputs = {"displacement"};
    options.emit.name = request.name + "_vertex";
    options.emit.target = &target;
    options.emit.differentials = Differentials::none;
    return make_shader(request.project, request.registry, options, diagnostics).shader;
}

std::string three_uniforms(const ExportRequest& request, const Reflection& reflection) {
    std::string text = "{\n";
    for (const UniformInfo& uniform : reflection.uniforms)
        if (uniform.graph_input)
            text += "  " + json_quoted(uniform.port) +
                    ": {value: " + uniform_value(request, uniform) + "},\n";
    return text + "}";
}

std::string three_textures(const std::vector<ExportedTexture>& textures) {
    constexpr const char* wraps[] = {"RepeatWrapping", "ClampToEdgeWrapping",
                                     "MirroredRepeatWrapping"};
    std::string text;
    for (const ExportedTexture& texture : textures) {
        const auto flag = [](bool on) { return on ? "true" : "false"; };
        text += "\n  {uniform: " + json_quoted(texture.sampler) +
                ", file: " + json_quoted(texture.file) + ", float: " + flag(texture.is_float) +
                ", srgb: " + flag(texture.srgb) + ", wrap: THREE." +
                wraps[static_cast<size_t>(texture.options.wrap)] +
                ", nearest: " + flag(texture.options.filter == Filter::nearest) + "},";
    }
    return text;
}

std::string three_presets(const ExportRequest& request) {
    std::string text = "{";
    for (const Preset& preset : request.project.top().presets) {
        std::string values;
        for (const auto& [input, value] : preset_values(preset))
            append_item(values, json_quoted(input) + ": " + value);
        text += "\n  " + json_quoted(preset.name) + ": {" + values + "},";
    }
    return text + (text.size() > 1 ? "\n}" : "}");
}

std::string three_input_list(const MadeShader& made, const ExportRequest& request) {
    Diagnostics ignored;
    const std::string reflection = reflection_json(made.shader, request.project, request.registry);
    return json::pretty(json::parse(reflection, "reflection", ignored).root.find("inputs"));
}

std::string three_imports(const std::vector<ExportedTexture>& textures) {
    const bool floats = std::ranges::any_of(textures, &ExportedTexture::is_float);
    return floats ? "import {EXRLoader} from 'three/addons/loaders/EXRLoader.js';\n" : "";
}

std::string three_loader(const std::vector<ExportedTexture>& textures) {
    return textures.empty() ? "const load = () => ({});\n" : std::string(texts::three_images_js);
}

}  // namespace wrinkle
