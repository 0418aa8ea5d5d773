// Interface of a generated shader: uniforms, images, struct members, outputs and attributes, and
// the node of each line. Lists contain only used entries, in the order of the source.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/texture_options.h"
#include "emit/conventions.h"

namespace wrinkle {

enum class SurfaceInput : uint8_t;  // ir/op.h, like the next two
enum class Type : uint8_t;
enum class Variant : uint8_t;
struct Language;

// Set and binding of a resource if the target numbers them (Bindings in emit/target.h).
struct Binding {
    int set = -1;      // -1: found by name
    int binding = -1;  // HLSL: register; Metal: index; both by kind of resource
};

// A uniform block with std140 layout.
struct Block {
    std::string name;      // "WrinkleParameters_NAME"
    std::string variable;  // Metal: name of the argument; WGSL: of the variable
    Binding binding;
    int size = 0;  // bytes
};

// A uniform made from a parameter of the module.
struct UniformInfo {
    std::string name;  // "softer_amount"; for a graph input "input_amount"
    Type type{};
    std::array<double, 4> value{};  // value in the graph
    std::string node;               // path; "" for a graph input
    std::string port;
    bool graph_input = false;
    uint32_t parameter = 0;  // index in Module::parameters
    int offset = -1;         // bytes in the parameter block; -1: no block
};

struct SamplerInfo {
    struct Reader {
        std::string node;  // path
        std::string port;
    };
    std::string name;     // name of the sampler2D
    std::string file;     // path to open
    std::string written;  // path as written in the graph
    TextureOptions options;
    std::vector<Reader> readers;
    uint32_t resource = 0;  // index in Module::resources
    Binding binding;
    int sampler_binding = -1;  // WGSL: numbers of the image and of its sampler differ
};

// A member of the struct that the function takes. With screen differentials, the position's are
// taken of `position_relative`: the position minus the eye, in object axes, for precision far
// from the origin. The `input` of that member is `position`. The member `normal_matrix` is the
// last; it has no input.
struct MemberInfo {
    std::string name;  // "uv0", "position_relative"; with given differentials also "uv0_dx"
    Type type{};
    SurfaceInput input{};
    Variant variant{};
    bool relative = false;
    bool normal_matrix = false;
};

// An output of the graph: a member of the result.
struct OutputInfo {
    std::string output;  // "normal"
    std::string member;  // its name in the result's struct, or the parameter
    Type type{};
    uint32_t port_type = 0;  // WR_PORT_*
    int location = -1;       // location of the fragment output; shader form only
    std::string variable;    // name of the fragment output
};

// A vertex attribute of the shader form, at its location in emit/attributes.h.
struct AttributeInfo {
    std::string name;
    Type type{};
    int location = 0;
    SurfaceInput input{};
    std::string semantic;  // HLSL: "POSITION", "TEXCOORD0"
};

// A uniform of the shader form that the caller sets per object (see emit/emit.h).
struct FrameUniform {
    std::string name;
    std::string type;  // GLSL type
    std::string doc;
    int offset = -1;  // bytes in the frame block; -1: no block
};

inline constexpr uint32_t no_node = ~0U;

// How the function returns its outputs.
enum class ResultForm : uint8_t {
    structure,  // a struct with a member per output
    value,      // the only output
    parameters  // `out` parameters, after the members of the surface
};

struct Reflection {
    std::string target;  // "glsl330"
    UvOrigin uv_origin = UvOrigin::bottom;
    NormalSpace normal_space = NormalSpace::object;  // function form
    std::string name;                                // NAME
    std::string function;                            // "wrinkle_NAME"
    std::string struct_name;  // "WrinkleSurface_NAME"; "" if the function takes no struct
    std::string result_name;  // "WrinkleMaterial_NAME"; "" without a struct
    ResultForm result_form = ResultForm::structure;
    std::vector<UniformInfo> uniforms;
    std::vector<SamplerInfo> samplers;
    std::vector<MemberInfo> members;
    std::vector<OutputInfo> outputs;
    std::vector<AttributeInfo> attributes;     // shader form
    std::vector<std::string> varyings;         // shader form
    std::vector<FrameUniform> frame_uniforms;  // shader form
    std::optional<Block> frame_block, parameter_block;
    std::string vertex_entry = "main", fragment_entry = "main";  // shader form
    bool uniform_control_flow = false;  // required: the function takes screen derivatives

    // lines[i] is the index in Module::nodes that line i + 1 came from, or no_node. The line of a
    // uniform has the node of its parameter; that of an image, its first reader. In the shader
    // form, these are lines of the fragment stage. Empty for SPIR-V, which has no lines.
    std::vector<uint32_t> lines;
    std::vector<std::string> node_paths;  // by index in Module::nodes
};

// Code around the function: the type of its result, a call in GLSL with the argument `surface`, and
// an output of the result held in the variable `result`.
std::string result_type(const Reflection& reflection);  // in GLSL
std::string result_type(const Reflection& reflection, const Language& language);
std::string call_text(const Reflection& reflection, std::string_view surface);
std::string output_text(const Reflection& reflection, const OutputInfo& output,
                        std::string_view result);

// Returns the reflection as JSON, one entry per line; `lines` as ranges of equal nodes.
std::string to_json(const Reflection& reflection);

}  // namespace wrinkle
