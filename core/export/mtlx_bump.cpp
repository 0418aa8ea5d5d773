// Bumps as slopes (s_u, s_v) along u and v of uv0, and as normals.
#include <cmath>

#include "export/mtlx_flatten.h"

namespace wrinkle {

std::string MtlxFlattener::two(Id id, const char* category, const std::string& a,
                               const std::string& b) {
    const std::string node = nodes_.add(category, title(id, "slopes"), "vector2");
    nodes_.connect(node, "in1", "vector2", a);
    nodes_.connect(node, "in2", "vector2", b);
    return node;
}

std::string MtlxFlattener::emit_slopes(Id id) {
    const Inst& inst = module_[id];
    switch (inst.op) {
        case Op::derivative_:
            return in_uv0(id, node(inst.arg[0]), inst.arg[1]);
        case Op::normal_derivative_:
            return emit_normal_slopes(id);
        case Op::gradient_from_derivative_:
            return node(inst.arg[0]);
        case Op::gradient_add_:
            return two(id, "add", node(inst.arg[0]), node(inst.arg[1]));
        default:
            break;
    }
    if (inst.op == Op::gradient_zero_) {
        const std::string flat = nodes_.add("constant", title(id, "slopes"), "vector2");
        nodes_.write(flat, "value", "vector2", {0, 0});
        return flat;
    }
    if (inst.op == Op::gradient_scale_) {
        const std::string scaled = nodes_.add("multiply", title(id, "slopes"), "vector2");
        nodes_.connect(scaled, "in1", "vector2", node(inst.arg[0]));
        operand(scaled, "in2", inst.arg[1], 1);
        return scaled;
    }
    const std::string mixed = nodes_.add("mix", title(id, "slopes"), "vector2");  // gradient_mix
    nodes_.connect(mixed, "bg", "vector2", node(inst.arg[0]));
    nodes_.connect(mixed, "fg", "vector2", node(inst.arg[1]));
    operand(mixed, "mix", inst.arg[2], 1);
    return mixed;
}

// -strength xy / depth.
std::string MtlxFlattener::emit_normal_slopes(Id id) {
    const Inst& inst = module_[id];
    const std::string normal = node(inst.arg[0]);
    const std::string depth = depth_of(id, normal);
    const std::string xy = nodes_.add("combine2", title(id, "tilt"), "vector2");
    nodes_.connect(xy, "in1", "float", nodes_.component(normal, 3, 0));
    nodes_.connect(xy, "in2", "float", nodes_.component(normal, 3, 1));
    const std::string tilt = nodes_.add("divide", title(id, "tilt"), "vector2");
    nodes_.connect(tilt, "in1", "vector2", xy);
    nodes_.connect(tilt, "in2", "float", depth);
    const std::string scaled = nodes_.add("multiply", title(id, "tilt"), "vector2");
    nodes_.connect(scaled, "in1", "vector2", tilt);
    operand(scaled, "in2", inst.arg[1], 1);
    const std::string slopes = nodes_.add("multiply", title(id, "slopes"), "vector2");
    nodes_.connect(slopes, "in1", "vector2", scaled);
    nodes_.write(slopes, "in2", "float", {-1});
    return in_uv0(id, slopes, inst.arg[2]);
}

// max(|z|, max(|x|, |y|) / 128, 1e-6): slopes are limited as in TspaceNormalToDerivative (Mikkelsen
// 2020).
std::string MtlxFlattener::depth_of(Id id, const std::string& normal) {
    const auto of_two = [&](const char* category, const std::string& a, const std::string& b) {
        const std::string node = nodes_.add(category, title(id, "depth"), "float");
        nodes_.connect(node, "in1", "float", a);
        nodes_.connect(node, "in2", "float", b);
        return node;
    };
    const auto of_number = [&](const char* category, const std::string& a, double number) {
        const std::string node = nodes_.add(category, title(id, "depth"), "float");
        nodes_.connect(node, "in1", "float", a);
        nodes_.write(node, "in2", "float", {number});
        return node;
    };
    const std::string sizes = nodes_.add("absval", title(id, "absolute"), "vector3");
    nodes_.connect(sizes, "in", "vector3", normal);
    const std::string widest =
        of_two("max", nodes_.component(sizes, 3, 0), nodes_.component(sizes, 3, 1));
    const std::string least = of_number("multiply", widest, 1.0 / 128);
    return of_number("max", of_two("max", nodes_.component(sizes, 3, 2), least), 1e-6);
}

bool MtlxFlattener::is_turned(Id frame) const {
    const auto& rows = support_.uv_of(frame).rows;
    return rows[0][1] != 0 || rows[1][0] != 0 || rows[0][0] != rows[1][1] || rows[0][0] <= 0;
}

// J^T s / sqrt |det J| with the derivative J of the frame's uv by uv0.
std::string MtlxFlattener::in_uv0(Id id, const std::string& slopes, Id frame) {
    if (!is_turned(frame)) return slopes;
    const MtlxSupport::Linear& uv = support_.uv_of(frame);
    const double root = std::sqrt(std::abs(uv.determinant()));
    const std::string made = nodes_.add("combine2", title(id, "slopes"), "vector2");
    for (size_t i = 0; i < 2; ++i) {
        const std::string sum = nodes_.add("dotproduct", title(id, "slope"), "float");
        nodes_.connect(sum, "in1", "vector2", slopes);
        nodes_.write(sum, "in2", "vector2", {uv.rows[0][i] / root, uv.rows[1][i] / root});
        nodes_.connect(made, i == 0 ? "in1" : "in2", "float", sum);
    }
    return made;
}

// The node normalmap reads normals as 0.5 + 0.5 m. A map that is read as 2 c - 1 is c.
std::string MtlxFlattener::coded(Id normal) {
    const Inst& inst = module_[normal];
    if (inst.op == Op::mul_ && module_.is_literal(inst.arg[1], 2)) {
        const Inst& difference = module_[inst.arg[0]];
        if (difference.op == Op::sub_ && module_.is_literal(difference.arg[1], 0.5))
            return node(difference.arg[0]);
    }
    const std::string half = nodes_.add("multiply", title(normal, "coded"), "vector3");
    nodes_.connect(half, "in1", "vector3", node(normal));
    nodes_.write(half, "in2", "float", {0.5});
    const std::string made = nodes_.add("add", title(normal, "coded"), "vector3");
    nodes_.connect(made, "in1", "vector3", half);
    nodes_.write(made, "in2", "float", {0.5});
    return made;
}

std::string MtlxFlattener::normal(Id value) {
    const Inst& inst = module_[value];
    if (inst.op != Op::resolve_ || module_[inst.arg[0]].op == Op::gradient_zero_) return {};
    const Inst& gradient = module_[inst.arg[0]];
    if (gradient.op == Op::gradient_from_derivative_) {
        const Inst& derivative = module_[gradient.arg[0]];
        if (derivative.op == Op::normal_derivative_ && !is_turned(derivative.arg[2]))
            return normal_of_map(value, gradient.arg[0]);
    }
    return normal_of_slopes(value, node(inst.arg[0]));
}

std::string MtlxFlattener::normal_of_map(Id resolve, Id derivative) {
    const Inst& inst = module_[derivative];
    const std::string source = coded(inst.arg[0]);
    const std::string normal = nodes_.add("normalmap", title(resolve, "normalmap"), "vector3");
    nodes_.connect(normal, "in", "vector3", source);
    if (!module_.is_literal(inst.arg[1], 1)) operand(normal, "scale", inst.arg[1], 1);
    return normal;
}

// (-s_u, -s_v, 1) as normalmap reads it, which makes it unit.
std::string MtlxFlattener::normal_of_slopes(Id resolve, const std::string& slopes) {
    const std::string half = nodes_.add("multiply", title(resolve, "coded"), "vector2");
    nodes_.connect(half, "in1", "vector2", slopes);
    nodes_.write(half, "in2", "float", {-0.5});
    const std::string coded = nodes_.add("add", title(resolve, "coded"), "vector2");
    nodes_.connect(coded, "in1", "vector2", half);
    nodes_.write(coded, "in2", "float", {0.5});
    const std::string in = nodes_.add("combine3", title(resolve, "coded"), "vector3");
    nodes_.connect(in, "in1", "float", nodes_.component(coded, 2, 0));
    nodes_.connect(in, "in2", "float", nodes_.component(coded, 2, 1));
    nodes_.write(in, "in3", "float", {1});
    const std::string normal = nodes_.add("normalmap", title(resolve, "normalmap"), "vector3");
    nodes_.connect(normal, "in", "vector3", in);
    return normal;
}

}  // namespace wrinkle
