// Forward derivatives: how a value changes along one direction.
//
// A direction says how the leaves change: for each leaf its tangent, of the same type; leaves not
// named are constant. The derivative is ordinary instructions of the same module, computed over a
// worklist with a memo; zero is a sentinel that costs nothing, so derivatives of sparse expressions
// stay sparse. Rules at singular points stand above the op table. Opaque values have no derivative
// here: expand first.
//
// The derivative of an open function's input is an input too (ir/open_input.h), which callers pass;
// that of a call is a call of the derived function; of a loop, a loop whose state is
// wider, along the path that the loop takes (that a step is the last is not differentiated). The
// derivative of a texture is the reference's filtered one: forward differences over one texel of
// the level in use (Mikkelsen's DerivFromHeightMap, three taps), times the change of uv.
#pragma once

#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

// Whether the value of this instruction has derivative 0 whatever its operands do, or is a leaf.
inline bool never_changes(const Inst& inst) {
    const OpInfo& row = info(inst.op);
    return row.flags & WR_FLAG_ZERO_DERIVATIVE || row.rule == Rule::leaf ||
           is_whole_type(inst.type);
}

// What an instruction's derivative is made of: its operands, a call's and a loop's for its results,
// with what a loop captures; of what is read from a picture its uv alone.
std::vector<Id> reads_of(const Module& module, Id value);

class Direction {
public:
    // `change`: what it is, where inputs of open functions shall have derivatives too.
    explicit Direction(Module& module, Change change = Change::none)
        : module_(&module), change_(change) {}
    void seed(Id leaf, Id tangent) { memo_.set(leaf, tangent); }
    // What is detached changes too: along something that is no place on the surface.
    void see_through_detach() { through_detach_ = true; }
    // Whether the instruction has tangent 0 whatever it reads.
    bool is_constant(const Inst& inst) const {
        return never_changes(inst) && !(through_detach_ && inst.op == Op::detach_);
    }

    // The tangent of `value`; poison stands for zero (see tangent_or_zero). Memoised.
    Id tangent(Id value);
    Id tangent_or_zero(Id value);
    // The derivative of one instruction alone: how it changes with `operand` (one of reads_of()),
    // as if all else it reads were constant. Of a direction without seeds.
    Id change_alone(Id value, Id operand, Id change);

private:
    // The tangents that are known, in a list as long as the module has become.
    class Memo {
    public:
        bool has(Id id) const { return id < tangents_.size() && tangents_[id] < marked; }
        Id at(Id id) const { return has(id) ? tangents_[id] : poison; }
        void set(Id id, Id tangent) { (*this)[id] = tangent; }
        void forget(Id id) { (*this)[id] = unknown; }
        // Between the first sight of a value and its tangent. False: seen or known before.
        bool mark(Id id) {
            if (id < tangents_.size() && tangents_[id] != unknown) return false;
            (*this)[id] = marked;
            return true;
        }

    private:
        static constexpr Id unknown = ~0U, marked = ~0U - 1;
        Id& operator[](Id id) {
            if (id >= tangents_.size()) tangents_.resize(id + size_t{1}, unknown);
            return tangents_[id];
        }
        std::vector<Id> tangents_;
    };

    // A function's derivative for some of its arguments changing.
    struct DerivedFunction {
        uint32_t region = 0;
        std::vector<int> member;  // of each result, in the derived function's; -1: zero
    };

    void unknown_below(Id value, std::vector<Id>& list);
    Id compute(Id id);
    Id change_of_input(uint32_t index);
    Id change_of_open_result(Id result);
    Id call_member(const Inst& result);
    Id loop_member(const Inst& result);
    const DerivedFunction& derived(uint32_t region, const std::vector<bool>& changing);
    std::vector<Id> widened_loop(Id loop);
    void seed_state(const Region& region, const std::vector<bool>& changing);
    bool spread(const Region& region, std::vector<bool>& changing);
    void forget(size_t first);
    Id texture(Id sample, Id read);

    Module* module_;
    Change change_;
    bool through_detach_ = false;
    Memo memo_;
    std::vector<Id> log_;                // what was memoised, in order
    std::vector<Id> open_, spare_list_;  // memory of tangent()
    std::map<std::pair<uint32_t, std::vector<bool>>, DerivedFunction> functions_;
    std::unordered_map<Id, std::vector<Id>> loops_;
    // For the level of textures. The pair is its own pair: in a row of images, each read at a uv
    // that the one before gives, they would double with every image.
    struct Screen;
    Screen& screen();
    std::shared_ptr<Screen> own_screen_;
    Screen* screen_ = nullptr;
};

// The change to the next pixel, in x and in y: every interpolated input changes by its own
// differential (position's is projected on the tangent plane of the surface normal when
// `project_position`, so that a height of position equals its volume form on low-poly meshes too).
Direction screen_direction(Module& module, Variant axis, bool project_position);

// d/dx, d/dy or d/dz: the position changes by a unit vector, all else is constant.
Direction space_direction(Module& module, int axis);

// d/du or d/dv of a uv set: that set changes by (1,0) or (0,1), all else is constant.
Direction uv_direction(Module& module, SurfaceInput uv_set, int axis);

}  // namespace wrinkle
