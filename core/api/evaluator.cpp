#include <algorithm>
#include <cmath>

#include "api/parts.h"
#include "base/text.h"
#include "graph/renamed.h"
#include "lower/literal.h"
#include "lower/types.h"

namespace wrinkle::api {

struct WRINKLE_INSIDE Evaluator::Parts {
    struct Limited {
        Input input;
        std::optional<Range> limits;
    };
    Problems problems;  // after an error, there is nothing else
    std::shared_ptr<const Graph::Parts> graph;
    std::shared_ptr<const Prepared> prepared;
    Program program;  // that of `prepared`, with the current values
    std::vector<Limited> inputs;
};

namespace {

// Replaces the value in the program; does nothing if no output depends on the input.
void put(Program& program, const Evaluator::Input& input) {
    const auto parameter = std::ranges::find(
        program.parameters, input.name, [](const Program::Parameter& each) { return each.name; });
    if (parameter != program.parameters.end()) set_parameter(program, *parameter, input.value);
}

std::vector<Evaluator::Parts::Limited> numeric_inputs(const Graph::Parts& graph) {
    std::vector<Evaluator::Parts::Limited> found;
    const Types types(graph.project, graph.library->registry);
    const auto& inputs = graph.project.top().inputs;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const Port& port = types.graph_input(0, i);
        const auto lanes = static_cast<size_t>(port.is_value() ? lanes_of(port.type) : 0);
        std::array<double, 4> value{};
        const bool given = literal_numbers(inputs[i].default_value, port.type, value);
        if (lanes == 0 || (port.type == PortType::normal_ && !given)) continue;
        const auto limits = range_of(inputs[i].limits);
        if (limits)
            for (double& number : value)
                number = std::clamp(number, limits->least, limits->most);
        found.push_back({{inputs[i].name, {value.begin(), value.begin() + lanes}}, limits});
    }
    return found;
}

Problems invalid(const std::string& message, const std::string& expected) {
    Diagnostics diagnostics;
    diagnostics.error(RuleId::option, message, expected);
    return problems_of(diagnostics);
}

Problems no_evaluator() {
    return invalid("there is no evaluator: none was made, or it was moved from", {});
}

}  // namespace

Evaluated evaluated_at(const Points& points, const Program& program,
                       const std::vector<Texture>& textures, bool double_precision,
                       Diagnostics problems) {
    Evaluated result;
    const bool single = !double_precision;
    if (!problems.has_errors()) {
        const PointSet set = point_set(points, program, single, problems);
        result.ok = !problems.has_errors();
        if (result.ok)
            for (OutputColumn& column : evaluate_columns(
                     program, set, textures, single ? Precision::single : Precision::full))
                result.outputs.push_back(
                    {std::move(column.name), column.lanes, std::move(column.values)});
    }
    result.problems = problems_of(problems);
    return result;
}

Evaluator::Evaluator() noexcept = default;
Evaluator::Evaluator(Evaluator&&) noexcept = default;
Evaluator& Evaluator::operator=(Evaluator&&) noexcept = default;
Evaluator::~Evaluator() = default;
Evaluator::Evaluator(std::unique_ptr<Parts> parts) noexcept : parts_(std::move(parts)) {}

Evaluator::Evaluator(const Evaluator& other) noexcept {
    *this = other;
}

// Without memory for a copy, the handle is empty.
Evaluator& Evaluator::operator=(const Evaluator& other) noexcept {
    if (this == &other) return *this;
    try {
        parts_ = other.parts_ ? std::make_unique<Parts>(*other.parts_) : nullptr;
    } catch (...) {
        parts_ = nullptr;
    }
    return *this;
}

Problems Evaluator::problems() const noexcept {
    try {
        return parts_ ? parts_->problems : no_evaluator();
    } catch (...) {
        return caught();
    }
}

std::vector<Evaluator::Input> Evaluator::inputs() const noexcept {
    try {
        std::vector<Input> inputs;
        if (parts_)
            for (const Parts::Limited& each : parts_->inputs)
                inputs.push_back(each.input);
        return inputs;
    } catch (...) {
        return {};
    }
}

int Evaluator::find(const std::string& input) const noexcept {
    try {
        if (!parts_ || parts_->inputs.empty()) return -1;
        std::string name(FormerNames(parts_->graph->project.top().inputs).current(input));
        if (name.empty()) name = input;
        const auto found = std::ranges::find_if(
            parts_->inputs, [&](const auto& each) { return each.input.name == name; });
        return found == parts_->inputs.end() ? -1
                                             : static_cast<int>(found - parts_->inputs.begin());
    } catch (...) {
        return -1;
    }
}

Problems Evaluator::set(int input, const std::vector<double>& value) noexcept {
    try {
        if (!parts_) return no_evaluator();
        if (input < 0 || static_cast<size_t>(input) >= parts_->inputs.size())
            return invalid("there is no input " + std::to_string(input),
                           std::to_string(parts_->inputs.size()) + " inputs are numeric");
        auto& [current, limits] = parts_->inputs[static_cast<size_t>(input)];
        const std::string name = "input '" + current.name + "'";
        if (value.size() != current.value.size())
            return invalid(name + " is given " + std::to_string(value.size()) + " numbers",
                           std::to_string(current.value.size()));
        if (!std::ranges::all_of(value, [](double number) { return std::isfinite(number); }))
            return invalid(name + " is given a number that is not finite", {});
        for (size_t i = 0; i < value.size(); ++i)
            current.value[i] =
                limits ? std::clamp(value[i], limits->least, limits->most) : value[i];
        put(parts_->program, current);
        return {};
    } catch (...) {
        return caught();
    }
}

Evaluated Evaluator::evaluate(const Points& points, bool double_precision) const noexcept {
    Evaluated result;
    try {
        if (parts_ && !has_errors(parts_->problems))
            return evaluated_at(points, parts_->program, parts_->prepared->textures,
                                double_precision, parts_->prepared->problems);
        result.problems = problems();
    } catch (...) {
        result = {};
        result.problems = caught();
    }
    return result;
}

Evaluator Graph::evaluator(bool vertex_tangents) const noexcept {
    try {
        auto parts = std::make_unique<Evaluator::Parts>();
        if (!parts_ || !parts_->whole) {
            parts->problems = parts_ ? parts_->unusable : no_graph();
            return Evaluator(std::move(parts));
        }
        parts->prepared = prepared_once(*parts_, vertex_tangents);
        parts->problems = problems_of(parts->prepared->problems);
        if (!has_errors(parts->problems)) {
            parts->graph = parts_;
            parts->program = parts->prepared->program;
            parts->inputs = numeric_inputs(*parts_);
        }
        return Evaluator(std::move(parts));
    } catch (...) {
        return {};
    }
}

}  // namespace wrinkle::api
