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

std::span<const std::string_view> check_names() {
    static constexpr std::string_view names[] = {
        "descriptor", "text",    "deterministic", "round_trip", "derivative",
        "detach",     "uniform", "finite",        "precision",  "gpu"};
    return names;
}

Report certify(const NodeType& type, const CertifyContext& bench) {
    Report report;
    report.node = type.id;
    check_descriptor(type, report);
    check_text(type, bench, report);
    const auto hopeless = [](const Finding& finding) {
        return finding.check == "text" || finding.check == "deterministic";
    };
    if (std::any_of(report.findings.begin(), report.findings.end(), hopeless)) return report;
    for (const auto check : {check_derivatives, check_uniforms, check_finite, check_parity})
        check(type, bench, report);
    return report;
}

std::string to_text(const Report& report, bool gpu) {
    const bool fine = report.findings.empty();
    return report.node + "  " + (fine ? "ok: " + counts(report, gpu) : "failed") + "\n" +
           findings(report);
}

}  // namespace wrinkle::certify
