// Keys of test files and their JSON Schema.
#include "base/text.h"
#include "cli/test_case.h"
#include "cpu/columns.h"
#include "json/write.h"

namespace wrinkle::cli {
namespace {

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

std::string definitions() {
    return R"(  "$defs": {
    "changes": {"type": "object", "additionalProperties": false, "properties": {
      )" + input_properties(true) +
           R"(}},
    "point": {"type": "object", "additionalProperties": false, "properties": {
      )" + input_properties(false) +
           R"(,
      "dx": {"description": "Changes to the next pixel to the right", "$ref": "#/$defs/changes"},
      "dy": {"description": "Changes to the next pixel above", "$ref": "#/$defs/changes"}}}
  }
)";
}

std::string properties(std::span<const CaseKey> keys, const std::string& indent) {
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

}  // namespace

const std::vector<CaseKey>& render_keys() {
    static const RenderCase defaults;
    static const RenderOptions& options = defaults.options;
    static const std::vector<std::string> views(gpu::view_names().begin(), gpu::view_names().end());
    static const std::vector<CaseKey> keys = {
        {"mesh", "A shape's name, or a mesh file relative to the graph and inside the root",
         R"("type": "string")", json_quoted(options.mesh), R"("torus")"},
        {"size", "Width and height in pixels", R"("type": "string", "pattern": "^[0-9]+x[0-9]+$")",
         json_quoted(std::to_string(options.width) + "x" + std::to_string(options.height)),
         R"("256x256")"},
        {"view", "As `wrinkle render --view`", "\"enum\": " + json::string_array(views),
         json_quoted(views[static_cast<size_t>(options.view)]), R"("normal")"},
        {"against", "The output that the difference view compares with; empty: the surface",
         R"("type": "string")", json_quoted(options.against), R"("wrong")"},
        {"displace", "As `wrinkle render --displace`", R"("type": "boolean")",
         boolean(options.displace), "true"},
        {"tolerance", "Root mean square of all channels, in 8-bit steps", tolerance_schema,
         shortest(defaults.tolerance), "2"}};
    return keys;
}

const std::vector<CaseKey>& case_keys() {
    static const TestCase defaults;
    static const std::vector<CaseKey> keys = {
        {"set", "Values as `--set` takes them, for every case of the file; no sweeps",
         R"("type": "array", "items": {"type": "string"})", "[]", R"(["bump.amount=2"])"},
        {"points", "Surface points as `wrinkle eval --at` takes them; each is a case",
         R"("anyOf": [{"$ref": "#/$defs/point"},)"
         R"( {"type": "array", "items": {"$ref": "#/$defs/point"}}])",
         "[]", R"([{"normal": [0, 0, 1], "uv0": [0.5, 0.5]}])"},
        {"expect", "For each point an object with the values of some or all outputs",
         R"("type": "array", "items": {"type": "object", "minProperties": 1,)"
         R"( "additionalProperties": {"type": ["number", "array"], "items": {"type": "number"}}})",
         "", R"([{"height": 0.25}])"},
        {"tolerance_deg", "For outputs of type normal: an angle in degrees", tolerance_schema,
         shortest(defaults.tolerance_deg), "0.1"},
        {"tolerance", "For every other number: an absolute difference", tolerance_schema,
         shortest(defaults.tolerance), "0.001"},
        {"glsl", "A case: the GLSL of the function form is golden/NAME.glsl",
         R"("type": "boolean")", boolean(defaults.glsl), "true"},
        {"render", "A case: the rendered image is golden/NAME.png",
         "\"type\": \"object\", \"additionalProperties\": false, \"properties\": {\n" +
             properties(render_keys(), "      ") + "}",
         "", R"({"mesh": "torus", "size": "256x256"})"}};
    return keys;
}

std::vector<std::string> names_of(std::span<const CaseKey> keys) {
    std::vector<std::string> names;
    for (const CaseKey& key : keys)
        names.push_back(key.name);
    return names;
}

std::string case_schema() {
    return R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Wrinkle test cases",
  "type": "object",
  "additionalProperties": false,
  "properties": {
)" + properties(case_keys(), "    ") +
           "\n  },\n" + definitions() + "}\n";
}

}  // namespace wrinkle::cli
