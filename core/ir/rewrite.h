// Rebuilding expressions: the one loop that every pass over a module shares.
//
// A Rewriter walks the instructions that some roots need, in id order, and writes each one again
// with its operands replaced; since writing simplifies, a replaced leaf folds upwards by itself.
// Regions that change are rebuilt and re-interned. Constant stack, linear time.
#pragma once

#include <span>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

// Marks what the roots need, through regions too. needed[id] is true for those.
std::vector<bool> reachable(const Module& module, std::span<const Id> roots);

// In the same module: `root` with each `from[i]` replaced by `to[i]`. Types must agree. Only what
// depends on them is written anew. Where a `to` stands inside a region, the root must not: its own
// loops move inwards.
Id substitute(Module& module, Id root, std::span<const Id> from, std::span<const Id> to);

// Rebuilds a module from its outputs with one callback: `replace(target, source, id, mapped)`
// returns the new id of source instruction `id`, or poison to write it again as it is; mapped[]
// holds the new ids of its operands, and after those of a call of an open function what the
// function gives. Side tables (nodes, parameters, resources, named values that are still needed,
// origins) come along; those of a source that is given away are the target's when `replace` is
// called.
using Replace = Id (*)(void* context, Module& target, const Module& source, Id id,
                       std::span<const Id> mapped);
Module rebuild(Module&& source, Replace replace, void* context);
Module rebuild(const Module& source, Replace replace, void* context);

// lod = 0.5 log2(max(|size*duv/dx|^2, |size*duv/dy|^2, 2^-40)) of a resource, from the uv's change
// to the next pixels.
Id sample_lod_of(Module& module, uint32_t resource, Id uv_dx, Id uv_dy);

// Each `sample` and `sample_grad` becomes sample_lod with the lod above, from the uv's forward
// derivative or from the given one. The CPU and shaders with given differentials use this form.
Module explicit_lod(Module source);

}  // namespace wrinkle
