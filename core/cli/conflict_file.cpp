#include "cli/conflict_file.h"

#include <filesystem>

#include "base/file.h"
#include "cli/session.h"

namespace wrinkle::cli {
namespace {

using difference::Conflict;
using difference::Section;

Diagnostic located(const Document& document, const Conflict& conflict, std::string message,
                   std::string expected) {
    constexpr RuleId rule = RuleId::merge_conflict;
    const Node* node = conflict.section == Section::nodes ? document.find(conflict.id) : nullptr;
    if (node && conflict.key.is_port)
        return diagnose_port(document, *node, conflict.key.name, rule, std::move(message),
                             std::move(expected));
    if (node) return diagnose(document, *node, rule, std::move(message), std::move(expected));
    const GraphInput* input = document.inputs.find(conflict.id);
    if (conflict.section == Section::inputs && input)
        return diagnose_key(document, *input, conflict.key.name, rule, std::move(message),
                            std::move(expected));
    const Output* output = document.outputs.find(conflict.id);
    if (conflict.section == Section::outputs && output)
        return diagnose(document, *output, rule, std::move(message), std::move(expected));
    return diagnose(document, rule, std::move(message), std::move(expected));
}

}  // namespace

std::optional<std::vector<Conflict>> open_conflicts(const std::string& graph,
                                                    Diagnostics& diagnostics) {
    const std::string file = conflict_file_of(graph);
    std::error_code error;
    if (!stream_title(graph).empty() || !std::filesystem::exists(file, error))
        return std::vector<Conflict>();
    auto text = read_text(file, diagnostics);
    if (!text) return {};
    return difference::read_conflicts(std::move(*text), file, diagnostics);
}

void report_conflicts(const std::string& graph, Diagnostics& diagnostics) {
    const auto conflicts = open_conflicts(graph, diagnostics);
    if (!conflicts || conflicts->empty()) return;
    Diagnostics known;  // errors of the graph are reported elsewhere
    const Document document = read_document(read_text(graph, known).value_or(""), graph, known);
    for (const Conflict& conflict : *conflicts) {
        const std::string command = "wrinkle settle " + graph + " " + conflict.id;
        const bool is_error = conflict.kind == difference::ConflictKind::error;
        diagnostics.add(located(document, conflict, "conflict of a merge: " + sentence_of(conflict),
                                is_error ? "edit the graph, then " + command + " --current"
                                         : command + " --ours or --theirs; after an edit of the "
                                                     "graph --current"));
    }
}

}  // namespace wrinkle::cli
