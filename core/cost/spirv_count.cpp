#include "cost/spirv_count.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "ir/op_traits.h"

namespace wrinkle {
namespace {

constexpr uint32_t magic = 0x07230203;
constexpr size_t header_words = 5;
constexpr uint32_t max_bound = 4'194'303;  // universal limits of the specification
constexpr uint64_t most_cost = 1'000'000'000;

// Numbers of the SPIR-V specification, section 3.49, and of GLSL.std.450.
enum : uint32_t {
    op_line = 8,
    op_ext_inst = 12,
    op_type_bool = 20,
    op_type_float = 22,
    op_type_vector = 23,
    op_type_matrix = 24,
    op_constant = 43,
    op_function = 54,
    op_function_call = 57,
    op_f_div = 136,
    op_vector_times_matrix = 144,
    op_matrix_times_vector = 145,
    op_matrix_times_matrix = 146,
    op_dot = 148,
    op_any = 154,
    op_all = 155,
    op_s_less_than = 177,
    op_loop_merge = 246,
    op_label = 248,
    op_branch_conditional = 250,
    op_switch = 251,
    op_no_line = 317,
};

struct Range {
    uint32_t first, last;
    bool holds(uint32_t op) const { return first <= op && op <= last; }
};

bool any_holds(std::span<const Range> ranges, uint32_t op) {
    return std::any_of(ranges.begin(), ranges.end(), [op](Range r) { return r.holds(op); });
}

// Instructions that cost one per component of their result: conversions, arithmetic, products with
// a scalar, tests, selections and comparisons, bit operations.
constexpr Range one_a_lane[] = {{109, 115}, {124, 124}, {126, 143}, {147, 147},
                                {156, 157}, {164, 191}, {194, 205}};
constexpr Range image_reads[] = {{87, 98}, {305, 315}, {320, 320}};
constexpr Range image_queries[] = {{101, 107}};
constexpr Range screen_derivatives[] = {{207, 215}};
constexpr Range block_ends[] = {{249, 255}};

// Functions of GLSL.std.450 that cost more than one operation per component.
struct FunctionCost {
    Range functions;
    uint32_t alu, transcendental = 0;
};
constexpr FunctionCost per_component[] = {
    {{13, 18}, 1, 1},                               // Sin to Atan
    {{25, 25}, 1, 1},                               // Atan2
    {{26, 26}, traits(Op::pow_).per_component, 2},  // Pow
    {{27, 32}, 1, 1},                               // Exp to InverseSqrt
    {{43, 45}, traits(Op::clamp_).per_component},   // FClamp, UClamp, SClamp
    {{46, 46}, traits(Op::mix_).per_component},     // FMix
    {{49, 49}, traits(Op::smoothstep_).per_component},
    {{50, 50}, 2},                                  // Fma
    {{81, 81}, traits(Op::clamp_).per_component}};  // NClamp
constexpr FunctionCost per_operand_component[] = {
    {{66, 66}, traits(Op::length_).per_operand, 1},
    {{67, 67}, traits(Op::length_).per_operand + 1, 1},  // Distance
    {{69, 69}, traits(Op::normalize_).per_component, 1}};
constexpr uint32_t function_cross = 68;

// Product of a matrix of `rows` x `inner` numbers and one of `inner` x `columns`; dot is a product
// of a row and a column.
constexpr uint32_t product_cost(uint32_t rows, uint32_t inner, uint32_t columns) {
    return rows * (2 * inner - 1) * columns;
}

const FunctionCost* cost_in(std::span<const FunctionCost> table, uint32_t function) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const FunctionCost& row) {
        return row.functions.holds(function);
    });
    return found == table.end() ? nullptr : &*found;
}

struct Shape {
    uint32_t rows = 0, columns = 0;  // scalar 1, 1; vector n, 1; 0: unknown
    uint32_t lanes() const { return rows * columns; }
};

class Counter {
public:
    explicit Counter(uint32_t bound) : type_shape_(bound), type_(bound, 0) {}

    // Counts one instruction; returns false and sets `why` for a function call.
    bool take(uint32_t op, std::span<const uint32_t> operands, std::string& why) {
        declare(op, operands);
        if (op == op_line) line_ = at(operands, 1);
        if (op == op_no_line) line_ = 0;
        inside_ = inside_ || op == op_function;
        if (op == op_constant) constants_[at(operands, 1)] = at(operands, 2);
        if (op == op_function_call) {
            why = "a call is left";
            return false;
        }
        if (!inside_) return true;
        if (op == op_label) end_loops(at(operands, 0));
        const ShaderCost cost = cost_of(op, operands);
        if (!(cost == ShaderCost{})) add(cost);
        find_iterations(op, operands);
        if (any_holds(block_ends, op)) line_ = 0;
        return true;
    }

    SpirvCount count;

private:
    static uint32_t at(std::span<const uint32_t> operands, size_t index) {
        return index < operands.size() ? operands[index] : 0;
    }
    Shape shape_of_type(uint32_t id) const {
        return id < type_shape_.size() ? type_shape_[id] : Shape{};
    }
    Shape shape(uint32_t value) const {
        const Shape found = value < type_.size() ? shape_of_type(type_[value]) : Shape{};
        return found.rows ? found : Shape{1, 1};
    }

    // Records types, and result types: if the first operand is a known type, the second operand is
    // a result of it.
    void declare(uint32_t op, std::span<const uint32_t> operands) {
        const uint32_t first = at(operands, 0);
        if (first >= type_shape_.size()) return;
        if (op_type_bool <= op && op <= op_type_float)
            type_shape_[first] = {1, 1};
        else if (op == op_type_vector)
            type_shape_[first] = {at(operands, 2), 1};
        else if (op == op_type_matrix)
            type_shape_[first] = {shape_of_type(at(operands, 1)).rows, at(operands, 2)};
        else if (operands.size() > 1 && type_shape_[first].rows && operands[1] < type_.size())
            type_[operands[1]] = first;
    }

    void add(const ShaderCost& cost) {
        count.once += cost;
        std::vector<ShaderCost>& lines = loops_.empty() ? count.lines : loops_.back().lines;
        if (lines.size() <= line_) lines.resize(line_ + size_t{1});
        lines[line_] += cost;
    }

    // Begins loops and finds their numbers of iterations: n if the first conditional branch of a
    // loop is on i < n and n is a constant, otherwise 1.
    void find_iterations(uint32_t op, std::span<const uint32_t> operands) {
        const auto known = [](const auto& table, uint32_t id) {
            const auto found = table.find(id);
            return found == table.end() ? 0 : found->second;
        };
        if (op == op_s_less_than) limits_[at(operands, 1)] = known(constants_, at(operands, 3));
        if (op == op_loop_merge) loops_.push_back({at(operands, 0), 0, {}});
        if (op != op_branch_conditional || loops_.empty() || loops_.back().iterations > 0) return;
        loops_.back().iterations = std::max(1U, known(limits_, at(operands, 0)));
    }

    // Ends the loop with this label of its merge block, and those in it.
    void end_loops(uint32_t label) {
        const auto ends = [&](const Loop& loop) { return loop.merge == label; };
        const auto first = std::ranges::find_if(loops_, ends);
        for (auto count = loops_.end() - first; count > 0; --count)
            end_loop();
    }
    void end_loop() {
        const Loop loop = std::move(loops_.back());
        loops_.pop_back();
        std::vector<ShaderCost>& lines = loops_.empty() ? count.lines : loops_.back().lines;
        lines.resize(std::max(lines.size(), loop.lines.size()));
        for (size_t i = 0; i < loop.lines.size(); ++i)
            lines[i] += loop.lines[i].times(std::max(1U, loop.iterations));
    }

public:
    void finish() {
        while (!loops_.empty())
            end_loop();
        for (const ShaderCost& line : count.lines)
            count.total += line;
    }

private:
    uint32_t product(uint32_t op, std::span<const uint32_t> operands) const {
        const Shape left = shape(at(operands, 2)), right = shape(at(operands, 3));
        if (op == op_vector_times_matrix) return product_cost(1, right.rows, right.columns);
        return product_cost(left.rows, left.columns, right.columns);
    }

    ShaderCost cost_of(uint32_t op, std::span<const uint32_t> operands) const {
        ShaderCost cost;
        const uint32_t lanes = shape(at(operands, 1)).lanes();
        cost.reads = any_holds(image_reads, op) ? 1 : 0;
        cost.queries = any_holds(image_queries, op) ? 1 : 0;
        cost.branches = op == op_branch_conditional || op == op_switch ? 1 : 0;
        cost.loops = op == op_loop_merge ? 1 : 0;
        if (any_holds(screen_derivatives, op)) {
            cost.derivatives = 1;
            cost.derivative_lanes = lanes;
        } else if (op == op_dot) {
            cost.alu = product_cost(1, shape(at(operands, 2)).lanes(), 1);
        } else if (op == op_any || op == op_all) {
            cost.alu = shape(at(operands, 2)).lanes();
        } else if (op_vector_times_matrix <= op && op <= op_matrix_times_matrix) {
            cost.alu = product(op, operands);
        } else if (op == op_ext_inst) {
            extended(at(operands, 3), lanes, shape(at(operands, 4)).lanes(), cost);
        } else if (any_holds(one_a_lane, op)) {
            cost.alu = lanes;
            cost.divisions = op == op_f_div ? lanes : 0;
        }
        return cost;
    }

    static void extended(uint32_t function, uint32_t lanes, uint32_t operand_lanes,
                         ShaderCost& cost) {
        cost.alu = function == function_cross ? traits(Op::cross_).fixed : lanes;
        if (const FunctionCost* found = cost_in(per_component, function)) {
            cost.alu = found->alu * lanes;
            cost.transcendental = found->transcendental * lanes;
        } else if (const FunctionCost* length = cost_in(per_operand_component, function)) {
            cost.alu = length->alu * operand_lanes;
            cost.transcendental = length->transcendental;
        }
    }

    struct Loop {
        uint32_t merge;       // label of the block after it
        uint32_t iterations;  // 0 until it is known
        std::vector<ShaderCost> lines;
    };
    std::vector<Loop> loops_;                           // open ones
    std::unordered_map<uint32_t, uint32_t> constants_;  // first word by id
    std::unordered_map<uint32_t, uint32_t> limits_;     // n by id of the comparison i < n
    std::vector<Shape> type_shape_;                     // by type id
    std::vector<uint32_t> type_;                        // type id by value id
    uint32_t line_ = 0;
    bool inside_ = false;
};

}  // namespace

ShaderCost& ShaderCost::operator+=(const ShaderCost& other) {
    alu += other.alu;
    transcendental += other.transcendental;
    divisions += other.divisions;
    reads += other.reads;
    queries += other.queries;
    derivatives += other.derivatives;
    derivative_lanes += other.derivative_lanes;
    branches += other.branches;
    loops += other.loops;
    return *this;
}

ShaderCost ShaderCost::times(uint32_t iterations) const {
    ShaderCost all = *this;
    for (uint32_t ShaderCost::*number :
         {&ShaderCost::alu, &ShaderCost::transcendental, &ShaderCost::divisions, &ShaderCost::reads,
          &ShaderCost::queries, &ShaderCost::derivatives, &ShaderCost::derivative_lanes})
        all.*number = static_cast<uint32_t>(
            std::min<uint64_t>(uint64_t{this->*number} * iterations, most_cost));
    return all;
}

std::optional<SpirvCount> count_spirv(std::span<const uint32_t> words, std::string& why) {
    why = "it is not SPIR-V";
    if (words.size() < header_words || words[0] != magic || words[3] > max_bound) return {};
    Counter counter(words[3]);
    for (size_t i = header_words; i < words.size();) {
        const size_t length = words[i] >> 16;
        if (length == 0 || i + length > words.size()) return {};
        if (!counter.take(words[i] & 0xFFFF, words.subspan(i + 1, length - 1), why)) return {};
        i += length;
    }
    why.clear();
    counter.finish();
    return std::move(counter.count);
}

}  // namespace wrinkle
