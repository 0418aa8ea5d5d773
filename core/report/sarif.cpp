#include "report/sarif.h"

#include <algorithm>
#include <map>
#include <vector>

#include "base/checksum.h"
#include "base/text.h"
#include "report/repository.h"

namespace wrinkle::report {
namespace {

constexpr size_t max_characters = 1024;

std::string sarif_object(std::string_view key, const std::string& value) {
    return "\"" + std::string(key) + "\": {" + value + "}";
}

std::string sarif_member(std::string_view key, std::string_view value) {
    return "\"" + std::string(key) + "\": " + json_quoted(value);
}

// Returns the text cut to the limit, with a space in "](": SARIF takes "[text](target)" for a link.
std::string message_object(std::string_view text) {
    std::string result;
    size_t count = 0, end_if_cut = 0;
    while (!text.empty() && count <= max_characters) {
        const Character character = first_character(text);
        if (text[0] == '(' && result.ends_with(']')) result += ' ', ++count;
        if (count++ < max_characters - 3) end_if_cut = result.size() + character.bytes;
        result += text.substr(0, character.bytes);
        text.remove_prefix(character.bytes);
    }
    if (count > max_characters) result = result.substr(0, end_if_cut) + "...";
    return sarif_object("message", sarif_member("text", result));
}

std::string level_of(const Diagnostic& diagnostic) {
    return sarif_member("level", diagnostic.severity == Severity::error ? "error" : "warning");
}

std::string rule_text(const RuleInfo& rule) {
    return "{" + sarif_member("id", rule.id) + ", " +
           sarif_object("shortDescription", sarif_member("text", std::string(rule.title) + ".")) +
           ", " + sarif_object("fullDescription", sarif_member("text", rule.description)) + ", " +
           sarif_object("help", sarif_member("text", rule.help)) + "}";
}

std::string location_of(const Location& where, const std::string& uri) {
    std::string region = "\"startLine\": " + std::to_string(std::max(where.line, 1U));
    if (where.line > 0 && where.column > 0)
        region += ", \"startColumn\": " + std::to_string(where.column);
    return "\"locations\": [{" +
           sarif_object("physicalLocation",
                        sarif_object("artifactLocation", sarif_member("uri", uri)) + ", " +
                            sarif_object("region", region)) +
           "}]";
}

class SarifWriter {
public:
    explicit SarifWriter(const SarifOptions& options) : options_(options) {}

    void add(const Diagnostic& diagnostic) {
        if (diagnostic.where.file.empty())
            notifications_.push_back(
                "{" + sarif_object("descriptor", sarif_member("id", id_of(diagnostic))) + ", " +
                level_of(diagnostic) + ", " + message_object(sentence_of(diagnostic)) + "}");
        else
            add_result(diagnostic);
    }

    std::string text(bool is_successful) const {
        const auto same = [](const std::string& each) { return "\n" + each; };
        return "{\"$schema\": \"https://json.schemastore.org/sarif-2.1.0.json\", "
               "\"version\": \"2.1.0\", \"runs\": [{\"tool\": {\"driver\": {" +
               sarif_member("name", "Wrinkle") + ", " +
               sarif_member("semanticVersion", options_.version) + ", \"rules\": [" +
               joined(rule_infos, ",",
                      [](const RuleInfo& rule) { return "\n" + rule_text(rule); }) +
               "]}}, \"columnKind\": \"unicodeCodePoints\", \"invocations\": [{"
               "\"executionSuccessful\": " +
               (is_successful ? "true" : "false") +
               (notifications_.empty() ? ""
                                       : ", \"toolExecutionNotifications\": [" +
                                             joined(notifications_, ",", same) + "]") +
               "}], \"results\": [" + joined(results_, ",", same) + "]}]}\n";
    }

private:
    static std::string id_of(const Diagnostic& diagnostic) {
        return std::string(info(diagnostic.rule).id);
    }

    void add_result(const Diagnostic& diagnostic) {
        const std::string uri = uri_of(path_in_repository(diagnostic.where.file, options_.root));
        results_.push_back(
            "{" + sarif_member("ruleId", id_of(diagnostic)) +
            ", \"ruleIndex\": " + std::to_string(static_cast<int>(diagnostic.rule)) + ", " +
            level_of(diagnostic) + ", " + message_object(sentence_of(diagnostic)) + ", " +
            location_of(diagnostic.where, uri) + ", " +
            sarif_object("partialFingerprints",
                         sarif_member("primaryLocationLineHash", fingerprint(diagnostic, uri))) +
            "}");
    }

    // Equal ones are numbered, as those of GitHub's own action.
    std::string fingerprint(const Diagnostic& diagnostic, const std::string& uri) {
        const std::string parts = joined(
            std::vector{id_of(diagnostic), uri, json_quoted(diagnostic.node), diagnostic.pointer},
            "\n");
        Xxh64 sum;
        sum.add(std::as_bytes(std::span(parts)));
        const std::string hash = sum.digest();
        return hash + ":" + std::to_string(++seen_[hash]);
    }

    const SarifOptions& options_;
    std::vector<std::string> results_, notifications_;
    std::map<std::string, int> seen_;  // count of each fingerprint
};

}  // namespace

std::string sarif(const Diagnostics& diagnostics, const SarifOptions& options) {
    SarifWriter writer(options);
    bool is_successful = true;
    for (const Diagnostic& each : diagnostics.list()) {
        writer.add(each);
        is_successful &= !each.where.file.empty() || each.severity != Severity::error;
    }
    if (diagnostics.dropped() > 0)
        writer.add(
            file_problem(Severity::warning, RuleId::over_limit, "", dropped_text(diagnostics), ""));
    return writer.text(is_successful);
}

}  // namespace wrinkle::report
