#include "ir/covariance.h"

#include <map>
#include <utility>

#include "ir/jacobian_by_source.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

class Terms {
public:
    void add_source(Module& m, const SourceJacobian& jacobian) {
        const Value covariance{&m, m[jacobian.source].arg[1]};
        if (m.type(jacobian.source) == Type::vec3_) {
            for (size_t i = 0; i < 3; ++i)
                add(jacobian.columns[i], jacobian.columns[i], covariance);
            return;
        }
        add(jacobian.columns[0], jacobian.columns[0], covariance.x());
        add(jacobian.columns[1], jacobian.columns[1], covariance.y());
        add(jacobian.columns[0], jacobian.columns[1], covariance.z() * 2);
    }
    std::vector<CovarianceTerm> list() && { return std::move(terms_); }

private:
    void add(const Scaled& a, const Scaled& b, Value weight) {
        if (!a.vector || !b.vector) return;
        if (a.factor) weight = weight * a.factor;
        if (b.factor) weight = weight * b.factor;
        const auto [place, is_new] =
            places_.try_emplace(std::pair(a.vector.id, b.vector.id), terms_.size());
        if (is_new)
            terms_.push_back({a.vector, b.vector, weight});
        else
            terms_[place->second].weight = terms_[place->second].weight + weight;
    }

    std::vector<CovarianceTerm> terms_;
    std::map<std::pair<Id, Id>, size_t> places_;
};

Id drop_one(void*, Module&, const Module& source, Id id, std::span<const Id> mapped) {
    return source[id].op == Op::with_covariance_ ? mapped[0] : no_id;
}

}  // namespace

std::vector<CovarianceTerm> covariance_terms(Value value) {
    Terms terms;
    for (const SourceJacobian& jacobian : jacobians_by_source(value))
        terms.add_source(*value.module, jacobian);
    return std::move(terms).list();
}

Value covariance_of(Value value) {
    Value sum;
    for (const auto& [a, b, weight] : covariance_terms(value)) {
        const Value crossed = (a.x() * b.y() + a.y() * b.x()) * 0.5;
        const Value part = vec3(a.x() * b.x(), a.y() * b.y(), crossed) * weight;
        sum = sum ? sum + part : part;
    }
    return sum;
}

Module drop_covariances(Module source) {
    if (!source.has(Op::with_covariance_)) return source;
    return rebuild(std::move(source), drop_one, nullptr);
}

}  // namespace wrinkle
