#include "certify/report.h"

#include <algorithm>

namespace wrinkle::certify {

void Report::add(Finding finding) {
    const auto same = [&](const Finding& other) {
        return other.check == finding.check && other.port == finding.port;
    };
    if (std::none_of(findings.begin(), findings.end(), same))
        findings.push_back(std::move(finding));
}

Diagnostic to_diagnostic(const Finding& finding, const Report& report, const std::string& file) {
    Diagnostic diagnostic;
    diagnostic.where.file = file;
    diagnostic.node = report.node;
    diagnostic.message = finding.check + ": " +
                         (finding.port.empty() ? "" : "port '" + finding.port + "': ") +
                         finding.message;
    diagnostic.expected = finding.remedy;
    return diagnostic;
}

}  // namespace wrinkle::certify
