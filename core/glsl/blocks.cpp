#include "glsl/blocks.h"

#include <algorithm>
#include <array>

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

std::string layout(const Binding& binding, std::string_view before) {
    return "layout(" + std::string(before) + "set = " + std::to_string(binding.set) +
           ", binding = " + std::to_string(binding.binding) + ") ";
}

// Assigns an offset to every member. Returns the block with its binding and size and advances
// `next`; std::nullopt without members.
template <class Member, class TypeOf>
std::optional<Block> block_of(std::vector<Member>& members, std::string name, std::string variable,
                              Binding& next, TypeOf type_of) {
    if (members.empty()) return {};
    Std140 layout;
    for (Member& member : members)
        member.offset = layout.place(type_of(member));
    Block block{std::move(name), std::move(variable), next, layout.size()};
    ++next.binding;
    return block;
}

}  // namespace

int Std140::place(std::string_view type) {
    const auto* const found = std::find_if(places.begin(), places.end(),
                                           [&](const Place& place) { return place.type == type; });
    const Place place = found == places.end() ? places.back() : *found;
    const int offset = (end_ + place.alignment - 1) / place.alignment * place.alignment;
    end_ = offset + place.size;
    return offset;
}

void assign_bindings(const EmitOptions& options, Reflection& r) {
    const Bindings kind = options.target->bindings;
    if (kind == Bindings::by_name) return;
    Binding next{options.set, options.first_binding};
    r.frame_block = block_of(r.frame_uniforms, "WrinkleFrame", "wrinkle_frame", next,
                             [](const FrameUniform& u) { return std::string_view(u.type); });
    r.parameter_block = block_of(r.uniforms, "WrinkleParameters_" + r.name, "wrinkle_parameters",
                                 next, [](const UniformInfo& u) { return info(u.type).name; });
    if (kind == Bindings::by_kind) next = {options.set + 1, options.first_binding};
    for (SamplerInfo& sampler : r.samplers) {
        sampler.binding = next;
        ++next.binding;
    }
}

std::string binding_text(const Binding& binding) {
    return binding.set < 0 ? "" : layout(binding, "");
}

void write_block(const std::optional<Block>& block, const std::vector<Declaration>& members,
                 Text& text) {
    if (block) text.line(0, {layout(block->binding, "std140, "), "uniform ", block->name, " {"});
    for (const Declaration& member : members)
        text.line(block ? 1 : 0,
                  {block ? "" : "uniform ", member.type, " ", member.name, ";",
                   member.doc.empty() ? "" : "  // ", member.doc},
                  member.node);
    if (block) text.line(0, "};");
}

}  // namespace wrinkle
