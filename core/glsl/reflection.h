// What a caller must know to use a generated text: which values to pass, which functions to call,
// which node each line came from. Everything listed is used by the text, in the text's order.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/texture_options.h"
#include "ir/module.h"

namespace wrinkle {

// The number of a resource, where the target numbers them (Bindings in glsl/target.h).
struct Binding {
    int set = -1;      // -1: it is found by its name
    int binding = -1;  // of HLSL and Metal the register or index, by kind
};

// A block of uniforms, laid out by std140.
struct Block {
    std::string name;      // "WrinkleParameters_NAME"
    std::string variable;  // what HLSL puts before the names of its members, and Metal's argument
    Binding binding;
    int size = 0;  // bytes
};

// A number that stayed a parameter.
struct UniformInfo {
    std::string name;  // "softer_amount"; of a graph input "input_amount"
    Type type = Type::float_;
    std::array<double, 4> value{};  // as the graph says
    std::string node;               // path; "" for a graph input
    std::string port;
    bool graph_input = false;
    uint32_t parameter = 0;  // index in Module::parameters
    int offset = -1;         // in the block of parameters, bytes
};

struct SamplerInfo {
    struct Reader {
        std::string node;  // path
        std::string port;
    };
    std::string name;     // of the sampler2D
    std::string file;     // to be opened
    std::string written;  // as the graph spells it
    TextureOptions options;
    std::vector<Reader> readers;
    uint32_t resource = 0;  // index in Module::resources
    Binding binding;
};

// A member of the struct that the functions take. With differentials from the screen the position's
// are taken of `position_relative`, the position seen from the eye in object axes (precision far
// from the origin); its input is `position`.
struct MemberInfo {
    std::string name;  // = property: "uv0", "position_relative"; given differentials: "uv0_dx"
    Type type = Type::float_;
    SurfaceInput input = SurfaceInput::position_;
    Variant variant = Variant::value;
    bool relative = false;
};

struct FunctionInfo {
    std::string output;    // "normal"
    std::string function;  // "wrinkle_NAME_normal"
    Type type = Type::vec3_;
    uint32_t port_type = 0;  // WR_PORT_*
    int location = -1;       // of the fragment output, shader form only
    std::string variable;    // its name there
};

// A vertex attribute of the shader form, at its place in glsl/attributes.h.
struct AttributeInfo {
    std::string name;
    Type type = Type::vec3_;
    int location = 0;
    SurfaceInput input = SurfaceInput::position_;
    std::string semantic;  // HLSL: "POSITION", "TEXCOORD0"
};

// A uniform of the shader form that the caller sets per object (see glsl/emit.h).
struct FrameUniform {
    std::string name;
    std::string type;  // GLSL
    std::string doc;
    int offset = -1;  // in the block of frame uniforms, bytes
};

inline constexpr uint32_t no_node = ~0U;

struct Reflection {
    std::string target;       // "glsl330"
    std::string name;         // NAME
    std::string struct_name;  // "WrinkleSurface_NAME"; "" when the functions take no argument
    std::vector<UniformInfo> uniforms;
    std::vector<SamplerInfo> samplers;
    std::vector<MemberInfo> members;
    std::vector<FunctionInfo> functions;
    std::vector<AttributeInfo> attributes;     // shader form
    std::vector<std::string> varyings;         // shader form
    std::vector<FrameUniform> frame_uniforms;  // shader form
    std::optional<Block> frame_block, parameter_block;
    std::string vertex_entry = "main", fragment_entry = "main";  // shader form
    bool uniform_control_flow = false;  // the functions take screen derivatives

    // lines[i] is the index in Module::nodes that line i + 1 came from, or no_node; of a uniform's
    // line the node that it is a number of, or that reads the image first. Of the fragment stage in
    // the shader form. Empty for SPIR-V, which has no lines.
    std::vector<uint32_t> lines;
    std::vector<std::string> node_paths;  // by index in Module::nodes
};

// The reflection as JSON, one entry per line; `lines` as ranges of equal nodes.
std::string to_json(const Reflection& reflection);

}  // namespace wrinkle
