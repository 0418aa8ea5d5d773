#include "ir/gradient_frame.h"

#include <bit>

#include "ir/surface.h"

namespace wrinkle {
namespace {

constexpr uint32_t bit(SurfaceInput input) {
    return 1u << static_cast<uint32_t>(input);
}
constexpr uint32_t all_uv_sets = bit(SurfaceInput::uv0_) | bit(SurfaceInput::uv1_) |
                                 bit(SurfaceInput::uv2_) | bit(SurfaceInput::uv3_);

// Least squared sine of the angle between a guessed tangent and the normal; far above the rounding
// of floats.
constexpr double min_sine_square = 1e-10;
constexpr std::string_view sine_name = "min_sine_square // between a tangent and the normal";

// Returns the uv set if the inputs are exactly one uv set.
std::optional<SurfaceInput> single_uv_set(uint32_t dependencies) {
    if (std::popcount(dependencies) != 1 || !(dependencies & all_uv_sets)) return {};
    return static_cast<SurfaceInput>(std::countr_zero(dependencies));
}

// Sets the frame's rows to those of J^T / sqrt|det J|, J = d(uv)/d(set); leaves them empty if `uv`
// is the set itself.
void change_basis_to_set(Module& target, ScreenDerivatives& screen, Id uv, SurfaceInput set,
                         Frame& frame) {
    const Id whole = target.input(set);
    if (uv == whole) return;
    const Value u = screen.along(axis_of_uv(set, 0), uv);
    const Value v = screen.along(axis_of_uv(set, 1), uv);
    const Value det = abs(u.x() * v.y() - u.y() * v.x());
    const Value scale = select(greater(det, 0), inversesqrt(max(det, min_area(det))), number(u, 0));
    frame.row_u = vec2(u.x() * scale, u.y() * scale);
    frame.row_v = vec2(v.x() * scale, v.y() * scale);
}

struct Choice {
    uint32_t method;
    uint32_t scale;
};

Choice chosen(uint32_t extra, uint32_t dependencies, const ExpandOptions& options) {
    Choice choice{extra & 0xFF, extra >> 8 & 0xFF};
    if (choice.method != WR_FRAME_auto) return choice;
    if (choice.scale == WR_SCALE_surface)
        choice.method = WR_FRAME_exact;
    else if (dependencies == bit(SurfaceInput::uv0_) && options.vertex_tangents)
        choice.method = WR_FRAME_vertex;
    else
        choice.method = WR_FRAME_derived;
    return choice;
}

// Returns the surface input that a frame of this method is a function of, if it is a single one.
std::optional<SurfaceInput> source_of(uint32_t method, uint32_t dependencies) {
    if (method != WR_FRAME_exact) return single_uv_set(dependencies);
    if (is_position_alone(dependencies)) return SurfaceInput::position_;
    return {};
}

// Returns false and records a problem if method and scale, or method and uv, do not match.
bool fits(Module& target, const Choice& choice, uint32_t dependencies) {
    const bool exact = choice.method == WR_FRAME_exact || choice.method == WR_FRAME_pixel;
    const bool on_surface = choice.scale == WR_SCALE_surface;
    const char* expected = "set the frame to 'auto', or change the scale";
    if (on_surface && !exact) {
        target.problem("the scale 'surface' goes with the frame 'exact'", expected);
    } else if (exact && !on_surface) {
        const std::string name = choice.method == WR_FRAME_pixel ? "pixel" : "exact";
        target.problem("the frame '" + name + "' goes with the scale 'surface'", expected);
    } else if (choice.method == WR_FRAME_vertex && dependencies != bit(SurfaceInput::uv0_)) {
        target.problem("the frame 'vertex' needs a uv that is made from uv0 alone",
                       "vertex tangents belong to uv0; set the frame to 'derived' or 'auto'");
    } else {
        return true;
    }
    return false;
}

TangentBasis vertex_basis(Module& target, bool raw) {
    const Value n{&target, target.input(SurfaceInput::normal_)};
    const Value tangent{&target, target.input(SurfaceInput::tangent_)};
    const Value sign = select(greater(tangent.w(), 0), number(n, 1), number(n, -1));
    const Value t = tangent.xyz();
    const Value b = surface_named("bitangent", cross(n, t));
    surface_named("handedness", sign);
    if (raw) return {t, b, {}, sign};
    const Value scale = surface_named("inverse_normal_length", inversesqrt(dot(n, n)));
    return {t, b, scale, sign * scale};
}

// GenBasisTB of the reference, sign(0) = +1. With a prefix, its intermediate values are named as
// those of the surface point.
TangentBasis derived_basis(Module& target, Id uv, ScreenDerivatives& screen,
                           const std::string& prefix) {
    const auto call = [&](const char* name, Value v) {
        return prefix.empty() ? named(name, v) : surface_named(prefix + name, v);
    };
    const Value uv_x = screen.along(DiffAxis::surface_x, uv);
    const Value uv_y = screen.along(DiffAxis::surface_y, uv);
    const Value p_x = screen.position(Variant::dx);
    const Value p_y = screen.position(Variant::dy);
    const Value n{&target, unit_normal(target)};
    const Value det = call("det", uv_x.x() * uv_y.y() - uv_y.x() * uv_x.y());
    const Value flip = sign_nonzero({&target, screen_area(target)});
    const Value along = call("direction", p_x * uv_y.y() - p_y * uv_x.y());
    const Value b = call("bitangent", cross(n, along));
    const Value t = call("tangent", cross(b, n));
    const Value scale = call("scale", inversesqrt(max(dot(b, b), min_area(b))));
    return {t, b, scale * sign_nonzero(det), scale * flip};
}

TangentBasis guessed_basis(Module& target, Id direction) {
    const Value n{&target, unit_normal(target)};
    const Value d{&target, direction};
    const Value part = d - n * dot(n, d);
    // A direction along n leaves only rounding errors, which define no tangent.
    const Value square = dot(part, part);
    const Value seen = greater(square - dot(d, d) * constant(sine_name, d, min_sine_square), 0);
    const Value scale = select(seen, inversesqrt(max(square, min_area(square))), number(n, 0));
    return {part, cross(n, d), scale, scale};
}

}  // namespace

Value TangentBasis::along(Value slope) const {
    const Value x = t_factor ? named("slope_u", slope.x() * t_factor) : slope.x();
    const Value y = b_factor ? named("slope_v", slope.y() * b_factor) : slope.y();
    return named("along_u", t * x) + named("along_v", b * y);
}

ForwardDiff& ScreenDerivatives::direction(DiffAxis axis) {
    auto& known = directions_[static_cast<size_t>(axis)];
    if (!known) known = direction_along(*target_, axis);
    return *known;
}

Value ScreenDerivatives::along(DiffAxis axis, Id value) {
    return {target_, direction(axis).jvp_or_zero(value)};
}

Value ScreenDerivatives::position(Variant axis) {
    return {target_, target_->input(SurfaceInput::position_, axis)};
}

FrameChoice choose_frame(Module& target, uint32_t extra, uint32_t dependencies,
                         const ExpandOptions& options) {
    Choice choice = chosen(extra, dependencies, options);
    if (!fits(target, choice, dependencies))
        choice.method = choice.scale == WR_SCALE_surface ? WR_FRAME_exact : WR_FRAME_derived;
    return {choice.method, source_of(choice.method, dependencies)};
}

Frame make_frame(Module& target, ScreenDerivatives& screen, Id uv, Id direction,
                 const FrameChoice& choice) {
    const auto& [method, source] = choice;
    Frame frame;
    if (method == WR_FRAME_pixel) return frame;
    if (method == WR_FRAME_exact && source) {
        frame.key = {Basis::space, no_id};
        frame.row_u = screen.along(DiffAxis::space_x, uv);
        frame.row_v = screen.along(DiffAxis::space_y, uv);
        frame.row_z = screen.along(DiffAxis::space_z, uv);
        return frame;
    }
    if (method == WR_FRAME_exact) {
        frame.row_u = screen.along(DiffAxis::surface_x, uv);
        frame.row_v = screen.along(DiffAxis::surface_y, uv);
        return frame;
    }
    if (source) change_basis_to_set(target, screen, uv, *source, frame);
    if (method == WR_FRAME_guess)
        frame.key = {Basis::guess, direction};
    else if (method == WR_FRAME_vertex)
        frame.key = {Basis::vertex, no_id};
    else if (source)
        frame.key = {Basis::derived_set, static_cast<Id>(*source)};
    else
        frame.key = {Basis::derived_uv, uv};
    return frame;
}

TangentBasis tangent_basis(Module& target, const FrameKey& key, ScreenDerivatives& screen,
                           bool raw) {
    switch (key.basis) {
        case Basis::vertex:
            return vertex_basis(target, raw);
        case Basis::derived_set: {
            const auto set = static_cast<SurfaceInput>(key.source);
            const std::string prefix = std::string(info(set).name) + "_";
            return derived_basis(target, target.input(set), screen, prefix);
        }
        case Basis::derived_uv:
            return derived_basis(target, key.source, screen, "");
        case Basis::guess:
            return guessed_basis(target, key.source);
        case Basis::exact:
        case Basis::space:
            break;
    }
    return {};
}

Value slope_in_basis(const Frame& frame, Value slope) {
    if (!frame.row_u) return slope;
    if (frame.key.basis == Basis::exact)
        return vec2(dot(slope, frame.row_u), dot(slope, frame.row_v));
    // By components, so that a diagonal J of constants simplifies.
    const auto along = [&](Value row) { return slope.x() * row.x() + slope.y() * row.y(); };
    if (frame.key.basis == Basis::space)
        return vec3(along(frame.row_u), along(frame.row_v), along(frame.row_z));
    return vec2(along(frame.row_u), along(frame.row_v));
}

}  // namespace wrinkle
