#include "graph/read.h"

#include <algorithm>
#include <span>

#include "base/text.h"
#include "graph/order.h"
#include "graph/reader.h"
#include "graph/renamed.h"
#include "json/parse.h"

namespace wrinkle {
namespace {

using json::Kind;
using json::Value;
using reading::Report;

class Reader {
public:
    Reader(Report& report, ReadLimits limits) : report_(report), limits_(limits) {}

    void read(const Value& root, Document& document) {
        if (!report_.expect(root, Kind::object, "the graph", "")) {
            lost_ = "it is not a JSON object";
            return;
        }
        for (const json::Member& member : root.children())
            if (!read_member(member, document))
                document.unknown.push_back({std::string(member.key), member.value});
        document.presets = with_current_presets(document);
        if (!root.has("wrinkle") && !root.cut_off())
            report_.at(root, "", RuleId::missing_key, "the file does not say that it is a graph",
                       "expected \"wrinkle\": 1");
    }

    const std::string& lost() const { return lost_; }

private:
    // Returns true if the member is known and valid; otherwise the caller stores it as unknown.
    bool read_member(const json::Member& member, Document& document) {
        const Value& value = member.value;
        if (member.key == "wrinkle") return read_format(value);
        if (member.key == "name") {
            if (!report_.expect(value, Kind::string, "\"name\"", "")) return false;
            document.name = value.as_string();
            return true;
        }
        if (member.key == "back_faces") return read_back_faces(value, document);
        return read_section(member, document);
    }

    bool read_section(const json::Member& member, Document& document) {
        const Value& value = member.value;
        const bool section = member.key == "inputs" || member.key == "presets" ||
                             member.key == "nodes" || member.key == "outputs" ||
                             member.key == "layout";
        if (!section) return false;
        if (!value.is(Kind::object))
            return report_.expect(value, Kind::object, json_quoted(member.key), "");
        constexpr auto ports = "inputs or outputs";
        if (member.key == "inputs")
            document.inputs =
                read_table<GraphInput>(value, limits_.ports, 0, ports, reading::read_graph_input);
        if (member.key == "presets")
            document.presets =
                read_table<Preset>(value, limits_.presets, 0, "presets", reading::read_preset);
        if (member.key == "outputs")
            document.outputs =
                read_table<Output>(value, limits_.ports, 0, ports, reading::read_output);
        if (member.key == "nodes")
            document.nodes = read_table<NodePtr>(value, limits_.nodes, limits_.nodes_before,
                                                 "nodes", reading::read_node);
        if (member.key == "layout") reading::read_layout(value, document, report_);
        return true;
    }

    static Table<Preset> with_current_presets(const Document& document) {
        const FormerNames names(document.inputs);
        if (names.empty()) return document.presets;
        std::vector<Preset> presets;
        for (const Preset& preset : document.presets)
            presets.push_back(with_current_names(preset, names));
        return document.presets.with_same_keys(std::move(presets));
    }

    bool read_format(const Value& value) {
        if (!report_.expect(value, Kind::number, "\"wrinkle\"", "")) return false;
        if (value.as_number() == 1) return true;
        report_.at(value, "", RuleId::format_version,
                   "the format version is " + std::string(value.spelling()),
                   "this program reads version 1");
        return false;
    }

    bool read_back_faces(const Value& value, Document& document) {
        if (!report_.expect(value, Kind::string, "\"back_faces\"", "")) return false;
        document.back_faces = enumerator_named<BackFaces>(back_faces_names, value.as_string());
        if (document.back_faces) return true;
        report_.at(value, "", RuleId::invalid_value,
                   "\"back_faces\" is " + json_quoted(value.as_string()),
                   "expected \"mirror\", \"flip\" or \"none\"");
        return false;
    }

    // Reads a table of entries that `what` names; at most `limit`, those `before` included.
    template <class T, class Read>
    Table<T> read_table(const Value& value, size_t limit, size_t before, const std::string& what,
                        Read read) {
        std::vector<T> items;
        items.reserve(std::min(value.size(), limit));
        for (const json::Member& member : value.children()) {
            if (items.size() + before >= limit) {
                report_.at_key(member.value, "", RuleId::over_limit,
                               "the graph has more " + what + " than are allowed",
                               "the limit is " + std::to_string(limit));
                lost_ = "it has more " + what + " than are allowed";
                break;
            }
            items.push_back(read(member.key, member.value, report_));
        }
        return Table<T>(std::move(items));
    }

    Report& report_;
    ReadLimits limits_;
    std::string lost_;  // Document::lost
};

void add_in_order(const Diagnostics& found, Diagnostics& diagnostics) {
    std::vector<Diagnostic> list = found.list();
    std::ranges::stable_sort(list, [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
    });
    Diagnostics sorted(found.list().size());
    for (Diagnostic& diagnostic : list)
        sorted.add(std::move(diagnostic));
    for (size_t i = 0; i < found.dropped(); ++i)
        sorted.add({});
    diagnostics.append(sorted);
}

constexpr std::string_view top_keys[] = {"wrinkle", "name",    "back_faces", "inputs", "presets",
                                         "nodes",   "outputs", "layout",     "$schema"};
constexpr std::string_view node_keys[] = {"type", "version", "muted", "in"};
const std::vector<std::string_view>& graph_input_keys() {
    static const std::vector<std::string_view> keys = [] {
        std::vector<std::string_view> names;
        const GraphInput any;
        each_key(any, [&](std::string_view key, const auto&) { names.push_back(key); });
        return names;
    }();
    return keys;
}

void report_keys(const std::vector<Extra>& extras, std::span<const std::string_view> known,
                 const std::string& node, Report& report) {
    if (extras.empty()) return;
    const std::vector<std::string> names(known.begin(), known.end());
    for (const Extra& extra : extras) {
        if (std::ranges::find(known, extra.key) != known.end()) continue;
        const std::string name = nearest(extra.key, names);
        report.at_key(extra.value, node, RuleId::unknown_key,
                      "unknown key " + json_quoted(extra.key),
                      name.empty() ? "" : "did you mean \"" + name + "\"?");
    }
}

void report_link_keys(const Input& input, const std::string& node, Report& report) {
    if (input.kind != Input::Kind::link || input.value.size() == 1) return;
    for (const json::Member& member : input.value.children())
        if (member.key != "from")
            report.at_key(member.value, node, RuleId::unknown_key,
                          "unknown key " + json_quoted(member.key) + " beside \"from\"",
                          "a link has no other key");
}

}  // namespace

Document read_document(std::string bytes, std::string file, Diagnostics& diagnostics,
                       ReadLimits limits) {
    Document document;
    document.file = file;
    Report report;
    const json::Parsed parsed = json::parse(std::move(bytes), std::move(file), report.list());
    document.source = parsed.root;
    if (report.list().has_errors()) document.lost = to_text(report.list().list().front());
    Reader reader(report, limits);
    if (parsed.complete || parsed.root.is(Kind::object)) reader.read(parsed.root, document);
    if (document.lost.empty()) document.lost = reader.lost();
    if (parsed.complete && reader.lost().empty()) {
        const size_t before = report.list().error_count();
        auto wires = std::make_shared<const Wires>(check_links(document, report.list()));
        if (report.list().error_count() == before) document.read_wires = std::move(wires);
    }
    add_in_order(report.list(), diagnostics);
    return document;
}

void report_unknown(const Document& document, Diagnostics& diagnostics) {
    Report report;
    report_keys(document.unknown, top_keys, "", report);
    for (const NodePtr& node : document.nodes) {
        report_keys(node->unknown, node_keys, node->id, report);
        for (const Input& input : node->inputs)
            report_link_keys(input, node->id, report);
    }
    for (const GraphInput& input : document.inputs)
        report_keys(input.unknown, graph_input_keys(), "", report);
    for (const Output& output : document.outputs)
        report_link_keys(output.from, "", report);
    add_in_order(report.list(), diagnostics);
}

}  // namespace wrinkle
