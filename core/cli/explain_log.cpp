// wrinkle explain-log GRAPH LOG: maps the messages of a shader compiler log to graph nodes.
#include "base/printable.h"
#include "base/text.h"
#include "cli/cli.h"
#include "cli/compile_graph.h"
#include "cli/output.h"
#include "emit/log.h"
#include "lower/flat.h"

namespace wrinkle::cli {
namespace {

// Generated source that a log is about.
struct Explained {
    const MadeShader& made;
    const Project& project;
    size_t first;                         // line of the caller's shader at which the source begins
    std::vector<std::string_view> lines;  // the generated source

    // Returns the message of a log line at its node.
    Diagnostic explain(const LogLine& said) const {
        const Reflection& reflection = made.shader.reflection;
        const size_t line = said.line < first ? 0 : said.line - first + 1;
        const uint32_t node = node_of_line(reflection, line);
        Diagnostic found = {.rule = RuleId::shader_rejected};
        found.where.file = project.top().file;
        if (node != no_node && node != 0)
            found = diagnose(project, made.compiled.places[node], reflection.node_paths[node],
                             found.rule, "", "");
        found.severity = said.warning ? Severity::warning : Severity::error;
        found.message = said.message;
        const bool inside = line > 0 && line <= lines.size();
        found.expected =
            "line " + std::to_string(said.line) +
            (inside ? ": " + std::string(trimmed(lines[line - 1])) : ", which is not of this text");
        return found;
    }
};

struct ExplainCommand {
    CommonOptions common;
    TextOptions text;
    std::string graph, log;
    size_t first = 1;

    int run() const {
        if (const std::string why = wrong_usage(); !why.empty()) return fail(exit_usage, why);
        if (std::string why; !have_compilers(text, why)) return fail(exit_environment, why);
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const Overrides overrides = parse_overrides(common, diagnostics);
        if (overrides.is_sweep())
            return fail(exit_usage, "a text has no sweep; give --set one value");
        const Compilation with{common, text, nodes.registry, overrides};
        const Project read = open_project(graph, common, diagnostics);
        const Project project = project_of_run(read, nodes.registry, overrides, 0, diagnostics);
        const MadeShader made =
            make_shader(project, nodes.registry, shader_options(graph, with), diagnostics);
        const auto said = read_text(log, diagnostics);
        if (diagnostics.has_errors() || !said) return report(diagnostics, common.diagnostics);
        report(diagnostics, "text");  // warnings about the graph
        const Shader& shader = made.shader;
        const auto lines = split(shader.source.empty() ? shader.fragment : shader.source, '\n');
        return print({made, project, first, lines}, *said);
    }

    std::string wrong_usage() const {
        if (graph == "-" && log == "-") return "standard input is the graph or the log, not both";
        if (const std::string why = wrong_text(text); !why.empty()) return why;
        return text.target == "spirv" ? "SPIR-V has no lines that a log could name" : "";
    }

    // Prints the log with explained messages; lines without a location are printed unchanged.
    int print(const Explained& explained, std::string_view said) const {
        Diagnostics found;
        std::string printed;
        std::vector<std::string_view> lines = split(said, '\n');
        if (lines.back().empty()) lines.pop_back();
        for (const std::string_view line : lines) {
            const LogLine read = read_log_line(line);
            if (read.line > 0) found.add(explained.explain(read));
            printed += read.line > 0 ? to_text(explained.explain(read))
                                     : printable(line.substr(0, line.find_last_not_of('\r') + 1));
            printed += '\n';
        }
        const std::string& format = common.diagnostics;
        return write_result("-", format == "text" ? printed : formatted(found, format));
    }
};

}  // namespace

void declare_explain_log(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<ExplainCommand>(
        app, run, "explain-log", "Finds the nodes that a graphics driver's errors are about");
    sub.add_option("GRAPH", c.graph, "The graph that the text was compiled from")->required();
    sub.add_option("LOG", c.log, "Log of the driver or compiler; - reads standard input")
        ->required();
    sub.add_option("--begins-at", c.first,
                   "The line of your shader that the text begins at, where it is a part of one")
        ->type_name("LINE")
        ->check(CLI::Range(size_t{1}, size_t{1} << 30))
        ->capture_default_str();
    declare_text(sub, c.text);
    declare_common(sub, c.common);
    sub.footer("Give it the options that the text was compiled with.");
}

}  // namespace wrinkle::cli
