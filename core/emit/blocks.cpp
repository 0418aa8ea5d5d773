#include "emit/blocks.h"

#include <algorithm>
#include <array>

#include "base/text.h"
#include "ir/op.h"

namespace wrinkle {
namespace {

struct Place {
    std::string_view type;
    int alignment, size;
};
constexpr std::array<Place, 8> places{{{"float", 4, 4},
                                       {"int", 4, 4},
                                       {"uint", 4, 4},
                                       {"bool", 4, 4},
                                       {"vec2", 8, 8},
                                       {"vec3", 16, 12},
                                       {"vec4", 16, 16},
                                       {"mat4", 16, 64}}};

// Returns "c1.y" for an offset of 20 bytes, in HLSL's registers of 16.
std::string register_of(int offset) {
    const std::string row = "c" + std::to_string(offset / 16);
    return offset % 16 == 0 ? row : row + "." + "xyzw"[offset % 16 / 4];
}

// Assigns an offset to every member. Returns the block with its binding and size and advances
// `next`; std::nullopt without members.
template <class Member, class TypeOf>
std::optional<Block> block_of(std::vector<Member>& members, std::string name, std::string variable,
                              int vec3_size, Binding& next, TypeOf type_of) {
    if (members.empty()) return {};
    BlockLayout layout(vec3_size);
    for (Member& member : members)
        member.offset = layout.place(type_of(member));
    Block block{std::move(name), std::move(variable), next, layout.size()};
    ++next.binding;
    return block;
}

}  // namespace

int BlockLayout::place(std::string_view type) {
    const auto* const found = std::find_if(places.begin(), places.end(),
                                           [&](const Place& place) { return place.type == type; });
    const Place place = found == places.end() ? places.back() : *found;
    const int offset = (end_ + place.alignment - 1) / place.alignment * place.alignment;
    end_ = offset + (type == "vec3" ? vec3_size_ : place.size);
    return offset;
}

void assign_bindings(const EmitOptions& options, Reflection& r) {
    const Bindings kind = options.target->bindings;
    if (kind == Bindings::by_name) return;
    const int vec3_size = options.target->language().vec3_size;
    Binding next{options.set, options.first_binding};
    r.frame_block = block_of(r.frame_uniforms, "WrinkleFrame", "wrinkle_frame", vec3_size, next,
                             [](const FrameUniform& u) { return std::string_view(u.type); });
    r.parameter_block =
        block_of(r.uniforms, "WrinkleParameters_" + r.name, r.name + "_parameters", vec3_size, next,
                 [](const UniformInfo& u) { return info(u.type).name; });
    if (kind == Bindings::by_kind) next = {options.set + 1, options.first_binding};
    for (SamplerInfo& sampler : r.samplers) {
        sampler.binding = next;
        ++next.binding;
        if (kind == Bindings::by_group) sampler.sampler_binding = next.binding++;
    }
}

void write_block(const Language& language, const std::optional<Block>& block,
                 const std::vector<Declaration>& members, Text& text) {
    if (members.empty()) return;
    const std::string set = block ? std::to_string(block->binding.set) : "";
    const std::string binding = block ? std::to_string(block->binding.binding) : "";
    const auto frame = [&](std::string_view pattern) {
        write_lines(
            filled(pattern,
                   {{'n', block->name}, {'v', block->variable}, {'s', set}, {'b', binding}}),
            text);
    };
    if (block) frame(language.block);
    for (const Declaration& member : members) {
        const std::string place = block ? register_of(member.offset) : "";
        const std::string line = filled(block ? language.block_member : language.uniform,
                                        {{'t', member.type}, {'n', member.name}, {'o', place}});
        text.line(block ? 1 : 0, {line, member.doc.empty() ? "" : "  // ", member.doc},
                  member.node);
    }
    if (block) frame(language.end_block);
}

void write_lines(std::string_view lines, Text& text, uint32_t node) {
    for (const std::string_view line : split(lines, '\n'))
        text.line(0, line, node);
}

}  // namespace wrinkle
