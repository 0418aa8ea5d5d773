#include "certify/certify.h"

#include <algorithm>
#include <set>

namespace wrinkle::certify {
namespace {

std::string counts(const Report& report, bool gpu) {
    std::string text = std::to_string(report.values) + " values in float, double";
    text += gpu ? " and on the GPU" : "";
    if (report.derivatives > 0) text += ", " + std::to_string(report.derivatives) + " derivatives";
    return text;
}

std::string findings(const Report& report) {
    std::string text;
    std::set<std::string> graphs;
    for (const Finding& finding : report.findings) {
        Diagnostic diagnostic = to_diagnostic(finding, report, "");
        diagnostic.node.clear();
        const std::string sentence = to_text(diagnostic);  // "error: ..."
        text += "    " + sentence.substr(sentence.find(": ") + 2) + "\n";
        if (!finding.graph.empty() && graphs.insert(finding.graph).second)
            text += "        in " + finding.graph + "\n";
    }
    return text;
}

}  // namespace

void Report::add(Finding finding) {
    const auto same = [&](const Finding& other) {
        return other.check == finding.check && other.port == finding.port;
    };
    if (std::ranges::none_of(findings, same)) findings.push_back(std::move(finding));
}

Diagnostic to_diagnostic(const Finding& finding, const Report& report, const std::string& file) {
    const std::string port = finding.port.empty() ? "" : "port '" + finding.port + "': ";
    return {.rule = RuleId::certification,
            .where = {file},
            .node = report.node,
            .message = finding.check + ": " + port + finding.message,
            .expected = finding.remedy};
}

std::span<const std::string_view> check_names() {
    static constexpr std::string_view names[] = {
        "descriptor", "text",    "deterministic", "round_trip", "derivative",
        "detach",     "uniform", "finite",        "precision",  "gpu"};
    return names;
}

Report certify(const NodeType& type, const CertifyContext& context) {
    Report report;
    report.node = type.id;
    check_descriptor(type, report);
    check_text(type, context, report);
    const auto hopeless = [](const Finding& finding) {
        return finding.check == "text" || finding.check == "deterministic";
    };
    if (std::ranges::any_of(report.findings, hopeless)) return report;
    for (const auto check : {check_derivatives, check_uniforms, check_finite, check_parity})
        check(type, context, report);
    return report;
}

std::string to_text(const Report& report, bool gpu) {
    const bool fine = report.findings.empty();
    return report.node + "  " + (fine ? "ok: " + counts(report, gpu) : "failed") + "\n" +
           findings(report);
}

}  // namespace wrinkle::certify
