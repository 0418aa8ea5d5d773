#include "ir/rewrite.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <unordered_map>

#include "ir/derive.h"
#include "ir/module_cloner.h"
#include "ir/value.h"

namespace wrinkle {
namespace {

// Footprints below a millionth of a texel are clamped; they are on the finest level too.
constexpr double min_footprint = 9.094947017729282e-13;  // 2^-40
constexpr std::string_view footprint_name = "min_footprint // in squared texels, 2^-40";

struct LodWriter {
    std::optional<ForwardDiff> x, y;
};

Id write_lod(void* context, Module& target, const Module& source, Id id,
             std::span<const Id> mapped) {
    const auto with = [&](Id lod) {
        return target.add(Op::sample_lod_, {mapped[0], lod}, source[id].extra);
    };
    if (source[id].op == Op::sample_grad_)
        return with(sample_lod_of(target, source[id].extra, mapped[1], mapped[2]));
    if (source[id].op != Op::sample_) return no_id;
    auto& writer = *static_cast<LodWriter*>(context);
    if (!writer.x) {
        writer.x = direction_along(target, DiffAxis::screen_x);
        writer.y = direction_along(target, DiffAxis::screen_y);
    }
    return with(sample_lod_of(target, source[id].extra, writer.x->jvp_or_zero(mapped[0]),
                              writer.y->jvp_or_zero(mapped[0])));
}

// Loops of the root move to levels deeper than those of the new values. Values that depend on no
// `from` need not move and stay one value.
void keep_what_does_not_read(const Module& m, Id root, std::span<const Id> from,
                             ModuleCloner& copier) {
    std::unordered_map<Id, bool> reads{{no_id, false}};
    for (const Id id : from)
        reads[id] = true;
    std::vector<Id> list, below;
    walk({&root, 1}, [&](Id id, std::vector<Id>& open) {
        if (reads.contains(id)) return;
        list.push_back(id);
        append_dependencies(m, id, false, open);
    });
    std::sort(list.begin(), list.end());
    for (const Id id : list) {
        below.clear();
        append_dependencies(m, id, false, below);
        const bool changes =
            std::any_of(below.begin(), below.end(), [&](Id other) { return reads.at(other); });
        reads[id] = changes;
        if (!changes && m[id].level == 0) copier.map(id, id);
    }
}

}  // namespace

Id sample_lod_of(Module& module, uint32_t resource, Id uv_dx, Id uv_dy) {
    const Value size{&module, module.add(Op::image_size_, {}, resource)};
    // In the order of a height map's own footprint, so that both are one value.
    const Value x = Value{&module, uv_dx} * size;
    const Value y = Value{&module, uv_dy} * size;
    const Value square = max(max(dot(x, x), dot(y, y)), constant(footprint_name, x, min_footprint));
    return (op(Op::log2_, square) * 0.5).id;
}

std::vector<Id> output_values(const Module& module) {
    std::vector<Id> values;
    for (const ModuleOutput& output : module.outputs)
        values.push_back(output.value);
    return values;
}

std::vector<bool> reachable(const Module& module) {
    return reachable(module, output_values(module));
}

// Operands have smaller ids, so one descending loop visits every user before its operands.
std::vector<bool> reachable(const Module& module, std::span<const Id> roots) {
    std::vector<bool> needed(module.size(), false);
    for (const Id root : roots)
        needed[root] = true;
    std::vector<Id> below;
    for (Id id = module.size(); id-- > 1;) {
        if (!needed[id]) continue;
        if (module[id].op == Op::loop_ || module[id].op == Op::call_) {
            below.clear();
            append_dependencies(module, id, true, below);
            for (const Id operand : below)
                needed[operand] = true;
            continue;
        }
        const Inst& inst = module[id];
        for (size_t i = 0; i < inst.arg.size() && inst.arg[i] != no_id; ++i)
            needed[inst.arg[i]] = true;
        if (inst.type == Type::gradient_) needed[inst.extra] = true;  // its base
    }
    needed[no_id] = false;
    return needed;
}

Id substitute(Module& module, Id root, std::span<const Id> from, std::span<const Id> to,
              Replace replace, void* context) {
    ModuleCloner copier(module, module, false);
    copier.set_replace(replace, context);
    int deepest = 0;
    for (size_t i = 0; i < from.size(); ++i) {
        copier.map(from[i], to[i]);
        deepest = std::max<int>(deepest, module[to[i]].level);
    }
    assert(deepest == 0 || module[root].level == 0);
    copier.set_shift(1, deepest);
    keep_what_does_not_read(module, root, from, copier);
    copier.run(std::span(&root, 1));
    return copier[root];
}

Module rebuild(Module&& source, Replace replace, void* context) {
    Module target;
    target.most_values = source.most_values;
    target.reserve(source.size());
    target.nodes = std::move(source.nodes);
    target.titles = std::move(source.titles);
    target.parameters = std::move(source.parameters);
    target.resources = std::move(source.resources);
    target.open_inputs = std::move(source.open_inputs);
    target.problems = std::move(source.problems);
    ModuleCloner copier(target, source, true);
    copier.set_replace(replace, context);
    std::ranges::stable_sort(source.named, {}, &Named::value);
    copier.carry_names(std::move(source.named));
    copier.run(output_values(source));
    target.outputs = std::move(source.outputs);
    for (ModuleOutput& output : target.outputs)
        output.value = copier[output.value];
    return target;
}

Module without_differentials(Module source) {
    const auto replace = [](void*, Module& target, const Module& from, Id id,
                            std::span<const Id> mapped) -> Id {
        const Inst& inst = from[id];
        if (inst.op == Op::input_ && variant_of(inst.extra) != Variant::value)
            return target.zero(inst.type);
        if (inst.op != Op::sample_ && inst.op != Op::sample_grad_) return no_id;
        return target.add(Op::sample_lod_, {mapped[0], target.number(0)}, inst.extra);
    };
    return rebuild(std::move(source), replace, nullptr);
}

Module without_mod(Module source) {
    const Replace replace = [](void*, Module& target, const Module& from, Id id,
                               std::span<const Id> mapped) {
        if (from[id].op != Op::mod_) return no_id;
        const Id quotient = target.add(Op::floor_, {target.add(Op::div_, {mapped[0], mapped[1]})});
        return target.add(Op::sub_, {mapped[0], target.add(Op::mul_, {quotient, mapped[1]})});
    };
    return rebuild(std::move(source), replace, nullptr);
}

Module explicit_lod(Module source) {
    LodWriter writer;
    return rebuild(std::move(source), write_lod, &writer);
}

}  // namespace wrinkle
