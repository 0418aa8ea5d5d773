// The spatial shader: the graph's functions, called with Godot's surface.
#include <algorithm>
#include <cctype>
#include <set>

#include "base/standard_outputs.h"
#include "compile/shader.h"
#include "emit/language.h"
#include "export/files.h"
#include "export/godot.h"
#include "ir/op.h"

namespace wrinkle {
namespace {

std::string type_text(Type type) {
    return std::string(info(type).name);
}

// Replaces identifiers of a text.
std::string with_words(std::string_view text, const std::map<std::string, std::string>& words) {
    const auto in_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    std::string result;
    for (size_t at = 0; at < text.size();) {
        size_t end = at;
        while (end < text.size() && in_word(text[end]))
            ++end;
        const std::string word(text.substr(at, end - at));
        const auto found = words.find(word);
        result += found == words.end() ? word : found->second;
        if (end < text.size()) result += text[end++];
        at = end;
    }
    return result;
}

// The declarations of uniforms, by name, and the identifiers in all other lines; a declaration that
// is "" is left out.
struct Rewriting {
    std::map<std::string, std::string> declarations, words;

    std::string apply(std::string_view source) const {
        std::string text;
        for (size_t at = 0; at < source.size();) {
            const size_t end = std::min(source.find('\n', at), source.size());
            const std::string_view line = source.substr(at, end - at);
            at = end + 1;
            text +=
                line.starts_with("uniform ") ? declaration(line) : with_words(line, words) + "\n";
        }
        return text;
    }

private:
    std::string declaration(std::string_view line) const {
        const size_t end = line.find(';');
        const std::string_view declared = line.substr(0, end);
        const std::string_view head = declared.substr(0, declared.find(" :"));
        const std::string name(head.substr(head.rfind(' ') + 1));
        const auto found = declarations.find(name);
        if (found == declarations.end()) return std::string(line) + "\n";
        if (found->second.empty()) return "";
        return found->second + std::string(line.substr(end)) + "\n";
    }
};

// Inputs and images of the displacement's text that the material's text declares too.
Rewriting shared_names(const Reflection& fragment, const Reflection& vertex) {
    Rewriting rewriting;
    const auto share = [&](const std::string& name, const std::string& shared) {
        rewriting.declarations[name] = "";
        rewriting.words[name] = shared;
    };
    for (const UniformInfo& uniform : vertex.uniforms)
        for (const UniformInfo& other : fragment.uniforms)
            if (uniform.graph_input && other.graph_input && uniform.port == other.port)
                share(uniform.name, other.name);
    for (const SamplerInfo& sampler : vertex.samplers)
        for (const SamplerInfo& other : fragment.samplers)
            if (sampler.file == other.file && sampler.options == other.options &&
                !rewriting.words.contains(sampler.name))
                share(sampler.name, other.name);
    return rewriting;
}

struct GodotCompiler {
    const ExportRequest& request;
    const GodotVersion& version;
    Diagnostics& diagnostics;

    // Names of the graph's outputs.
    std::vector<std::string> output_names() const {
        MaterialOptions options;
        options.vertex_tangents = !request.mesh.tangents.empty();
        const Compiled compiled =
            compile_or_check(request.project, request.registry, options, diagnostics);
        std::vector<std::string> names;
        if (compiled.ok)
            for (const ModuleOutput& output : compiled.module.outputs)
                names.push_back(output.name);
        return names;
    }

    Shader make(const std::string& name, std::vector<std::string> outputs,
                Differentials differentials) const {
        ShaderOptions options;
        options.material.vertex_tangents = !request.mesh.tangents.empty();
        options.emit.differentials = differentials;
        options.emit.name = name;
        options.emit.target = find_target(version.target);
        options.emit.uv_origin = UvOrigin::top;
        options.emit.normal_space = NormalSpace::view;
        options.outputs = std::move(outputs);
        return make_shader(request.project, request.registry, options, diagnostics).shader;
    }

    void warn_of(const std::vector<std::string>& outputs) const {
        for (const std::string& output : outputs)
            if (output != "height" && output != "displacement" && !godot_takes(output) &&
                find_standard_output(output))
                warn_unsupported(request, version.label, output, diagnostics);
    }

    bool check_uv_sets(const Shader& shader) const {
        if (version.major > 3) return true;
        for (const MemberInfo& member : shader.reflection.members)
            if (member.input == SurfaceInput::uv2_ || member.input == SurfaceInput::uv3_)
                diagnostics.add(file_problem(
                    Severity::error, RuleId::host_lacks, request.graph,
                    "the graph reads " + member.name + "; meshes of Godot 3 have uv0 and uv1",
                    "use uv0 or uv1, or export to Godot 4"));
        return !diagnostics.has_errors();
    }

    std::optional<GodotShader> run() const {
        const std::vector<std::string> outputs = output_names();
        if (diagnostics.has_errors()) return {};
        warn_of(outputs);
        std::vector<std::string> taken;
        std::ranges::copy_if(outputs, std::back_inserter(taken), godot_takes);
        GodotShader shader;
        if (!taken.empty()) shader.fragment = make(request.name, taken, Differentials::screen);
        if (std::ranges::count(outputs, "displacement") > 0)
            shader.vertex = make("vertex_" + request.name, {"displacement"}, Differentials::none);
        if (diagnostics.has_errors() || !check_uv_sets(shader.fragment)) return {};
        if (shader.vertex && !check_uv_sets(*shader.vertex)) return {};
        gather(shader);
        return shader;
    }

    static void gather(GodotShader& shader) {
        const auto add = [&](const Reflection& reflection, const Rewriting& shared) {
            for (const SamplerInfo& sampler : reflection.samplers)
                if (!shared.declarations.contains(sampler.name)) shader.samplers.push_back(sampler);
            for (const UniformInfo& uniform : reflection.uniforms)
                if (!shared.declarations.contains(uniform.name)) shader.inputs.push_back(uniform);
        };
        add(shader.fragment.reflection, {});
        if (!shader.vertex) return;
        const Rewriting shared =
            shared_names(shader.fragment.reflection, shader.vertex->reflection);
        add(shader.vertex->reflection, shared);
        shader.vertex->source = shared.apply(shader.vertex->source);
    }
};

// Varyings from vertex() to fragment(), and the arguments of the functions.
class Stages {
public:
    Stages(const ExportRequest& request, const GodotVersion& version, const GodotShader& shader)
        : request_(request), version_(version), shader_(shader) {}

    std::string text() {
        const std::string pixel = fragment();
        const std::string displaced = shader_.vertex ? displacement() : "";
        std::string declarations;
        for (const std::string& varying : varyings_)
            declarations += "varying " + varying + ";\n";
        return declarations + "\nvoid vertex() {\n" + vertex_ + displaced +
               "}\n\nvoid fragment() {\n" + pixel + "}\n";
    }

private:
    std::string own(std::string_view name) const { return request_.name + "_" + std::string(name); }

    // Declares a varying that vertex() sets; returns its name.
    std::string varying(const std::string& type, std::string_view name, const std::string& value) {
        if (varyings_.insert(type + " " + own(name)).second)
            vertex_ += "    " + own(name) + " = " + value + ";\n";
        return own(name);
    }

    std::string eye() const {
        const std::string world(version_.object_to_world), camera(version_.view_to_world);
        return "(inverse(" + world + ") * vec4(" + camera + "[3].xyz, 1.0)).xyz";
    }
    std::string from_eye() { return varying("vec3", "from_eye", "VERTEX - " + eye()); }
    std::string to_view() {
        const std::string world(version_.object_to_world), view(version_.world_to_view);
        return varying("mat3", "to_view", "mat3(" + view + ") * mat3(" + world + ")");
    }
    static std::string tangent() {
        return "vec4(TANGENT, dot(cross(NORMAL, TANGENT), BINORMAL) < 0.0 ? -1.0 : 1.0)";
    }

    // An argument in fragment().
    std::string argument(const MemberInfo& member) {
        if (member.normal_matrix) return "normal_matrix";
        switch (member.input) {
            case SurfaceInput::position_:
                return member.relative ? from_eye() : varying("vec3", "position", "VERTEX");
            case SurfaceInput::normal_:
                return varying("vec3", "normal", "NORMAL");
            case SurfaceInput::tangent_:
                return varying("vec4", "tangent", tangent());
            case SurfaceInput::uv0_:
                return "UV";
            case SurfaceInput::uv1_:
                return "UV2";
            case SurfaceInput::uv2_:
                return varying("vec4", "uv2_uv3", "CUSTOM0") + ".xy";
            case SurfaceInput::uv3_:
                return varying("vec4", "uv2_uv3", "CUSTOM0") + ".zw";
            case SurfaceInput::color0_:
                return "COLOR";
            case SurfaceInput::view_:
                return "view";
            default:
                return "facing";
        }
    }

    // An argument in vertex(), of the surface before it is displaced.
    std::string vertex_argument(const MemberInfo& member) const {
        switch (member.input) {
            case SurfaceInput::position_:
                return member.relative ? "VERTEX - " + eye() : "VERTEX";
            case SurfaceInput::normal_:
                return "NORMAL";
            case SurfaceInput::tangent_:
                return tangent();
            case SurfaceInput::uv0_:
                return "UV";
            case SurfaceInput::uv1_:
                return "UV2";
            case SurfaceInput::uv2_:
                return "CUSTOM0.xy";
            case SurfaceInput::uv3_:
                return "CUSTOM0.zw";
            case SurfaceInput::color0_:
                return "COLOR";
            case SurfaceInput::view_:
                return "normalize(" + eye() + " - VERTEX)";
            default:
                return "1.0";
        }
    }

    std::string displacement() const {
        const Reflection& reflection = shader_.vertex->reflection;
        const auto argument = [&](const MemberInfo& member) { return vertex_argument(member); };
        std::string text;
        const std::string height = called(reflection, argument, "shape", text).at("displacement");
        return text + "    VERTEX += normalize(NORMAL) * " + height + ";\n";
    }

    // Appends a call of the function to `text`; returns the expressions of its outputs.
    template <class Argument>
    static std::map<std::string, std::string> called(const Reflection& reflection,
                                                     Argument argument, const std::string& result,
                                                     std::string& text) {
        std::map<std::string, std::string> values;
        std::string arguments;
        const auto append = [&](const std::string& each) {
            arguments += (arguments.empty() ? "" : ", ") + each;
        };
        if (!reflection.struct_name.empty()) {
            text += "    " + reflection.struct_name + " surface;\n";
            for (const MemberInfo& member : reflection.members)
                text += "    surface." + member.name + " = " + argument(member) + ";\n";
            append("surface");
        } else {
            for (const MemberInfo& member : reflection.members)
                append(argument(member));
        }
        const bool parameters = reflection.result_form == ResultForm::parameters;
        for (const OutputInfo& output : reflection.outputs) {
            if (parameters) {
                text += "    " + type_text(output.type) + " " + output.member + ";\n";
                append(output.member);
            }
            values[output.output] =
                parameters ? output.member : output_text(reflection, output, result);
        }
        const std::string taken = parameters ? "" : result_type(reflection) + " " + result + " = ";
        text += "    " + taken + reflection.function + "(" + arguments + ");\n";
        return values;
    }

    std::string fragment() {
        const Reflection& reflection = shader_.fragment.reflection;
        if (reflection.outputs.empty()) return {};  // the graph has outputs of other hosts only
        std::string call;
        const auto values = called(
            reflection, [&](const MemberInfo& member) { return argument(member); }, "material",
            call);
        const std::string assigned =
            godot_assignments(version_, values, values.contains("tangent") ? to_view() : "");
        std::string before;
        const auto reads = [&](auto is) { return std::ranges::any_of(reflection.members, is); };
        if (reads([](const MemberInfo& m) { return m.input == SurfaceInput::view_; }))
            before += view();
        const bool facing = reads([](const MemberInfo& m) {
            return !m.normal_matrix && m.input == SurfaceInput::facing_;
        });
        const bool matrix = reads([](const MemberInfo& m) { return m.normal_matrix; });
        if (facing || matrix) before += orientation(facing, matrix);
        return before + call + assigned;
    }

    // An orthogonal camera looks along its axis everywhere.
    std::string view() {
        const std::string across = "inverse(" + to_view() + ") * vec3(0.0, 0.0, 1.0)";
        std::string seen = "-" + from_eye();
        return "    vec3 view = normalize(PROJECTION_MATRIX[3][3] == 0.0 ? " + seen + " : " +
               across + ");\n";
    }

    // The transposed inverse of to_view without its determinant's size. FRONT_FACING is not
    // corrected for mirrored objects (godot#93705).
    std::string orientation(bool facing, bool matrix) {
        const std::string m = to_view();
        std::string text = "    float mirrored = determinant(" + m + ") < 0.0 ? -1.0 : 1.0;\n";
        if (matrix)
            text += "    mat3 normal_matrix = mat3(cross(" + m + "[1], " + m + "[2]), cross(" + m +
                    "[2], " + m + "[0]),\n            cross(" + m + "[0], " + m +
                    "[1])) * mirrored;\n";
        if (facing) text += "    float facing = FRONT_FACING ? mirrored : -mirrored;\n";
        return text;
    }

    const ExportRequest& request_;
    const GodotVersion& version_;
    const GodotShader& shader_;
    std::set<std::string> varyings_;
    std::string vertex_;
};

}  // namespace

std::optional<GodotShader> compile_for_godot(const ExportRequest& request,
                                             const GodotVersion& version,
                                             Diagnostics& diagnostics) {
    return GodotCompiler{request, version, diagnostics}.run();
}

std::string godot_shader_text(const ExportRequest& request, const GodotVersion& version,
                              const GodotShader& shader,
                              const std::vector<GodotParameter>& parameters,
                              const std::vector<GodotTexture>& textures) {
    Rewriting rewriting;
    for (const GodotParameter& parameter : parameters) {
        rewriting.declarations[parameter.name] = parameter.declaration;
        if (!parameter.expression.empty()) rewriting.words[parameter.name] = parameter.expression;
    }
    for (const GodotTexture& texture : textures)
        rewriting.declarations[texture.sampler] =
            "uniform sampler2D " + texture.sampler +
            (texture.hints.empty() ? "" : " : " + texture.hints);
    const auto has = [&](std::string_view name) {
        return std::ranges::any_of(shader.fragment.reflection.outputs,
                                   [&](const OutputInfo& output) { return output.output == name; });
    };
    std::string text = "shader_type spatial;\nrender_mode diffuse_lambert, specular_schlick_ggx";
    if (has("opacity")) text += ", " + std::string(version.alpha_mode);
    if (has("opacity") || request.double_sided) text += ", cull_disabled";
    text += ";\n\n" + rewriting.apply(shader.fragment.source) + "\n";
    if (shader.vertex) text += rewriting.apply(shader.vertex->source) + "\n";
    return text + Stages(request, version, shader).text();
}

}  // namespace wrinkle
