#include "lower/field.h"

#include "ir/derive.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

// The implicit samples that `value` needs, in id order.
std::vector<Id> samples_of(const Module& module, Id value) {
    const std::vector<bool> needed = reachable(module, std::span(&value, 1));
    std::vector<Id> samples;
    for (Id id = 1; id < needed.size(); ++id)
        if (needed[id] && module[id].op == Op::sample_) samples.push_back(id);
    return samples;
}

}  // namespace

Id read_field(Module& module, Id value, SurfaceInput domain, Id at) {
    if (value == poison || at == poison) return poison;
    std::vector<Id> from{module.input(domain)}, to{at};
    const bool inside = module[at].level > 0;
    const std::vector<Id> samples = inside ? samples_of(module, value) : std::vector<Id>{};
    for (const Id sample : samples) {
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
