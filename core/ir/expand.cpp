#include "ir/expand.h"

#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/normals.h"
#include "ir/compact.h"
#include "ir/gradient_sum.h"
#include "ir/normal_variance.h"
#include "ir/open_function.h"
#include "ir/rewrite.h"
#include "ir/surface.h"

namespace wrinkle {
namespace {

// FLT_EPSILON: keeps SurfgradFromPerturbedNormal finite where the normal lies in the tangent plane.
constexpr double min_cosine = 1.1920929e-7;

constexpr std::string_view cosine_name = "min_cosine // between the normal and one in its plane";
constexpr std::string_view ratio_name = "min_ratio // of z to x and y: slopes are at most 128";
constexpr std::string_view depth_name = "min_z // of a normal map: the zero vector is flat";

struct Derivative {
    Value slope;  // in the uv; normals: xy, and the slope is -xy strength / depth
    Frame frame;
    Value strength, depth;  // normals only
};

struct Expander {
    Expander(const ExpandOptions& o, const Module& source) : options(o), facts(source) {}

    const ExpandOptions& options;
    const ValueAnalysis facts;  // for the source
    Module* target = nullptr;
    std::optional<OpenFunctions> functions;
    std::optional<ScreenDerivatives> screen;
    std::optional<GradientAlgebra> algebra;
    std::optional<NormalVariance> variance;  // only if an output or the options need it
    // An opaque value is mapped not to an Id of the target but to its index in the vector of its
    // type. The first two entries are empty: 0 is no_id, 1 any value that cannot be expanded.
    static constexpr Id unexpanded = 1;
    std::vector<Frame> frames{2};
    std::map<std::tuple<Id, Id, uint32_t, std::optional<SurfaceInput>>, Id> known_frames;
    std::vector<Derivative> derivatives{2};
    std::vector<GradientSum> gradients{2};
    // By source Id: the resolved normal; empty for the surface.
    std::unordered_map<Id, Value> bases;

    Value value(Id id) const { return {target, id}; }
    Id parameter(const Parameter& parameter);
    Value base_normal(const Module& source, Id gradient) const;
    Value resolved(const Module& source, Id resolve, const GradientSum& gradient);
    Id opaque(const Module& source, Id id, std::span<const Id> mapped);
    GradientSum gradient(const Module& source, Id id, std::span<const Id> mapped);
    GradientSum source_gradient(const Module& source, Id id, std::span<const Id> mapped);
    GradientSum scaled(const GradientSum& gradient, Value amount);
    GradientSum gradient_from_position(Id height);
    GradientSum from_derivative(const Derivative& d);
    GradientSum from_normal(Value n, Value v);
    Derivative normal_derivative(Value m, Value strength, const Frame& frame);
    void base(const Module& source, Id id, Id normal);
    Id sample(const Module& source, Id id, std::span<const Id> mapped);
};

// Returns the parameter as a constant of its value; no_id for one that stays a parameter.
Id Expander::parameter(const Parameter& parameter) {
    if (options.parameters == Parameters::kept || parameter.graph_input) return no_id;
    return target->constant(parameter.type,
                            std::span(parameter.value.data(), info(parameter.type).lanes));
}

template <class T>
Id append(std::vector<T>& list, T value) {
    list.push_back(std::move(value));
    return static_cast<Id>(list.size() - 1);
}

Value Expander::base_normal(const Module& source, Id gradient) const {
    const Id base = source[gradient].extra;
    return base == no_id ? Value{} : bases.at(base);
}

// Strips a positive literal factor from a normal that may have any length.
Value strip_positive_factor(Value normal, double& factor) {
    const Module& m = *normal.module;
    const Inst& inst = m[normal.id];
    if (inst.op != Op::mul_ || m[inst.arg[1]].op != Op::literal_) return normal;
    if (m[inst.arg[1]].value <= 0) return normal;
    factor = m[inst.arg[1]].value;
    return {normal.module, inst.arg[0]};
}

// SurfgradFromPerturbedNormal: (k n - v) / |k|, k = n.v, with the division pending.
GradientSum Expander::from_normal(Value n, Value v) {
    double factor = 1;
    v = strip_positive_factor(v, factor);
    if (variance) v = variance->object_normal(v, factor);
    const Value k = dot(n, v);
    GradientSum result;
    GradientSum::Term& term = result.pending.emplace_back();
    term.numerator.rest = v;
    term.numerator.along = -k;
    term.denominator = max(abs(k), constant(cosine_name, k, min_cosine / factor));
    return result;
}

// TspaceNormalToDerivative: -xy / max(|z|, max(|x|,|y|)/128), with the division pending.
Derivative Expander::normal_derivative(Value m, Value strength, const Frame& frame) {
    double factor = 1;
    m = strip_positive_factor(m, factor);
    const Value widest = max(abs(m.x()), abs(m.y()));
    const Value least = named("least_depth", widest * constant(ratio_name, m, 1 / max_slope));
    const Value depth = max(max(abs(m.z()), least), constant(depth_name, m, min_depth / factor));
    const Value xy = variance ? variance->tangent_normal(m, depth, factor) : m.xy();
    return {xy, frame, strength, named("depth", depth)};
}

GradientSum Expander::from_derivative(const Derivative& d) {
    if (!d.slope) return {};
    if (!d.depth) return algebra->from_slope(d.frame.key, slope_in_basis(d.frame, d.slope));
    const Value downhill = slope_in_basis(d.frame, d.slope * d.strength);
    return algebra->from_negated_slope(d.frame.key, downhill, d.depth);
}

GradientSum Expander::gradient_from_position(Id height) {
    GradientSum result;
    const Value volume =
        vec3(screen->along(DiffAxis::space_x, height), screen->along(DiffAxis::space_y, height),
             screen->along(DiffAxis::space_z, height));
    if (!target->is_literal(volume.id, 0)) result.flat.volume = volume;
    return result;
}

GradientSum Expander::source_gradient(const Module& source, Id id, std::span<const Id> mapped) {
    const Inst& inst = source[id];
    switch (inst.op) {
        case Op::gradient_from_derivative_:
            return from_derivative(derivatives.at(mapped[0]));
        case Op::gradient_from_height_: {
            if (is_position_alone(facts.dependencies(inst.arg[0])))
                return gradient_from_position(mapped[0]);
            const Id x = screen->along(DiffAxis::surface_x, mapped[0]).id;
            const Id y = screen->along(DiffAxis::surface_y, mapped[0]).id;
            if (target->is_literal(x, 0) && target->is_literal(y, 0)) return {};
            return algebra->from_slope({}, vec2(value(x), value(y)));
        }
        case Op::gradient_from_volume_: {
            GradientSum result;
            if (!is_tangent(source, *target, inst.arg[0]))
                result.flat.volume = value(mapped[0]);
            else if (!target->is_literal(mapped[0], 0))
                result.flat.rest = value(mapped[0]);
            return result;
        }
        case Op::gradient_from_normal_:
        case Op::gradient_from_outward_normal_: {
            const Value on_base = base_normal(source, id);
            const Value n = on_base ? on_base : value(unit_normal(*target));
            const Value v = value(mapped[0]);
            const bool reverse = inst.op == Op::gradient_from_outward_normal_;
            return from_normal(n, reverse ? v * sign_nonzero(dot(n, v)) : v);
        }
        default:
            return {};  // gradient_zero
    }
}

GradientSum Expander::scaled(const GradientSum& gradient, Value amount) {
    if (target->is_literal(amount.id, 0)) return {};
    if (target->is_literal(amount.id, 1)) return gradient;
    return algebra->scale(gradient, amount);
}

GradientSum Expander::gradient(const Module& source, Id id, std::span<const Id> mapped) {
    switch (source[id].op) {
        case Op::gradient_add_:
            return algebra->add(gradients.at(mapped[0]), gradients.at(mapped[1]));
        case Op::gradient_scale_:
            return scaled(gradients.at(mapped[0]), value(mapped[1]));
        case Op::gradient_mix_: {
            const Value t = value(mapped[2]);
            return algebra->add(scaled(gradients.at(mapped[0]), number(t, 1) - t),
                                scaled(gradients.at(mapped[1]), t));
        }
        default:
            return source_gradient(source, id, mapped);
    }
}

// `resolve` is the instruction whose gradient is resolved.
Value Expander::resolved(const Module& source, Id resolve, const GradientSum& gradient) {
    Value facing;
    if (options.back_faces != BackFaces::none) facing = value(target->input(SurfaceInput::facing_));
    const Value sign = options.back_faces == BackFaces::flip ? facing : Value{};
    return algebra->resolve(gradient, facing, sign, base_normal(source, source[resolve].arg[0]));
}

void Expander::base(const Module& source, Id id, Id normal) {
    const bool on_resolve = source[source[id].arg[0]].op == Op::resolve_;
    bases.emplace(id, on_resolve ? value(normal) : Value{});
    if (!on_resolve && !is_surface_normal(source, source[id].arg[0]))
        target->problem("the base is neither the surface's normal nor the output of a resolve",
                        "connect a resolve's normal, or leave the port unconnected");
}

Id Expander::opaque(const Module& source, Id id, std::span<const Id> mapped) {
    const Inst inst = source[id];
    switch (inst.op) {
        case Op::ddx_:
            return screen->along(DiffAxis::screen_x, mapped[0]).id;
        case Op::ddy_:
            return screen->along(DiffAxis::screen_y, mapped[0]).id;
        case Op::base_:
            base(source, id, mapped[0]);
            return unexpanded;
        case Op::frame_: {
            const Id direction = mapped.size() > 1 ? mapped[1] : no_id;
            const uint32_t uv = facts.dependencies(inst.arg[0]);
            const FrameChoice choice = choose_frame(*target, inst.extra, uv, options);
            Id& frame = known_frames[{mapped[0], direction, choice.method, choice.source}];
            if (frame == no_id)
                frame = append(frames, make_frame(*target, *screen, mapped[0], direction, choice));
            return frame;
        }
        case Op::derivative_:
            return append(derivatives, {value(mapped[0]), frames.at(mapped[1]), {}, {}});
        case Op::normal_derivative_:
            return append(derivatives, normal_derivative(value(mapped[0]), value(mapped[1]),
                                                         frames.at(mapped[2])));
        case Op::slope_: {
            const auto& [slope, frame, strength, depth] = derivatives.at(mapped[0]);
            if (!slope) return target->zero(Type::vec2_);
            return depth ? (slope * (-strength / depth)).id : slope.id;
        }
        case Op::gradient_vector_: {
            const Value on_base = base_normal(source, inst.arg[0]);
            const Value gamma = algebra->vector(gradients.at(mapped[0]), on_base);
            return gamma ? gamma.id : target->zero(Type::vec3_);
        }
        case Op::resolve_:
            return detach(resolved(source, id, gradients.at(mapped[0]))).id;
        case Op::normal_variance_:
            return variance->of(resolved(source, id, gradients.at(mapped[0]))).id;
        case Op::normal_covariance_:
            return variance->along(resolved(source, id, gradients.at(mapped[0])), value(mapped[1]))
                .id;
        case Op::with_covariance_:
            return variance ? variance->varying(value(mapped[0]), value(mapped[1])).id : mapped[0];
        default:
            return append(gradients, gradient(source, id, mapped));
    }
}

Id Expander::sample(const Module& source, Id id, std::span<const Id> mapped) {
    if (!facts.is_discontinuous(source[id].arg[0]) && !functions->in_function(mapped[0]))
        return no_id;
    const Id dx = screen->along(DiffAxis::screen_x, mapped[0]).id;
    const Id dy = screen->along(DiffAxis::screen_y, mapped[0]).id;
    return target->add(Op::sample_grad_, {mapped[0], dx, dy}, source[id].extra);
}

Id expand_one(void* context, Module& target, const Module& source, Id id,
              std::span<const Id> mapped) {
    auto& expander = *static_cast<Expander*>(context);
    if (!expander.target) {
        expander.target = &target;
        target.number(0);  // Id 1 is `unexpanded` of an ordinary type too
        expander.screen.emplace(target);
        expander.algebra.emplace(target, *expander.screen);
        if (expander.options.covariances == Covariances::kept || wants_normal_variance(source))
            expander.variance.emplace(target, *expander.screen);
        expander.functions.emplace(target, *expander.screen, source);
    }
    const Op op = source[id].op;
    if (op == Op::parameter_) return expander.parameter(target.parameters[source[id].extra]);
    if (op == Op::sample_) return expander.sample(source, id, mapped);
    if (op == Op::call_) return expander.functions->call(source, id, mapped);
    if (op == Op::result_) return expander.functions->result(source, id, mapped[0]);
    if (!is_opaque(source[id].op)) return no_id;
    if (source[id].level > 0) {
        target.problem("a bump cannot be made inside a loop or a function",
                       "compute heights or slopes there, and make the gradient outside");
        return Expander::unexpanded;
    }
    return expander.opaque(source, id, mapped);
}

}  // namespace

Module expand(Module source, const ExpandOptions& options) {
    Expander expander(options, source);
    Module expanded = rebuild(std::move(source), expand_one, &expander);
    if (expander.functions) expander.functions->finish(expanded);
    return compact(finish(std::move(expanded), options.covariances));
}

}  // namespace wrinkle
