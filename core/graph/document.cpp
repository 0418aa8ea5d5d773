#include "graph/document.h"

#include <algorithm>

#include "base/standard_outputs.h"
#include "base/text.h"

namespace wrinkle {
namespace {

std::string pointer_to(std::initializer_list<std::string_view> keys) {
    std::string pointer;
    for (const std::string_view key : keys)
        pointer += json::pointer_step(key);
    return pointer;
}

Diagnostic made(RuleId rule, Location where, std::string pointer, std::string message,
                std::string expected) {
    return {.rule = rule,
            .where = std::move(where),
            .pointer = std::move(pointer),
            .message = std::move(message),
            .expected = std::move(expected)};
}

// Returns the file without a line if the value is not part of the text as read.
Location place(const Document& document, const json::Value& value, bool key) {
    if (!value.has_location()) return {document.file, 0, 0};
    return key ? value.key_location() : value.location();
}

constexpr std::string_view subgraph_prefix = "graph:";
constexpr size_t max_id = 128;  // characters

std::string spelling_problem(std::string_view id) {
    if (id.empty()) return "is empty";
    if (!is_utf8(id)) return "is not valid UTF-8";
    size_t characters = 0;
    unsigned char before = 0;
    for (const char c : id) {
        const auto byte = static_cast<unsigned char>(c);
        const bool upper_control = before == 0xC2 && byte < 0xA0;  // U+0080 to U+009F
        if (byte < 0x20 || byte == 0x7F || upper_control) return "contains a control character";
        if (c == '.') return "contains a '.'";
        if ((byte & 0xC0) != 0x80) ++characters;
        before = byte;
    }
    if (id[0] == '$') return "begins with '$'";
    if (characters > max_id) return "is longer than 128 characters";
    return {};
}

}  // namespace

const Input* Node::find(std::string_view port) const {
    for (const Input& input : inputs)
        if (input.port == port) return &input;
    return nullptr;
}

std::string type_of_subgraph(std::string_view file) {
    return std::string(subgraph_prefix).append(file);
}

std::optional<std::string_view> subgraph_file(std::string_view type) {
    if (!type.starts_with(subgraph_prefix)) return {};
    return type.substr(subgraph_prefix.size());
}

const Node* Document::find(std::string_view id) const {
    const NodePtr* node = nodes.find(id);
    return node ? node->get() : nullptr;
}

const Output* Document::find_output(std::string_view name) const {
    const std::string_view wanted = output_name(name);
    const Output* found = std::ranges::find(
        outputs, wanted, [](const Output& output) { return output_name(output.name); });
    return found == outputs.end() ? nullptr : found;
}

Diagnostic diagnose(const Document& document, RuleId rule, std::string message,
                    std::string expected) {
    return made(rule, {document.file, 0, 0}, "", std::move(message), std::move(expected));
}

Diagnostic diagnose(const Document& document, const Node& node, RuleId rule, std::string message,
                    std::string expected) {
    Diagnostic diagnostic =
        made(rule, place(document, node.source, true), pointer_to({"nodes", node.id}),
             std::move(message), std::move(expected));
    diagnostic.node = node.id;
    return diagnostic;
}

Diagnostic diagnose_port(const Document& document, const Node& node, std::string_view port,
                         RuleId rule, std::string message, std::string expected) {
    Diagnostic diagnostic = diagnose(document, node, rule, std::move(message), std::move(expected));
    const Input* input = node.find(port);
    if (!input) return diagnostic;
    diagnostic.pointer = pointer_to({"nodes", node.id, "in", port});
    if (!input->value.has_location()) return diagnostic;
    diagnostic.where = input->value.location();
    if (!document.edited) diagnostic.pointer = input->value.pointer();  // a former name as written
    return diagnostic;
}

Diagnostic diagnose(const Document& document, const GraphInput& input, RuleId rule,
                    std::string message, std::string expected) {
    return made(rule, place(document, input.source, true), pointer_to({"inputs", input.name}),
                std::move(message), std::move(expected));
}

Diagnostic diagnose_key(const Document& document, const GraphInput& input, std::string_view key,
                        RuleId rule, std::string message, std::string expected) {
    const json::Value value = input.source.find(key);
    Diagnostic diagnostic =
        diagnose(document, input, rule, std::move(message), std::move(expected));
    if (!value.has_location()) return diagnostic;
    diagnostic.where = value.location();
    diagnostic.pointer += json::pointer_step(key);
    return diagnostic;
}

Diagnostic diagnose(const Document& document, const Output& output, RuleId rule,
                    std::string message, std::string expected) {
    return made(rule, place(document, output.from.value, false),
                pointer_to({"outputs", output.name}), std::move(message), std::move(expected));
}

Diagnostic diagnose(const json::Value& value, std::string node, RuleId rule, std::string message,
                    std::string expected) {
    Diagnostic diagnostic =
        made(rule, value.location(), value.pointer(), std::move(message), std::move(expected));
    diagnostic.node = std::move(node);
    return diagnostic;
}

std::vector<Extra> present_keys(const GraphInput& input) {
    std::vector<Extra> keys;
    each_key(input, [&]<class T>(std::string_view key, const T& value) {
        if constexpr (std::is_same_v<T, std::string>) {
            if (!value.empty()) keys.push_back({std::string(key), json::Value::string(value)});
        } else if (!value.is(json::Kind::null)) {
            keys.push_back({std::string(key), value});
        }
    });
    return keys;
}

std::optional<Range> range_of(const json::Value& pair) {
    if (!pair.is(json::Kind::array)) return {};
    return Range{pair.at(0).as_number(), pair.at(1).as_number()};
}

std::string id_problem(std::string_view id, bool reserved) {
    if (reserved && (id == Link::surface || id == Link::input)) return "is a reserved word";
    return spelling_problem(id);
}

}  // namespace wrinkle
