// wrinkle explain-log GRAPH LOG: maps the messages of a shader compiler log to graph nodes.
#include <algorithm>
#include <memory>

#include "base/dynamic_library.h"
#include "base/printable.h"
#include "base/text.h"
#include "base/words.h"
#include "cli/compile_graph.h"
#include "cli/output.h"
#include "glsl/log.h"
#include "lower/flat.h"
#include "spirv/spirv.h"

namespace wrinkle::cli {
namespace {

// Maps log lines about one generated source to nodes.
class Explained {
public:
    Explained(const MadeShader& made, const Project& project, size_t first)
        : made_(made),
          project_(project),
          first_(first),
          lines_(split(made.shader.source.empty() ? made.shader.fragment : made.shader.source,
                       '\n')) {}

    Diagnostic explain(const LogLine& said) const {
        const Reflection& reflection = made_.shader.reflection;
        const size_t line = said.line < first_ ? 0 : said.line - first_ + 1;
        const uint32_t node = node_of_line(reflection, line);
        Diagnostic found;
        found.where.file = project_.top().file;
        if (node != no_node && node != 0)
            found = diagnose(project_, made_.compiled.places[node], reflection.node_paths[node], "",
                             "");
        found.severity = said.warning ? Severity::warning : Severity::error;
        found.message = said.message;
        const bool inside = line > 0 && line <= lines_.size();
        found.expected = "line " + std::to_string(said.line) +
                         (inside ? ": " + std::string(trimmed(lines_[line - 1]))
                                 : ", which is not of this text");
        return found;
    }

private:
    const MadeShader& made_;
    const Project& project_;
    size_t first_;
    std::vector<std::string_view> lines_;
};

struct ExplainCommand {
    CommonOptions common;
    TextOptions text;
    std::string graph, log;
    size_t first = 1;

    int run() const {
        if (const std::string why = wrong_usage(); !why.empty()) {
            print_error(why);
            return exit_usage;
        }
        if (std::string why; is_translated(*find_target(text.target)) && !have_spirv_tools(why)) {
            print_error(why + "; " + library_remedy);
            return exit_environment;
        }
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const Overrides overrides = parse_overrides(common, diagnostics);
        if (overrides.is_sweep()) {
            print_error("a text has no sweep; give --set one value");
            return exit_usage;
        }
        const Compilation with{common, text, nodes.registry, overrides};
        const Project read = open_project(graph, common, diagnostics);
        const Project project =
            with_overrides(read, nodes.registry, overrides.list, 0, diagnostics);
        const MadeShader made =
            make_shader(project, nodes.registry, shader_options(graph, with), diagnostics);
        const auto said = read_text(log, diagnostics);
        if (diagnostics.has_errors() || !said) return report(diagnostics, common.diagnostics);
        report(diagnostics, "text");  // warnings about the graph
        return print(Explained(made, project, first), *said);
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
        while (!said.empty()) {
            const size_t end = std::min(said.find('\n'), said.size());
            const std::string_view line = said.substr(0, end);
            said.remove_prefix(std::min(end + 1, said.size()));
            const LogLine read = read_log_line(line);
            if (read.line > 0) found.add(explained.explain(read));
            printed += read.line > 0 ? to_text(explained.explain(read))
                                     : printable(line.substr(0, line.find_last_not_of('\r') + 1));
            printed += '\n';
        }
        const bool json = common.diagnostics == "json";
        return write_result("-", json ? to_json(found) : printed) ? exit_success : exit_environment;
    }
};

}  // namespace

void declare_explain_log(CLI::App& app, Run& run) {
    auto command = std::make_shared<ExplainCommand>();
    ExplainCommand& c = *command;
    CLI::App& sub = *app.add_subcommand(
        "explain-log", "Finds the nodes that a graphics driver's errors are about");
    sub.add_option("GRAPH", c.graph, "The graph that the text was compiled from")->required();
    sub.add_option("LOG", c.log, "What the driver or compiler said; - reads standard input")
        ->required();
    sub.add_option("--begins-at", c.first,
                   "The line of your shader that the text begins at, where it is a part of one")
        ->type_name("LINE")
        ->check(CLI::Range(size_t{1}, size_t{1} << 30))
        ->capture_default_str();
    declare_text(sub, c.text);
    declare_common(sub, c.common);
    sub.footer("Give it the options that the text was compiled with.");
    sub.callback([command, &run] { run = [command] { return command->run(); }; });
}

}  // namespace wrinkle::cli
