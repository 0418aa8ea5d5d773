// Rebuilds expressions: the loop that all passes over a module share.
//
// A ModuleCloner (ir/module_cloner.h) visits the instructions that some roots need, in id order,
// and writes each again with its operands replaced; writing simplifies, so the effects of a
// replaced leaf fold upwards. Instructions that no root needs are not copied (dead code
// elimination). Regions that change are rebuilt and re-interned. Constant stack, linear time.
#pragma once

#include <span>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

std::vector<Id> output_values(const Module& module);

// Marks the values that the roots need, including those in regions: needed[id] is true for them.
std::vector<bool> reachable(const Module& module, std::span<const Id> roots);
std::vector<bool> reachable(const Module& module);  // from the outputs

// Rebuilds a module from its outputs with one callback: `replace(target, source, id, mapped)`
// returns the new id of source instruction `id`, or no_id to copy it unchanged. mapped[] holds the
// new ids of its operands, followed, for a call of an open function, by those of the function's
// results. Side tables (nodes, parameters, resources, named values that are still needed, origins)
// are carried over; those of a moved-from source are in the target when `replace` is called.
using Replace = Id (*)(void* context, Module& target, const Module& source, Id id,
                       std::span<const Id> mapped);
Module rebuild(Module&& source, Replace replace, void* context);

// Returns `root` with each `from[i]` replaced by `to[i]`, in the same module. Types must agree.
// Only values that depend on a `from` are written again, by `replace` if it is given. Precondition:
// if a `to` is inside a region, the root is not; the root's loops move to deeper levels.
Id substitute(Module& module, Id root, std::span<const Id> from, std::span<const Id> to,
              Replace replace = nullptr, void* context = nullptr);

// lod = 0.5 log2(max(|size*duv/dx|^2, |size*duv/dy|^2, 2^-40)) of a resource, from the screen
// derivatives of the uv.
Id sample_lod_of(Module& module, uint32_t resource, Id uv_dx, Id uv_dy);

// Replaces each `sample` and `sample_grad` by a sample_lod with the lod above, from the uv's
// forward derivative or from the given one. The CPU and shaders with given differentials use this
// form.
Module explicit_lod(Module source);

// Replaces each differential of an input by zero and each `sample` and `sample_grad` by a
// sample_lod of level 0: the values that a vertex stage can compute.
Module without_differentials(Module source);

// Replaces mod(x, y) by x - y floor(x / y), for languages without it.
Module without_mod(Module source);

// Changes the origin of uv sets and images from the bottom to the top: each uv input (u, v) is read
// as (u, 1 - v), its differentials as (du, -dv), and images are sampled at the flipped uv. Values
// between them stay in the convention of the bottom. Tangents do not change: sign(w) cross(N, T)
// points up in the image, so against the new v. Run after explicit_lod().
Module with_uv_origin_top(Module source);

// Splits each loop into a loop of loops if the outputs run more than 8 loops in a row, those of
// called functions included. LLVM's loop strength reduction takes time exponential in the number of
// loops in a row: in llvmpipe 16 loops took 25 s to compile, and 1 s as loops of loops.
Module nest_loops(Module source);

}  // namespace wrinkle
