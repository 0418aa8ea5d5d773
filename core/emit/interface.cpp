#include "emit/interface.h"

#include <algorithm>
#include <utility>

#include "base/standard_outputs.h"
#include "base/text.h"
#include "emit/blocks.h"

namespace wrinkle {
namespace {

// Strips underscores at both ends: a part of a global name has one before it, and GLSL reserves
// double underscores.
std::string without_underscores(const std::string& name) {
    const size_t first = name.find_first_not_of('_');
    if (first == name.npos) return {};
    return name.substr(first, name.find_last_not_of('_') + 1 - first);
}

// Returns a new global name: NAME_NODE_PORT, or NAME_PORT for the graph itself. Characters that
// names cannot hold are dropped; "n" if none is left.
std::string global_name(Interface& face, const std::string& node, const std::string& port) {
    std::string own = without_underscores(identifier(node.empty() ? port : node + "_" + port));
    if (own.empty()) own = "n";
    return face.globals.unique(face.reflection.name + "_" + own);
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
        uniform.name =
            global_name(face, parameter.graph_input ? "input" : uniform.node, parameter.port);
        uniform.type = parameter.type;
        uniform.value = parameter.value;
        uniform.port = parameter.port;
        uniform.graph_input = parameter.graph_input;
        uniform.parameter = i;
        face.symbols.parameters[i] = uniform.name;
        face.reflection.uniforms.push_back(std::move(uniform));
    }
}

// Names a sampler by node and port of the reader at the node of the first sample.
std::string sampler_name(const Module& m, const EmitAnalysis::UsedResource& used, Interface& face) {
    const auto& readers = m.resources[used.resource].readers;
    if (readers.empty()) return global_name(face, node_path(m, used.node), "image");
    auto reader = std::find_if(readers.begin(), readers.end(),
                               [&](const auto& r) { return r.node == used.node; });
    if (reader == readers.end()) reader = readers.begin();
    return global_name(face, node_path(m, reader->node), reader->port);
}

void add_samplers(const EmitAnalysis& analysis, Interface& face) {
    const Module& m = analysis.module();
    face.symbols.resources.resize(m.resources.size());
    for (const EmitAnalysis::UsedResource& used : analysis.resources) {
        const Resource& resource = m.resources[used.resource];
        SamplerInfo sampler;
        sampler.name = sampler_name(m, used, face);
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

void add_constants(const EmitAnalysis& analysis, Interface& face) {
    for (const Id id : analysis.constants)
        face.symbols.constants[id] = global_name(face, "", analysis.name(id)->name);
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
    const bool world_or_view = reflection.normal_space == NormalSpace::world ||
                               reflection.normal_space == NormalSpace::view;
    if (world_or_view && has_normals(reflection))
        reflection.members.push_back(
            {.name = "normal_matrix", .type = Type::mat3_, .normal_matrix = true});
}

void add_functions(const EmitAnalysis& analysis, const EmitOptions& options, Interface& face) {
    const Module& m = analysis.module();
    Reflection& r = face.reflection;
    const Language& language = options.target->language();
    const bool flat = language.arguments == Arguments::flat;
    r.function = face.globals.unique("wrinkle_" + r.name);
    r.result_form = options.bare_result ? ResultForm::value
                    : flat              ? ResultForm::parameters
                                        : ResultForm::structure;
    if (r.result_form == ResultForm::structure) r.result_name = "WrinkleMaterial_" + r.name;
    NameSet members(&language.reserved);
    const std::string prefix = r.result_form == ResultForm::parameters ? "out_" : "";
    for (const ModuleOutput& output : m.outputs)
        r.outputs.push_back({output.name, members.unique(prefix + output.name),
                             m.type(output.value), output.port_type, -1, ""});
    face.symbols.prefix = r.function;
    face.symbols.functions.resize(m.region_count());
    face.symbols.resource_parameters.resize(m.region_count());
    face.symbols.resource_arguments.resize(m.region_count());
    for (const uint32_t region : analysis.functions)
        face.symbols.functions[region] =
            face.globals.unique(r.function + "_" + m.region(region).name);
}

void write_doc(const MemberInfo& member, const Reflection& reflection, std::string& line) {
    const std::string_view doc = info(member.input).doc;
    const bool top = reflection.uv_origin == UvOrigin::top;
    if (member.normal_matrix)
        line.append("transposed inverse of the matrix from object to ")
            .append(name_of(reflection.normal_space))
            .append(" space");
    else if (member.relative)
        line.append("position seen from the eye, object axes, length units");
    else if (member.variant != Variant::value)
        line.append("change of ")
            .append(info(member.input).name)
            .append(" to the next pixel in ")
            .append(member.variant == Variant::dx ? "x" : "y");
    else if (member.input == SurfaceInput::normal_)
        line.append("interpolated normal, object space, of any length but zero");
    else if (member.input == SurfaceInput::tangent_)
        line.append("interpolated tangent of uv0, object space; ")
            .append(top ? "w N x T points up in images" : "w: sign of the bitangent");
    else if (member.input == SurfaceInput::uv0_ && top)
        line.append("first uv set, origin at the top left");
    else if (!doc.empty() && doc[0] >= 'A' && doc[0] <= 'Z')
        line.append(1, static_cast<char>(doc[0] - 'A' + 'a')).append(doc.substr(1));
    else
        line.append(doc);
}

// Returns the comment of an output; "" for one without a standard name. Only normals are in the
// reflection's space.
std::string output_doc(const OutputInfo& output, const Reflection& reflection) {
    const StandardOutput* standard = find_standard_output(output.output);
    if (!standard) return {};
    std::string doc(standard->doc);
    constexpr std::string_view object = "object space";
    const size_t at = doc.find(object);
    if (at != doc.npos && standard->type == "normal")
        doc.replace(at, object.size(), std::string(name_of(reflection.normal_space)) + " space");
    return doc;
}

constexpr size_t max_comment_column = 48;

// Lines of code with a comment each, which may be empty, appended in order.
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
        if (ends.comment > begin.comment) {
            if (column > 0) line.resize(std::max(line.size(), column) + 2, ' ');
            line.append("// ");
            const std::string_view comments = lines.comments;
            append_comment_text(line, comments.substr(begin.comment, ends.comment - begin.comment));
        }
        text.line(indent, line, ends.node);
        begin = ends;
    }
}

void write_struct(const Language& language, const std::string& name, const CommentedLines& members,
                  Text& text) {
    if (name.empty()) return;
    text.line(0, filled(language.structure, {{'n', name}}));
    write(members, 1, max_comment_column, text);
    text.line(0, language.end_structure);
}

}  // namespace

Interface make_interface(const EmitAnalysis& analysis, const EmitOptions& options) {
    const Language& language = options.target->language();
    Interface face{NameSet(&language.reserved), {}, {}};
    const Module& m = analysis.module();
    NameSet plain(&language.reserved);
    face.reflection.target = options.target->name;
    face.reflection.uv_origin = options.uv_origin;
    if (options.form == Form::function) face.reflection.normal_space = options.normal_space;
    face.reflection.name = plain.unique(without_underscores(identifier(options.name)));
    for (const std::string kind :
         {"Surface_", "Material_", "Parameters_", "Vertex_", "Varyings_", "Targets_"})
        face.globals.unique("Wrinkle" + kind + face.reflection.name);
    add_functions(analysis, options, face);
    add_samplers(analysis, face);
    add_uniforms(analysis, face);
    add_constants(analysis, face);
    add_members(analysis, options.differentials == Differentials::given, face.reflection);
    if (!face.reflection.members.empty() && language.arguments == Arguments::structs)
        face.reflection.struct_name = "WrinkleSurface_" + face.reflection.name;
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

// Writes the comments of struct members for languages without structs.
static void write_parameter_docs(const Reflection& reflection, Text& text) {
    for (const MemberInfo& member : reflection.members) {
        std::string doc;
        write_doc(member, reflection, doc);
        text.line(0, {"//   ", member.name, ": ", doc});
    }
    if (reflection.result_form != ResultForm::parameters) return;
    for (const OutputInfo& output : reflection.outputs) {
        const std::string doc = output_doc(output, reflection);
        if (!doc.empty()) text.line(0, {"//   ", output.member, ": ", doc});
    }
}

void write_structs(const Language& language, const Reflection& reflection, Text& text) {
    CommentedLines lines;
    for (const MemberInfo& member : reflection.members) {
        append_filled(lines.code, language.member,
                      {{'t', language.type(member.type)}, {'n', member.name}});
        write_doc(member, reflection, lines.comments);
        lines.end_line();
    }
    write_struct(language, reflection.struct_name, lines, text);
    if (language.arguments == Arguments::flat) write_parameter_docs(reflection, text);
    lines = {};
    for (const OutputInfo& output : reflection.outputs) {
        append_filled(lines.code, language.member,
                      {{'t', language.type(output.type)}, {'n', output.member}});
        lines.comments.append(output_doc(output, reflection));
        lines.end_line();
    }
    write_struct(language, reflection.result_name, lines, text);
}

void write_uniforms(const Module& module, const Language& language, const Reflection& reflection,
                    Text& text) {
    CommentedLines lines;
    for (const SamplerInfo& sampler : reflection.samplers) {
        const auto& readers = module.resources[sampler.resource].readers;
        const uint32_t node = readers.empty() ? no_node : readers.front().node;
        const bool as_stored = sampler.options.srgb == SrgbDecoder::shader &&
                               sampler.options.encoding == Encoding::srgb;
        const std::string declaration = filled(
            language.image,
            {{'n', sampler.name},
             {'s', std::to_string(sampler.binding.set)},
             {'b', std::to_string(sampler.binding.binding)},
             {'l', std::to_string(sampler.sampler_binding)},
             {'h', sampler.options.decodes_texels() ? language.srgb_hint : std::string_view()}});
        lines.comments.append(declaration.empty() ? sampler.name + ": " : "")
            .append(sampler.written)
            .append(" (")
            .append(name_of(sampler.options.encoding))
            .append(as_stored ? " as stored, " : ", ")
            .append(name_of(sampler.options.wrap))
            .append(")");
        for (const std::string_view line : split(declaration, '\n')) {
            lines.code.append(line);
            lines.end_line(node);
        }
    }
    const bool numbered = !reflection.samplers.empty() && reflection.samplers[0].binding.set >= 0;
    write(lines, 0, max_comment_column + (numbered ? 32 : 0), text);
    std::vector<Declaration> numbers;
    for (const UniformInfo& uniform : reflection.uniforms) {
        const Parameter& parameter = module.parameters[uniform.parameter];
        numbers.push_back({language.type(uniform.type), uniform.name, "", uniform.offset,
                           parameter.graph_input ? no_node : parameter.node});
    }
    write_block(language, reflection.parameter_block, numbers, text);
}

void write_precision(const Target& target, Text& text) {
    for (const std::string_view line : split(target.precision, '\n'))
        if (!line.empty()) text.line(0, line);
}

static std::string constant_text(const EmitAnalysis& analysis, const Language& language, Id id) {
    const Module& m = analysis.module();
    if (m[id].op == Op::literal_) return std::string(analysis.literal(id));
    std::string list;
    for (const Id part : m.operands(id))
        append_item(list, analysis.literal(part));
    return std::string(language.type(m.type(id))) + "(" + list + ")";
}

static void write_constants(const EmitAnalysis& analysis, const Language& language,
                            const Symbols& symbols, Text& text) {
    CommentedLines lines;
    for (const Id id : analysis.constants) {
        append_filled(lines.code, language.global_constant,
                      {{'t', language.type(analysis.module().type(id))},
                       {'n', symbols.constants.at(id)},
                       {'v', constant_text(analysis, language, id)}});
        lines.comments.append(analysis.name(id)->comment);
        lines.end_line();
    }
    constexpr size_t max_column = 64;
    write(lines, 0, max_column, text);
}

void write_functions(const EmitAnalysis& analysis, const Interface& face, const Target& target,
                     Text& text) {
    write_constants(analysis, target.language(), face.symbols, text);
    Values values(analysis, face.symbols);
    const std::string_view helper = target.language().image_size_helper;
    if (analysis.reads_sizes && !helper.empty()) {
        text.line(0, "");
        write_lines(filled(helper, {{'f', face.symbols.prefix}}), text);
    }
    for (const uint32_t region : analysis.functions) {
        text.line(0, "");
        Body(analysis, values, face.globals, target, text).region_function(region);
    }
    text.line(0, "");
    Body(analysis, values, face.globals, target, text).material_function(face.reflection);
}

bool has_normals(const Reflection& reflection) {
    return std::ranges::any_of(reflection.outputs, [](const OutputInfo& output) {
        return output.port_type == WR_PORT_normal;
    });
}

std::string title_of(const Module& module, const Reflection& reflection) {
    const std::string& title = module.titles[module.nodes[0].title];
    std::string line =
        "// " + comment_text(title.empty() ? reflection.name : title) + ". Generated by Wrinkle.";
    if (reflection.uv_origin == UvOrigin::top) line += " UV origin: top.";
    if (reflection.normal_space != NormalSpace::object)
        line.append(" Normals: ").append(name_of(reflection.normal_space)).append(" space.");
    return line;
}

}  // namespace wrinkle
