// wrinkle eval FILE: a graph's outputs at surface points, as JSON.
#include <memory>

#include "base/text.h"
#include "cli/evaluation.h"
#include "cli/meshes.h"
#include "cli/output.h"
#include "json/write.h"

namespace wrinkle::cli {
namespace {

struct EvalCommand {
    CommonOptions common;
    std::string file, at, precision = "float";
    MeshPlace place;

    int run() const {
        if (!check_usage()) return exit_usage;
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const Overrides overrides = parse_overrides(common, diagnostics);
        const std::vector<Point> points = at.empty() ? points_on_mesh(place, common, diagnostics)
                                                     : points_of_option(at, diagnostics);
        TextureStore textures;
        std::string text = overrides.is_sweep() ? "{\"runs\": [\n" : "{";
        const auto use = [&](size_t i, const MaterialRun& run, Diagnostics& problems) {
            read_textures(textures, run.compiled, run.project, problems);
            if (!problems.has_errors() && !diagnostics.has_errors())
                text += result(i, run, overrides, points, textures, problems);
        };
        compile_runs(file, common, nodes.registry, overrides, Purpose::eval, use, diagnostics);
        text += overrides.is_sweep() ? "\n]}\n" : "}\n";
        const int code = report(diagnostics, common.diagnostics);
        if (code != exit_fine) return code;
        return write_result("-", text) ? exit_fine : exit_environment;
    }

    bool check_usage() const {
        std::string sentence;
        if (at.empty() == place.mesh.empty())
            sentence = "eval needs points: --at JSON, or --mesh NAME|PATH with --uv U,V";
        else if (at.empty() && !is_uv(place.uv))
            sentence = "--mesh needs a place: --uv U,V such as 0.5,0.25";
        else if (!at.empty() && !place.uv.empty())
            sentence = "--uv goes with --mesh";
        else if (at == "-" && file == "-")
            sentence = "the graph and the points cannot both come from standard input";
        if (!sentence.empty()) complain(sentence);
        return sentence.empty();
    }

    std::string result(size_t number, const MaterialRun& run, const Overrides& overrides,
                       const std::vector<Point>& points, const TextureStore& textures,
                       Diagnostics& diagnostics) const {
        const Precision wanted = precision == "double" ? Precision::full : Precision::single;
        const auto columns = evaluate_at(run, textures, points, wanted, diagnostics);
        if (!columns) return {};
        const std::string numbers = points_json(*columns, points.size(), wanted);
        if (!overrides.is_sweep()) return numbers;
        return (number > 0 ? ",\n" : "") + std::string("{\"set\": ") + set_json(overrides, number) +
               ", " + numbers + "}";
    }

    static std::string points_json(const std::vector<OutputColumn>& columns, size_t count,
                                   Precision precision) {
        std::string text = "\"points\": [";
        for (size_t point = 0; point < count; ++point)
            text += (point > 0 ? ",\n  " : "\n  ") + values_json(columns, point, precision);
        return text + (count > 0 ? "\n]" : "]");
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
    auto command = std::make_shared<EvalCommand>();
    EvalCommand& c = *command;
    CLI::App& sub = *app.add_subcommand("eval", "A graph's outputs at surface points, as JSON");
    sub.add_option("FILE", c.file, "A graph; - reads standard input")->required();
    sub.add_option("--at", c.at,
                   "A point such as {\"normal\": [0, 0, 1], \"uv0\": [0.5, 0.5], \"dx\": {...}}, "
                   "an array of them, @FILE, or - for standard input")
        ->type_name("JSON");
    sub.add_option("--mesh", c.place.mesh, "A point of this instead: " + mesh_help())
        ->type_name("NAME|PATH")
        ->check(check_mesh);
    sub.add_option("--uv", c.place.uv, "Where on it, in uv0")->type_name("U,V");
    sub.add_option("--size", c.place.size, "dx and dy are one texel of N x N of uv0")
        ->type_name("N")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    sub.add_option("--precision", c.precision, "Of the arithmetic")
        ->check(CLI::IsMember({"float", "double"}))
        ->capture_default_str();
    declare_common(sub, c.common);
    sub.callback([command, &run] { run = [command] { return command->run(); }; });
}

}  // namespace wrinkle::cli
