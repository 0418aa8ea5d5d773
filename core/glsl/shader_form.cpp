// Shader form: the complete vertex and fragment pair around the function.
#include <algorithm>
#include <limits>

#include "base/standard_outputs.h"
#include "glsl/attributes.h"
#include "glsl/blocks.h"
#include "glsl/interface.h"

namespace wrinkle {
namespace {

struct Stage {
    const EmitAnalysis& analysis;
    const EmitOptions& options;
    Interface& face;
    bool relative = false;  // the position relative to the eye is used
    bool world = false;     // there is an output of type normal
};

std::string at(int location) {
    return "layout(location = " + std::to_string(location) + ") ";
}

// Assigns consecutive locations, because drivers reject locations beyond their draw buffers:
// standard outputs by their rank, then the others in graph order.
void assign_locations(Interface& face) {
    std::vector<OutputInfo*> order;
    for (OutputInfo& output : face.reflection.outputs) {
        order.push_back(&output);
        output.variable = face.globals.unique("out_" + output.output);
    }
    const auto rank = [](const OutputInfo* output) {
        const StandardOutput* standard = find_standard_output(output->output);
        return standard ? standard->rank : std::numeric_limits<int>::max();
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](const auto* one, const auto* other) { return rank(one) < rank(other); });
    for (size_t i = 0; i < order.size(); ++i)
        order[i]->location = static_cast<int>(i);
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
    if (stage.relative) r.varyings.push_back("wrinkle_position_relative");
    stage.world = std::any_of(r.outputs.begin(), r.outputs.end(), [](const auto& output) {
        return output.port_type == WR_PORT_normal;
    });
    r.frame_uniforms.push_back({"wrinkle_object_to_clip", "mat4", "object space to clip space"});
    if (stage.relative)
        r.frame_uniforms.push_back({"wrinkle_eye", "vec3", "the eye in object space"});
    if (stage.world)
        r.frame_uniforms.push_back({"wrinkle_object_to_world", "mat4", "the object's matrix"});
}

std::string varying_type(const Reflection& r, const std::string& varying) {
    for (const AttributeInfo& attribute : r.attributes)
        if (varying == "wrinkle_" + attribute.name) return std::string(info(attribute.type).name);
    return "vec3";
}

// Returns "layout(location = 2) ", or "" if the target matches varyings by name.
std::string at_varying(const Stage& stage, size_t index) {
    return stage.options.target->bindings == Bindings::by_name ? "" : at(static_cast<int>(index));
}

void write_frame(const Stage& stage, bool vertex, Text& text) {
    const Reflection& r = stage.face.reflection;
    std::vector<Declaration> members;
    for (const FrameUniform& uniform : r.frame_uniforms) {
        const bool own = (uniform.name == "wrinkle_object_to_world") != vertex;
        if (own || r.frame_block)
            members.push_back({uniform.type, uniform.name,
                               uniform.name == "wrinkle_eye" ? "in object space" : ""});
    }
    write_block(r.frame_block, members, text);
}

std::string vertex_text(const Stage& stage) {
    const Reflection& r = stage.face.reflection;
    Text text;
    text.line(0, stage.options.target->version);
    text.line(0, title_of(stage.analysis.module(), r.name));
    for (const AttributeInfo& attribute : r.attributes)
        text.line(0, at(attribute.location) + "in " + std::string(info(attribute.type).name) + " " +
                         attribute.name + ";");
    write_frame(stage, true, text);
    for (size_t i = 0; i < r.varyings.size(); ++i)
        text.line(0, at_varying(stage, i) + "out " + varying_type(r, r.varyings[i]) + " " +
                         r.varyings[i] + ";");
    text.line(0, "");
    text.line(0, "void main() {");
    for (const std::string& varying : r.varyings)
        text.line(1, varying + " = " +
                         (varying == "wrinkle_position_relative" ? "position - wrinkle_eye"
                                                                 : varying.substr(8)) +
                         ";");
    text.line(1, "gl_Position = wrinkle_object_to_clip * vec4(position, 1.0);");
    text.line(0, "}");
    return std::move(text.text);
}

void write_normal_to_world(Text& text) {
    text.line(0, "");
    text.line(0, "// A normal of the object in the world: cof(M) n, times the sign of det(M).");
    text.line(0, "vec3 wrinkle_normal_to_world(vec3 n) {");
    text.line(1, "mat3 m = mat3(wrinkle_object_to_world);");
    text.line(1, "mat3 cofactor = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));");
    text.line(1, "return normalize(cofactor * n) * (dot(m[0], cofactor[0]) < 0.0 ? -1.0 : 1.0);");
    text.line(0, "}");
}

std::string member_value(const MemberInfo& member) {
    if (member.input == SurfaceInput::view_) return "normalize(-wrinkle_position_relative)";
    if (member.input == SurfaceInput::facing_) return "gl_FrontFacing ? 1.0 : -1.0";
    return "wrinkle_" + member.name;
}

void write_main(const Stage& stage, Text& text) {
    const Reflection& r = stage.face.reflection;
    text.line(0, "");
    text.line(0, "void main() {");
    if (!r.struct_name.empty()) text.line(1, r.struct_name + " s;");
    for (const MemberInfo& member : r.members)
        text.line(1, "s." + member.name + " = " + member_value(member) + ";");
    text.line(1, result_type(r) + " m = " + call_text(r, "s") + ";");
    for (const OutputInfo& output : r.outputs) {
        const std::string value = output_text(r, output, "m");
        const bool normal = output.port_type == WR_PORT_normal;
        text.line(1, output.variable + " = " +
                         (normal ? "wrinkle_normal_to_world(" + value + ")" : value) + ";");
    }
    text.line(0, "}");
}

Text fragment_text(const Stage& stage) {
    const Reflection& r = stage.face.reflection;
    Text text = reserve_text(stage.analysis, stage.options.max_bytes);
    text.line(0, stage.options.target->version);
    text.line(0, title_of(stage.analysis.module(), r.name));
    write_precision(*stage.options.target, text);
    for (size_t i = 0; i < r.varyings.size(); ++i)
        text.line(0, at_varying(stage, i) + "in " + varying_type(r, r.varyings[i]) + " " +
                         r.varyings[i] + ";");
    for (const OutputInfo& output : r.outputs)
        text.line(0, at(output.location) + "out " + std::string(info(output.type).name) + " " +
                         output.variable + ";");
    if (stage.world) write_frame(stage, false, text);
    write_structs(r, text);
    write_uniforms(stage.analysis.module(), r, text);
    write_functions(stage.analysis, stage.face, *stage.options.target, text);
    if (stage.world) write_normal_to_world(text);
    write_main(stage, text);
    return text;
}

}  // namespace

void write_shader_form(const EmitAnalysis& analysis, const EmitOptions& options, Interface& face,
                       Shader& shader) {
    Stage stage{analysis, options, face};
    assign_locations(face);
    find_varyings(stage);
    assign_bindings(options, face.reflection);
    shader.vertex = vertex_text(stage);
    Text fragment = fragment_text(stage);
    shader.fragment = std::move(fragment.text);
    face.reflection.lines = std::move(fragment.nodes);
}

}  // namespace wrinkle
