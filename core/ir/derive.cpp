#include "ir/derive.h"

#include <algorithm>
#include <utility>

#include "ir/rewrite.h"
#include "ir/surface.h"
#include "ir/value.h"

namespace wrinkle {

std::vector<Id> reads_of(const Module& m, Id value) {
    const Inst& inst = m[value];
    if (is_sample(inst.op)) return {inst.arg[0]};
    if (inst.op == Op::swizzle_ && is_sample(m[inst.arg[0]].op)) return {m[inst.arg[0]].arg[0]};
    const Id of = inst.op == Op::result_ ? inst.arg[0] : value;
    const auto operands = m.operands(of);
    std::vector<Id> reads(operands.begin(), operands.end());
    if (m[of].op == Op::loop_)
        for (const Id captured : region_body(m, m.region(m[of].extra)).captured)
            reads.push_back(captured);
    std::sort(reads.begin(), reads.end());
    reads.erase(std::unique(reads.begin(), reads.end()), reads.end());
    return reads;
}

Id ForwardDiff::local_jvp(Id value, Id operand, Id derivative) {
    const std::vector<Id> reads = reads_of(*module_, value);
    for (const Id read : reads)
        memo_.set(read, read == operand ? derivative : no_id);
    const uint32_t node = std::exchange(module_->current_node, module_->origin[value]);
    const Id result = compute(value);
    module_->current_node = node;
    forget(0);
    for (const Id read : reads)
        memo_.forget(read);
    loops_.clear();
    return result;
}

Id ForwardDiff::jvp(Id value) {
    if (value == no_id || memo_.has(value)) return memo_.at(value);
    // The body of a loop calls jvp() again from compute(), with a list of its own.
    std::vector<Id> list = std::exchange(spare_list_, {});
    collect_worklist(value, list);
    const uint32_t node = module_->current_node;
    for (const Id id : list) {
        module_->current_node = module_->origin[id];
        const Id derivative = compute(id);
        if (derivative != no_id) module_->name_slope(id, derivative, suffix());
        memo_.set(id, derivative);
        log_.push_back(id);
    }
    module_->current_node = node;
    spare_list_ = std::move(list);
    return memo_.at(value);
}

// Returns the end of a derivative's name: "_dx" along screen x, "_dy" along screen y.
std::string_view ForwardDiff::suffix() const {
    const bool on_screen = axis_ != DiffAxis::none && axis_ < DiffAxis::space_x;
    return !on_screen ? "" : is_y(axis_) ? "_dy" : "_dx";
}

// Collects and marks the values that the derivative of `value` needs and that have none yet, in id
// order.
void ForwardDiff::collect_worklist(Id value, std::vector<Id>& list) {
    list.clear();
    open_.assign(1, value);
    while (!open_.empty()) {
        const Id id = open_.back();
        open_.pop_back();
        if (id == no_id || !memo_.mark(id)) continue;
        list.push_back(id);
        const Inst& inst = (*module_)[id];
        if (is_constant(inst)) continue;
        for (const Id operand : module_->operands(id))
            open_.push_back(operand);
        // Captured values of a loop are differentiated once, outside, independently of its body.
        if (inst.op == Op::loop_)
            for (const Id captured : region_body(*module_, module_->region(inst.extra)).captured)
                open_.push_back(captured);
    }
    std::sort(list.begin(), list.end());
}

Id ForwardDiff::jvp_or_zero(Id value) {
    const Id derivative = jvp(value);
    return derivative ? derivative : module_->zero(module_->type(value));
}

Id ForwardDiff::derivative_of_input(uint32_t index) {
    const OpenInput input = module_->open_inputs[index];
    if (!is_float_type(input.type) || !(input.dependencies & varying_)) return no_id;
    const uint32_t known = input.derivatives[static_cast<size_t>(axis_)];
    if (known) return module_->region_parameter(0, known, input.type);
    OpenInput changed = input;
    changed.tangent = false;
    changed.axis = axis_;
    changed.of = index;
    changed.derivatives = {};
    const Id id = module_->add_open_input(std::move(changed));
    module_->open_inputs[index].derivatives[static_cast<size_t>(axis_)] = (*module_)[id].extra;
    return id;
}

// Before expansion the derivative is an op (ddx, ddy), which expand() replaces.
Id ForwardDiff::derivative_of_open_result(Id result) {
    if (axis_ == DiffAxis::screen_x) return module_->add(Op::ddx_, {result});
    if (axis_ == DiffAxis::screen_y) return module_->add(Op::ddy_, {result});
    return no_id;
}

Id ForwardDiff::compute(Id id) {
    const Inst inst = (*module_)[id];
    if (module_->is_open_input(id)) return derivative_of_input(inst.extra);
    if (is_float_type(inst.type) && module_->open_result(id)) return derivative_of_open_result(id);
    if (is_constant(inst) || inst.type == Type::tuple_) return no_id;
    if (inst.op == Op::detach_ || inst.op == Op::with_covariance_) return memo_.at(inst.arg[0]);
    if (inst.op == Op::result_)
        return (*module_)[inst.arg[0]].op == Op::loop_ ? loop_member(inst) : call_member(inst);
    if (is_sample(inst.op)) return texture(id, id);
    // Takes differences of the components that are read, not of all four.
    if (inst.op == Op::swizzle_ && is_sample((*module_)[inst.arg[0]].op))
        return texture(inst.arg[0], id);
    std::array<Id, 4> derivatives{};
    size_t count = 0;
    bool any = false;
    for (const Id operand : module_->operands(id)) {
        derivatives[count] = memo_.at(operand);
        any = any || derivatives[count];
        ++count;
    }
    if (!any) return no_id;
    const Id derivative = jvp_rule(*module_, id, std::span(derivatives.data(), count));
    return module_->is_literal(derivative, 0) ? no_id : derivative;
}

struct ForwardDiff::Screen {
    ForwardDiff x, y;
};

ForwardDiff::Screen& ForwardDiff::screen() {
    if (!screen_) {
        own_screen_ =
            std::make_shared<Screen>(Screen{direction_along(*module_, DiffAxis::screen_x),
                                            direction_along(*module_, DiffAxis::screen_y)});
        screen_ = own_screen_->x.screen_ = own_screen_->y.screen_ = own_screen_.get();
    }
    return *screen_;
}

// Forward differences over one texel of the mip level in use, times the derivative of uv. `read` is
// the sample itself or a swizzle of it.
Id ForwardDiff::texture(Id sample, Id read) {
    Module& m = *module_;
    const Inst inst = m[sample];
    const Inst reader = m[read];
    const Value derivative{&m, memo_.at(inst.arg[0])};
    if (!derivative) return no_id;
    Id lod = inst.arg[1];
    if (inst.op == Op::sample_) {
        const Id x = screen().x.jvp_or_zero(inst.arg[0]);
        lod = sample_lod_of(m, inst.extra, x, screen().y.jvp_or_zero(inst.arg[0]));
    } else if (inst.op == Op::sample_grad_) {
        lod = sample_lod_of(m, inst.extra, inst.arg[1], inst.arg[2]);
    }
    const Value size{&m, m.add(Op::image_size_, {}, inst.extra)};
    const Value one{&m, m.number(1)}, none{&m, m.number(0)};
    const Value coarsest = max(size.x(), size.y());
    const Value texels = op(Op::clamp_, op(Op::exp2_, {&m, lod}), one, coarsest);
    const Value step = Value{&m, m.construct(Type::vec2_, {texels.id, texels.id})} / size;
    const Value uv{&m, inst.arg[0]};
    const auto tap = [&](Value at) {
        std::array<Id, 3> args{at.id, inst.arg[1], inst.arg[2]};
        const auto arity = static_cast<size_t>(info(inst.op).arity);
        const Id texel = m.add(inst.op, std::span(args.data(), arity), inst.extra);
        return Value{&m, read == sample ? texel : m.add(Op::swizzle_, {texel}, reader.extra)};
    };
    const Value here{&m, read};
    const Value along_u = (tap(uv + vec2(step.x(), none)) - here) / step.x();
    const Value along_v = (tap(uv + vec2(none, step.y())) - here) / step.y();
    return (along_u * derivative.x() + along_v * derivative.y()).id;
}

Id ForwardDiff::loop_member(const Inst& result) {
    std::vector<Id>& members = loops_[result.arg[0]];
    if (members.empty()) members = dual_loop(result.arg[0]);
    return members[result.extra];
}

void ForwardDiff::forget(size_t first) {
    for (size_t i = first; i < log_.size(); ++i) {
        memo_.forget(log_[i]);
        loops_.erase(log_[i]);
    }
    log_.resize(first);
}

// Marks the members of the state that become active because of those marked; returns false if none
// was added.
bool ForwardDiff::propagate_activity(const Region& region, std::vector<bool>& active) {
    bool grew = false;
    for (size_t k = 0; k < active.size(); ++k) {
        if (active[k] || jvp(region.results[k + 1]) == no_id) continue;
        active[k] = grew = true;
    }
    return grew;
}

// Seeds the state: the derivatives of active members are parameters after the state, in order; the
// other members are constant.
void ForwardDiff::seed_state(const Region& region, const std::vector<bool>& active) {
    auto next = static_cast<uint32_t>(active.size());
    for (uint32_t k = 0; k < active.size(); ++k) {
        const Type type = region.params[k];
        const Id param = module_->region_parameter(region.level, k, type);
        memo_.set(param, active[k] ? module_->region_parameter(region.level, next++, type) : no_id);
        log_.push_back(param);
    }
}

// Returns the derivatives of a loop's members: results of a loop over the state followed by the
// derivatives of its active members (dual numbers).
std::vector<Id> ForwardDiff::dual_loop(Id loop) {
    const Inst inst = (*module_)[loop];
    Region region = module_->region(inst.extra);
    const auto operands = module_->operands(loop);
    std::vector<Id> args(operands.begin(), operands.end());
    const size_t own = args.size();
    std::vector<bool> active;
    for (const Id arg : args)
        active.push_back(memo_.at(arg) != no_id);
    const size_t before = log_.size();
    do {
        forget(before);
        seed_state(region, active);
    } while (propagate_activity(region, active));
    std::vector<Id> members(own, no_id);
    const std::vector<Type> types = region.params;
    for (size_t k = 0; k < own; ++k) {
        if (!active[k]) continue;
        const Id start = memo_.at(args[k]);
        args.push_back(start ? start : module_->zero(types[k]));
        region.params.push_back(types[k]);
        if (!region.param_names.empty())
            region.param_names.push_back(region.param_names[k] + "_slope");
        region.results.push_back(jvp_or_zero(region.results[k + 1]));
    }
    forget(before);
    if (region.params.size() == own) return members;
    const Id wide = module_->apply_region(module_->intern_region(std::move(region)), args);
    auto next = static_cast<uint32_t>(own);
    for (size_t k = 0; k < own; ++k)
        if (active[k]) members[k] = module_->result(wide, next++);
    return members;
}

void ForwardDiff::seed_input(SurfaceInput input, Id derivative) {
    seed(module_->input(input), derivative);
    varying_ |= 1U << static_cast<uint32_t>(input);
}

void ForwardDiff::seed_screen() {
    constexpr SurfaceInput varying[] = {SurfaceInput::normal_, SurfaceInput::uv0_,
                                        SurfaceInput::uv1_,    SurfaceInput::uv2_,
                                        SurfaceInput::uv3_,    SurfaceInput::color0_};
    const Variant axis = is_y(axis_) ? Variant::dy : Variant::dx;
    const uint32_t node = std::exchange(module_->current_node, 0);
    for (const SurfaceInput input : varying)
        seed_input(input, module_->input(input, axis));
    seed_input(SurfaceInput::position_, axis_ >= DiffAxis::surface_x
                                            ? projected_position(*module_, axis)
                                            : module_->input(SurfaceInput::position_, axis));
    module_->current_node = node;
}

ForwardDiff direction_along(Module& module, DiffAxis axis) {
    ForwardDiff direction(module, axis);
    const auto after = [&](DiffAxis first) {
        return static_cast<uint32_t>(axis) - static_cast<uint32_t>(first);
    };
    if (axis >= DiffAxis::uv0_u) {
        const uint32_t index = after(DiffAxis::uv0_u);
        const auto set = static_cast<uint32_t>(SurfaceInput::uv0_) + index / 2;
        direction.seed_input(static_cast<SurfaceInput>(set), module.unit(Type::vec2_, index % 2));
    } else if (axis >= DiffAxis::space_x) {
        direction.seed_input(SurfaceInput::position_,
                             module.unit(Type::vec3_, after(DiffAxis::space_x)));
    } else {
        direction.seed_screen();
    }
    return direction;
}

}  // namespace wrinkle
