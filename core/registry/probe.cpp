#include "registry/probe.h"

#include "json/parse.h"
#include "registry/child.h"
#include "registry/library.h"
#include "registry/recording.h"

namespace wrinkle {
namespace {

std::string while_doing(std::string_view stage) {
    if (stage == "load") return "while it was loaded";
    if (stage == "enter") return "in its wrinkle_plugin()";
    if (stage == "build") return "in build()";
    return "while its descriptors were read";
}

// Output of a probe without its stage lines.
struct Answer {
    std::string stage = "load";  // the last stage
    std::string_view fine;       // text after probe_fine
    std::string_view refused;
    bool is_fine = false;
};

Answer read_answer(const ProbeResult& result) {
    Answer answer;
    std::string_view rest = result.output;
    while (rest.starts_with(probe_stage)) {
        const size_t end = rest.find('\n');
        if (end == rest.npos) break;
        answer.stage = rest.substr(probe_stage.size(), end - probe_stage.size());
        rest.remove_prefix(end + 1);
    }
    if (!result.is_whole()) return answer;
    answer.is_fine = rest.starts_with(probe_fine);
    if (answer.is_fine) answer.fine = rest.substr(probe_fine.size());
    if (rest.starts_with(probe_refused)) answer.refused = rest.substr(probe_refused.size());
    return answer;
}

// Reads faults in the form of to_json() of base/diagnostics.h.
void read_faults(std::string_view text, const std::string& origin, Diagnostics& diagnostics) {
    Diagnostics none;
    const json::Value root = json::parse(std::string(text), origin, none).root;
    const auto word = [](const json::Value& object, std::string_view key) {
        const json::Value value = object.find(key);
        return value.is(json::Kind::string) ? plugin_text(value.as_string()) : std::string();
    };
    for (const json::Member& each : root.find("diagnostics").children()) {
        Diagnostic fault = file_problem(Severity::error, RuleId::plugin, origin,
                                        word(each.value, "message"), word(each.value, "expected"));
        fault.node = word(each.value, "node");
        if (!fault.message.empty()) diagnostics.add(std::move(fault));
    }
}

std::string cannot_start(const std::string& why) {
    return "it cannot be looked into: " + why;
}

}  // namespace

std::optional<PluginListing> probe_plugin(const std::string& path, const std::string& sha256,
                                          const std::string& origin,
                                          std::chrono::milliseconds limit,
                                          Diagnostics& diagnostics) {
    std::string why;
    const std::string words[] = {std::string(probe_list_word), path, sha256};
    const auto result = run_child(words, limit, why);
    if (!result) {
        add_fault(diagnostics, origin, cannot_start(why),
                  "that program is installed beside this one");
        return std::nullopt;
    }
    const Answer answer = read_answer(*result);
    if (answer.is_fine) return read_listing(std::string(answer.fine), origin, origin, diagnostics);
    const size_t before = diagnostics.error_count();
    read_faults(answer.refused, origin, diagnostics);
    if (diagnostics.error_count() == before)
        add_fault(diagnostics, origin,
                  result->output_too_large
                      ? "it describes more than can be"
                      : "it " + ending(*result, while_doing(answer.stage), limit));
    return std::nullopt;
}

BuildRun probe_build(const std::string& path, NodeToBuild node, std::span<const int32_t> options,
                     std::chrono::milliseconds limit) {
    std::vector<std::string> words{std::string(probe_build_word), path, std::to_string(node.index),
                                   node.twice ? "1" : "0"};
    for (const int32_t option : options)
        words.push_back(std::to_string(option));
    BuildRun run;
    const auto result = run_child(words, limit, run.why);
    run.started = result.has_value();
    if (!result) {
        run.why = cannot_start(run.why);
        return run;
    }
    const Answer answer = read_answer(*result);
    Diagnostics faults;
    read_faults(answer.refused, path, faults);
    if (answer.is_fine)
        run.calls = std::make_shared<const std::string>(answer.fine);
    else if (result->output_too_large || result->exit_code == child_output_too_large)
        run.why = "it makes more than " + std::to_string(max_build_calls) + " calls in build()";
    else if (faults.has_errors())
        run.why = sentence_of(faults);
    else
        run.why = "it " + ending(*result, while_doing(answer.stage), limit);
    return run;
}

}  // namespace wrinkle
