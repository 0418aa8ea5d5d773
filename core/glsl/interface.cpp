#include "glsl/interface.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "glsl/blocks.h"

namespace wrinkle {
namespace {

std::string at_node(const std::string& path, const std::string& port) {
    return path.empty() ? port : path + "_" + port;
}

std::string node_path(const Module& m, uint32_t node) {
    return node < m.nodes.size() ? m.nodes[node].path : "";
}

void add_uniforms(const EmitAnalysis& analysis, Interface& face) {
    const Module& m = analysis.module();
    face.symbols.parameters.resize(m.parameters.size());
    for (uint32_t i = 0; i < m.parameters.size(); ++i) {
        if (!analysis.parameters_used[i]) continue;
        const Parameter& parameter = m.parameters[i];
        UniformInfo uniform;
        uniform.node = parameter.graph_input ? "" : node_path(m, parameter.node);
        uniform.name = face.globals.unique(
            at_node(parameter.graph_input ? "input" : uniform.node, parameter.port));
        uniform.type = parameter.type;
        uniform.value = parameter.value;
        uniform.port = parameter.port;
        uniform.graph_input = parameter.graph_input;
        uniform.parameter = i;
        face.symbols.parameters[i] = uniform.name;
        face.reflection.uniforms.push_back(std::move(uniform));
    }
}

// Returns the name hint of a sampler: node and port of the reader at the node of the first sample.
std::string sampler_name(const Module& m, const EmitAnalysis::UsedResource& used) {
    const auto& readers = m.resources[used.resource].readers;
    if (readers.empty()) return at_node(node_path(m, used.node), "image");
    auto reader = std::find_if(readers.begin(), readers.end(),
                               [&](const auto& r) { return r.node == used.node; });
    if (reader == readers.end()) reader = readers.begin();
    return at_node(node_path(m, reader->node), reader->port);
}

void add_samplers(const EmitAnalysis& analysis, Interface& face) {
    const Module& m = analysis.module();
    face.symbols.resources.resize(m.resources.size());
    for (const EmitAnalysis::UsedResource& used : analysis.resources) {
        const Resource& resource = m.resources[used.resource];
        SamplerInfo sampler;
        sampler.name = face.globals.unique(sampler_name(m, used));
        sampler.file = resource.file;
        sampler.written = resource.name;
        sampler.options = resource.options;
        sampler.resource = used.resource;
        for (const Resource::Reader& reader : resource.readers)
            sampler.readers.push_back({node_path(m, reader.node), reader.port});
        face.symbols.resources[used.resource] = sampler.name;
        face.reflection.samplers.push_back(std::move(sampler));
    }
}

MemberInfo member(SurfaceInput input, Variant variant) {
    return {member_name(input, variant), info(input).type, input, variant, false};
}

void add_members(const EmitAnalysis& analysis, bool given, Reflection& reflection) {
    for (int i = 0; i < surface_input_count; ++i) {
        const auto input = static_cast<SurfaceInput>(i);
        const auto used = [&](Variant variant) {
            return analysis.inputs_used[EmitAnalysis::input_slot(input, variant)];
        };
        const bool changes = used(Variant::dx) || used(Variant::dy);
        const bool relative = !given && changes && input == SurfaceInput::position_;
        if (used(Variant::value) || (!given && changes && !relative))
            reflection.members.push_back(member(input, Variant::value));
        if (relative)
            reflection.members.push_back(
                {"position_relative", Type::vec3_, input, Variant::value, true});
        for (const Variant variant : {Variant::dx, Variant::dy})
            if (given && used(variant)) reflection.members.push_back(member(input, variant));
    }
    if (!reflection.members.empty()) reflection.struct_name = "WrinkleSurface_" + reflection.name;
}

void add_functions(const EmitAnalysis& analysis, Interface& face) {
    const Module& m = analysis.module();
    const std::string prefix = "wrinkle_" + face.reflection.name + "_";
    for (const ModuleOutput& output : m.outputs)
        face.reflection.functions.push_back({output.name, face.globals.unique(prefix + output.name),
                                             m.type(output.value), output.port_type, -1, ""});
    face.symbols.functions.resize(m.region_count());
    for (const uint32_t region : analysis.functions)
        face.symbols.functions[region] = face.globals.unique(prefix + m.region(region).name);
}

void write_doc(const MemberInfo& member, std::string& line) {
    const std::string_view doc = info(member.input).doc;
    if (member.relative)
        line.append("position seen from the eye, object axes, length units");
    else if (member.variant != Variant::value)
        line.append("change of ")
            .append(info(member.input).name)
            .append(" to the next pixel in ")
            .append(member.variant == Variant::dx ? "x" : "y");
    else if (member.input == SurfaceInput::normal_)
        line.append("interpolated normal, object space, of any length but zero");
    else if (member.input == SurfaceInput::tangent_)
        line.append("interpolated tangent of uv0, object space; w: sign of the bitangent");
    else if (!doc.empty() && doc[0] >= 'A' && doc[0] <= 'Z')
        line.append(1, static_cast<char>(doc[0] - 'A' + 'a')).append(doc.substr(1));
    else
        line.append(doc);
}

constexpr size_t max_comment_column = 48;

// Lines of code with one comment each, appended in order.
struct CommentedLines {
    struct Ends {
        size_t code = 0, comment = 0;
        uint32_t node = no_node;
    };
    std::string code, comments;
    std::vector<Ends> ends;
    void end_line(uint32_t node = no_node) { ends.push_back({code.size(), comments.size(), node}); }
};

// Aligns the comments in one column. Lines wider than `farthest` do not move the column; their
// comments follow the code.
void write(const CommentedLines& lines, int indent, size_t farthest, Text& text) {
    size_t column = 0, code_begin = 0;
    for (const CommentedLines::Ends& ends : lines.ends) {
        const size_t width = ends.code - std::exchange(code_begin, ends.code);
        if (width <= farthest) column = std::max(column, width);
    }
    std::string line;
    CommentedLines::Ends begin;
    for (const CommentedLines::Ends& ends : lines.ends) {
        line.assign(lines.code, begin.code, ends.code - begin.code);
        line.resize(std::max(line.size(), column) + 2, ' ');
        line.append("// ");
        const std::string_view comments = lines.comments;
        append_comment_text(line, comments.substr(begin.comment, ends.comment - begin.comment));
        text.line(indent, line, ends.node);
        begin = ends;
    }
}

// Names of the shader form, taken in both forms so that a uniform has the same name in both.
const NameSet& fixed_names() {
    static const NameSet fixed = [] {
        NameSet names = NameSet::with_reserved_words();
        names.add({{}, "WrinkleFrame"});
        for (const char* name : {"object_to_clip", "object_to_world", "normal_to_world", "eye",
                                 "position_relative", "frame", "parameters"})
            names.add({"wrinkle", name});
        for (int i = 0; i < surface_input_count; ++i)
            names.add({"wrinkle", info(static_cast<SurfaceInput>(i)).name});
        return names;
    }();
    return fixed;
}

// Strips leading underscores: NAME always follows an underscore, and GLSL reserves double
// underscores.
std::string behind_underscores(const std::string& name) {
    return name.substr(std::min(name.find_first_not_of('_'), name.size()));
}

}  // namespace

Interface make_interface(const EmitAnalysis& analysis, const EmitOptions& options) {
    Interface face{NameSet(&fixed_names()), {}, {}};
    const Module& m = analysis.module();
    NameSet plain;
    face.reflection.target = options.target->name;
    face.reflection.name = plain.unique(behind_underscores(identifier(options.name)));
    face.globals.unique("WrinkleSurface_" + face.reflection.name);
    face.globals.unique("WrinkleParameters_" + face.reflection.name);
    add_functions(analysis, face);
    add_samplers(analysis, face);
    add_uniforms(analysis, face);
    add_members(analysis, options.differentials == Differentials::given, face.reflection);
    face.reflection.uniform_control_flow = analysis.implicit;
    face.reflection.node_paths.reserve(m.nodes.size());
    for (const NodeInstance& node : m.nodes)
        face.reflection.node_paths.push_back(node.path);
    return face;
}

Text reserve_text(const EmitAnalysis& analysis, uint64_t most) {
    constexpr size_t letters_a_value = 28, values_a_line = 2;  // estimates
    constexpr size_t outside = 1000;
    Text text;
    text.most = most;
    text.text.reserve(std::min<size_t>(letters_a_value * analysis.used_count() + outside, most));
    text.nodes.reserve(analysis.used_count() / values_a_line);
    return text;
}

void write_struct(const Reflection& reflection, Text& text) {
    if (reflection.struct_name.empty()) return;
    text.line(0, {"struct ", reflection.struct_name, " {"});
    CommentedLines lines;
    for (const MemberInfo& member : reflection.members) {
        lines.code.append(info(member.type).name).append(" ").append(member.name).append(";");
        write_doc(member, lines.comments);
        lines.end_line();
    }
    write(lines, 1, max_comment_column, text);
    text.line(0, "};");
}

void write_uniforms(const Module& module, const Reflection& reflection, Text& text) {
    CommentedLines lines;
    for (const SamplerInfo& sampler : reflection.samplers) {
        const std::string binding = binding_text(sampler.binding);
        lines.code.append(binding).append("uniform sampler2D ").append(sampler.name).append(";");
        lines.comments.append(sampler.written)
            .append(" (")
            .append(name_of(sampler.options.encoding));
        lines.comments.append(", ").append(name_of(sampler.options.wrap)).append(")");
        const auto& readers = module.resources[sampler.resource].readers;
        lines.end_line(readers.empty() ? no_node : readers.front().node);
    }
    const bool numbered = !reflection.samplers.empty() && reflection.samplers[0].binding.set >= 0;
    write(lines, 0, max_comment_column + (numbered ? 32 : 0), text);
    std::vector<Declaration> numbers;
    for (const UniformInfo& uniform : reflection.uniforms) {
        const Parameter& parameter = module.parameters[uniform.parameter];
        numbers.push_back({info(uniform.type).name, uniform.name, "",
                           parameter.graph_input ? no_node : parameter.node});
    }
    write_block(reflection.parameter_block, numbers, text);
}

void write_precision(const Target& target, Text& text) {
    for (const std::string_view line : split(target.precision, '\n'))
        if (!line.empty()) text.line(0, line);
}

std::string argument_text(const Reflection& reflection) {
    return reflection.struct_name.empty() ? "" : reflection.struct_name + " s";
}

void write_functions(const EmitAnalysis& analysis, const Interface& face, const Target& target,
                     Text& text) {
    const Module& m = analysis.module();
    Values values(analysis);
    for (const uint32_t region : analysis.functions) {
        text.line(0, "");
        Body(analysis, values, face.symbols, face.globals, target, text)
            .region_function(region, face.symbols.functions[region]);
    }
    const std::string argument = argument_text(face.reflection);
    for (size_t i = 0; i < m.outputs.size(); ++i) {
        text.line(0, "");
        Body(analysis, values, face.symbols, face.globals, target, text)
            .output_function(m.outputs[i].value, face.reflection.functions[i].function, argument);
    }
}

std::string title_of(const Module& module, const std::string& name) {
    const std::string& title = module.titles[module.nodes[0].title];
    return "// " + comment_text(title.empty() ? name : title) + ". Generated by Wrinkle.";
}

}  // namespace wrinkle
