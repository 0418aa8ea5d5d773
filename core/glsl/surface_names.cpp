// Names of what expansion makes of the surface point (ir/surface.h, ir/gradient_frame.h).
#include "glsl/names.h"

namespace wrinkle {
namespace {

bool is_input(const Module& m, Id id, SurfaceInput input, Variant variant) {
    return m[id].op == Op::input_ && m[id].extra == input_extra(input, variant);
}

bool is_normal(const Module& m, Id id) {
    return m[id].op == Op::normalize_ &&
           is_input(m, m[id].arg[0], SurfaceInput::normal_, Variant::value);
}

std::string axis_of(uint32_t extra) {
    return variant_of(extra) == Variant::dx ? "dx" : "dy";
}

std::string change_name(const Module& m, Id id) {
    const uint32_t extra = m[id].extra;
    if (variant_of(extra) == Variant::value) return {};
    if (input_of(extra) == SurfaceInput::position_) return "dp" + axis_of(extra);
    return "d" + std::string(info(input_of(extra)).name) + "_" + axis_of(extra);
}

// P - n (n.P), P the position's change: "surface_dpdx".
std::string projected_name(const Module& m, Id id) {
    const Inst& inst = m[id];
    if (inst.op != Op::sub_ || m[inst.arg[0]].op != Op::input_) return {};
    const std::string change = change_name(m, inst.arg[0]);
    const Inst& part = m[inst.arg[1]];
    if (!change.starts_with("dp") || part.op != Op::mul_) return {};
    return is_normal(m, part.arg[0]) || is_normal(m, part.arg[1]) ? "surface_" + change : "";
}

// T of a derived frame: (p_x v_y - p_y v_x) made unit; the uv set's number.
std::string derived_tangent(const Module& m, Id id) {
    const Inst& unit = m[id];
    if (unit.op != Op::mul_ || m[unit.arg[1]].op != Op::inversesqrt_) return {};
    const Inst& turned = m[unit.arg[0]];
    if (turned.op != Op::mul_ || m[turned.arg[0]].op != Op::sub_) return {};
    const Inst& first = m[m[turned.arg[0]].arg[0]];
    if (first.op != Op::mul_ || projected_name(m, first.arg[0]) != "surface_dpdx") return {};
    const Inst& lane = m[first.arg[1]];
    if (lane.op != Op::swizzle_ || m[lane.arg[0]].op != Op::input_) return {};
    return std::string(info(input_of(m[lane.arg[0]].extra)).name) + "_tangent";
}

// cross(n, T) with its sign.
std::string bitangent(const Module& m, Id id) {
    if (m[id].op != Op::mul_ || m[m[id].arg[0]].op != Op::cross_) return {};
    const Inst& cross = m[m[id].arg[0]];
    if (is_input(m, cross.arg[0], SurfaceInput::normal_, Variant::value)) return "bitangent";
    if (!is_normal(m, cross.arg[0])) return {};
    const std::string tangent = derived_tangent(m, cross.arg[1]);
    return tangent.empty() ? "" : tangent.substr(0, 4) + "bitangent";
}

// The vectors of Mikkelsen 2010, eq. 3: r_x = p_y x n, r_y = n x p_x, det = p_x . r_x.
std::string screen_name(const Module& m, Id id) {
    const Inst& inst = m[id];
    if (inst.op == Op::cross_) {
        if (is_normal(m, inst.arg[1]) && projected_name(m, inst.arg[0]) == "surface_dpdy")
            return "r_x";
        if (is_normal(m, inst.arg[0]) && projected_name(m, inst.arg[1]) == "surface_dpdx")
            return "r_y";
    }
    if (inst.op == Op::dot_ && projected_name(m, inst.arg[0]) == "surface_dpdx" &&
        screen_name(m, inst.arg[1]) == "r_x")
        return "det";
    if (inst.op == Op::div_ && m[inst.arg[0]].op == Op::sign_nonzero_ &&
        m[m[inst.arg[0]].arg[0]].op == Op::dot_ && screen_name(m, m[inst.arg[0]].arg[0]) == "det")
        return "inverse_det";
    return {};
}

// u_x v_y - v_x u_y of a uv set's changes, and its sign.
std::string uv_set_name(const Module& m, Id id) {
    const Inst& inst = m[id];
    if (inst.op == Op::sign_nonzero_) {
        const std::string det = uv_set_name(m, inst.arg[0]);
        return det.ends_with("_det") ? det.substr(0, 4) + "sign" : "";
    }
    if (inst.op != Op::sub_ || m[inst.arg[0]].op != Op::mul_ || m[inst.arg[1]].op != Op::mul_)
        return {};
    const auto set = [&](Id lane) -> std::string_view {
        const Id input = m[lane].op == Op::swizzle_ ? m[lane].arg[0] : poison;
        const bool change =
            m[input].op == Op::input_ && variant_of(m[input].extra) != Variant::value;
        return change ? info(input_of(m[input].extra)).name : "";
    };
    const Inst& left = m[inst.arg[0]];
    const Inst& right = m[inst.arg[1]];
    const std::string_view name = set(left.arg[0]);
    const bool same = name == set(left.arg[1]) && name == set(right.arg[0]) &&
                      name == set(right.arg[1]) && name.starts_with("uv");
    return same ? std::string(name) + "_det" : "";
}

// 1 / |N| of the interpolated normal.
std::string length_name(const Module& m, Id id) {
    const Inst& square = m[m[id].arg[0]];
    const bool normal = square.op == Op::dot_ && square.arg[0] == square.arg[1] &&
                        is_input(m, square.arg[0], SurfaceInput::normal_, Variant::value);
    return normal ? "inverse_normal_length" : "";
}

}  // namespace

std::string surface_name(const Module& module, Id id) {
    const Op op = module[id].op;
    if (op == Op::input_) return change_name(module, id);
    if (op == Op::normalize_) return is_normal(module, id) ? "normal" : "";
    if (op == Op::inversesqrt_) return length_name(module, id);
    if (op == Op::sign_nonzero_) return uv_set_name(module, id);
    if (op == Op::sub_) {
        const std::string projected = projected_name(module, id);
        return projected.empty() ? uv_set_name(module, id) : projected;
    }
    if (op == Op::mul_) {
        const std::string tangent = derived_tangent(module, id);
        return tangent.empty() ? bitangent(module, id) : tangent;
    }
    return screen_name(module, id);
}

}  // namespace wrinkle
