// The shading languages, each a row of data in a file language_NAME.cpp: names of types, spellings
// of ops, and patterns of declarations. The emitter has one path for all of them; the default
// values are those of GLSL.
//
// A pattern is text with fields: "$t $n = $v;" with t "vec2", n "uv", v "s.uv0" gives
// "vec2 uv = s.uv0;". A pattern may have several lines. These fields have one meaning everywhere:
//   $t type   $n name   $v value or list   $s set or semantic   $b binding   $l location
//   $0, $1 ... operands
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>

#include "emit/names.h"
#include "ir/op.h"

namespace wrinkle {

struct Field {
    char letter;
    std::string_view text;
};
void append_filled(std::string& text, std::string_view pattern,
                   std::initializer_list<Field> fields);
std::string filled(std::string_view pattern, std::initializer_list<Field> fields);
// Appends an item to a list with commas; skips an empty item.
void append_item(std::string& list, std::string_view item);

// Arguments and results of a material's function.
enum class Arguments : uint8_t {
    structs,  // a struct in, a struct out
    flat      // the members of the first as parameters, those of the second as `out` parameters
};

// Patterns of the complete pair.
struct StagePatterns {
    // Inputs and outputs are members of structs: v of the inputs, o of the varyings and t of the
    // targets; otherwise they are globals.
    bool structs = false;
    std::string_view attribute = "layout(location = $l) in $t $n;";
    std::string_view varying_out = "out $t $n;", varying_in = "in $t $n;";
    std::string_view clip_position;  // member of the varyings
    std::string_view target = "layout(location = $l) out $t $n;";
    // Heads of the entry points; $n: NAME, $v: further parameters.
    std::string_view vertex = "void main() {", fragment = "void main() {";
    std::string_view transform = "gl_Position = $0 * vec4($1, 1.0);";  // matrix, position
    std::string_view front_facing = "gl_FrontFacing";
    std::string_view vertex_entry = "main", fragment_entry = "main";
};

struct Language {
    NameSet reserved{nullptr};  // names that the generated code cannot use
    std::array<std::string_view, 9> types;
    std::string_view matrix4 = "mat4";

    // By op: the name of a call or an operator; for other syntax a pattern of the operands.
    std::array<std::string_view, tables::op_count> ops;
    // Returns true if a built-in accepts a scalar for this operand together with vectors, as
    // clamp(vec3, float, float). `others`: exactly two operands are scalars.
    bool (*takes_scalar)(Op op, size_t operand, bool others);
    std::string_view select = "$0 ? $1 : $2";
    bool select_is_call = false;
    std::string_view splat = "$t($0)";
    bool splat_is_cast = false;
    bool has_mod = true;  // built-in mod(x, y) = x - y floor(x / y)
    std::string_view uint_literal = "$vu";
    bool uint_literal_is_int = false;  // $v is the int of the same bits
    std::string_view not_a_number = "uintBitsToFloat(0x7fc00000u)";
    std::string_view infinity = "uintBitsToFloat(0x7f800000u)";
    std::string_view minus_infinity = "uintBitsToFloat(0xff800000u)";

    std::string_view global_constant = "const $t $n = $v;";
    std::string_view constant = "$t $n = $v;";
    std::string_view variable = "$t $n = $v;";
    std::string_view unset = "$t $n;";
    std::string_view parameter = "$t $n";
    std::string_view out_parameter = "out $t $n";
    std::string_view out_argument = "$n";
    std::string_view out_use = "$n";  // in the function
    std::string_view function = "$t $n($v) {";
    std::string_view no_value = "void $n($v) {";  // a function without a result
    std::string_view structure = "struct $n {";
    std::string_view member = "$t $n;";
    std::string_view end_structure = "};";
    std::string_view loop = "for (int $n = 0; $n < $v; ++$n) {";
    std::string_view leave = "if ($v) break;";
    Arguments arguments = Arguments::structs;

    std::string_view image = "uniform sampler2D $n;";
    std::string_view srgb_hint;  // $h in `image`, if the sampler decodes
    std::string_view uniform = "uniform $t $n;";
    std::string_view block, block_member, end_block;  // $v: its variable; $o: packoffset
    std::string_view block_use = "$n";                // $v: its variable
    // If not empty, functions that use images or the block have these parameters.
    std::string_view image_parameter, image_argument, block_parameter, block_argument;
    std::string_view image_stage_parameter, block_stage_parameter;  // entry points
    std::string_view image_size_helper;  // lines of a function $f_image_size
    StagePatterns stage;
    int vec3_size = 12;  // in a block

    void spell(Op op, std::string_view text) { ops[static_cast<size_t>(op)] = text; }
    std::string_view type(Type type) const { return types[static_cast<size_t>(type)]; }
    std::string_view op(Op op) const { return ops[static_cast<size_t>(op)]; }
    bool is_pattern(Op op) const { return this->op(op).find('$') != std::string_view::npos; }
};

// GLSL's types, ops and reserved words: the start of every language.
Language glsl_language();

// Adds words to a language's reserved ones, separated by spaces or line ends.
void reserve_words(Language& language, std::string_view words);

// The languages of emit/target.h, created on first use.
const Language& glsl();         // OpenGL and OpenGL ES: uniforms by name
const Language& vulkan_glsl();  // uniforms in blocks with sets and bindings
const Language& hlsl();
const Language& msl();
const Language& wgsl();
const Language& godot3();
const Language& godot4();

}  // namespace wrinkle
