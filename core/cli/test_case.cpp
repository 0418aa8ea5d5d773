#include "cli/test_case.h"

#include <algorithm>

#include "base/file.h"
#include "base/text.h"
#include "cli/meshes.h"
#include "cli/output.h"
#include "cli/session.h"
#include "json/parse.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

using json::Kind;
using json::Value;

// Reads the keys into a test case and reports problems at their values.
class CaseReader {
public:
    CaseReader(TestCase& test, Diagnostics& diagnostics) : test_(test), diagnostics_(diagnostics) {}

    void read(const Value& root, bool updating) {
        if (!wants(root, Kind::object, "a test file")) return;
        for (const json::Member& member : root.children())
            if (is_known(member, case_keys())) read_key(member);
        if (test_.points.count() == 0 && !test_.glsl && !test_.render)
            error(root, "there is no case in this file", "points, \"glsl\": true or render");
        if (updating) return;
        for (const json::Member& entry : test_.expect.children())
            if (entry.value.size() == 0)
                error(entry.value, "this entry expects nothing", "at least one output");
        const size_t expected = test_.expect.size();
        if (expected != test_.points.count())
            error(root.has("expect") ? test_.expect : root,
                  std::to_string(test_.points.count()) + " points, but " +
                      std::to_string(expected) + " entries in 'expect'",
                  "one for each point; --update writes them");
    }

private:
    void read_key(const json::Member& member) {
        const auto& [key, value] = member;
        if (key == "set")
            read_set(value);
        else if (key == "points")
            test_.points = read_points(value, diagnostics_);
        else if (key == "expect")
            read_expect(value);
        else if (key == "tolerance_deg")
            read_tolerance(member, test_.tolerance_deg);
        else if (key == "tolerance")
            read_tolerance(member, test_.tolerance);
        else if (key == "glsl")
            test_.glsl = wants(value, Kind::boolean, "glsl") && value.as_boolean();
        else if (key == "render")
            read_render(value);
    }

    void read_set(const Value& value) {
        if (!wants(value, Kind::array, "set")) return;
        for (const json::Member& member : value.children())
            if (wants(member.value, Kind::string, "a value of 'set'"))
                test_.set.emplace_back(member.value.as_string());
    }

    void read_expect(const Value& value) {
        if (!wants(value, Kind::array, "expect")) return;
        test_.expect = value;
        for (const json::Member& member : value.children())
            wants(member.value, Kind::object, "an entry of 'expect'");
    }

    void read_tolerance(const json::Member& member, double& tolerance) {
        const std::string name(member.key);
        if (!wants(member.value, Kind::number, name.c_str())) return;
        tolerance = member.value.as_number();
        if (tolerance < 0) error(member.value, name + " is negative", "0 or more");
    }

    void read_render(const Value& value) {
        if (!wants(value, Kind::object, "render")) return;
        RenderCase& render = test_.render.emplace();
        for (const json::Member& member : value.children()) {
            if (!is_known(member, render_keys())) continue;
            if (member.key == "tolerance")
                read_tolerance(member, render.tolerance);
            else if (member.key == "mesh")
                read_mesh(member.value, render);
            else if (member.key == "view")
                read_view(member.value, render.options);
            else if (member.key == "size")
                read_size(member.value, render.options);
            else if (member.key == "against" && wants(member.value, Kind::string, "against"))
                render.options.against = member.value.as_string();
            else if (member.key == "displace" && wants(member.value, Kind::boolean, "displace"))
                render.options.displace = member.value.as_boolean();
        }
    }

    void read_mesh(const Value& value, RenderCase& render) {
        if (!wants(value, Kind::string, "mesh")) return;
        render.mesh = value;
        render.options.mesh = value.as_string();
        if (!check_mesh(render.options.mesh).empty())
            error(value, "mesh: there is no '" + render.options.mesh + "'", mesh_help());
    }

    void read_view(const Value& value, RenderOptions& options) {
        if (!wants(value, Kind::string, "view")) return;
        const auto view = gpu::view_named(value.as_string());
        if (view)
            options.view = *view;
        else
            error(value, "view: there is no '" + std::string(value.as_string()) + "'",
                  joined(gpu::view_names(), ", "));
    }

    void read_size(const Value& value, RenderOptions& options) {
        if (!value.is(Kind::string) ||
            !parse_size(std::string(value.as_string()), options.width, options.height))
            error(value, "size does not fit", "a text such as \"512x512\"");
    }

    bool is_known(const json::Member& member, std::span<const CaseKey> keys) {
        const std::vector<std::string> names = names_of(keys);
        if (std::find(names.begin(), names.end(), member.key) != names.end()) return true;
        error(member.value, "unknown key '" + std::string(member.key) + "'",
              did_you_mean(member.key, names, joined(names, ", ")));
        return false;
    }

    bool wants(const Value& value, Kind kind, const char* what) {
        if (value.is(kind)) return true;
        error(value, std::string(what) + " is " + json::kind_name(value.kind()),
              json::kind_name(kind));
        return false;
    }

    void error(const Value& value, std::string message, std::string expected) {
        report_at(value, std::move(message), std::move(expected), diagnostics_);
    }

    TestCase& test_;
    Diagnostics& diagnostics_;
};

// Returns the offset after the array or object at `begin`. Precondition: `text` is valid JSON.
size_t end_of_container(std::string_view text, size_t begin) {
    int depth = 0;
    bool in_string = false;
    for (size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string && c == '\\')
            ++i;
        else if (c == '"')
            in_string = !in_string;
        else if (!in_string && (c == '[' || c == '{'))
            ++depth;
        else if (!in_string && (c == ']' || c == '}') && --depth == 0)
            return i + 1;
    }
    return text.size();
}

bool is_test(const fs::path& path) {
    return path.filename().string().ends_with(test_suffix);
}

// Adds the tests below a folder. An unreadable folder is an error, so that its tests are not
// skipped silently. Symbolic links to folders are not followed.
void find_below(const fs::path& top, std::vector<fs::path>& tests, Diagnostics& diagnostics) {
    std::vector<fs::path> folders{top};
    while (!folders.empty()) {
        const fs::path folder = std::move(folders.back());
        folders.pop_back();
        std::error_code problem, ignored;
        for (fs::directory_iterator at(folder, problem), end; !problem && at != end;
             at.increment(problem)) {
            if (at->is_directory(ignored) && !at->is_symlink(ignored))
                folders.push_back(at->path());
            else if (is_test(at->path()) && !inside(top, link_target(at->path())))
                diagnostics.error(
                    at->path().string() + ": leads outside the folder " + top.string(),
                    "name it itself, or remove the link");
            else if (is_test(at->path()))
                tests.push_back(at->path());
        }
        if (problem)
            diagnostics.error(folder.string() + ": cannot be searched: " + problem.message());
    }
}

}  // namespace

fs::path TestCase::golden(const std::string& extension) const {
    return file.parent_path() / "golden" / (name + extension);
}

std::optional<TestCase> read_test_case(const fs::path& file, bool updating,
                                       Diagnostics& diagnostics) {
    Diagnostics own;
    TestCase test;
    test.file = file;
    const std::string leaf = file.filename().string();
    test.name = leaf.substr(0, leaf.size() - test_suffix.size());
    test.graph = file.parent_path() / (test.name + ".json");
    if (const auto text = read_text(file.string(), own)) {
        test.text = *text;
        const json::Parsed parsed = json::parse(*text, file.string(), own);
        if (!own.has_errors()) CaseReader(test, own).read(parsed.root, updating);
    }
    diagnostics.append(own);
    if (own.has_errors()) return {};
    return test;
}

std::string with_expect(const TestCase& test, const std::vector<std::string>& entries) {
    std::string list = "[";
    for (const std::string& entry : entries)
        list += (list.size() > 1 ? ",\n    " : "\n    ") + entry;
    list += entries.empty() ? "]" : "\n  ]";
    const std::string& text = test.text;
    if (test.expect.has_location()) {
        const size_t begin = test.expect.offset();
        return text.substr(0, begin) + list + text.substr(end_of_container(text, begin));
    }
    const size_t brace = text.rfind('}');
    const size_t last = text.find_last_not_of(" \t\r\n", brace - 1);
    const char* comma = text[last] == '{' ? "" : ",";
    return text.substr(0, last + 1) + comma + "\n  \"expect\": " + list + "\n" + text.substr(brace);
}

std::vector<fs::path> find_tests(const std::vector<std::string>& paths, Diagnostics& diagnostics) {
    std::vector<fs::path> tests;
    for (const std::string& path : paths) {
        std::vector<fs::path> found;
        std::error_code ignored;
        if (fs::is_directory(path, ignored))
            find_below(path, found, diagnostics);
        else if (is_test(path))
            found.push_back(path);
        if (found.empty() && !diagnostics.has_errors())
            diagnostics.error(path + ": there is no test",
                              "a file NAME.test.json, or a folder with such files in or below it");
        std::sort(found.begin(), found.end());
        tests.insert(tests.end(), found.begin(), found.end());
    }
    return tests;
}

}  // namespace wrinkle::cli
