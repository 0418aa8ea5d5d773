#include <algorithm>
#include <map>
#include <set>

#include "ir/compact.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

bool acts_by_components(Op op) {
    const Rule rule = info(op).rule;
    return rule == Rule::same || rule == Rule::broadcast || rule == Rule::floats ||
           op == Op::select_;
}

// Returns how many of the first parts of a construct are floats of one op that acts by components.
size_t run_length(const Module& m, std::span<const Id> parts) {
    const Op op = m[parts[0]].op;
    if (!acts_by_components(op)) return 1;
    const auto other = std::ranges::find_if(
        parts, [&](Id id) { return m[id].op != op || m.type(id) != Type::float_; });
    return std::max<size_t>(1, static_cast<size_t>(other - parts.begin()));
}

template <class Visit>
void for_each_run(const Module& m, std::span<const Id> parts, Visit visit) {
    while (!parts.empty()) {
        const size_t count = run_length(m, parts);
        visit(parts.first(count));
        parts = parts.subspan(count);
    }
}

class Packer {
public:
    explicit Packer(const Module& source) : uses_(count_uses(source)) {}

    static Id pack_one(void* context, Module& target, const Module& source, Id id,
                       std::span<const Id> mapped) {
        auto& packer = *static_cast<Packer*>(context);
        const auto operands = source.operands(id);
        packer.target_uses_.resize(target.size());
        for (size_t k = 0; k < operands.size(); ++k)
            packer.target_uses_[mapped[k]] = packer.uses_[operands[k]];
        if (source[id].op != Op::construct_ || source[id].type == Type::mat3_) return no_id;
        packer.m_ = &target;
        const uint32_t node = target.current_node;
        std::vector<Id> parts;
        const std::vector<Id> all(mapped.begin(), mapped.end());
        for_each_run(target, all, [&](std::span<const Id> run) { packer.append_run(run, parts); });
        target.current_node = node;
        return parts.size() == all.size() ? no_id
                                          : target.add(Op::construct_, parts, 0, source[id].type);
    }

    void drop_names(Module& packed) const {
        std::erase_if(packed.named, [&](const Named& named) {
            return !named.output && renamed_.contains(named.value);
        });
    }

private:
    static std::vector<uint32_t> count_uses(const Module& source) {
        std::vector<uint32_t> uses(source.size());
        const std::vector<bool> needed = reachable(source);
        for (Id id = 1; id < source.size(); ++id)
            if (needed[id])
                for (const Id operand : source.operands(id))
                    ++uses[operand];
        return uses;
    }

    // Appends the floats as one vector if that saves operations: each construct is one more vector
    // to write, each packed op saves all but one.
    void append_run(std::span<const Id> run, std::vector<Id>& parts) {
        packed_ = constructs_ = 0;
        const Id vector = run.size() > 1 && run[0] != run[1] ? packed(run) : no_id;
        if (vector != no_id && packed_ * (run.size() - 1) >= constructs_)
            parts.push_back(vector);
        else
            parts.insert(parts.end(), run.begin(), run.end());
    }

    using Lanes = std::vector<Id>;

    // Returns a value with these components; the scalar itself if all are the same. Constant stack.
    Id packed(std::span<const Id> root) {
        std::vector<Lanes> open{{root.begin(), root.end()}};
        while (!open.empty()) {
            const Lanes lanes = open.back();
            const std::vector<Lanes> operands = operands_of(lanes);
            const size_t before = open.size();
            for (const Lanes& operand : operands)
                if (!is_splat(operand) && !known_.contains(operand)) open.push_back(operand);
            if (open.size() > before) continue;
            open.pop_back();
            if (!is_splat(lanes) && !known_.contains(lanes))
                known_[lanes] = operands.empty() ? construct(lanes) : packed_op(lanes, operands);
        }
        return written({root.begin(), root.end()});
    }

    static bool is_splat(std::span<const Id> lanes) {
        return std::ranges::all_of(lanes, [&](Id id) { return id == lanes[0]; });
    }
    Id written(const Lanes& lanes) const { return is_splat(lanes) ? lanes[0] : known_.at(lanes); }

    // Returns the lanes of each operand if the lanes are results of one op, each read by as many
    // others, and choices by one condition; otherwise nothing.
    std::vector<Lanes> operands_of(const Lanes& lanes) const {
        const Inst& first = (*m_)[lanes[0]];
        std::vector<Lanes> operands;
        if (is_splat(lanes) || !alike(lanes)) return operands;
        for (size_t k = 0; k < static_cast<size_t>(info(first.op).arity); ++k) {
            Lanes& operand = operands.emplace_back();
            for (const Id lane : lanes)
                operand.push_back((*m_)[lane].arg[k]);
        }
        if (first.op == Op::select_ && !is_splat(operands[0])) operands.clear();
        return operands;
    }

    Id construct(std::span<const Id> lanes) {
        m_->current_node = m_->origin[lanes[0]];
        std::vector<Id> parts;
        for_each_run(*m_, lanes, [&](std::span<const Id> run) {
            if (run.size() > 1 && run.size() < lanes.size() && run[0] != run[1])
                parts.push_back(packed(run));
            else
                parts.insert(parts.end(), run.begin(), run.end());
        });
        const Id vector =
            m_->add(Op::construct_, parts, 0, vector_of(static_cast<int>(lanes.size())));
        if ((*m_)[vector].op == Op::construct_ && !m_->is_constant(vector)) ++constructs_;
        name(vector, lanes);
        return vector;
    }

    // Gives a vector the name that its lanes have, as "slope" of "slope_dx" and "slope_dy".
    void name(Id vector, std::span<const Id> lanes) {
        const Named* first = m_->name_of(lanes[0]);
        if (!first || first->output || m_->is_constant(vector)) return;
        const auto stem_of = [](std::string_view name) {
            const bool on_screen = name.ends_with("_dx") || name.ends_with("_dy");
            return name.substr(0, name.size() - (on_screen ? 3 : 0));
        };
        const std::string stem(stem_of(first->name));
        const auto is_alike = [&](Id lane) {
            const Named* other = m_->name_of(lane);
            return other && !other->output && stem_of(other->name) == stem;
        };
        if (!std::ranges::all_of(lanes, is_alike) || m_->name_of(vector)) return;
        m_->named.push_back({vector, first->node, stem, false, first->derived});
        renamed_.insert(lanes.begin(), lanes.end());
    }

    uint32_t uses(Id id) const { return id < target_uses_.size() ? target_uses_[id] : 0; }

    bool alike(const Lanes& lanes) const {
        const Op op = (*m_)[lanes[0]].op;
        return acts_by_components(op) && std::all_of(lanes.begin(), lanes.end(), [&](Id id) {
                   return (*m_)[id].op == op && m_->type(id) == Type::float_ &&
                          uses(id) == uses(lanes[0]);
               });
    }

    Id packed_op(const Lanes& lanes, std::span<const Lanes> operands) {
        const Op op = (*m_)[lanes[0]].op;
        const Type type = vector_of(static_cast<int>(lanes.size()));
        std::vector<Id> args;
        for (const Lanes& operand : operands) {
            const bool widen = op == Op::select_ && !args.empty() && is_splat(operand);
            args.push_back(widen ? m_->add(Op::construct_, operand, 0, type) : written(operand));
        }
        ++packed_;
        m_->current_node = m_->origin[lanes[0]];
        const Id vector = m_->add(op, args);
        name(vector, lanes);
        return vector;
    }

    Module* m_ = nullptr;                // the target
    std::vector<uint32_t> uses_;         // by Id of the source
    std::vector<uint32_t> target_uses_;  // by Id of the target
    std::map<Lanes, Id> known_;
    std::set<Id> renamed_;  // lanes of vectors that have their name
    size_t packed_ = 0, constructs_ = 0;
};

bool has_candidate(const Module& m) {
    for (Id id = 1; id < m.size(); ++id)
        if (m[id].op == Op::construct_ && run_length(m, m.operands(id)) > 1) return true;
    return false;
}

}  // namespace

Module pack(Module module) {
    const bool regions = module.region_count() > 1;
    if (!regions && !has_candidate(module)) return module;
    Packer packer(module);
    Module packed = rebuild(std::move(module), Packer::pack_one, &packer);
    packer.drop_names(packed);
    return packed;
}

}  // namespace wrinkle
