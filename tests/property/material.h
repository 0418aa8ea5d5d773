// Builds a small module and evaluates its outputs at a point. By convention output 0 is a normal.
#pragma once

#include <span>
#include <string>

#include "ir/expand.h"
#include "ir/value.h"
#include "property/surfaces.h"

namespace wrinkle::test {

// The free vector of the surface serves as a texture's normal at the point.
inline constexpr SurfaceInput texel = SurfaceInput::color0_;

struct Material {
    Module module;

    Value input(SurfaceInput which) { return {&module, module.input(which)}; }
    Value position() { return input(SurfaceInput::position_); }
    Value uv0() { return input(SurfaceInput::uv0_); }
    Value uv1() { return input(SurfaceInput::uv1_); }
    Value texel_normal() { return input(texel).xyz(); }
    Value number(double v) { return {&module, module.number(v)}; }
    Value vector(dvec3 v) {
        const std::array<double, 3> lanes{v.x, v.y, v.z};
        return {&module, module.constant(Type::vec3_, lanes)};
    }
    Value vector(dvec2 v) {
        const std::array<double, 2> lanes{v.x, v.y};
        return {&module, module.constant(Type::vec2_, lanes)};
    }
    Value sin(Value x) { return op(Op::sin_, x); }
    Value cos(Value x) { return op(Op::cos_, x); }
    Value mix(Value a, Value b, Value t) { return op(Op::mix_, a, b, t); }
    Value smoothstep(double low, double high, Value x) {
        return op(Op::smoothstep_, number(low), number(high), x);
    }

    Value from_height(Value h) {
        return {&module, module.add(Op::gradient_from_height_, {h.id}, 0)};
    }
    Value from_volume(Value g) {
        return {&module, module.add(Op::gradient_from_volume_, {g.id}, 0)};
    }
    Value from_normal(Value n) {
        return {&module, module.add(Op::gradient_from_normal_, {n.id}, 0)};
    }
    Value from_outward_normal(Value n) {
        return {&module, module.add(Op::gradient_from_outward_normal_, {n.id}, 0)};
    }
    Value flat() { return {&module, module.add(Op::gradient_zero_, {})}; }
    Value frame(Value uv, uint32_t method, uint32_t scale) {
        return {&module, module.add(Op::frame_, {uv.id}, WR_FRAME(method, scale))};
    }
    Value guess_frame(Value uv, Value direction) {
        return {&module, module.add(Op::frame_, {uv.id, direction.id},
                                    WR_FRAME(WR_FRAME_guess, WR_SCALE_unit))};
    }
    Value from_slope(Value slope, Value frame) {
        const Value d = op(Op::derivative_, slope, frame);
        return {&module, module.add(Op::gradient_from_derivative_, {d.id}, 0)};
    }
    Value from_tangent_normal(Value m, Value frame, double strength = 1) {
        const Value d = op(Op::normal_derivative_, m, number(strength), frame);
        return {&module, module.add(Op::gradient_from_derivative_, {d.id}, 0)};
    }
    Value add(Value a, Value b) { return op(Op::gradient_add_, a, b); }
    Value scale(Value a, Value amount) { return op(Op::gradient_scale_, a, amount); }
    Value scale(Value a, double amount) { return scale(a, number(amount)); }
    Value mix_gradients(Value a, Value b, double t) {
        return op(Op::gradient_mix_, a, b, number(t));
    }
    Value vector_of(Value gradient) { return op(Op::gradient_vector_, gradient); }
    Value resolve(Value gradient) {
        return {&module, module.add(Op::resolve_, {gradient.id}, ++resolves_)};
    }
    void output(std::string name, Value v) {
        module.outputs.push_back({std::move(name), WR_PORT_float, v.id});
    }

private:
    uint32_t resolves_ = 0;  // number of resolve ops; each has its own number in `extra`
};

// An expanded module with outputs that can be evaluated. The constructor adds a test failure for
// each problem of the expansion.
class Expanded {
public:
    explicit Expanded(const Material& material, const ExpandOptions& options = {});

    Lanes lanes(size_t output, const Surroundings& around) const;
    double number(size_t output, const Surroundings& around) const {
        return lanes(output, around)[0];
    }
    dvec3 vector(size_t output, const Surroundings& around) const {
        return to_vec3(lanes(output, around));
    }
    const Module& module() const { return module_; }

private:
    Module module_;
};

}  // namespace wrinkle::test
