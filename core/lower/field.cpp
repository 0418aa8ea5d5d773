#include "lower/field.h"

#include "ir/derive.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

// What `value` needs of the pixels beside it, in id order: implicit samples, ddx and ddy.
std::vector<Id> implicit_parts(const Module& module, Id value) {
    const std::vector<bool> needed = reachable(module, std::span(&value, 1));
    std::vector<Id> parts;
    for (Id id = 1; id < needed.size(); ++id) {
        const Op op = module[id].op;
        if (needed[id] && (op == Op::sample_ || op == Op::ddx_ || op == Op::ddy_))
            parts.push_back(id);
    }
    return parts;
}

}  // namespace

Id read_field(Module& module, Id value, SurfaceInput domain, Id at) {
    if (value == poison || at == poison) return poison;
    std::vector<Id> from{module.input(domain)}, to{at};
    const bool inside = module[at].level > 0;
    const std::vector<Id> parts = inside ? implicit_parts(module, value) : std::vector<Id>{};
    for (const Id sample : parts) {
        if (module[sample].op != Op::sample_) {
            from.push_back(sample);
            to.push_back(sample);
            continue;
        }
        const Id uv = module[sample].arg[0];
        const Id moved = substitute(module, uv, from, to);
        if (moved == uv) continue;
        const Id dx = module.add(Op::ddx_, {uv});
        const Id dy = module.add(Op::ddy_, {uv});
        from.push_back(sample);
        to.push_back(module.add(Op::sample_grad_, {moved, dx, dy}, module[sample].extra));
    }
    return substitute(module, value, from, to);
}

Id sample_inside(Module& module, uint32_t resource, Id uv) {
    std::array<Id, 2> changes{};
    constexpr std::array axes{Variant::dx, Variant::dy};
    for (size_t i = 0; i < 2; ++i) {
        changes[i] = screen_direction(module, axes[i], false).tangent(uv);
        if (changes[i] == poison) changes[i] = module.input(SurfaceInput::uv0_, axes[i]);
    }
    return module.add(Op::sample_grad_, {uv, changes[0], changes[1]}, resource);
}

}  // namespace wrinkle
