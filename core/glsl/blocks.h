// Where uniforms and images stand for a target that numbers them: blocks of uniforms laid out by
// std140, sets and bindings. Source: OpenGL 4.6 specification, 7.6.2.2.
#pragma once

#include <string_view>

#include "glsl/emit.h"
#include "glsl/text.h"

namespace wrinkle {

// Offsets in bytes of the members of one block.
class Std140 {
public:
    int place(std::string_view type);  // as GLSL spells it: "float", "vec2" ... "mat4"
    int size() const { return (end_ + 15) / 16 * 16; }

private:
    int end_ = 0;
};

// Numbers everything that the reflection lists, whose uniforms and images are all there; does
// nothing where the target finds them by name.
void assign_bindings(const EmitOptions& options, Reflection& reflection);

// "layout(set = 0, binding = 2) " of an image; "" where it is found by name.
std::string binding_text(const Binding& binding);

// A member's declaration, what a comment says of it, and the node that it belongs to.
struct Declaration {
    std::string_view type, name, doc;
    uint32_t node = no_node;
};

// Appends the block of the members; each as a uniform of its own where there is no block.
void write_block(const std::optional<Block>& block, const std::vector<Declaration>& members,
                 Text& text);

}  // namespace wrinkle
