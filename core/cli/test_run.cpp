#include "cli/test_run.h"

#include <chrono>
#include <cmath>

#include "base/file.h"
#include "base/text.h"
#include "cli/eval_text.h"
#include "cli/evaluation.h"
#include "cli/material_run.h"
#include "cli/test_accept.h"
#include "cli/test_compare.h"
#include "cli/test_image.h"
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

// Returns the path of the node of each line.
std::vector<std::string> nodes_of_lines(const Shader& shader, const Module& module) {
    std::vector<std::string> nodes;
    for (const uint32_t node : shader.reflection.lines)
        nodes.emplace_back(node == no_node ? "" : module.nodes[node].path);
    return nodes;
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
        : test_(test), settings_(settings), common_(settings.common), outcome_(outcome) {}

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
    void read_images();
    void refuse_outside(const fs::path& file);
    std::string preset_path();
    void check_points();
    void check_text();
    void check_budget();
    void check_image();
    void compare_image(const Image& image, Check check);
    const std::string& hash() {
        if (hash_.empty()) hash_ = hash_of_inputs(test_, settings_.registry, settings_.common);
        return hash_;
    }
    bool save(const Image& image, const char* folder, std::string& path);
    Check begin(CheckKind kind, const std::string& name, const json::Value& place) const;
    void end(Check check);
    void add_error();
    void add_uses();

    const TestCase& test_;
    const TestSettings& settings_;
    CommonOptions common_;  // with the preset and the values of the case
    TestOutcome& outcome_;
    Diagnostics problems_;
    std::optional<MaterialRun> given_, screen_;  // given and screen differentials
    Shader shader_;
    double compile_ms_ = 0;
    std::string hash_;  // hash(), once it is needed
    TextureStore textures_;
    Stopwatch watch_;  // since the last check
};

void CaseRun::compile() {
    common_.set = test_.set;
    if (!test_.preset.empty()) common_.presets = {preset_path()};
    for (const fs::path& file : {test_.graph, test_.golden(".glsl"), test_.golden(".png")})
        refuse_outside(file);
    const Overrides overrides = parse_overrides(common_, problems_);
    if (overrides.is_sweep())
        problems_.error(RuleId::test_case, test_.file.string() + ": 'set' holds a sweep",
                        "one value");
    const std::string graph = test_.graph.string();
    const auto compile_to = [&](std::optional<MaterialRun>& result,
                                const MaterialOptions& options) {
        const auto keep = [&](size_t, const MaterialRun& run, Diagnostics&) { result = run; };
        if (!problems_.has_errors())
            compile_runs(graph, common_, settings_.registry, overrides, options, keep, problems_);
    };
    const bool displaced = test_.render && test_.render->options.displace;
    if (test_.points.count() > 0 || displaced)
        compile_to(given_, {.given_differentials = true, .runs_calls = "eval"});
    const Stopwatch watch;
    if (test_.glsl || test_.render || !test_.budget.empty())
        compile_to(screen_, {.runs_calls = "render"});
    if (problems_.has_errors()) return;
    if (screen_) shader_ = emit_function(*screen_, material_name(graph), problems_);
    compile_ms_ = watch.seconds() * 1000;
    if (!problems_.has_errors()) read_images();
}

void CaseRun::read_images() {
    if (given_) read_textures(textures_, given_->compiled, given_->project, problems_);
    if (test_.render && !problems_.has_errors())
        read_textures(textures_, screen_->compiled, screen_->project, problems_);
}

// Reports an error if `file`, which is derived from the name of the test, is outside the root after
// links are resolved. The same rule applies to files that a graph names.
void CaseRun::refuse_outside(const fs::path& file) {
    const fs::path root = root_of(test_, common_);
    if (inside(root, link_target(file))) return;
    problems_.error(RuleId::outside_root,
                    file.string() + ": leads outside the root " + root.string(),
                    "a file below it, or another root with --root");
}

// Returns the preset with the path of a file relative to the working folder.
std::string CaseRun::preset_path() {
    if (!test_.preset.ends_with(".json")) return test_.preset;
    const fs::path file = test_.file.parent_path() / test_.preset;
    refuse_outside(file);
    return file.string();
}

void CaseRun::check_points() {
    const auto columns = evaluate_points(*given_, textures_, {test_.points}, precision, problems_);
    if (!columns) return;
    for (size_t point = 0; point < test_.points.count(); ++point) {
        Check check =
            begin(CheckKind::point, "points/" + std::to_string(point), test_.points.sources[point]);
        const json::Value expected = entry_of(test_, point);
        CaseComparison compared =
            compare_point(test_, given_->project.top(), expected, *columns, point);
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
    } else if (*expected != shader_.source) {
        check.status = Status::failed;
        check.message = golden.string() + ": " + text_difference(*expected, shader_.source);
        check.expected_text = *expected;
    }
    if (check.status != Status::passed) {
        check.actual_text = shader_.source;
        check.nodes_of_lines = nodes_of_lines(shader_, screen_->compiled.module);
    }
    end(std::move(check));
}

void CaseRun::check_budget() {
    Check check = begin(CheckKind::cost, "budget", test_.budget_value);
    std::string why;
    const auto measured = measure_budget(
        test_.budget, {screen_->compiled.module, shader_.source.size(), compile_ms_}, why);
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
    const CaseToDraw it{test_, *screen_, given_ ? &*given_ : nullptr, shader_, textures_, common_};
    const std::string inputs = settings_.images ? hash() : "";
    const DrawnCase drawn = draw_case(it, settings_.images, inputs, problems_);
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
        check.width = image.width;
        check.height = image.height;
        save(image, "actual", check.actual_image);
        if (expected) save(*expected, "expected", check.expected_image);
        if (!compared.map.empty()) {
            save(compared.map, "map", check.map_image);
            save(side_by_side({&*expected, &image, &compared.map}), "joined", check.joined_image);
        }
        check.map_measure = compared.map_measure;
        check.map_scale = compared.map_scale;
    }
    end(std::move(check));
}

// Sets `path`, relative to the report's folder.
bool CaseRun::save(const Image& image, const char* folder, std::string& path) {
    const fs::path relative = fs::path(folder) / (test_.flat_name() + ".png");
    const fs::path file = settings_.folder / relative;
    if (!is_in_report(settings_.folder, file)) return false;
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    Diagnostics problems;
    if (save_image(image, file, {}, problems)) {
        path = relative.generic_string();
        return true;
    }
    // A case has its verdict without the default folder.
    if (settings_.folder != default_report) outcome_.environment = problems.list().front().message;
    return false;
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
        check.measured.clear();
    }
    outcome_.checks.push_back(std::move(check));
}

void CaseRun::add_error() {
    Check check = begin(CheckKind::none, "case", test_.object);
    check.status = Status::error;
    check.message = "cannot be run";
    for (const Diagnostic& each : problems_.list())
        if (each.severity == Severity::error) {
            check.message += ": " + to_text(each);
            break;
        }
    end(std::move(check));
}

void CaseRun::add_uses() {
    const std::optional<MaterialRun>& run = given_ ? given_ : screen_;
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

TestFile read_test_file(const fs::path& path) {
    TestFile file;
    file.path = path;
    file.cases = read_test_cases(path, file.problems);
    return file;
}

TestOutcome run_test_file(const TestFile& file, const TestSettings& settings) {
    TestOutcome outcome;
    outcome.problems = file.problems;
    if (file.problems.has_errors()) {
        Check check;
        check.test = near_path(file.path).generic_string();
        check.name = "file";
        check.file = file.path.string();
        check.status = Status::error;
        check.message = "cannot be run: " + to_text(file.problems.list().front());
        outcome.checks.push_back(check);
    }
    for (const TestCase& test : file.cases)
        CaseRun(test, settings, outcome).run();
    return outcome;
}

}  // namespace wrinkle::cli
