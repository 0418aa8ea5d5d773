// wrinkle eval FILE: evaluates a graph's outputs at surface points, as JSON, CSV or NPY.
#include <filesystem>

#include "base/text.h"
#include "cli/cli.h"
#include "cli/eval_text.h"
#include "cli/evaluation.h"
#include "cli/meshes.h"
#include "cli/output.h"
#include "json/write.h"

namespace wrinkle::cli {
namespace {

// Reports a warning for each output normal without unit length: its values exceed the range of the
// precision.
void check_normals(const std::vector<OutputColumn>& columns, const PointList& points,
                   Diagnostics& diagnostics) {
    for (const OutputColumn& column : columns) {
        if (column.port_type != WR_PORT_normal) continue;
        for (size_t i = 0; i < column.values.size(); i += 3) {
            const double* n = column.values.data() + i;
            const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
            if (square > 0.5 && square < 2) continue;
            points.report(i / 3, RuleId::precision_loss, Severity::warning,
                          "'" + column.name + "' has no direction: its numbers are " +
                              "too large or too small for the precision",
                          "inputs between 1e-18 and 1e18, or --precision double", diagnostics);
        }
    }
}

struct EvalCommand {
    CommonOptions common;
    std::string file, precision = "float", output = "-", format;
    PointOptions at;

    int run() const {
        if (const std::string why = wrong_usage(); !why.empty()) return fail(exit_usage, why);
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const Overrides overrides = parse_overrides(common, diagnostics);
        const PointSource source = open_points(at, common, diagnostics);
        const std::string form = chosen_form();
        if (output == "-" && form != "json" && overrides.is_sweep())
            return fail(exit_usage, "a sweep writes a file for each of its runs: -o OUT");
        TextureStore textures;
        std::vector<Result> results;
        std::string json;
        const auto use = [&](size_t i, const MaterialRun& run, Diagnostics& problems) {
            read_textures(textures, run.compiled, run.project, problems);
            if (problems.has_errors() || diagnostics.has_errors()) return;
            std::string text = numbers(form, run, source, textures, problems);
            if (form != "json")
                results.push_back({path_of_run(output, overrides, i), std::move(text)});
            else if (overrides.is_sweep())
                json += (i > 0 ? ",\n" : "") + std::string("{\"set\": ") + set_json(overrides, i) +
                        ", " + text + "}";
            else
                json = text;
        };
        compile_runs(file, common, nodes.registry, overrides,
                     {.given_differentials = true, .runs_calls = "eval"}, use, diagnostics);
        if (form == "json")  // one text for all runs
            results = {{output, overrides.is_sweep() ? "{\"runs\": [\n" + json + "\n]}\n"
                                                     : "{" + json + "}\n"}};
        const int code = report(diagnostics, common.diagnostics);
        return code == exit_success ? write_results(results) : code;
    }

    // Returns one sentence on wrong usage, otherwise "".
    std::string wrong_usage() const {
        if (at.mesh.empty() && at.at.empty())
            return "eval needs points: --at JSON, --at FILE.csv|npy, or --mesh NAME|PATH with "
                   "--uv U,V or --at";
        if (at.mesh.empty() && !at.uv.empty()) return "--uv goes with --mesh";
        if (!at.mesh.empty() && at.at.empty() && !parse_uv(at.uv))
            return "--mesh needs a place: --uv U,V such as 0.5,0.25, or --at FILE.csv|npy";
        if (!at.at.empty() && !at.uv.empty()) return "--uv and --at are two ways of one place";
        if (at.at == "-" && file == "-")
            return "the graph and the points cannot both come from standard input";
        if (format.empty() && output != "-" && !is_form(extension_of(output)))
            return "-o " + output + " does not end in .json, .csv or .npy; name it so, or --format";
        return "";
    }

    static std::string extension_of(const std::string& path) {
        const std::string extension = std::filesystem::path(path).extension().string();
        return extension.empty() ? "" : extension.substr(1);
    }
    static bool is_form(const std::string& name) {
        return name == "json" || name == "csv" || name == "npy";
    }
    std::string chosen_form() const {
        const std::string form = format.empty() ? extension_of(output) : format;
        return is_form(form) ? form : "json";
    }

    std::string numbers(const std::string& form, const MaterialRun& run, const PointSource& source,
                        const TextureStore& textures, Diagnostics& diagnostics) const {
        const Precision wanted = precision == "double" ? Precision::full : Precision::single;
        const auto columns = evaluate_points(run, textures, source, wanted, diagnostics);
        if (!columns) return {};
        check_normals(*columns, source.points, diagnostics);
        return eval_text(form, *columns, source.points.count(), wanted);
    }

    static std::string set_json(const Overrides& overrides, size_t run) {
        std::string text = "{";
        for (const Override& each : overrides.list) {
            const json::Value& value = each.values[each.is_sweep() ? run : 0];
            text += (text.size() > 1 ? ", " : "") + json_quoted(each.target.text()) + ": " +
                    json::one_line(value);
        }
        return text + "}";
    }
};

}  // namespace

void declare_eval(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<EvalCommand>(
        app, run, "eval", "A graph's outputs at surface points, as JSON, CSV or NPY");
    sub.add_option("FILE", c.file, "A graph; - reads standard input")->required();
    sub.add_option("--at", c.at.at,
                   "A point such as {\"normal\": [0, 0, 1], \"uv0\": [0.5, 0.5], \"dx\": {...}}, "
                   "an array of them, @FILE, - for standard input, or a table FILE.csv|npy with "
                   "columns such as uv0.x,uv0.y,dx.uv0.x; with --mesh places, of which uv0 is read")
        ->type_name("JSON|FILE");
    declare_mesh(sub, c.at.mesh, "Points of this: ");
    sub.add_option("--uv", c.at.uv, "One place on it, in uv0")->type_name("U,V");
    sub.add_option("--size", c.at.size, "dx and dy are one texel of N x N of uv0")
        ->type_name("N")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    sub.add_option("-o", c.output, "A file in place of standard output: .json, .csv or .npy")
        ->type_name("OUT");
    add_choice(sub, "--format", c.format, {"json", "csv", "npy"},
               "The form of the result; default: as OUT ends, else json");
    add_choice(sub, "--precision", c.precision, {"float", "double"}, "Precision of the arithmetic");
    declare_common(sub, c.common);
}

}  // namespace wrinkle::cli
