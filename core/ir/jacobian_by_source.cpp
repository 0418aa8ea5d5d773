#include "ir/jacobian_by_source.h"

#include <algorithm>
#include <optional>

#include "ir/derive.h"
#include "ir/module_cloner.h"

namespace wrinkle {
namespace {

Value times_factor(Value a, Value factor) {
    if (!a) return factor;
    return factor ? a * factor : a;
}

// d value / d instruction. `whole`: it is `factor` times the identity (an empty factor is 1);
// otherwise `lanes` holds its columns.
struct Columns {
    bool whole = false;
    Value factor;
    std::array<Scaled, 4> lanes;
};

class ReversePass {
public:
    explicit ReversePass(Value value)
        : m_(*value.module), value_(value.id), local_(m_), columns_(value.id + size_t{1}) {
        local_.differentiate_detached();
    }

    std::vector<SourceJacobian> run() {
        const std::vector<Id> needed = what_varies();
        if (needed.empty() || needed.back() != value_) return {};
        columns_[value_] = Columns{true, {}, {}};
        std::vector<SourceJacobian> found;
        for (size_t i = needed.size(); i-- > 0;) {
            const Id id = needed[i];
            if (!columns_[id]) continue;
            if (m_[id].op == Op::with_covariance_) {
                make_explicit(id);
                found.push_back({id, columns_[id]->lanes});
            }
            for (const Id read : reads_of(m_, id))
                if (read < varies_.size() && varies_[read]) pass_on(id, read);
        }
        std::reverse(found.begin(), found.end());
        return found;
    }

private:
    // Returns the instructions that the value depends on and that depend on a source, in id order.
    std::vector<Id> what_varies() {
        std::vector<Id> needed;
        walk({&value_, 1}, [&](Id id, std::vector<Id>& open) {
            if (local_.is_constant(m_[id])) return;
            needed.push_back(id);
            for (const Id read : reads_of(m_, id))
                open.push_back(read);
        });
        std::sort(needed.begin(), needed.end());
        varies_.assign(value_ + size_t{1}, false);
        std::erase_if(needed, [&](Id id) {
            const std::vector<Id> reads = reads_of(m_, id);
            varies_[id] =
                m_[id].op == Op::with_covariance_ ||
                std::any_of(reads.begin(), reads.end(), [&](Id read) { return varies_[read]; });
            return !varies_[id];
        });
        return needed;
    }

    void pass_on(Id id, Id read) {
        const Columns& of = *columns_[id];
        if (of.whole && stays_whole(id, read)) return;
        for (uint32_t lane = 0; lane < info(m_.type(read)).lanes; ++lane) {
            const Id unit = m_.unit(m_.type(read), lane);
            const Value derivative{&m_, local_.local_jvp(id, read, unit)};
            if (!derivative) continue;
            if (of.whole)
                add(read, lane, without_factors(derivative, of.factor));
            else
                add_combined(read, lane, derivative, of.lanes);
        }
    }

    // Handles an instruction that is `read` times a scalar, through which a multiple of the
    // identity stays one. Returns false for all others.
    bool stays_whole(Id id, Id read) {
        const Inst inst = m_[id];
        const Value factor = columns_[id]->factor;
        if (m_.type(read) != inst.type || inst.arg[0] == inst.arg[1]) return false;
        switch (inst.op) {
            case Op::detach_:
            case Op::with_covariance_:
                if (read == inst.arg[0]) add_whole(read, factor);
                return true;
            case Op::add_:
                if (m_.type(inst.arg[0]) != m_.type(inst.arg[1])) return false;
                add_whole(read, factor);
                return true;
            case Op::sub_:
                if (m_.type(inst.arg[0]) != m_.type(inst.arg[1])) return false;
                add_whole(read, read == inst.arg[0] ? factor : negative(factor));
                return true;
            case Op::neg_:
                add_whole(read, negative(factor));
                return true;
            case Op::mul_: {
                const Id other = inst.arg[read == inst.arg[0] ? 1 : 0];
                if (m_.type(other) != Type::float_) return false;
                add_whole(read, times_factor({&m_, other}, factor));
                return true;
            }
            default:
                return false;
        }
    }

    Value negative(Value factor) { return factor ? -factor : Value{&m_, m_.number(-1)}; }

    void add_whole(Id id, Value factor) {
        if (!columns_[id]) {
            columns_[id] = Columns{true, factor, {}};
        } else if (columns_[id]->whole) {
            Value& known = columns_[id]->factor;
            const Value one{&m_, m_.number(1)};
            known = (known ? known : one) + (factor ? factor : one);
        } else {
            for (uint32_t lane = 0; lane < info(m_.type(id)).lanes; ++lane)
                add(id, lane, {{&m_, m_.unit(m_.type(id), lane)}, factor});
        }
    }

    void make_explicit(Id id) {
        if (!columns_[id]->whole) return;
        const Value factor = columns_[id]->factor;
        columns_[id] = Columns{};
        for (uint32_t lane = 0; lane < info(m_.type(id)).lanes; ++lane)
            add(id, lane, {{&m_, m_.unit(m_.type(id), lane)}, factor});
    }

    // The chain rule: each component of `derivative` times the column of that component.
    void add_combined(Id read, uint32_t lane, Value derivative, std::array<Scaled, 4> of) {
        const uint32_t count = info(m_.type(derivative.id)).lanes;
        for (uint32_t i = 0; i < count; ++i) {
            const Value number{&m_, m_.component(derivative.id, i)};
            if (!of[i].vector || m_.is_literal(number.id, 0)) continue;
            const bool is_one = m_.is_literal(number.id, 1);
            add(read, lane,
                {of[i].vector, is_one ? of[i].factor : times_factor(number, of[i].factor)});
        }
    }

    void add(Id id, uint32_t lane, const Scaled& more) {
        if (!columns_[id]) columns_[id] = Columns{};
        if (columns_[id]->whole) make_explicit(id);
        Scaled& known = columns_[id]->lanes[lane];
        if (!known.vector) {
            known = more;
        } else if (known.vector.id == more.vector.id) {
            const Value one{&m_, m_.number(1)};
            known.factor = (known.factor ? known.factor : one) + (more.factor ? more.factor : one);
        } else if (known.factor.id == more.factor.id) {
            known.vector = known.vector + more.vector;
        } else {
            known = {
                times_factor(known.vector, known.factor) + times_factor(more.vector, more.factor),
                {}};
        }
    }

    Module& m_;
    const Id value_;
    ForwardDiff local_;
    std::vector<std::optional<Columns>> columns_;  // by Id
    std::vector<bool> varies_;                     // by Id
};

}  // namespace

std::vector<SourceJacobian> jacobians_by_source(Value value) {
    return ReversePass(value).run();
}

}  // namespace wrinkle
