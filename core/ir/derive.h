// Forward-mode derivatives (Jacobian-vector products, JVP): how a value changes along one
// direction.
//
// A ForwardDiff seeds leaves with their derivatives, each of the leaf's type; leaves without a seed
// are constant. The derivative is emitted as ordinary instructions of the same module, by a
// worklist with a memo, in time linear in the instructions below the value. no_id represents a zero
// derivative and emits no instruction, so derivatives of sparse expressions stay sparse. The rules
// at singular points are documented above the op table (wrinkle/plugin.h). Opaque values have no
// derivative here: expand them first.
//
// The derivative of an open function's input is another input (ir/open_input.h), which callers
// pass; that of a call is a call of the derived function; that of a loop is a loop with a wider
// state, along the path that the loop takes (the loop condition is not differentiated). The
// derivative of a texture is the reference's filtered one: forward differences over one texel of
// the mip level in use (Mikkelsen's DerivFromHeightMap, three taps), times the derivative of uv.
#pragma once

#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

// Returns true if the derivative of the instruction is 0 for any derivatives of its operands, or if
// it is a leaf (only a seed gives it a derivative).
inline bool has_zero_derivative(const Inst& inst) {
    const OpInfo& row = info(inst.op);
    return row.flags & WR_FLAG_ZERO_DERIVATIVE || row.rule == Rule::leaf ||
           is_whole_type(inst.type);
}

// Returns the values that the derivative of an instruction depends on, sorted: its operands; for a
// result those of its call or loop, with the values that a loop captures; for a texture sample or a
// component of it only the uv.
std::vector<Id> reads_of(const Module& module, Id value);

class ForwardDiff {
public:
    // `axis` identifies the direction; required if inputs of open functions need derivatives.
    explicit ForwardDiff(Module& module, DiffAxis axis = DiffAxis::none)
        : module_(&module), axis_(axis) {}
    void seed(Id leaf, Id derivative) { memo_.set(leaf, derivative); }
    void seed_input(SurfaceInput input, Id derivative);
    // Differentiates `detach` as the identity: for directions that are not positions on the
    // surface.
    void differentiate_detached() { through_detach_ = true; }
    // Returns true if the instruction's derivative is 0 for any derivatives of its operands.
    bool is_constant(const Inst& inst) const {
        return has_zero_derivative(inst) && !(through_detach_ && inst.op == Op::detach_);
    }

    // Returns the derivative of `value`; no_id represents zero (see jvp_or_zero). Memoised.
    Id jvp(Id value);
    Id jvp_or_zero(Id value);
    // Returns the derivative of the single instruction `value` if its operand `operand` (one of
    // reads_of()) has this derivative and all others are constant. Precondition: there are no
    // seeds.
    Id local_jvp(Id value, Id operand, Id derivative);

private:
    // Memoised derivatives by Id; the vector grows with the module.
    class Memo {
    public:
        bool has(Id id) const { return id < derivatives_.size() && derivatives_[id] < marked; }
        Id at(Id id) const { return has(id) ? derivatives_[id] : no_id; }
        void set(Id id, Id derivative) { (*this)[id] = derivative; }
        void forget(Id id) { (*this)[id] = unknown; }
        // Marks a value as visited, before its derivative is computed. Returns false if it is
        // already marked or has one.
        bool mark(Id id) {
            if (id < derivatives_.size() && derivatives_[id] != unknown) return false;
            (*this)[id] = marked;
            return true;
        }

    private:
        static constexpr Id unknown = ~0U, marked = ~0U - 1;
        Id& operator[](Id id) {
            if (id >= derivatives_.size()) derivatives_.resize(id + size_t{1}, unknown);
            return derivatives_[id];
        }
        std::vector<Id> derivatives_;
    };

    // The derivative of a function with respect to a subset of its arguments.
    struct DerivedFunction {
        uint32_t region = 0;
        std::vector<int> member;  // by result: its index in the derived function; -1: zero
    };

    friend ForwardDiff direction_along(Module& module, DiffAxis axis);
    void seed_screen();
    void collect_worklist(Id value, std::vector<Id>& list);
    Id compute(Id id);
    std::string_view suffix() const;
    Id derivative_of_input(uint32_t index);
    Id derivative_of_open_result(Id result);
    Id call_member(const Inst& result);
    Id loop_member(const Inst& result);
    using Activity = std::vector<bool>;  // by argument: it has a derivative
    Id call_along(const Inst& result, const Activity& active, std::span<const Id> args);
    const Activity& influences(uint32_t region, uint32_t member);
    uint32_t slope_function(uint32_t region, uint32_t member, const Activity& active);
    const DerivedFunction& derived(uint32_t region, const Activity& active);
    std::vector<Id> dual_loop(Id loop);
    void seed_state(const Region& region, const std::vector<bool>& active);
    bool propagate_activity(const Region& region, std::vector<bool>& active);
    void forget(size_t first);
    Id texture(Id sample, Id read);

    Module* module_;
    DiffAxis axis_;
    uint32_t varying_ = 0;  // surface inputs that have a seed, a bit per SurfaceInput
    bool through_detach_ = false;
    Memo memo_;
    std::vector<Id> log_;                // memoised ids, in order
    std::vector<Id> open_, spare_list_;  // scratch memory of jvp()
    struct Functions {
        std::map<std::pair<uint32_t, Activity>, DerivedFunction> derived;
        std::map<std::tuple<uint32_t, uint32_t, Activity>, uint32_t> slopes;  // by result too
        std::map<std::pair<uint32_t, uint32_t>, Activity> influences;         // by result
    };
    Functions functions_;
    std::unordered_map<Id, std::vector<Id>> loops_;
    // Screen directions, for the mip level of textures. The pair uses itself for nested samples: in
    // a chain of images, each sampled at a uv computed from the previous one, the number of
    // directions would otherwise double with every image.
    struct Screen;
    Screen& screen();
    std::shared_ptr<Screen> own_screen_;
    Screen* screen_ = nullptr;
};

// Seeds the inputs that vary along an axis; all else is constant.
//   screen, surface   every interpolated input with its own differential to the next pixel; along
//                     the surface, that of position is projected on the tangent plane of the
//                     surface normal, so that a height of position equals its volume form on
//                     low-poly meshes too
//   space             position with a unit vector
//   uv                that uv set with (1,0) or (0,1)
ForwardDiff direction_along(Module& module, DiffAxis axis);

// The rule of each op: returns the derivative of instruction `id`, of the instruction's type, from
// those of its operands (no_id: zero). Precondition: at least one is not zero; the instruction is
// not a texture sample, call or loop.
Id jvp_rule(Module& module, Id id, std::span<const Id> derivatives);

}  // namespace wrinkle
