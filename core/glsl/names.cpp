#include "glsl/names.h"

#include <algorithm>

#include "base/text.h"

namespace wrinkle {
namespace {

constexpr size_t longest_name = 120;
constexpr size_t longest_comment = 160;

std::string legal(std::string_view wanted) {
    std::string name = identifier(wanted);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    if (name.starts_with("gl_") || name.starts_with("GL_") || name == "_") name.insert(0, "n");
    if (name.size() > longest_name) name.resize(longest_name);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    return name;
}

// max(|z| ..., floor) of a tangent-space normal, as expansion writes it.
bool is_depth(const Module& m, Id id) {
    const Inst& inst = m[id];
    return inst.op == Op::max_ && m.is_literal(inst.arg[1], 1e-6) && m[inst.arg[0]].op == Op::max_;
}

// -xy of a tangent-space normal, times factors.
bool is_slope(const Module& m, Id id) {
    for (int factors = 0; m[id].op == Op::mul_ && factors < 4; ++factors)
        id = m[id].arg[0];
    return m.type(id) == Type::vec2_ && m[id].op == Op::neg_ && m[m[id].arg[0]].op == Op::swizzle_;
}

// A sample, or what constants and swizzles make of it.
bool is_texel(const Module& m, Id id) {
    for (int steps = 0; steps < 6; ++steps) {
        const Inst& inst = m[id];
        if (inst.op == Op::sample_ || inst.op == Op::sample_lod_ || inst.op == Op::sample_grad_)
            return true;
        const bool scaled = (inst.op == Op::add_ || inst.op == Op::sub_ || inst.op == Op::mul_) &&
                            m.is_constant(inst.arg[1]);
        if (!scaled && inst.op != Op::swizzle_) return false;
        id = inst.arg[0];
    }
    return false;
}

}  // namespace

bool NameSet::taken(const std::string& name) const {
    return names_.count(name) || (outer_ && outer_->taken(name));
}

std::string NameSet::unique(std::string_view wanted) {
    const std::string base = legal(wanted);
    std::string name = base;
    uint32_t& next = next_.try_emplace(base, 2).first->second;
    while (taken(name) || is_reserved(name))
        name = base + "_" + std::to_string(next++);
    names_.insert(name);
    return name;
}

std::string comment_text(std::string_view text) {
    std::string result;
    for (const char c : text.substr(0, longest_comment))
        result += static_cast<unsigned char>(c) < 0x20 || c == '\x7F' ? ' ' : c == '\\' ? '/' : c;
    while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xC0) == 0x80 &&
           text.size() > longest_comment)
        result.pop_back();
    return result;
}

std::string_view word_for(const Module& module, Id id) {
    if (is_depth(module, id)) return "depth";
    if (is_slope(module, id)) return "slope";
    if (is_texel(module, id)) return "texel";
    switch (module[id].op) {
        case Op::image_size_:
            return "size";
        case Op::add_:
            return "sum";
        case Op::sub_:
            return "difference";
        case Op::mul_:
        case Op::matrix_product_:
            return "product";
        case Op::div_:
            return "quotient";
        case Op::neg_:
            return "negated";
        case Op::normalize_:
            return "unit";
        case Op::select_:
            return "choice";
        case Op::construct_:
            return "vector";
        case Op::transform_:
            return "transformed";
        case Op::lt_:
        case Op::le_:
        case Op::gt_:
        case Op::ge_:
        case Op::eq_:
        case Op::ne_:
        case Op::and_:
        case Op::or_:
        case Op::not_:
            return "test";
        case Op::bit_and_:
        case Op::bit_or_:
        case Op::bit_xor_:
        case Op::shift_left_:
        case Op::shift_right_:
            return "bits";
        case Op::sign_nonzero_:
            return "sign";
        case Op::to_float_:
        case Op::to_int_:
        case Op::to_uint_:
            return info(module.type(id)).name;
        case Op::result_:
            return module.region(module[module[id].arg[0]].extra).kind == RegionKind::loop
                       ? "state"
                       : std::string_view(module.region(module[module[id].arg[0]].extra).name);
        default:
            return info(module[id].op).name;
    }
}

}  // namespace wrinkle
