#include "base/text.h"
#include "graph/reader.h"

namespace wrinkle::reading {
namespace {

using json::Kind;
using json::Value;

constexpr const char* link_form = "expected \"NODE.OUTPUT\", \"surface.NAME\" or \"input.NAME\"";

bool parse_link(std::string_view text, Link& link) {
    const size_t dot = text.find('.');
    if (dot == text.npos || dot == 0 || dot + 1 == text.size()) return false;
    if (text.find('.', dot + 1) != text.npos) return false;
    link.node = text.substr(0, dot);
    link.port = text.substr(dot + 1);
    return true;
}

void read_inputs(const Value& in, Node& node, Report& report) {
    node.inputs.reserve(in.size());
    for (const json::Member& member : in.children())
        read_input(member.key, member.value, node.id, report, node.inputs.emplace_back());
}

bool read_version(const Value& value, Node& node, Report& report) {
    constexpr double most = 1'000'000;
    if (!report.expect(value, Kind::number, "\"version\"", node.id)) return false;
    const double number = value.as_number();
    if (number >= 1 && number <= most && number == std::floor(number)) {
        node.version = static_cast<int>(number);
        return true;
    }
    report.at(value, node.id, RuleId::invalid_value,
              "\"version\" is " + std::string(value.spelling()), "expected an integer from 1 on");
    return false;
}

// Returns true if the member is known and valid; otherwise the caller stores it as unknown.
bool read_member(const json::Member& member, Node& node, Report& report) {
    const Value& value = member.value;
    if (member.key == "type") {
        if (!report.expect(value, Kind::string, "\"type\"", node.id)) return false;
        node.type = value.as_string();
        if (!node.type.empty()) return true;
        report.at(value, node.id, RuleId::invalid_value, "\"type\" is empty",
                  "expected the name of a node type");
        return false;
    }
    if (member.key == "version") return read_version(value, node, report);
    if (member.key == "muted") {
        if (!report.expect(value, Kind::boolean, "\"muted\"", node.id)) return false;
        node.muted = value.as_boolean();
        return true;
    }
    if (member.key == "in") {
        if (!report.expect(value, Kind::object, "\"in\"", node.id)) return false;
        read_inputs(value, node, report);
        return true;
    }
    return false;
}

}  // namespace

void Report::at(const Value& value, std::string node, RuleId rule, std::string message,
                std::string expected) {
    if (list_.dropped() > 0) return list_.add({});
    list_.add(diagnose(value, std::move(node), rule, std::move(message), std::move(expected)));
}

void Report::at_key(const Value& value, std::string node, RuleId rule, std::string message,
                    std::string expected) {
    if (list_.dropped() > 0) return list_.add({});
    Diagnostic diagnostic =
        diagnose(value, std::move(node), rule, std::move(message), std::move(expected));
    diagnostic.where = value.key_location();
    list_.add(std::move(diagnostic));
}

bool Report::expect(const Value& value, Kind kind, std::string_view name, std::string_view node) {
    if (value.is(kind)) return true;
    at(value, std::string(node), RuleId::wrong_kind,
       std::string(name) + " is " + json::kind_name(value.kind()),
       std::string("expected ") + json::kind_name(kind));
    return false;
}

bool Report::expect_id(const Value& value, std::string_view what, std::string_view id,
                       bool reserved) {
    const std::string problem = id_problem(id, reserved);
    if (problem.empty()) return true;
    at_key(value, "", RuleId::invalid_name,
           std::string(what) + " " + json_quoted(id) + " " + problem,
           "expected 1 to 128 characters without '.', not beginning with '$'");
    return false;
}

void read_input(std::string_view port, const Value& value, std::string_view node, Report& report,
                Input& input) {
    input.port = port;
    input.value = value;
    const Value from = value.find("from");
    if (!from.tree()) return;
    input.kind = Input::Kind::broken;
    if (!report.expect(from, Kind::string, "\"from\"", node)) return;
    if (parse_link(from.as_string(), input.link))
        input.kind = Input::Kind::link;
    else
        report.at(from, std::string(node), RuleId::invalid_link,
                  json_quoted(from.as_string()) + " is not a link", link_form);
}

NodePtr read_node(std::string_view id, const Value& value, Report& report) {
    auto result = std::make_shared<Node>();
    Node& node = *result;
    node.id = id;
    node.source = value;
    report.expect_id(value, "the id", id, true);
    if (!report.expect(value, Kind::object, "the node", id)) return result;
    for (const json::Member& member : value.children())
        if (!read_member(member, node, report))
            node.unknown.push_back({std::string(member.key), member.value});
    if (node.type.empty() && !value.has("type") && !value.cut_off())
        report.at(value, node.id, RuleId::missing_key, "the node has no \"type\"",
                  "expected \"type\": \"NAME\"");
    return result;
}

Output read_output(std::string_view name, const Value& value, Report& report) {
    report.expect_id(value, "the output name", name, false);
    Output output;
    output.name = name;
    read_input(name, value, "", report, output.from);
    if (output.from.kind != Input::Kind::literal) return output;
    output.from.kind = Input::Kind::broken;
    if (!value.cut_off())
        report.at(value, "", RuleId::invalid_link, "output " + json_quoted(name) + " is not a link",
                  "expected { \"from\": \"NODE.OUTPUT\" }");
    return output;
}

}  // namespace wrinkle::reading
