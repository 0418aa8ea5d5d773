#include <algorithm>
#include <limits>
#include <set>

#include "base/text.h"
#include "graph/reader.h"

namespace wrinkle::reading {
namespace {

using json::Kind;
using json::Value;

constexpr size_t max_choices = 256, max_renamed = 32;

bool is_single(const Value& value) {
    return value.is(Kind::number) &&
           std::abs(value.as_number()) <= std::numeric_limits<float>::max();
}

bool refuse(const Value& value, std::string message, std::string expected, Report& report) {
    report.at(value, "", RuleId::invalid_value, std::move(message), std::move(expected));
    return false;
}

bool read_range(const Value& value, const std::string& name, Report& report) {
    constexpr auto form = "expected two numbers, the lesser first: [0, 1]";
    if (!report.expect(value, Kind::array, name, "")) return false;
    if (value.size() != 2)
        return refuse(value, name + " holds " + std::to_string(value.size()) + " values", form,
                      report);
    for (const json::Member& end : value.children())
        if (!report.expect(end.value, Kind::number, "an end of " + name, ""))
            return false;
        else if (!is_single(end.value))
            return refuse(end.value, name + " is too large for single precision", "at most 3.4e38",
                          report);
    if (value.at(0).as_number() < value.at(1).as_number()) return true;
    const bool empty = value.at(0).as_number() == value.at(1).as_number();
    return refuse(value, name + (empty ? " is empty" : " is reversed"), form, report);
}

bool read_step(const Value& value, const std::string& name, Report& report) {
    if (!report.expect(value, Kind::number, name, "")) return false;
    if (value.as_number() > 0 && is_single(value)) return true;
    return refuse(value, name + " is " + std::string(value.spelling()),
                  "expected a number greater than 0", report);
}

bool read_names(const Value& value, const std::string& name, size_t most, Report& report) {
    if (!report.expect(value, Kind::array, name, "")) return false;
    if (value.size() == 0 || value.size() > most)
        return refuse(value, name + " has " + std::to_string(value.size()) + " names",
                      "expected 1 to " + std::to_string(most), report);
    std::set<std::string_view> seen;
    for (const json::Member& choice : value.children()) {
        if (!report.expect(choice.value, Kind::string, "a name in " + name, "")) return false;
        const std::string_view word = choice.value.as_string();
        if (word.empty() || !seen.insert(word).second)
            return refuse(choice.value,
                          name + (word.empty() ? " has an empty name" : " repeats a name"),
                          "expected different names", report);
    }
    return true;
}

bool read_renamed(const Value& value, const std::string& name, Report& report) {
    if (!read_names(value, name, max_renamed, report)) return false;
    for (const json::Member& former : value.children())
        if (const std::string problem = id_problem(former.value.as_string(), false);
            !problem.empty())
            return refuse(former.value, "a name in " + name + " " + problem,
                          "expected former names of the input", report);
    return true;
}

// Stores a member's value if it has the form of its key; otherwise reports an error and returns
// false.
class KeyReader {
public:
    KeyReader(const json::Member& member, Report& report) : member_(member), report_(report) {}

    bool read(std::string& text) const {
        if (!report_.expect(member_.value, Kind::string, name(), "")) return false;
        text = member_.value.as_string();
        return true;
    }
    bool read(Value& value) const {
        if (!has_form()) return false;
        value = member_.value;
        return true;
    }

private:
    std::string name() const { return json_quoted(member_.key); }
    bool has_form() const {
        const auto& [key, value] = member_;
        if (key == "choices") return read_names(value, name(), max_choices, report_);
        if (key == "renamed") return read_renamed(value, name(), report_);
        if (key == "step") return read_step(value, name(), report_);
        return key == "default" || read_range(value, name(), report_);
    }

    const json::Member& member_;
    Report& report_;
};

}  // namespace

GraphInput read_graph_input(std::string_view name, const Value& value, Report& report) {
    GraphInput input;
    input.name = name;
    input.source = value;
    report.expect_id(value, "the input name", name, false);
    if (!report.expect(value, Kind::object, "the graph input", "")) return input;
    for (const json::Member& member : value.children()) {
        bool stored = false;
        each_key(input, [&](std::string_view key, auto& known) {
            if (key == member.key) stored = KeyReader(member, report).read(known);
        });
        if (!stored) input.unknown.push_back({std::string(member.key), member.value});
    }
    if (!value.has("type") && !value.cut_off())
        report.at(value, "", RuleId::missing_key, "the graph input has no \"type\"",
                  "expected \"type\": \"float\"");
    return input;
}

Preset read_preset(std::string_view name, const Value& value, Report& report) {
    Preset preset;
    preset.name = name;
    preset.source = value;
    report.expect_id(value, "the preset name", name, false);
    if (!report.expect(value, Kind::object, "the preset", "")) return preset;
    for (const json::Member& member : value.children())
        preset.values.push_back({std::string(member.key), member.value});
    return preset;
}

}  // namespace wrinkle::reading
