#include "cli/diff_results.h"

#include <algorithm>

#include "base/file.h"
#include "base/text.h"
#include "cli/eval_text.h"
#include "cli/evaluation.h"
#include "cli/test_compare.h"
#include "cli/test_evidence.h"
#include "cli/test_image.h"
#include "cli/test_material.h"
#include "cost/report.h"
#include "json/parse.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

using report::Check;
using report::CheckKind;
using report::Status;

// Points of three planes through the origin, with every value that a graph may read.
constexpr const char* default_points = R"([
{"position": [0.3, -0.2, 0], "normal": [0, 0, 1], "tangent": [1, 0, 0, 1], "color0": [1, 1, 1, 1],
 "view": [0.36, 0.48, 0.8], "uv0": [0.31, 0.42], "uv1": [0.62, 0.84], "uv2": [0.31, 0.42],
 "uv3": [0.31, 0.42],
 "dx": {"position": [0.002, 0, 0], "normal": [0, 0, 0], "uv0": [0.001, 0], "uv1": [0.002, 0],
        "uv2": [0.001, 0], "uv3": [0.001, 0]},
 "dy": {"position": [0, 0.002, 0], "normal": [0, 0, 0], "uv0": [0, 0.001], "uv1": [0, 0.002],
        "uv2": [0, 0.001], "uv3": [0, 0.001]}},
{"position": [0, 0.5, -0.4], "normal": [1, 0, 0], "tangent": [0, 0, -1, 1],
 "color0": [0.5, 0.5, 0.5, 1], "view": [0.8, 0.36, 0.48], "uv0": [0.77, 0.63],
 "uv1": [1.54, 1.26], "uv2": [0.77, 0.63], "uv3": [0.77, 0.63],
 "dx": {"position": [0, 0, -0.002], "normal": [0, 0, 0], "uv0": [0.001, 0], "uv1": [0.002, 0],
        "uv2": [0.001, 0], "uv3": [0.001, 0]},
 "dy": {"position": [0, 0.002, 0], "normal": [0, 0, 0], "uv0": [0, 0.001], "uv1": [0, 0.002],
        "uv2": [0, 0.001], "uv3": [0, 0.001]}},
{"position": [-0.7, 0, 0.1], "normal": [0, 1, 0], "tangent": [1, 0, 0, 1],
 "color0": [0, 0, 0, 1], "view": [0.48, 0.8, 0.36], "uv0": [0.052, 0.21], "uv1": [0.104, 0.42],
 "uv2": [0.052, 0.21], "uv3": [0.052, 0.21],
 "dx": {"position": [0.002, 0, 0], "normal": [0, 0, 0], "uv0": [0.001, 0], "uv1": [0.002, 0],
        "uv2": [0.001, 0], "uv3": [0.001, 0]},
 "dy": {"position": [0, 0, -0.002], "normal": [0, 0, 0], "uv0": [0, 0.001], "uv1": [0, 0.002],
        "uv2": [0, 0.001], "uv3": [0, 0.001]}}])";

constexpr int default_size = 256;
constexpr Precision diff_precision = Precision::single;  // precision of shaders

TestCase blank_case(const GraphOperand& operand) {
    TestCase test;
    const std::string name = operand.file.empty() ? "graph" : operand.file.stem().string();
    test.name = name;
    test.graph = operand.file;
    test.file = operand.file.parent_path() / (name + std::string(test_suffix));
    return test;
}

RenderCase default_render(gpu::View view) {
    RenderCase render;
    render.options.width = render.options.height = default_size;
    render.options.view = view;
    return render;
}

// Returns the cases of NAME.test.json in the folder of a graph; none if it cannot be read.
std::vector<TestCase> cases_beside(const GraphOperand& operand, Diagnostics& diagnostics) {
    const fs::path file = blank_case(operand).file;
    std::error_code ignored;
    if (operand.file.empty() || !fs::exists(file, ignored)) return {};
    return read_test_cases(file, diagnostics);
}

std::vector<TestCase> cases_of(const GraphOperand& before, const GraphOperand& after, bool renders,
                               Diagnostics& diagnostics) {
    std::vector<TestCase> tests;
    if (renders) tests = cases_beside(after, diagnostics);
    if (renders && tests.empty()) tests = cases_beside(before, diagnostics);
    if (tests.empty()) tests.push_back(blank_case(after));
    const auto has_points = [](const TestCase& test) { return test.points.count() > 0; };
    const auto has_render = [](const TestCase& test) { return test.render.has_value(); };
    if (renders && std::ranges::none_of(tests, has_points)) {
        const json::Parsed points = json::parse(default_points, "points", diagnostics);
        tests.front().points = read_points(points.root, diagnostics);
    }
    if (renders && std::ranges::none_of(tests, has_render)) {
        tests.front().render = default_render(gpu::View::shaded);
        TestCase normals = blank_case(after);
        normals.name += ".normals";
        normals.render = default_render(gpu::View::normal);
        tests.push_back(std::move(normals));
    }
    for (TestCase& test : tests) {
        test.glsl = true;
        test.tolerance = test.tolerance_deg = 0;
        if (!test.render) continue;
        RenderCase& render = *test.render;
        render.metric = map_metric(render);
        render.tolerance = 0;
        render.max_pixel.reset();
        render.max_over.reset();
    }
    return tests;
}

// One graph, compiled, evaluated and drawn by one case.
struct CaseResults {
    CaseMaterial material;
    std::vector<OutputColumn> columns;
    DrawnCase drawn;
    std::optional<CostReport> cost;
    Diagnostics problems;
};

CaseResults results_of(const TestCase& test, const ReadGraph& graph, const DiffSettings& settings,
                       std::string& environment) {
    CaseResults results;
    Diagnostics& problems = results.problems;
    results.material = compile_case(test, graph, settings.registry, settings.common, problems);
    const CaseMaterial& material = results.material;
    if (!problems.has_errors() && test.points.count() > 0) {
        auto columns = evaluate_points(*material.given, material.textures, {test.points},
                                       diff_precision, problems);
        if (columns) results.columns = std::move(*columns);
    }
    if (problems.has_errors()) return results;
    std::string why;
    results.cost = measure_cost(material.screen->compiled.module, Differentials::screen, why);
    if (!results.cost && environment.empty()) environment = "costs cannot be counted: " + why;
    if (test.render) results.drawn = draw_case(test, material, nullptr, "", problems);
    if (environment.empty()) environment = results.drawn.environment;
    return results;
}

// Compares the results of one case.
class CaseDifference {
public:
    CaseDifference(const TestCase& test, const CaseResults& before, const CaseResults& after,
                   const fs::path& folder)
        : test_(test), before_(before), after_(after), folder_(folder) {}

    std::vector<Check> checks() {
        if (before_.drawn.image && after_.drawn.image) add(image());
        if (before_.cost && after_.cost) add(cost());
        for (size_t point = 0; point < test_.points.count(); ++point)
            add(at_point(point));
        if (!folder_.empty()) add(text());
        return std::move(checks_);
    }

    std::string environment;  // why an image could not be written

private:
    Check begin(CheckKind kind, const std::string& name) const {
        Check check;
        check.kind = kind;
        check.test = test_.full_name();
        check.name = name;
        check.file = check.graph = test_.graph.string();
        return check;
    }
    void add(Check check) {
        if (!check.message.empty()) check.status = Status::changed;
        checks_.push_back(std::move(check));
    }
    Check cost() const;
    Check at_point(size_t point) const;
    Check text() const;
    Check image();

    const TestCase& test_;
    const CaseResults& before_;
    const CaseResults& after_;
    const fs::path& folder_;
    std::vector<Check> checks_;
};

Check CaseDifference::cost() const {
    Check check = begin(CheckKind::cost, "cost");
    const auto compare = [&](const std::string& name, uint64_t before, uint64_t after) {
        if (before == after) return;
        report::Measured& each = check.measured.emplace_back();
        each.name = name;
        each.expected = std::to_string(before);
        each.actual = std::to_string(after);
        each.value = static_cast<double>(after) - static_cast<double>(before);
        check.message +=
            (check.message.empty() ? "" : ", ") + name + " " + each.expected + " -> " + each.actual;
    };
    const auto before = named_counts(*before_.cost), after = named_counts(*after_.cost);
    for (size_t i = 0; i < before.size(); ++i)
        compare(before[i].name, before[i].count, after[i].count);
    compare("values", before_.material.screen->compiled.module.size(),
            after_.material.screen->compiled.module.size());
    return check;
}

Check CaseDifference::at_point(size_t point) const {
    Check check = begin(CheckKind::point, "points/" + std::to_string(point));
    check.expected_text = values_json(before_.columns, point, diff_precision);
    check.actual_text = values_json(after_.columns, point, diff_precision);
    if (check.expected_text == check.actual_text) return check;
    Diagnostics ignored;
    const json::Parsed expected = json::parse(check.expected_text, "", ignored);
    check.measured = compare_point(test_, after_.material.given->project.top(), expected.root,
                                   after_.columns, point)
                         .measured;
    for (const report::Measured& each : check.measured) {
        if (each.within() && !each.actual.empty()) continue;
        check.message += (check.message.empty() ? "" : "; ") + each.name + " " + each.expected;
        check.message += each.actual.empty()
                             ? " -> none"
                             : " -> " + each.actual + ", " + short_number(each.value) +
                                   (each.unit.empty() ? "" : " " + each.unit);
    }
    for (const OutputColumn& column : after_.columns)
        if (!expected.root.has(column.name))
            check.message += (check.message.empty() ? "" : "; ") + column.name + " is new";
    return check;
}

Check CaseDifference::text() const {
    Check check = begin(CheckKind::text, "glsl");
    const std::string &before = before_.material.shader.source,
                      &after = after_.material.shader.source;
    if (before == after) return check;
    check.message = text_difference(before, after);
    check.expected_text = before;
    check.actual_text = after;
    check.nodes_of_lines = nodes_of_lines(after_.material);
    return check;
}

Check CaseDifference::image() {
    Check check = begin(CheckKind::image, "render");
    const Image &before = *before_.drawn.image, &after = *after_.drawn.image;
    const ImageComparison compared = compare_images(*test_.render, before, after);
    check.message = compared.largest;
    check.measured = compared.measured;
    if (!check.message.empty() && !folder_.empty())
        save_images({&before, after, compared}, folder_, test_.flat_name(), check, environment);
    return check;
}

// Returns a check of a case that one of the graphs cannot run.
Check failed_case(const TestCase& test, const GraphOperand& operand, const Diagnostics& problems) {
    Check check;
    check.test = test.full_name();
    check.name = "case";
    check.file = check.graph = operand.name;
    check.status = Status::error;
    check.message = operand.name + " " + cannot_run(problems);
    return check;
}

}  // namespace

report::Results compare_materials(const GraphOperand& before, const GraphOperand& after,
                                  const DiffSettings& settings, Diagnostics& diagnostics,
                                  std::string& environment) {
    report::Results results;
    results.before = before.name;
    results.after = after.name;
    const GraphOperand* operands[] = {&before, &after};
    ReadGraph graphs[] = {open_graph(before, settings.common), open_graph(after, settings.common)};
    for (size_t i = 0; i < 2 && settings.renders; ++i)
        warn_of_other_files(*operands[i], graphs[i].project, settings.registry, diagnostics);
    for (const TestCase& test : cases_of(before, after, settings.renders, diagnostics)) {
        CaseResults sides[] = {results_of(test, graphs[0], settings, environment),
                               results_of(test, graphs[1], settings, environment)};
        bool runs = true;
        for (size_t i = 0; i < 2; ++i) {
            if (!sides[i].problems.has_errors()) continue;
            runs = false;
            results.checks.push_back(failed_case(test, *operands[i], sides[i].problems));
            break;
        }
        if (!runs) continue;
        CaseDifference difference(test, sides[0], sides[1], settings.folder);
        for (Check& check : difference.checks())
            results.checks.push_back(std::move(check));
        if (environment.empty()) environment = difference.environment;
        if (results.driver.empty()) results.driver = sides[1].drawn.driver;
    }
    return results;
}

}  // namespace wrinkle::cli
