#include "cli/test_run.h"

#include <chrono>
#include <cmath>

#include "base/file.h"
#include "cli/eval_text.h"
#include "cli/evaluation.h"
#include "cli/test_accept.h"
#include "cli/test_compare.h"
#include "cli/test_evidence.h"
#include "cli/test_image.h"
#include "cli/test_material.h"
#include "cli/test_report.h"
#include "image/load.h"
#include "json/write.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

using report::Check;
using report::CheckKind;
using report::Status;

constexpr Precision precision = Precision::single;  // precision of shaders

json::Value entry_of(const TestCase& test, size_t point) {
    return point < test.expect.size() ? test.expect.at(point) : json::Value();
}

// Returns the outputs that the entry names; all outputs if it is empty.
std::vector<OutputColumn> named_by(const json::Value& entry,
                                   const std::vector<OutputColumn>& columns) {
    std::vector<OutputColumn> result;
    for (const OutputColumn& column : columns)
        if (entry.size() == 0 || entry.has(column.name)) result.push_back(column);
    return result;
}

bool is_finite(const std::vector<OutputColumn>& columns, size_t point) {
    for (const OutputColumn& column : columns)
        for (size_t lane = 0; lane < column.lanes; ++lane)
            if (!std::isfinite(column.values[point * column.lanes + lane])) return false;
    return true;
}

void set_new(Check& check) {
    check.status = Status::added;
    check.message =
        check.baseline.empty() ? "expects nothing yet" : check.baseline + " does not exist yet";
    check.expected = "--accept or --update writes it";
}

class Stopwatch {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Runs one case.
class CaseRun {
public:
    CaseRun(const TestCase& test, const TestSettings& settings, TestOutcome& outcome)
        : test_(test), settings_(settings), outcome_(outcome) {}

    void run() {
        compile();
        if (!problems_.has_errors() && test_.points.count() > 0) check_points();
        if (!problems_.has_errors() && test_.glsl) check_text();
        if (!problems_.has_errors() && !test_.budget.empty()) check_budget();
        if (!problems_.has_errors() && test_.render) check_image();
        outcome_.problems.append_once(problems_);
        if (problems_.has_errors()) add_error();
        add_uses();
    }

private:
    void compile();
    void check_points();
    void check_text();
    void check_budget();
    void check_image();
    void compare_image(const Image& image, Check check);
    const std::string& hash() {
        if (hash_.empty()) hash_ = hash_of_inputs(test_, settings_.registry, settings_.common);
        return hash_;
    }
    Check begin(CheckKind kind, const std::string& name, const json::Value& place) const;
    void end(Check check);
    void add_error();
    void add_uses();

    const TestCase& test_;
    const TestSettings& settings_;
    TestOutcome& outcome_;
    Diagnostics problems_;
    CaseMaterial material_;
    std::string hash_;  // hash(), once it is needed
    Stopwatch watch_;   // since the last check
};

void CaseRun::compile() {
    for (const fs::path& file : {test_.graph, test_.golden(".glsl"), test_.golden(".png")})
        refuse_outside(test_, file, settings_.common, problems_);
    ReadGraph graph;
    graph.project = open_project(test_.graph.string(), settings_.common, graph.problems);
    material_ = compile_case(test_, graph, settings_.registry, settings_.common, problems_);
}

void CaseRun::check_points() {
    const auto columns =
        evaluate_points(*material_.given, material_.textures, {test_.points}, precision, problems_);
    if (!columns) return;
    for (size_t point = 0; point < test_.points.count(); ++point) {
        Check check =
            begin(CheckKind::point, "points/" + std::to_string(point), test_.points.sources[point]);
        const json::Value expected = entry_of(test_, point);
        CaseComparison compared =
            compare_point(test_, material_.given->project.top(), expected, *columns, point);
        const auto columns_named = named_by(expected, *columns);
        check.message = std::move(compared.difference);
        if (expected.size() == 0)
            set_new(check);
        else if (!check.message.empty())
            check.status = Status::failed;
        check.actual_text = values_json(columns_named, point, precision);
        if (!is_finite(columns_named, point)) {
            check.status = Status::failed;
            check.message = check.actual_text + " is not finite";
        }
        check.measured = std::move(compared.measured);
        if (expected.size() > 0) check.expected_text = json::one_line(expected);
        end(std::move(check));
    }
}

void CaseRun::check_text() {
    Check check = begin(CheckKind::text, "glsl", test_.object.find("glsl"));
    const fs::path golden = test_.golden(".glsl");
    check.baseline = golden.string();
    std::string why;
    std::error_code ignored;
    const auto expected = read_file(golden, why);
    if (!expected) {
        check.message = golden.string() + ": " + why;
        if (!fs::exists(golden, ignored))
            set_new(check);
        else
            check.status = Status::failed;
    } else if (*expected != material_.shader.source) {
        check.status = Status::failed;
        check.message =
            golden.string() + ": " + text_difference(*expected, material_.shader.source);
        check.expected_text = *expected;
    }
    if (check.status != Status::passed) {
        check.actual_text = material_.shader.source;
        check.nodes_of_lines = nodes_of_lines(material_);
    }
    end(std::move(check));
}

void CaseRun::check_budget() {
    Check check = begin(CheckKind::cost, "budget", test_.budget_value);
    std::string why;
    const auto measured = measure_budget(
        test_.budget,
        {material_.screen->compiled.module, material_.shader.source.size(), material_.compile_ms},
        why);
    if (!measured) {
        check.status = Status::error;
        check.message = "its cost cannot be counted: " + why;
        outcome_.environment = check.message;
    } else {
        check.measured = *measured;
        for (const report::Measured& each : check.measured)
            if (!each.within())
                check.message += (check.message.empty() ? "" : "; ") + each.name + " is " +
                                 each.actual + ", " + each.expected + " allowed" +
                                 (each.node.empty() ? "" : ", most of it in " + each.node);
        if (!check.message.empty()) check.status = Status::failed;
    }
    end(std::move(check));
}

void CaseRun::check_image() {
    Check check = begin(CheckKind::image, "render", test_.render->value);
    check.baseline = test_.golden(".png").string();
    const std::string inputs = settings_.images ? hash() : "";
    const DrawnCase drawn = draw_case(test_, material_, settings_.images, inputs, problems_);
    if (!drawn.environment.empty()) {
        check.status = Status::error;
        check.message = outcome_.environment = drawn.environment;
        return end(std::move(check));
    }
    outcome_.driver = drawn.driver;
    if (drawn.image) compare_image(*drawn.image, std::move(check));
}

void CaseRun::compare_image(const Image& image, Check check) {
    Diagnostics missing;
    std::error_code ignored;
    const auto expected = load_image(check.baseline, missing);
    ImageComparison compared;
    if (!expected) {
        check.message = missing.list().front().message;
        if (!fs::exists(check.baseline, ignored))
            set_new(check);
        else
            check.status = Status::failed;
    } else {
        compared = compare_images(*test_.render, *expected, image);
        check.measured = std::move(compared.measured);
        check.message = std::move(compared.difference);
        if (!check.message.empty()) check.status = Status::failed;
    }
    if (check.status != Status::passed) {
        const CheckImages images{expected ? &*expected : nullptr, image, compared};
        std::string why;
        // A case has its verdict without the default folder.
        if (!save_images(images, settings_.folder, test_.flat_name(), check, why) &&
            settings_.folder != default_report)
            outcome_.environment = why;
    }
    end(std::move(check));
}

Check CaseRun::begin(CheckKind kind, const std::string& name, const json::Value& place) const {
    Check check;
    check.kind = kind;
    check.test = test_.full_name();
    check.name = name;
    check.file = test_.file.string();
    check.graph = test_.graph.string();
    const Diagnostic at = diagnose(place, "", RuleId::test_failed, "", "");
    check.line = at.where.line;
    check.column = at.where.column;
    check.pointer = at.pointer;
    return check;
}

void CaseRun::end(Check check) {
    check.seconds = watch_.seconds();
    watch_ = {};
    if (check.status != Status::passed) {
        check.inputs = hash();
    } else {
        check.actual_text.clear();
        check.expected_text.clear();
        if (check.kind == CheckKind::point) check.measured.clear();
    }
    outcome_.checks.push_back(std::move(check));
}

void CaseRun::add_error() {
    Check check = begin(CheckKind::none, "case", test_.object);
    check.status = Status::error;
    check.message = cannot_run(problems_);
    end(std::move(check));
}

void CaseRun::add_uses() {
    const std::optional<MaterialRun>& run = material_.given ? material_.given : material_.screen;
    if (!run) return;
    report::CaseUses& uses = outcome_.uses.emplace_back();
    for (const Check& check : outcome_.checks)
        if (check.test == test_.full_name() && check.status == Status::failed) uses.failed = true;
    for (const std::string& path : input_paths(run->project, settings_.registry))
        uses.uses.push_back("file " + near_path(path).generic_string());
    for (const Project::File& file : run->project.files)
        for (const auto& node : file.document.nodes)
            uses.uses.push_back("node " + node->type);
}

}  // namespace

TestOutcome run_test_file(const TestFile& file, const TestSettings& settings) {
    TestOutcome outcome;
    outcome.problems = file.problems;
    if (file.problems.has_errors()) {
        Check check;
        check.test = near_path(file.path).generic_string();
        check.name = "file";
        check.file = file.path.string();
        check.status = Status::error;
        check.message = cannot_run(file.problems);
        outcome.checks.push_back(check);
    }
    for (const TestCase& test : file.cases)
        CaseRun(test, settings, outcome).run();
    return outcome;
}

}  // namespace wrinkle::cli
