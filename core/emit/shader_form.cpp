// Shader form: the complete vertex and fragment pair around the function.
#include <algorithm>

#include "base/standard_outputs.h"
#include "emit/attributes.h"
#include "emit/blocks.h"
#include "emit/interface.h"

namespace wrinkle {
namespace {

struct Stage {
    const EmitAnalysis& analysis;
    const EmitOptions& options;
    Interface& face;
    const Language& language;
    const StagePatterns& patterns;
    bool relative = false;  // the position relative to the eye is used
    bool world = false;     // there is an output of type normal
};

// Assigns consecutive locations, because drivers reject locations beyond their draw buffers:
// standard outputs in the order of their table, then the others in graph order.
void assign_locations(Interface& face) {
    std::vector<OutputInfo*> order;
    for (OutputInfo& output : face.reflection.outputs) {
        order.push_back(&output);
        output.variable = face.globals.unique("out_" + output.output);
    }
    const auto rank = [](const OutputInfo* output) {
        const StandardOutput* standard = find_standard_output(output->output);
        return standard ? standard : standard_output_table.data() + standard_output_table.size();
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](const auto* one, const auto* other) { return rank(one) < rank(other); });
    for (size_t i = 0; i < order.size(); ++i)
        order[i]->location = static_cast<int>(i);
}

// Returns "TEXCOORD0" for "uv0", "POSITION" for "position".
std::string semantic_of(const std::string& attribute) {
    if (attribute.starts_with("uv")) return "TEXCOORD" + attribute.substr(2);
    std::string upper = attribute;
    for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return upper;
}

void find_varyings(Stage& stage) {
    Reflection& r = stage.face.reflection;
    r.attributes.push_back({"position",
                            Type::vec3_,
                            location_of(SurfaceInput::position_),
                            SurfaceInput::position_,
                            {}});
    for (const MemberInfo& member : r.members) {
        const int location = location_of(member.input);
        stage.relative = stage.relative || member.relative || member.input == SurfaceInput::view_;
        if (location >= 0 && member.input != SurfaceInput::position_)
            r.attributes.push_back(
                {std::string(info(member.input).name), member.type, location, member.input, {}});
        if (location >= 0 && !member.relative) r.varyings.push_back("wrinkle_" + member.name);
    }
    if (stage.patterns.attribute.find("$s") != std::string_view::npos)
        for (AttributeInfo& attribute : r.attributes)
            attribute.semantic = semantic_of(attribute.name);
    if (stage.relative) r.varyings.push_back("wrinkle_position_relative");
    stage.world = has_normals(r);
    r.frame_uniforms.push_back({"wrinkle_object_to_clip", "mat4", "object space to clip space"});
    if (stage.relative)
        r.frame_uniforms.push_back({"wrinkle_eye", "vec3", "the eye in object space"});
    if (stage.world)
        r.frame_uniforms.push_back({"wrinkle_object_to_world", "mat4", "the object's matrix"});
}

Type varying_type(const Reflection& r, const std::string& varying) {
    for (const AttributeInfo& attribute : r.attributes)
        if (varying == "wrinkle_" + attribute.name) return attribute.type;
    return Type::vec3_;
}

// Writes the frame block, or the uniforms that the stage uses.
void write_frame(const Stage& stage, bool vertex, Text& text) {
    const Reflection& r = stage.face.reflection;
    std::vector<Declaration> members;
    for (const FrameUniform& uniform : r.frame_uniforms) {
        const bool own = (uniform.name == "wrinkle_object_to_world") != vertex;
        const bool matrix = uniform.type == "mat4";
        if (own || r.frame_block)
            members.push_back({matrix ? stage.language.matrix4 : stage.language.type(Type::vec3_),
                               uniform.name, uniform.name == "wrinkle_eye" ? "in object space" : "",
                               uniform.offset});
    }
    write_block(stage.language, r.frame_block, members, text);
}

std::string frame_use(const Stage& stage, std::string_view name) {
    const auto& block = stage.face.reflection.frame_block;
    if (!block) return std::string(name);
    return filled(stage.language.block_use, {{'v', block->variable}, {'n', name}});
}

// Begins and ends the struct of a stage's inputs or outputs, where the language has one.
void begin_struct(const Stage& stage, const std::string& kind, Text& text) {
    if (stage.patterns.structs)
        text.line(0, filled(stage.language.structure,
                            {{'n', "Wrinkle" + kind + "_" + stage.face.reflection.name}}));
}
void end_struct(const Stage& stage, Text& text) {
    if (stage.patterns.structs) text.line(0, stage.language.end_structure);
}

void write_place(const Stage& stage, std::string_view pattern, Type type, std::string_view name,
                 int location, std::string_view semantic, Text& text) {
    text.line(stage.patterns.structs ? 1 : 0, filled(pattern, {{'t', stage.language.type(type)},
                                                               {'n', name},
                                                               {'l', std::to_string(location)},
                                                               {'s', semantic}}));
}

void write_varyings(const Stage& stage, std::string_view pattern, Text& text) {
    const Reflection& r = stage.face.reflection;
    begin_struct(stage, "Varyings", text);
    if (stage.patterns.structs) text.line(1, stage.patterns.clip_position);
    for (size_t i = 0; i < r.varyings.size(); ++i)
        write_place(stage, pattern, varying_type(r, r.varyings[i]), r.varyings[i],
                    static_cast<int>(i), "", text);
    end_struct(stage, text);
}

// Writes the head of an entry point with the resources that it takes as parameters, and, if results
// are in a struct, the declaration of that struct.
void begin_entry(const Stage& stage, std::string_view pattern, const std::string& more,
                 const std::string& result, std::string_view variable, Text& text) {
    const std::string& name = stage.face.reflection.name;
    text.line(0, "");
    text.line(0, filled(pattern, {{'n', name}, {'v', more}}));
    if (stage.patterns.structs)
        text.line(1, filled(stage.language.unset,
                            {{'t', "Wrinkle" + result + "_" + name}, {'n', variable}}));
}
void end_entry(const Stage& stage, const std::string& variable, Text& text) {
    if (stage.patterns.structs) text.line(1, "return " + variable + ";");
    text.line(0, "}");
}

std::string block_parameter(const Stage& stage, const std::optional<Block>& block) {
    if (!block || stage.language.block_stage_parameter.empty()) return {};
    return ", " + filled(stage.language.block_stage_parameter,
                         {{'t', block->name},
                          {'n', block->variable},
                          {'b', std::to_string(block->binding.binding)}});
}

std::string vertex_text(const Stage& stage) {
    const Reflection& r = stage.face.reflection;
    const std::string in = stage.patterns.structs ? "v." : "",
                      out = stage.patterns.structs ? "o." : "";
    Text text;
    write_lines(stage.options.target->version, text);
    text.line(0, title_of(stage.analysis.module(), r));
    begin_struct(stage, "Vertex", text);
    for (const AttributeInfo& attribute : r.attributes)
        write_place(stage, stage.patterns.attribute, attribute.type, attribute.name,
                    attribute.location, attribute.semantic, text);
    end_struct(stage, text);
    write_frame(stage, true, text);
    write_varyings(stage, stage.patterns.varying_out, text);
    begin_entry(stage, stage.patterns.vertex, block_parameter(stage, r.frame_block), "Varyings",
                "o", text);
    for (const std::string& varying : r.varyings) {
        const std::string value = varying == "wrinkle_position_relative"
                                      ? in + "position - " + frame_use(stage, "wrinkle_eye")
                                      : in + varying.substr(std::string_view("wrinkle_").size());
        text.line(1, out + varying + " = " + value + ";");
    }
    text.line(1,
              filled(stage.patterns.transform,
                     {{'0', frame_use(stage, "wrinkle_object_to_clip")}, {'1', in + "position"}}));
    end_entry(stage, "o", text);
    return std::move(text.text);
}

// Writes a function of a matrix m and a normal n: cof(m) n, times the sign of det(m).
void write_normal_to_world(const Language& language, Text& text) {
    const std::string_view vec3 = language.type(Type::vec3_);
    const auto constant = [&](const char* name, const char* value) {
        text.line(1, filled(language.constant, {{'t', vec3}, {'n', name}, {'v', value}}));
    };
    const std::string_view matrix = language.matrix4.substr(language.matrix4.rfind(' ') + 1);
    const std::string list = filled(language.parameter, {{'t', matrix}, {'n', "m"}}) + ", " +
                             filled(language.parameter, {{'t', vec3}, {'n', "n"}});
    text.line(0, "");
    text.line(0, "// A normal of the object in the world: cof(m) n, times the sign of det(m).");
    text.line(
        0, filled(language.function, {{'t', vec3}, {'n', "wrinkle_normal_to_world"}, {'v', list}}));
    constant("x", "m[0].xyz");
    constant("y", "m[1].xyz");
    constant("z", "m[2].xyz");
    constant("turned", "cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z");
    const std::string facing = filled(
        language.select, {{'0', "dot(x, cross(y, z)) < 0.0"}, {'1', "-turned"}, {'2', "turned"}});
    text.line(1, "return normalize(" + facing + ");");
    text.line(0, "}");
}

std::string member_value(const Stage& stage, const MemberInfo& member) {
    const std::string in = stage.patterns.structs ? "v." : "";
    if (member.input == SurfaceInput::view_)
        return "normalize(-" + in + "wrinkle_position_relative)";
    if (member.input == SurfaceInput::facing_)
        return filled(stage.language.select,
                      {{'0', stage.patterns.front_facing}, {'1', "1.0"}, {'2', "-1.0"}});
    return in + "wrinkle_" + member.name;
}

std::string fragment_parameters(const Stage& stage) {
    const Reflection& r = stage.face.reflection;
    std::string list = stage.world ? block_parameter(stage, r.frame_block) : "";
    list += block_parameter(stage, r.parameter_block);
    if (!stage.language.image_stage_parameter.empty())
        for (const SamplerInfo& sampler : r.samplers)
            list += ", " +
                    filled(stage.language.image_stage_parameter,
                           {{'n', sampler.name}, {'b', std::to_string(sampler.binding.binding)}});
    return list;
}

void write_main(const Stage& stage, Text& text) {
    const Reflection& r = stage.face.reflection;
    const Language& language = stage.language;
    const std::string out = stage.patterns.structs ? "t." : "";
    begin_entry(stage, stage.patterns.fragment, fragment_parameters(stage), "Targets", "t", text);
    if (!r.struct_name.empty())
        text.line(1, filled(language.unset, {{'t', r.struct_name}, {'n', "s"}}));
    for (const MemberInfo& member : r.members)
        text.line(1, "s." + member.name + " = " + member_value(stage, member) + ";");
    std::string arguments = r.struct_name.empty() ? "" : "s";
    const std::string& resources = stage.face.symbols.material_arguments;
    if (!arguments.empty() && !resources.empty()) arguments += ", ";
    text.line(1,
              filled(language.constant, {{'t', result_type(r, language)},
                                         {'n', "m"},
                                         {'v', r.function + "(" + arguments + resources + ")"}}));
    for (const OutputInfo& output : r.outputs) {
        const std::string value = output_text(r, output, "m");
        const bool normal = output.port_type == WR_PORT_normal;
        text.line(1,
                  out + output.variable + " = " +
                      (normal ? "wrinkle_normal_to_world(" +
                                    frame_use(stage, "wrinkle_object_to_world") + ", " + value + ")"
                              : value) +
                      ";");
    }
    end_entry(stage, "t", text);
}

Text fragment_text(const Stage& stage) {
    const Reflection& r = stage.face.reflection;
    const Module& module = stage.analysis.module();
    Text text = reserve_text(stage.analysis, stage.options.max_bytes);
    write_lines(stage.options.target->version, text);
    text.line(0, title_of(module, r));
    write_precision(*stage.options.target, text);
    write_varyings(stage, stage.patterns.varying_in, text);
    begin_struct(stage, "Targets", text);
    for (const OutputInfo& output : r.outputs)
        write_place(stage, stage.patterns.target, output.type, output.variable, output.location, "",
                    text);
    end_struct(stage, text);
    if (stage.world) write_frame(stage, false, text);
    write_structs(stage.language, r, text);
    write_uniforms(module, stage.language, r, text);
    write_functions(stage.analysis, stage.face, *stage.options.target, text);
    if (stage.world) write_normal_to_world(stage.language, text);
    write_main(stage, text);
    return text;
}

}  // namespace

void write_shader_form(const EmitAnalysis& analysis, const EmitOptions& options, Interface& face,
                       Shader& shader) {
    const Language& language = options.target->language();
    Stage stage{analysis, options, face, language, language.stage};
    assign_locations(face);
    find_varyings(stage);
    assign_bindings(options, face.reflection);
    set_resource_uses(analysis, language, face);
    Reflection& r = face.reflection;
    r.vertex_entry = filled(stage.patterns.vertex_entry, {{'n', r.name}});
    r.fragment_entry = filled(stage.patterns.fragment_entry, {{'n', r.name}});
    shader.vertex = vertex_text(stage);
    Text fragment = fragment_text(stage);
    shader.fragment = std::move(fragment.text);
    face.reflection.lines = std::move(fragment.nodes);
}

}  // namespace wrinkle
