#include "ir/expand.h"

#include <vector>

#include "ir/rewrite.h"
#include "ir/value.h"

namespace wrinkle {
namespace {

// Returns v if `id` is inversesqrt(dot(v, v)), otherwise no_id.
Id inverse_length_of(const Module& m, Id id) {
    if (m[id].op != Op::inversesqrt_) return no_id;
    const Inst& square = m[m[id].arg[0]];
    return square.op == Op::dot_ && square.arg[0] == square.arg[1] ? square.arg[0] : no_id;
}

struct Finisher {
    const Covariances covariances;
    std::vector<bool> inverse_known;  // by Id of the source: 1 / its length is computed

    Finisher(const Module& source, Covariances wanted)
        : covariances(wanted), inverse_known(source.size(), false) {
        if (!source.has(Op::inversesqrt_)) return;
        const std::vector<bool> needed = reachable(source);
        for (Id id = 1; id < source.size(); ++id)
            if (needed[id] && source[id].level == 0)
                inverse_known[inverse_length_of(source, id)] = true;
        inverse_known[no_id] = false;
    }
};

// Returns true if an operand of any instruction is a detach. Precondition: there are no regions.
bool reads_detached(const Module& m) {
    if (!m.has(Op::detach_)) return false;
    Id first = 1;
    while (m[first].op != Op::detach_)
        ++first;
    for (Id id = first + 1; id < m.size(); ++id)
        for (const Id operand : m[id].arg)
            if (m[operand].op == Op::detach_) return true;
    return false;
}

bool divides_by_length(const Module& m) {
    for (Id id = 1; m.has(Op::inversesqrt_) && id < m.size(); ++id)
        if (inverse_length_of(m, id) != no_id) return true;
    return false;
}

// Returns true if the pass would change only outputs that are detached; replaces these by the
// detached values.
bool take_outputs(Module& m) {
    if (m.region_count() > 1 || m.has(Op::with_covariance_)) return false;
    if (divides_by_length(m) || reads_detached(m)) return false;
    for (ModuleOutput& output : m.outputs)
        if (m[output.value].op == Op::detach_) output.value = m[output.value].arg[0];
    return true;
}

Id finish_one(void* context, Module& target, const Module& source, Id id,
              std::span<const Id> mapped) {
    const auto& finisher = *static_cast<const Finisher*>(context);
    if (source[id].op == Op::detach_) return mapped[0];
    if (source[id].op == Op::with_covariance_)
        return finisher.covariances == Covariances::kept ? no_id : mapped[0];
    if (source[id].op != Op::normalize_ || !finisher.inverse_known[source[id].arg[0]]) return no_id;
    const Value v{&target, mapped[0]};
    return (v * inversesqrt(dot(v, v))).id;
}

}  // namespace

Module finish(Module expanded, Covariances covariances) {
    if (take_outputs(expanded)) return expanded;
    Finisher finisher(expanded, covariances);
    return rebuild(std::move(expanded), finish_one, &finisher);
}

}  // namespace wrinkle
