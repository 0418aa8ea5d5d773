#include "editor/model/document/inputs.h"

#include <algorithm>
#include <charconv>

#include "editor/model/words.h"
#include "graph/condition.h"
#include "graph/edit.h"
#include "lower/literal.h"
#include "lower/preset.h"

namespace wrinkle::editor {
namespace {

const Extra* entry_of(const Document& document, const std::string& preset, std::string_view input) {
    const Preset* found = preset.empty() ? nullptr : document.presets.find(preset);
    if (!found) return nullptr;
    const auto entry = std::ranges::find(found->values, input, &Extra::key);
    return entry == found->values.end() ? nullptr : &*entry;
}

// Returns the number of a value in a condition; "" is 0.
std::optional<double> operand(std::string_view word, const Port& port) {
    if (word.empty() || word == "false") return 0;
    if (word == "true") return 1;
    const auto choice = std::ranges::find(port.choices, word);
    if (choice != port.choices.end()) return static_cast<double>(choice - port.choices.begin());
    double number = 0;
    const auto end = std::from_chars(word.data(), word.data() + word.size(), number).ptr;
    return end == word.data() + word.size() ? std::optional(number) : std::nullopt;
}

bool holds(double left, std::string_view op, double right) {
    if (op == "==") return left == right;
    if (op == "!=") return left != right;
    if (op == "<") return left < right;
    if (op == "<=") return left <= right;
    return op == ">" ? left > right : left >= right;
}

// Moves the input at index `from` to index `to`, and puts it into the group.
Document with_position(const Document& document, size_t from, size_t to, const std::string& group) {
    std::vector<GraphInput> inputs(document.inputs.begin(), document.inputs.end());
    inputs[from].group = group;
    const auto first = inputs.begin() + static_cast<std::ptrdiff_t>(std::min(from, to));
    const auto last = inputs.begin() + static_cast<std::ptrdiff_t>(std::max(from, to)) + 1;
    std::rotate(first, from < to ? first + 1 : last - 1, last);
    Document changed = document;
    changed.inputs = Table<GraphInput>(std::move(inputs));
    return changed;
}

}  // namespace

Document with_input_at(const Document& document, std::string_view input, std::string_view target) {
    const size_t from = document.inputs.index_of(input), to = document.inputs.index_of(target);
    if (from == Table<GraphInput>::npos || to == Table<GraphInput>::npos || from == to)
        return document;
    return with_position(document, from, to, document.inputs[to].group);
}

Document with_input_in_group(const Document& document, std::string_view input,
                             const std::string& group) {
    const size_t from = document.inputs.index_of(input);
    if (from == Table<GraphInput>::npos) return document;
    size_t to = from;
    for (size_t i = 0; i < document.inputs.size(); ++i)
        if (i != from && document.inputs[i].group == group) to = i < from ? i + 1 : i;
    return with_position(document, from, to, group);
}

bool is_in_preset(const Document& document, const std::string& preset, std::string_view input) {
    return entry_of(document, preset, input) != nullptr;
}

json::Value value_of_input(const Document& document, const std::string& preset,
                           const GraphInput& input) {
    const Extra* entry = entry_of(document, preset, input.name);
    return entry ? entry->value : input.default_value;
}

std::array<double, 4> numbers_of_input(const Document& document, const std::string& preset,
                                       const GraphInput& input, const Port& port) {
    std::array<double, 4> numbers = port.default_value;
    const json::Value value = value_of_input(document, preset, input);
    if (port.is_option())
        numbers[0] = literal_option(value, port).value_or(static_cast<int32_t>(numbers[0]));
    else
        literal_numbers(value, port.type, numbers);
    return numbers;
}

Document with_input_value(const Document& document, const std::string& preset,
                          const std::string& input, json::Value value) {
    const GraphInput* found = document.inputs.find(input);
    if (!found) return document;
    if (preset.empty()) {
        GraphInput changed = *found;
        changed.default_value = std::move(value);
        return set_graph_input(document, std::move(changed));
    }
    const Preset* old = document.presets.find(preset);
    if (!old) return document;
    if (value == found->default_value) return without_input_value(document, preset, input);
    Preset changed = *old;
    const auto entry = std::ranges::find(changed.values, input, &Extra::key);
    if (entry == changed.values.end())
        changed.values.push_back({input, std::move(value)});
    else
        entry->value = std::move(value);
    return set_preset(document, std::move(changed));
}

Document without_input_value(const Document& document, const std::string& preset,
                             std::string_view input) {
    if (!is_in_preset(document, preset, input)) return document;
    Preset changed = *document.presets.find(preset);
    std::erase_if(changed.values, [&](const Extra& value) { return value.key == input; });
    return set_preset(document, std::move(changed));
}

Document with_copied_preset(const Document& document, const std::string& name,
                            const std::string& from) {
    Preset preset;
    if (const Preset* source = document.presets.find(from)) preset.values = source->values;
    preset.name = name;
    return set_preset(document, std::move(preset));
}

std::string free_preset_name(const Document& document) {
    std::string name;
    for (size_t n = 1; name.empty() || document.presets.find(name); ++n)
        name = "preset " + std::to_string(n);
    return name;
}

std::string preset_name_problem(const Document& document, const std::string& name) {
    if (name.empty()) return "Type a name for the preset.";
    if (document.presets.find(name)) return "There is a preset " + name + " already.";
    const std::string problem = id_problem(name, false);
    return problem.empty() ? ""
                           : "\"" + name + "\" cannot be the name of a preset: " + problem + ".";
}

PresetOfFile with_preset_file(const Model& model, const Document& document,
                              const std::filesystem::path& file) {
    PresetOfFile result{document, file.filename().string(), {}};
    result.name.resize(result.name.size() - preset_suffix.size());
    Diagnostics problems;
    Preset preset = preset_of_file(project_with(model, document), file.string(), problems);
    preset.name = result.name;
    for (const Extra& value : preset.values)
        if (const Port* port = port_of_input(model, value.key))
            for (const LiteralProblem& problem : literal_problems(value.value, *port))
                if (problem.severity == Severity::error)
                    problems.add(diagnose(value.value, "", problem.rule,
                                          "input '" + value.key + "' " + problem.message,
                                          problem.expected));
    if (const std::string problem = id_problem(preset.name, false); !problem.empty())
        problems.error(RuleId::invalid_name, "the name of the preset " + problem,
                       "expected another name of the file");
    if (problems.has_errors())
        result.problem = first_error(problems);
    else
        result.document = set_preset(document, std::move(preset));
    return result;
}

bool is_displayed(const Model& model, const Document& document, const std::string& preset,
                  const GraphInput& input) {
    const auto condition = parse_condition(input.when);
    if (!condition) return true;
    const GraphInput* other = document.inputs.find(condition->input);
    const Port* port = other ? port_of_input(model, other->name) : nullptr;
    if (!port) return true;
    const auto right = operand(condition->value, *port);
    return !right ||
           holds(numbers_of_input(document, preset, *other, *port)[0], condition->op, *right);
}

const Port* port_of_input(const Model& model, std::string_view input) {
    const size_t index = model.project->top().inputs.index_of(input);
    return index == Table<GraphInput>::npos ? nullptr : &model.types->graph_input(0, index);
}

Document with_preset_as_defaults(const Model& model, const Document& document,
                                 const std::string& preset) {
    if (preset.empty() || !document.presets.find(preset)) return document;
    Diagnostics reported_by_check;
    return with_preset(project_with(model, document), preset, reported_by_check).top();
}

std::vector<std::string> changed_inputs(const Model& model, const PresetOf& before,
                                        const PresetOf& after) {
    const Table<GraphInput> a =
        with_preset_as_defaults(model, before.document, before.preset).inputs;
    const Table<GraphInput> b = with_preset_as_defaults(model, after.document, after.preset).inputs;
    std::vector<std::string> changed;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (a[i].default_value != b[i].default_value) changed.push_back(b[i].name);
    return changed;
}

}  // namespace wrinkle::editor
