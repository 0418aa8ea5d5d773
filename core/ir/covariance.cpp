#include "ir/covariance.h"

#include <map>
#include <utility>

#include "ir/jacobian_by_source.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

Id drop_one(void*, Module&, const Module& source, Id id, std::span<const Id> mapped) {
    return source[id].op == Op::with_covariance_ ? mapped[0] : no_id;
}

}  // namespace

std::vector<CovarianceTerm> covariance_terms(Value value) {
    Module& m = *value.module;
    std::vector<CovarianceTerm> terms;
    std::map<std::pair<Id, Id>, size_t> places;
    const auto add = [&](const Scaled& a, const Scaled& b, Value weight) {
        if (!a.vector || !b.vector) return;
        if (a.factor) weight = weight * a.factor;
        if (b.factor) weight = weight * b.factor;
        const auto [place, is_new] = places.try_emplace({a.vector.id, b.vector.id}, terms.size());
        if (is_new)
            terms.push_back({a.vector, b.vector, weight});
        else
            terms[place->second].weight = terms[place->second].weight + weight;
    };
    for (const auto& [source, columns] : jacobians_by_source(value)) {
        const Value covariance{&m, m[source].arg[1]};
        if (m.type(source) == Type::vec3_) {
            for (size_t i = 0; i < 3; ++i)
                add(columns[i], columns[i], covariance);
            continue;
        }
        add(columns[0], columns[0], covariance.x());
        add(columns[1], columns[1], covariance.y());
        add(columns[0], columns[1], covariance.z() * 2);
    }
    return terms;
}

Value covariance_of(Value value) {
    Value sum;
    for (const auto& [a, b, weight] : covariance_terms(value)) {
        const Value crossed = (a.x() * b.y() + a.y() * b.x()) * 0.5;
        sum = sum_of(sum, vec3(a.x() * b.x(), a.y() * b.y(), crossed) * weight);
    }
    return sum;
}

Module drop_covariances(Module source) {
    if (!source.has(Op::with_covariance_)) return source;
    return rebuild(std::move(source), drop_one, nullptr);
}

}  // namespace wrinkle
