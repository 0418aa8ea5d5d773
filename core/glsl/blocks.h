// Resource layout for targets that number their resources: std140 uniform blocks, descriptor sets
// and bindings. Source: OpenGL 4.6 specification, 7.6.2.2.
#pragma once

#include <string_view>

#include "glsl/emit.h"
#include "glsl/text.h"

namespace wrinkle {

// Offsets in bytes of the members of one block.
class Std140 {
public:
    // Adds a member of a GLSL type: "float", "vec2" ... "mat4". Returns its offset in bytes.
    int place(std::string_view type);
    int size() const { return (end_ + 15) / 16 * 16; }

private:
    int end_ = 0;
};

// Assigns blocks, member offsets, sets and bindings to the uniforms and images of the reflection.
// Does nothing if the target finds them by name. Precondition: the reflection lists all of them.
void assign_bindings(const EmitOptions& options, Reflection& reflection);

// Returns "layout(set = 0, binding = 2) " for an image; "" if it is found by name.
std::string binding_text(const Binding& binding);

// A member's declaration, the text of its comment, and the node that it belongs to.
struct Declaration {
    std::string_view type, name, doc;
    uint32_t node = no_node;
};

// Appends the block with its members; without a block, each member as a separate uniform.
void write_block(const std::optional<Block>& block, const std::vector<Declaration>& members,
                 Text& text);

}  // namespace wrinkle
