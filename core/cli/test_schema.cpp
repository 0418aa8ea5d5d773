// Keys of test files: one table for the JSON Schema and the reader.
#include <algorithm>
#include <set>

#include "base/mapped.h"
#include "base/text.h"
#include "cli/meshes.h"
#include "cli/output.h"
#include "cli/session.h"
#include "cli/test_budget.h"
#include "cli/test_case.h"
#include "cpu/columns.h"
#include "json/write.h"
#include "registry/port_type.h"

namespace wrinkle::cli {
namespace {

using json::Kind;
using json::Member;
using json::Value;

struct CaseReader;

// Values are JSON text. `schema` holds the members of the JSON Schema of the value.
struct CaseKey {
    std::string name, doc, schema, fallback, example;  // fallback "": no default
    void (*read)(CaseReader& reader, const Member& member);
};

std::string numbers(size_t count) {
    if (count == 1) return R"({"type": "number"})";
    const std::string size = std::to_string(count);
    return R"({"type": "array", "items": {"type": "number"}, "minItems": )" + size +
           ", \"maxItems\": " + size + "}";
}

// Schema properties of the surface inputs, or of their differentials if `changes` is set; `facing`
// has no differentials.
std::string input_properties(bool changes) {
    std::string text;
    for (const std::string& name : surface_input_names()) {
        const auto input = find_input(name);
        if (!input || (changes && input->input == SurfaceInput::facing_)) continue;
        text += (text.empty() ? "" : ",\n      ") + json_quoted(name) + ": " +
                numbers(lanes_of(*input));
    }
    return text;
}

std::string properties(const std::vector<CaseKey>& keys, const std::string& indent) {
    std::string text;
    for (const CaseKey& key : keys) {
        text += (text.empty() ? "" : ",\n") + indent + json_quoted(key.name) +
                ": {\"description\": " + json_quoted(key.doc) + ", " + key.schema;
        if (!key.fallback.empty()) text += ", \"default\": " + key.fallback;
        text += ", \"examples\": [" + key.example + "]}";
    }
    return text;
}

const char* boolean(bool value) {
    return value ? "true" : "false";
}

constexpr const char* tolerance_schema = R"("type": "number", "minimum": 0)";

struct CaseReader {
    TestCase& test;
    Diagnostics& diagnostics;
    json::Value cases;  // value of the key "cases"

    RenderOptions& options() { return test.render->options; }

    void take(const Member& member, std::string& text) {
        if (wants(member.value, Kind::string, member.key)) text = member.value.as_string();
    }
    void take(const Member& member, bool& truth) {
        if (wants(member.value, Kind::boolean, member.key)) truth = member.value.as_boolean();
    }
    template <class Number>
    void take_limit(const Member& member, Number& limit) {
        if (!wants(member.value, Kind::number, member.key)) return;
        limit = member.value.as_number();
        if (member.value.as_number() < 0)
            error(member.value, std::string(member.key) + " is negative", "0 or more");
    }

    void take_metric(const Value& value) {
        if (!wants(value, Kind::string, "metric")) return;
        test.render->metric = value.as_string();
        if (!std::ranges::count(image_metrics, test.render->metric))
            error(value, "metric: there is no '" + test.render->metric + "'",
                  joined(image_metrics, ", "));
    }

    void take_set(const Value& value) {
        if (!wants(value, Kind::array, "set")) return;
        for (const Member& member : value.children())
            if (wants(member.value, Kind::string, "a value of 'set'"))
                test.set.emplace_back(member.value.as_string());
    }

    void take_name(const Member& member) {
        take(member, test.entry);
        if (member.value.is(Kind::string) && !is_name(test.entry))
            error(member.value, "the name " + json_quoted(test.entry) + " cannot be part of a file",
                  "lower-case letters, digits and '_'");
    }

    void take_cases(const Value& value) {
        if (!wants(value, Kind::array, "cases")) return;
        cases = value;
    }

    void take_expect(const Value& value) {
        if (!wants(value, Kind::array, "expect")) return;
        test.expect = value;
        for (const Member& member : value.children())
            wants(member.value, Kind::object, "an entry of 'expect'");
    }

    void take_render(const Value& value);
    void take_budget(const Value& value);
    void take_mesh(const Member& member) {
        take(member, options().mesh);
        test.render->mesh = member.value;
        if (!check_mesh(options().mesh).empty())
            error(member.value, "mesh: there is no '" + options().mesh + "'", mesh_help());
    }

    void take_view(const Value& value) {
        if (!wants(value, Kind::string, "view")) return;
        const auto view = gpu::view_named(value.as_string());
        if (view)
            options().view = *view;
        else
            error(value, "view: there is no '" + std::string(value.as_string()) + "'",
                  joined(gpu::view_names(), ", "));
    }

    void take_size(const Value& value) {
        if (!value.is(Kind::string) ||
            !parse_size(value.as_string(), max_rendered_side, options().width, options().height))
            error(value, "size does not fit", "a text such as \"512\" or \"640x480\"");
    }

    void read_keys(const Value& value, const char* what, const std::vector<CaseKey>& keys) {
        if (!wants(value, Kind::object, what)) return;
        const auto names = mapped<std::string>(keys, &CaseKey::name);
        for (const Member& member : value.children()) {
            const auto key = std::ranges::find(keys, member.key, &CaseKey::name);
            if (key != keys.end())
                key->read(*this, member);
            else
                error(member.value, "unknown key '" + std::string(member.key) + "'",
                      did_you_mean(member.key, names, joined(names, ", ")));
        }
    }

    bool wants(const Value& value, Kind kind, std::string_view what) {
        if (value.is(kind)) return true;
        error(value, std::string(what) + " is " + json::kind_name(value.kind()),
              json::kind_name(kind));
        return false;
    }

    void error(const Value& value, std::string message, std::string expected) {
        report_at(value, RuleId::test_case, std::move(message), std::move(expected), diagnostics);
    }
};

const std::vector<CaseKey>& render_keys() {
    static const RenderCase defaults;
    static const RenderOptions& options = defaults.options;
    static const std::vector<std::string> views(gpu::view_names().begin(), gpu::view_names().end());
    static const std::vector<CaseKey> keys = {
        {"mesh", "A shape's name, or a mesh file relative to the graph and inside the root",
         R"("type": "string")", json_quoted(options.mesh), R"("torus")",
         [](auto& reader, auto& member) { reader.take_mesh(member); }},
        {"size", "Width and height in pixels: N or WxH",
         R"("type": "string", "pattern": "^[0-9]+(x[0-9]+)?$")",
         json_quoted(std::to_string(options.width) + "x" + std::to_string(options.height)),
         R"("256x256")", [](auto& reader, auto& member) { reader.take_size(member.value); }},
        {"view", "As `wrinkle render --view`", "\"enum\": " + json::string_array(views),
         json_quoted(views[static_cast<size_t>(options.view)]), R"("normal")",
         [](auto& reader, auto& member) { reader.take_view(member.value); }},
        {"against", "The output that the difference view compares with; empty: the surface",
         R"("type": "string")", json_quoted(options.against), R"("wrong")",
         [](auto& reader, auto& member) { reader.take(member, reader.options().against); }},
        {"displace", "As `wrinkle render --displace`", R"("type": "boolean")",
         boolean(options.displace), "true",
         [](auto& reader, auto& member) { reader.take(member, reader.options().displace); }},
        {"metric", "Measure of the difference, as `wrinkle compare --metric`",
         "\"enum\": " + json::string_array(image_metrics), json_quoted(defaults.metric),
         R"("flip")", [](auto& reader, auto& member) { reader.take_metric(member.value); }},
        {"tolerance",
         "Limit of the mean; of rms, of the root mean square. Default: rms 1, flip 0.01, "
         "degrees 0.2",
         tolerance_schema, "", "2",
         [](auto& reader, auto& member) {
             reader.take_limit(member, reader.test.render->tolerance);
         }},
        {"max_pixel", "Limit of every pixel", tolerance_schema, "", "0.3",
         [](auto& reader, auto& member) {
             reader.take_limit(member, reader.test.render->max_pixel);
         }},
        {"over", "Pixels above this value are counted", tolerance_schema, shortest(defaults.over),
         "0.1",
         [](auto& reader, auto& member) { reader.take_limit(member, reader.test.render->over); }},
        {"max_over", "Limit of that count", tolerance_schema, "", "20",
         [](auto& reader, auto& member) {
             reader.take_limit(member, reader.test.render->max_over);
         }}};
    return keys;
}

std::string budget_properties(const std::string& indent) {
    return joined(budget_names(), ",\n", [&](const std::string& name) {
        return indent + json_quoted(name) + ": {\"type\": \"number\", \"minimum\": 0}";
    });
}

// Keys of a file and of the entries of "cases".
const std::vector<CaseKey>& case_keys() {
    static const TestCase defaults;
    static const std::vector<CaseKey> keys = {
        {"preset", "As `--preset`: a preset of the graph, or a file relative to this one",
         R"("type": "string")", json_quoted(defaults.preset), R"("Old")",
         [](auto& reader, auto& member) { reader.take(member, reader.test.preset); }},
        {"set", "Values as `--set` takes them, after those of `preset`; no sweeps",
         R"("type": "array", "items": {"type": "string"})", "[]", R"(["bump.amount=2"])",
         [](auto& reader, auto& member) { reader.take_set(member.value); }},
        {"points", "Surface points as `wrinkle eval --at` takes them; each is a case",
         R"("anyOf": [{"$ref": "#/$defs/point"},)"
         R"( {"type": "array", "items": {"$ref": "#/$defs/point"}}])",
         "[]", R"([{"normal": [0, 0, 1], "uv0": [0.5, 0.5]}])",
         [](auto& reader, auto& member) {
             reader.test.points = read_points(member.value, reader.diagnostics);
         }},
        {"expect", "For each point an object with the values of some or all outputs",
         R"("type": "array", "items": {"type": "object", "minProperties": 1,)"
         R"( "additionalProperties": {"type": ["number", "array"], "items": {"type": "number"}}})",
         "", R"([{"height": 0.25}])",
         [](auto& reader, auto& member) { reader.take_expect(member.value); }},
        {"tolerance_deg", "For outputs of type normal: an angle in degrees", tolerance_schema,
         shortest(defaults.tolerance_deg), "0.1",
         [](auto& reader, auto& member) { reader.take_limit(member, reader.test.tolerance_deg); }},
        {"tolerance", "For every other number: an absolute difference", tolerance_schema,
         shortest(defaults.tolerance), "0.001",
         [](auto& reader, auto& member) { reader.take_limit(member, reader.test.tolerance); }},
        {"glsl", "A case: the GLSL of the function form is golden/NAME.glsl",
         R"("type": "boolean")", boolean(defaults.glsl), "true",
         [](auto& reader, auto& member) { reader.take(member, reader.test.glsl); }},
        {"render", "A case: the rendered image is golden/NAME.png",
         "\"type\": \"object\", \"additionalProperties\": false, \"properties\": {\n" +
             properties(render_keys(), "      ") + "}",
         "", R"({"mesh": "torus", "size": "256x256"})",
         [](auto& reader, auto& member) { reader.take_render(member.value); }},
        {"budget", "A case: limits of the cost, as `wrinkle compile --cost` counts it",
         "\"type\": \"object\", \"additionalProperties\": false, \"properties\": {\n" +
             budget_properties("      ") + "}",
         "", R"({"alu": 120, "texture_reads": 4})",
         [](auto& reader, auto& member) { reader.take_budget(member.value); }}};
    return keys;
}

const std::vector<CaseKey>& entry_keys() {
    static const std::vector<CaseKey> keys = [] {
        std::vector<CaseKey> all = case_keys();
        all.insert(all.begin(),
                   {"name", "Part of the names of golden files: NAME.ENTRY.glsl",
                    R"("type": "string", "pattern": "^[a-z][a-z0-9_]*$")", "", R"("old")",
                    [](auto& reader, auto& member) { reader.take_name(member); }});
        return all;
    }();
    return keys;
}

const std::vector<CaseKey>& file_keys() {
    static const std::vector<CaseKey> keys = [] {
        std::vector<CaseKey> all = case_keys();
        all.push_back({"cases", "Further cases, with other values of the graph's inputs",
                       R"("type": "array", "items": {"$ref": "#/$defs/case"})", "[]",
                       R"([{"name": "old", "preset": "Old", "glsl": true}])",
                       [](auto& reader, auto& member) { reader.take_cases(member.value); }});
        return all;
    }();
    return keys;
}

std::string definitions() {
    return R"(  "$defs": {
    "changes": {"type": "object", "additionalProperties": false, "properties": {
      )" + input_properties(true) +
           R"(}},
    "point": {"type": "object", "additionalProperties": false, "properties": {
      )" + input_properties(false) +
           R"(,
      "dx": {"description": "Changes to the next pixel to the right", "$ref": "#/$defs/changes"},
      "dy": {"description": "Changes to the next pixel above", "$ref": "#/$defs/changes"}}},
    "case": {"type": "object", "additionalProperties": false, "required": ["name"], "properties": {
)" + properties(entry_keys(), "      ") +
           R"(}}
  }
)";
}

void CaseReader::take_render(const Value& value) {
    if (value.is(Kind::object)) test.render.emplace().value = value;
    read_keys(value, "render", render_keys());
}

void CaseReader::take_budget(const Value& value) {
    if (!wants(value, Kind::object, "budget")) return;
    const auto names = budget_names();
    test.budget_value = value;
    for (const Member& member : value.children()) {
        test.budget.push_back({std::string(member.key)});
        BudgetLimit& budget = test.budget.back();
        take_limit(member, budget.limit);
        if (!std::ranges::count(names, budget.name))
            error(member.value, "budget: there is no '" + budget.name + "'",
                  did_you_mean(budget.name, names, joined(names, ", ")));
    }
}

bool has_case(const TestCase& test) {
    return test.points.count() > 0 || test.glsl || test.render || !test.budget.empty();
}

// Reports the object of a test without a case, and more entries of 'expect' than points.
void check_case(CaseReader& reader) {
    const TestCase& test = reader.test;
    const Value& object = test.object;
    if (!has_case(test))
        reader.error(
            object,
            "there is no case in this " + std::string(test.entry.empty() ? "file" : "entry"),
            "points, \"glsl\": true, render or budget");
    const size_t points = test.points.count(), expected = test.expect.size();
    if (expected > points)
        reader.error(test.expect,
                     std::to_string(points) + " points, but " + std::to_string(expected) +
                         " entries in 'expect'",
                     "at most one for each point");
}

}  // namespace

std::string case_schema() {
    return R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Wrinkle test cases",
  "type": "object",
  "additionalProperties": false,
  "properties": {
)" + properties(file_keys(), "    ") +
           "\n  },\n" + definitions() + "}\n";
}

double default_tolerance(std::string_view metric) {
    return metric == "flip" ? 0.01 : metric == "degrees" ? 0.2 : 1;
}

std::vector<TestCase> read_case_keys(const Value& root, TestCase file_case,
                                     Diagnostics& diagnostics) {
    std::vector<TestCase> tests;
    std::set<std::string> names;
    CaseReader file{file_case, diagnostics, {}};
    file.read_keys(root, "a test file", file_keys());
    if (!root.is(Kind::object)) return {};
    file_case.object = root;
    TestCase settings = file_case;
    settings.points = {};
    settings.expect = {};
    settings.glsl = false;
    settings.render.reset();
    settings.budget.clear();
    const bool has_entries = file.cases.size() > 0;
    if (has_case(file_case) || !has_entries) check_case(file);
    if (has_case(file_case)) tests.push_back(file_case);
    for (const Member& member : file.cases.children()) {
        TestCase& test = tests.emplace_back(settings);
        CaseReader reader{test, diagnostics, {}};
        reader.read_keys(member.value, "an entry of 'cases'", entry_keys());
        if (!member.value.is(Kind::object)) continue;
        test.object = member.value;
        test.name += "." + test.entry;
        if (!member.value.has("name"))
            reader.error(member.value, "an entry of 'cases' has no name", "\"name\": \"old\"");
        else if (!names.insert(test.entry).second)
            reader.error(member.value, "two entries of 'cases' have the name '" + test.entry + "'",
                         "different names");
        check_case(reader);
    }
    return tests;
}

}  // namespace wrinkle::cli
