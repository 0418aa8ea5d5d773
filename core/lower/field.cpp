#include "lower/field.h"

#include "ir/derive.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

// Returns the ddx and ddy instructions that `value` needs.
std::vector<Id> screen_changes(const Module& module, Id value) {
    const std::vector<bool> needed = reachable(module, std::span(&value, 1));
    std::vector<Id> changes;
    for (Id id = 1; id < needed.size(); ++id)
        if (needed[id] && (module[id].op == Op::ddx_ || module[id].op == Op::ddy_))
            changes.push_back(id);
    return changes;
}

// Replaces an implicit sample with another uv by one with the differentials of its old uv.
Id with_differentials(void*, Module& target, const Module& source, Id id,
                      std::span<const Id> mapped) {
    const Inst inst = source[id];
    if (inst.op != Op::sample_ || mapped[0] == inst.arg[0]) return poison;
    const Id dx = target.add(Op::ddx_, {inst.arg[0]});
    const Id dy = target.add(Op::ddy_, {inst.arg[0]});
    return target.add(Op::sample_grad_, {mapped[0], dx, dy}, inst.extra);
}

}  // namespace

Id read_field(Module& module, Id value, SurfaceInput domain, Id at) {
    if (value == poison || at == poison) return poison;
    std::vector<Id> from{module.input(domain)}, to{at};
    if (module[at].level == 0) return substitute(module, value, from, to);
    for (const Id change : screen_changes(module, value)) {
        from.push_back(change);
        to.push_back(change);
    }
    return substitute(module, value, from, to, with_differentials);
}

Id sample_inside(Module& module, uint32_t resource, Id uv) {
    std::array<Id, 2> changes{};
    constexpr std::array axes{Variant::dx, Variant::dy};
    for (size_t i = 0; i < 2; ++i) {
        changes[i] = screen_direction(module, axes[i], false).jvp(uv);
        if (changes[i] == poison) changes[i] = module.input(SurfaceInput::uv0_, axes[i]);
    }
    return module.add(Op::sample_grad_, {uv, changes[0], changes[1]}, resource);
}

}  // namespace wrinkle
