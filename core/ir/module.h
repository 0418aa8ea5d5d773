// The expression language: a module of immutable SSA instructions with hash consing.
//
// An instruction is 32 bytes in one vector and is identified by its index, its Id. Operands always
// have smaller ids, so id order is a topological order and every pass is a loop. add() interns:
// equal expressions are one value. It also checks types, folds constants and applies peepholes, so
// an expression is simplified while it is written.
//
// No instruction has the Id 0, which has two names:
//   poison   the result of an invalid add(), which records a problem. An op with a poison operand
//            is poison, without another problem. (LLVM's poison, deferred undefined behaviour, is
//            something else.)
//   no_id    absent: an unused operand, the surface as base of a gradient, an empty Value, a zero
//            derivative (ir/derive.h), "none" as the result of a query or of a Replace callback.
//
// Regions represent both loops and functions. A region's body is ordinary instructions over
// region_param(level, k). A level is a region depth: that of an instruction is the greatest level
// of its operands; 0 is outside every region. A loop body captures the values of lower levels that
// it uses, so loop-invariant code is outside the loop without a pass for it. Functions are closed:
// end_region() turns their captured values (except literals, parameters of the user, image sizes
// and values computed from these) into further parameters, and renames their parameters to level 1
// so that equal functions are one region wherever they were recorded. A loop's region has its
// parameters at its own level.
//   function: results are its outputs. A sub-graph's is open until expand() (ir/open_input.h).
//   loop:     parameters are the state; results[0] is the loop condition, a bool, results[1..] the
//             next state. It runs while the condition holds for the current state, at most
//             `max_iterations` times; its value is the last state. (The results are computed first;
//             if the condition is false the next state is dropped.)
// `loop` and `call` have type tuple; result(k) extracts a member.
//
// The power x^n of x = uv0.x, as print() writes it, with the depth of each value:
//
//   %2 float = swizzle.x %1              0
//   %5 float = region_param 1.0          1: the product
//   %6 float = region_param 1.1          1: the counter
//   %7 float = mul %5 %2                 1; captures %2
//   %8 float = add %6 %4                 1; captures the literal 1
//   %9 bool = lt %6 %3                   1; captures n
//   @1 loop of at most 64 (float, float) -> %9 %7 %8
//   %10 tuple = loop @1 %2 %4            0
//
// Literals are scalars in double; a vector constant is a construct of literals. A node's
// unconnected numbers are `parameter`s, so that frames, bases and errors never depend on a value;
// expand() (ir/expand.h) can turn them into literals.
//
// A gradient-typed instruction stores its base in `extra` (the Id of a `base` instruction; 0 is the
// surface or, of gradient_zero, any). Adding or mixing gradients of two bases is an error. A
// resolve's `extra` identifies the node instance that made it, so that hash consing never merges
// two resolves into one base.
//
// Side tables: origin[id] is the node instance that first wrote the instruction; `named` holds the
// names of values; problems lists the errors of add(), by origin.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "base/string_pool.h"
#include "ir/inst.h"
#include "ir/intern_table.h"
#include "ir/open_input.h"
#include "ir/side_tables.h"

namespace wrinkle {

class ModuleCloner;  // ir/module_cloner.h

enum class RegionKind : uint8_t { function, loop };
struct Region {
    RegionKind kind = RegionKind::function;
    uint8_t level = 1;  // level of its parameters
    uint32_t max_iterations = 0;
    std::vector<Type> params;
    std::vector<Id> results;
    // Open functions: the first parameter in Module::open_inputs; the results are at level 0.
    static constexpr uint32_t closed = ~0U;
    uint32_t first_input = closed;
    // Not part of its identity. Names of parameters and results: a sub-graph's, else empty.
    std::string name;
    std::vector<std::string> param_names, result_names;

    bool is_open() const { return first_input != closed; }
};

// The values and calls of a region's body, except values that every region may read (literals,
// parameters of the user, image sizes).
struct RegionBody {
    std::vector<Id> captured;  // at lower levels, in order of first use from left to right
    std::vector<uint32_t> called;
    bool parameters_fit = true;  // its region_params exist, with these types
};

// A recorded region and, for a function, the values it captured: they became further parameters,
// and apply() passes them after the arguments. (Equal functions share a region and may capture
// different values.)
struct RegionUse {
    uint32_t region = 0;
    std::vector<Id> captured;
};

class Module {
public:
    Module();
    void reserve(size_t expected);  // reserves memory; before the first instruction

    // The general form. `type` is used by construct only; elsewhere the type follows from the
    // operands. Returns poison (and records a problem, unless an operand is poison) if they do not
    // fit.
    Id add(Op op, std::span<const Id> args, uint32_t extra = 0, Type type = Type::poison_);
    Id add(Op op, std::initializer_list<Id> args, uint32_t extra = 0, Type type = Type::poison_) {
        return add(op, std::span<const Id>(args.begin(), args.size()), extra, type);
    }

    Id literal(Type scalar, double value);
    Id number(double value) { return literal(Type::float_, value); }
    Id constant(Type type, std::span<const double> lanes);  // vectors and mat3 (column-major) too
    Id zero(Type type);
    Id unit(Type type, size_t lane);  // a float or vector: 1 in this component, 0 in all others
    Id input(SurfaceInput input, Variant variant = Variant::value);
    Id parameter(uint32_t index);
    // An opaque leaf; `number` belongs to the caller.
    Id material(uint32_t number) {
        return intern({Op::material_, Type::material_, 0, {}, number, 0});
    }
    Id construct(Type type, std::initializer_list<Id> parts);
    Id swizzle(Id vector, std::string_view components);  // "xy", "z"
    Id component(Id vector, uint32_t lane);              // a float has itself as component

    // Regions are recorded in nested pairs of begin and end. begin_region() returns the parameters;
    // the values added before end_region() that use them are the body. The name of a function may
    // name its parameters too: "noise(point, width)".
    std::vector<Id> begin_region(RegionKind kind, std::string name, std::span<const Type> params);
    RegionUse end_region(std::span<const Id> results, uint32_t max_iterations = 0);
    // Calls a function or runs a loop; returns one Id per output or per member of the state.
    std::vector<Id> apply(const RegionUse& use, std::span<const Id> args);
    // Interns a region that is already closed and has its levels, as passes that rebuild make them.
    uint32_t intern_region(Region region);
    // apply_region() returns the tuple of a region applied to these arguments (captured values
    // included), result() a member of a tuple.
    Id apply_region(uint32_t region, std::span<const Id> args);
    Id result(Id tuple, uint32_t member);
    // A parameter of an open function (ir/open_input.h).
    Id add_open_input(OpenInput input);
    bool is_open_input(Id id) const {
        return inst_[id].op == Op::region_param_ && inst_[id].level == 0;
    }
    // If `id` is a result of a call of an open function, returns the value of that result in the
    // function's body; otherwise no_id.
    Id open_result(Id id) const;
    // Maximum region depth: each level makes loops and their derivatives more expensive.
    static constexpr int max_region = 16;
    static constexpr int max_call = 48;  // passes over called functions recurse
    int depth() const { return static_cast<int>(open_.size()); }

    const Inst& operator[](Id id) const { return inst_[id]; }  // not to be held across add()
    Id size() const { return static_cast<Id>(inst_.size()); }
    Type type(Id id) const { return inst_[id].type; }
    std::span<const Id> operands(Id id) const {
        const Inst& inst = inst_[id];
        const int arity = info(inst.op).arity;
        if (arity < 0) return listed_operands(inst);
        return std::span(inst.arg.data(), static_cast<size_t>(arity));
    }
    // Returns true if an instruction of this op was ever written, needed or not.
    bool has(Op op) const { return has_[static_cast<size_t>(op)]; }
    const Region& region(uint32_t index) const { return regions_[index]; }
    uint32_t region_count() const { return static_cast<uint32_t>(regions_.size()); }
    // Returns the greatest number of nested calls below a region.
    int call_depth(uint32_t region) const { return call_depths_[region]; }

    // Returns true for a scalar literal of this value, or a construct of such literals.
    bool is_literal(Id id, double value) const {
        const Inst& inst = inst_[id];
        if (inst.op == Op::literal_) return inst.value == value;
        return inst.op == Op::construct_ && has_literal_parts(id, value);
    }
    bool is_constant(Id id) const {  // a literal or a construct of literals
        const Op op = inst_[id].op;
        return op == Op::literal_ || (op == Op::construct_ && has_constant_parts(id));
    }

    uint32_t add_parameter(Parameter parameter);
    uint32_t add_resource(const Resource& resource);  // merges with an equal one

    void problem(std::string message, std::string expected = {});
    // Names a value for generated source, used if it becomes a separate statement; an existing name
    // is retained. "min_area // why": a named constant with a comment, the same for all nodes, if
    // the value is a literal or a vector of literals, or becomes one.
    void name(Id value, uint32_t node, std::string_view name);
    const Named* name_of(Id value);  // its first name; null if it has none
    // Names the derivative of a value that has a name: "slope" for an output and for "value", else
    // "NAME_slope".
    void name_slope(Id value, Id derivative, std::string_view suffix);

    // Side tables; passes carry them over.
    std::vector<NodeInstance> nodes;
    StringPool titles;
    std::vector<Parameter> parameters;
    std::vector<Resource> resources;
    std::vector<OpenInput> open_inputs;
    std::vector<Named> named;
    std::vector<ModuleOutput> outputs;
    std::vector<Problem> problems;
    std::vector<uint32_t> origin;  // by Id
    uint32_t current_node = 0;     // the origin of instructions added now

    // Maximum number of instructions: adding one more throws OverLimit (base/limits.h), which names
    // the current node.
    uint64_t most_values;

    // Returns a parameter of the region at this level, for passes that rebuild regions.
    Id region_parameter(int level, uint32_t index, Type type);
    // Returns a copy of a literal, an input or a region parameter of another module.
    Id leaf(const Inst& inst) { return intern(inst); }
    std::array<double, 9> lanes_of(Id constant) const;

private:
    using RegionIdentity =
        std::tuple<RegionKind, uint8_t, uint32_t, uint32_t, std::vector<Type>, std::vector<Id>>;
    static RegionIdentity identity(const Region& region) {
        return {region.kind,        region.level,  region.max_iterations,
                region.first_input, region.params, region.results};
    }
    struct OpenRegion {
        RegionKind kind;
        std::string name;
        std::vector<Type> params;
        size_t first_name;  // in `named`
    };
    void share_name(uint32_t index);
    Id intern(const Inst& inst);
    Id append(const Inst& inst);
    bool has_constant_parts(Id construct) const;
    bool has_literal_parts(Id construct, double value) const;
    uint32_t intern_list(std::span<const Id> ids);
    Type typed(Op op, std::span<const Type> types, uint32_t extra, Type wanted);
    Type refused(Op op, std::span<const Type> types, Type wanted);
    Id folded_call(uint32_t region, uint32_t result, std::span<const Id> args);
    Id folded_constant(Op op, std::span<const Id> args, uint32_t extra, Type type);
    Id not_written(Op op, std::span<const Id> args);
    Id add_swizzle(Id vector, uint32_t extra);
    std::span<const Id> listed_operands(const Inst& inst) const;
    bool set_base(Op op, std::span<const Id> args, uint32_t& extra);
    bool fits(const OpenRegion& open, std::span<const Id> results);
    bool fits(const RegionBody& body);
    void name_copies(size_t first, const ModuleCloner& copier);
    int calls_below(const RegionBody& body) const;
    uint32_t intern_region(Region region, const RegionBody& body);

    std::vector<Inst> inst_;
    InternTable table_;
    std::vector<Id> parameter_ids_;  // by index of the parameter
    std::array<bool, tables::op_count> has_{};
    std::vector<std::vector<Id>> lists_;
    std::map<std::vector<Id>, uint32_t> list_table_;
    std::vector<Region> regions_;  // [0] is unused
    std::map<RegionIdentity, uint32_t> region_table_;
    std::vector<uint8_t> free_levels_;  // by region: the greatest level that a loop's body captures
    std::vector<int> call_depths_;      // by region: greatest number of nested calls
    std::vector<OpenRegion> open_;
    std::vector<uint32_t> names_;  // by Id: 1 + index in `named`; 0 for none
    size_t indexed_names_ = 0;     // entries of `named` that names_ has
};

RegionBody region_body(const Module& module, const Region& region);

}  // namespace wrinkle
