// Resource layout for targets that number their resources: uniform blocks, descriptor sets and
// bindings. Blocks have the layout std140 (OpenGL 4.6 specification, 7.6.2.2), which WGSL shares;
// in Metal a vec3 takes 16 bytes (Metal Shading Language Specification, 2.2.3).
#pragma once

#include <string_view>

#include "emit/emit.h"
#include "emit/language.h"
#include "emit/text.h"

namespace wrinkle {

// Offsets in bytes of the members of one block.
class BlockLayout {
public:
    explicit BlockLayout(int vec3_size = 12) : vec3_size_(vec3_size) {}
    // Adds a member of a GLSL type: "float", "vec2" ... "mat4". Returns its offset in bytes.
    int place(std::string_view type);
    int size() const { return (end_ + 15) / 16 * 16; }

private:
    int vec3_size_;
    int end_ = 0;
};

// Assigns blocks, member offsets, sets and bindings to the uniforms and images of the reflection.
// Does nothing if the target finds them by name. Precondition: the reflection lists all of them.
void assign_bindings(const EmitOptions& options, Reflection& reflection);

// A member's declaration in the language, the text of its comment, and the node that it belongs to.
struct Declaration {
    std::string_view type, name, doc;
    int offset = -1;
    uint32_t node = no_node;
};

// Appends the block with its members; without a block, each member as a separate uniform.
void write_block(const Language& language, const std::optional<Block>& block,
                 const std::vector<Declaration>& members, Text& text);

// Appends text of several lines.
void write_lines(std::string_view lines, Text& text, uint32_t node = no_node);

}  // namespace wrinkle
