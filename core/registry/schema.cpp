// JSON Schema of graph files, generated from the node types.
#include <cmath>

#include "base/back_faces.h"
#include "base/text.h"
#include "json/write.h"
#include "registry/port_type.h"
#include "registry/reference.h"

namespace wrinkle {
namespace {

std::string literal_schema(const Port& port) {
    if (port.kind == Port::Kind::flag) return "{\"type\": \"boolean\"}";
    if (port.kind == Port::Kind::choice)
        return "{\"enum\": " + json::string_array(port.choices) + "}";
    if (port.kind == Port::Kind::count) {
        std::string text = "{\"type\": \"integer\"";
        const auto bound = [&](const char* word, double value) {
            if (std::isfinite(value)) text += word + shortest(value);
        };
        if (port.has_hard_range()) bound(", \"minimum\": ", port.hard_min);
        if (port.has_hard_range()) bound(", \"maximum\": ", port.hard_max);
        return text + "}";
    }
    if (port.type == PortType::image_) return "{\"$ref\": \"#/$defs/image\"}";
    const int lanes = lanes_of(port.type);
    if (lanes == 0) return "false";
    if (lanes == 1) return "{\"type\": \"number\"}";
    if (port.type == PortType::color_) return "{\"$ref\": \"#/$defs/color\"}";
    return "{\"$ref\": \"#/$defs/numbers" + std::to_string(lanes) + "\"}";
}

std::string port_schema(const Port& port) {
    std::string doc = port.doc;
    if (const std::string details = details_text(port); !details.empty())
        doc += " (" + details + ")";
    std::string text = "{\"description\": " + json_quoted(doc);
    const std::string value = default_json(port);
    if (!value.empty()) text += ", \"default\": " + value;
    const std::string literal = literal_schema(port);
    text += std::string(", \"anyOf\": [{\"$ref\": \"#/$defs/") +
            (port.is_option() ? "input_wire" : "wire") + "\"}";
    return text + (literal == "false" ? "" : ", " + literal) + "]}";
}

// Applies only to nodes of this type.
std::string node_schema(const NodeType& type) {
    std::string text =
        "      {\"if\": {\"properties\": {\"type\": {\"const\": " + json_quoted(type.id) +
        "}}, \"required\": [\"type\"]},\n       \"then\": {\"description\": " +
        json_quoted(type.title + ": " + type.doc) + ", \"properties\": {\"in\": {\"properties\": {";
    const char* separator = "\n         ";
    for (const Port& port : type.ports) {
        if (port.kind == Port::Kind::output) continue;
        text += separator + json_quoted(port.name) + ": " + port_schema(port);
        separator = ",\n         ";
    }
    return text + "}}}}}";
}

std::string type_names(const Registry& registry) {
    std::string text = "{\"anyOf\": [{\"enum\": [";
    for (const NodeType& type : registry.list())
        text += json_quoted(type.id) + ", ";
    return text + json_quoted(reroute_type) + "]}, {\"type\": \"string\"}]}";
}

std::string numbers(int lanes) {
    const std::string count = std::to_string(lanes);
    return "    \"numbers" + count +
           "\": {\"type\": \"array\", \"items\": {\"type\": \"number\"}, " +
           "\"minItems\": " + count + ", \"maxItems\": " + count + "},\n";
}

std::string graph_input_schema() {
    std::vector<std::string_view> types(port_type_names().begin(), port_type_names().end());
    types.insert(types.end(), option_type_names.begin(), option_type_names.end());
    const std::string range =
        R"({"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2})";
    std::string text =
        R"({"type": "object", "required": ["type"], "properties": {"type": {"enum": )" +
        json::string_array(types) + "}";
    for (const char* key : {"unit", "label", "group", "widget", "when", "doc"})
        text += ", " + json_quoted(key) + R"(: {"type": "string"})";
    text += R"(, "slider": )" + range + R"(, "limits": )" + range;
    text += R"(, "step": {"type": "number", "exclusiveMinimum": 0})";
    text += R"(, "choices": {"type": "array", "items": {"type": "string", "minLength": 1},)"
            R"( "minItems": 1, "maxItems": 256, "uniqueItems": true})";
    text +=
        R"(, "renamed": {"type": "array", "items": {"type": "string", "pattern": "^[^.$][^.]*$",)"
        R"( "maxLength": 128}, "minItems": 1, "maxItems": 32, "uniqueItems": true})";
    return text + "}}";
}

std::string definitions(const Registry& registry) {
    std::string text = "  \"$defs\": {\n";
    for (const int lanes : {2, 3, 4})
        text += numbers(lanes);
    text += R"(    "color": {"anyOf": [{"$ref": "#/$defs/numbers3"},)"
            R"( {"type": "string", "pattern": "^#[0-9A-Fa-f]{6}$"}]},)"
            "\n";
    text +=
        "    \"wire\": {\"type\": \"object\", \"required\": [\"from\"], \"properties\": "
        "{\"from\": {\"type\": \"string\", \"pattern\": \"^[^.]+\\\\.[^.]+$\"}}},\n";
    text +=
        "    \"input_wire\": {\"type\": \"object\", \"required\": [\"from\"], \"properties\": "
        "{\"from\": {\"type\": \"string\", \"pattern\": \"^input\\\\.[^.]+$\"}}},\n";
    text +=
        "    \"image\": {\"anyOf\": [{\"type\": \"string\", \"minLength\": 1}, {\"type\": "
        "\"object\", \"required\": [\"file\"], \"properties\": {\"file\": {\"type\": "
        "\"string\"}, \"encoding\": {\"enum\": " +
        json::string_array(encoding_names) +
        "}, \"wrap\": {\"enum\": " + json::string_array(wrap_names) +
        "}, \"filter\": {\"enum\": " + json::string_array(filter_names) + "}}}]},\n";
    text +=
        "    \"node\": {\"type\": \"object\", \"required\": [\"type\"],\n"
        "     \"properties\": {\"type\": " +
        type_names(registry) +
        ", \"version\": {\"type\": \"integer\", \"minimum\": 1}, \"muted\": {\"type\": "
        "\"boolean\"}, \"in\": {\"type\": \"object\"}},\n     \"allOf\": [\n";
    text += joined(registry.list(), ",\n", node_schema);
    if (registry.list().empty()) text += "true";
    return text + "\n     ]}\n  }\n";
}

}  // namespace

std::string graph_schema(const Registry& registry) {
    std::string text =
        "{\n  \"$schema\": \"https://json-schema.org/draft/2020-12/schema\",\n"
        "  \"title\": \"Wrinkle graph\",\n  \"type\": \"object\",\n"
        "  \"required\": [\"wrinkle\"],\n  \"properties\": {\n"
        "    \"wrinkle\": {\"const\": 1},\n"
        "    \"name\": {\"type\": \"string\"},\n"
        "    \"back_faces\": {\"enum\": " +
        json::string_array(back_faces_names) +
        "},\n"
        "    \"inputs\": {\"type\": \"object\", \"additionalProperties\": " +
        graph_input_schema() +
        "},\n"
        "    \"presets\": {\"type\": \"object\", \"additionalProperties\": {\"type\": "
        "\"object\"}},\n"
        "    \"nodes\": {\"type\": \"object\", \"additionalProperties\": "
        "{\"$ref\": \"#/$defs/node\"}},\n"
        "    \"outputs\": {\"type\": \"object\", \"properties\": {";
    text += joined(standard_outputs(), ", ", [](std::string_view name) {
        return json_quoted(name) + ": {\"$ref\": \"#/$defs/wire\"}";
    });
    text +=
        "}, \"additionalProperties\": {\"$ref\": "
        "\"#/$defs/wire\"}},\n"
        "    \"layout\": {\"type\": \"object\"}\n  },\n";
    return text + definitions(registry) + "}\n";
}

}  // namespace wrinkle
