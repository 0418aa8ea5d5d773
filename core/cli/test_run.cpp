#include "cli/test_run.h"

#include <cmath>
#include <cstdio>

#include "base/file.h"
#include "base/printable.h"
#include "base/text.h"
#include "cli/eval_text.h"
#include "cli/meshes.h"
#include "cli/output.h"
#include "image/load.h"
#include "json/write.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

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

// Names the case in messages.
std::string title(const TestCase& test) {
    return test.file.string() + (test.entry.empty() ? "" : ": case " + test.entry);
}

// Opens the mesh of a render case; a path is resolved like the image paths of the graph. Returns
// std::nullopt and reports an error on failure.
std::optional<Mesh> mesh_of(const RenderCase& render, const Project& project,
                            const CommonOptions& common, Diagnostics& diagnostics) {
    const std::string& name = render.options.mesh;
    if (!is_mesh_path(name)) return open_mesh(name, common, diagnostics);
    if (const auto path = resolve_file(project, 0, name))
        return open_mesh(path->string(), common, diagnostics);
    report_at(render.mesh, "mesh names " + json_quoted(name) + ", outside the root",
              "keep it below " + project.root.string() + ", or choose another root with --root",
              diagnostics);
    return {};
}

}  // namespace

void TestRun::test(const fs::path& file, Diagnostics& diagnostics) {
    Diagnostics reading;
    std::vector<TestCase> cases = read_test_cases(file, options_.update, reading);
    conclude(file.string(), reading, diagnostics);
    for (size_t i = 0; i < cases.size(); ++i) {
        Diagnostics own;
        run(cases[i], own);
        conclude(title(cases[i]), own, diagnostics);
        // An update may have moved the text of the cases after it.
        if (options_.update) cases = read_test_cases(file, true, diagnostics);
    }
}

// Counts a case that could not run, and appends its problems.
void TestRun::conclude(const std::string& title, const Diagnostics& own, Diagnostics& diagnostics) {
    diagnostics.append_once(own);
    if (!own.has_errors()) return;
    ++tally_.failed;
    std::printf("FAIL %s\n", printable(title + ": cannot be run").c_str());
}

void TestRun::run(const TestCase& test, Diagnostics& diagnostics) {
    CommonOptions common = common_;
    common.set = test.set;
    if (!test.preset.empty()) common.presets = {preset_of(test, diagnostics)};
    const std::string graph = test.graph.string();
    for (const fs::path& file : {test.graph, test.golden(".glsl"), test.golden(".png")})
        refuse_outside(file, test, diagnostics);
    const Overrides overrides = parse_overrides(common, diagnostics);
    if (overrides.is_sweep())
        diagnostics.error(test.file.string() + ": 'set' holds a sweep", "one value");
    std::optional<MaterialRun> given, screen;
    TextureStore textures;
    const auto compile = [&](const MaterialOptions& options, std::optional<MaterialRun>& result) {
        const auto keep = [&](size_t, const MaterialRun& run, Diagnostics&) { result = run; };
        if (!diagnostics.has_errors())
            compile_runs(graph, common, registry_, overrides, options, keep, diagnostics);
    };
    const bool displaced = test.render && test.render->options.displace;
    if (test.points.count() > 0 || displaced)
        compile({.given_differentials = true, .runs_calls = "eval"}, given);
    if (test.glsl || test.render) compile({.runs_calls = "render"}, screen);
    if (diagnostics.has_errors()) return;
    Shader shader;
    if (screen) shader = emit_function(*screen, material_name(graph), diagnostics);
    if (diagnostics.has_errors()) return;
    if (given) read_textures(textures, given->compiled, given->project, diagnostics);
    if (!diagnostics.has_errors() && test.render)
        read_textures(textures, screen->compiled, screen->project, diagnostics);
    if (!diagnostics.has_errors() && test.points.count() > 0)
        values(test, *given, textures, diagnostics);
    if (diagnostics.has_errors()) return;
    if (test.glsl) text(test, shader);
    if (!test.render) return;
    const auto still = mesh_of(*test.render, screen->project, common, diagnostics);
    std::optional<Mesh> moved;
    if (still && displaced) moved = displaced_mesh(*still, *given, textures, diagnostics);
    if (still && !diagnostics.has_errors())
        image(test, shader, *still, moved, textures, diagnostics);
}

// Reports an error if `file`, which is derived from the name of the test, is outside the root after
// links are resolved. The same rule applies to files that a graph names.
void TestRun::refuse_outside(const fs::path& file, const TestCase& test, Diagnostics& diagnostics) {
    const fs::path folder = test.file.has_parent_path() ? test.file.parent_path() : ".";
    const fs::path root = common_.root.empty() ? folder : fs::path(common_.root);
    if (inside(root, link_target(file))) return;
    diagnostics.error(file.string() + ": leads outside the root " + root.string(),
                      "a file below it, or another root with --root");
}

// Returns the preset with the path of a file relative to the working folder.
std::string TestRun::preset_of(const TestCase& test, Diagnostics& diagnostics) {
    if (!test.preset.ends_with(".json")) return test.preset;
    const fs::path file = test.file.parent_path() / test.preset;
    refuse_outside(file, test, diagnostics);
    return file.string();
}

void TestRun::values(const TestCase& test, const MaterialRun& run, const TextureStore& textures,
                     Diagnostics& diagnostics) {
    const auto columns = evaluate_points(run, textures, {test.points}, precision, diagnostics);
    if (!columns) return;
    std::vector<bool> differs(test.points.count());
    for (size_t point = 0; point < test.points.count(); ++point) {
        const json::Value expected = entry_of(test, point);
        const auto sentences = differences(test, run.project.top(), expected, *columns, point);
        differs[point] = !sentences.empty() || expected.size() == 0;
        if (options_.update && is_finite(*columns, point))
            pass();
        else if (options_.update)
            fail(test, test.points.sources[point], "",
                 "point " + std::to_string(point) + ": " + values_json(*columns, point, precision) +
                     " is not finite");
        else if (sentences.empty())
            pass();
        else
            fail(test, test.points.sources[point], "",
                 "point " + std::to_string(point) + ", " + joined(sentences, "; "));
    }
    if (options_.update) update_values(test, *columns, differs);
}

// Rewrites "expect"; entries within the tolerance are copied unchanged.
void TestRun::update_values(const TestCase& test, const std::vector<OutputColumn>& columns,
                            const std::vector<bool>& differs) {
    std::vector<std::string> entries;
    bool changed = test.expect.size() != test.points.count();
    for (size_t point = 0; point < test.points.count(); ++point) {
        const json::Value entry = entry_of(test, point);
        if (!is_finite(columns, point)) return;
        changed = changed || differs[point];
        entries.push_back(differs[point] ? values_json(named_by(entry, columns), point, precision)
                                         : json::one_line(entry));
    }
    if (changed) write(test.file, with_expect(test, entries));
}

void TestRun::text(const TestCase& test, const Shader& shader) {
    const fs::path golden = test.golden(".glsl");
    if (options_.update) {
        if (write(golden, shader.source)) pass();
        return;
    }
    std::string why;
    const auto expected = read_file(golden, why);
    const std::string difference =
        expected ? text_difference(*expected, shader.source) : why + "; --update writes it";
    if (difference.empty()) return pass();
    fail(test, {}, "/glsl", golden.string() + ": " + difference);
    if (may_report(test, golden)) write(report_path(test, ".glsl"), shader.source);
}

void TestRun::image(const TestCase& test, const Shader& shader, const Mesh& still,
                    const std::optional<Mesh>& moved, const TextureStore& textures,
                    Diagnostics& diagnostics) {
    Diagnostics environment;
    const RenderOptions& options = test.render->options;
    auto renderer = OffscreenRenderer::make(options, still, environment);
    if (!renderer) {
        tally_.environment = environment.list().front().message;
        return;
    }
    if (moved) renderer->show(*moved);
    const auto drawn = renderer->draw(shader, textures, diagnostics);
    if (!drawn) return;
    const fs::path golden = test.golden(".png");
    if (options_.update) {
        if (save(drawn->image, golden)) pass();
        return;
    }
    Diagnostics missing;
    const auto expected = load_image(golden, missing);
    const double distance = expected ? image_difference(*expected, drawn->image) : -1;
    if (distance >= 0 && distance <= test.render->tolerance) return pass();
    fail(test, {}, "/render",
         golden.string() + ": " +
             (!expected      ? missing.list().front().message + "; --update writes it"
              : distance < 0 ? "is of another size"
                             : "the picture differs by " + std::to_string(distance) + " of 255, " +
                                   shortest(test.render->tolerance) + " allowed"));
    if (may_report(test, golden)) save(drawn->image, report_path(test, ".png"));
}

bool TestRun::may_report(const TestCase& test, const fs::path& golden) {
    if (options_.report.empty()) return false;
    const std::string read[] = {golden, test.file, test.graph};
    const std::string made[] = {report_path(test, golden.extension())};
    const std::string why = overwrite_fault(made, read);
    if (!why.empty()) tally_.environment = why;
    return why.empty();
}

bool TestRun::write(const fs::path& path, std::string_view bytes) {
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);
    std::string why;
    if (write_file(path, bytes, why)) return true;
    tally_.environment = path.string() + ": " + why;
    return false;
}

bool TestRun::save(const Image& image, const fs::path& path) {
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);
    Diagnostics problems;
    if (save_image(image, path, {}, problems)) return true;
    tally_.environment = problems.list().front().message;
    return false;
}

// Includes the folder in the file name, so that tests in different folders do not collide.
fs::path TestRun::report_path(const TestCase& test, const std::string& extension) const {
    std::string name;
    for (const fs::path& part : test.file.parent_path().lexically_normal())
        if (part != "." && part != ".." && part != "/" && !part.empty())
            name += part.string() + "-";
    return fs::path(options_.report) / (name + test.name + extension);
}

// Records a failure at `place`, or at the JSON pointer `pointer` if `place` has no location.
void TestRun::fail(const TestCase& test, const json::Value& place, const char* pointer,
                   const std::string& sentence) {
    ++tally_.failed;
    std::printf("FAIL %s\n", printable(title(test) + ": " + sentence).c_str());
    failures_.add(place.has_location()
                      ? diagnose(place, "", sentence, "")
                      : Diagnostic{Severity::error, Location{test.file.string()},
                                   test.object.pointer() + pointer, "", sentence, ""});
}

}  // namespace wrinkle::cli
