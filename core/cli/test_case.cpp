#include "cli/test_case.h"

#include <algorithm>

#include "base/file.h"
#include "cli/session.h"
#include "json/parse.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

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
                    RuleId::outside_root,
                    at->path().string() + ": leads outside the folder " + top.string(),
                    "name it itself, or remove the link");
            else if (is_test(at->path()))
                tests.push_back(at->path());
        }
        if (problem)
            diagnostics.error(RuleId::file_unreadable,
                              folder.string() + ": cannot be searched: " + problem.message());
    }
}

}  // namespace

fs::path TestCase::golden(const std::string& extension) const {
    return file.parent_path() / "golden" / (name + extension);
}

std::vector<fs::path> TestCase::golden_files() const {
    std::vector<fs::path> files;
    if (glsl) files.push_back(golden(".glsl"));
    if (render) files.push_back(golden(".png"));
    return files;
}

std::string TestCase::full_name() const {
    return near_path(file.parent_path() / name).generic_string();
}

std::string TestCase::flat_name() const {
    std::string flat;
    for (const fs::path& part : fs::path(full_name()))
        if (part != "." && part != ".." && part != "/" && !part.empty())
            flat += (flat.empty() ? "" : "-") + part.string();
    return flat;
}

fs::path root_of(const TestCase& test, const CommonOptions& common) {
    if (!common.root.empty()) return common.root;
    return test.file.has_parent_path() ? test.file.parent_path() : ".";
}

fs::path near_path(const fs::path& path) {
    if (!path.is_absolute()) return path.lexically_normal();
    std::error_code ignored;
    return path_from(fs::current_path(ignored), path);
}

std::vector<TestCase> read_test_cases(const fs::path& file, Diagnostics& diagnostics) {
    Diagnostics own;
    std::vector<TestCase> cases;
    TestCase test;
    test.file = file;
    const std::string leaf = file.filename().string();
    test.name = leaf.substr(0, leaf.size() - test_suffix.size());
    test.graph = file.parent_path() / (test.name + ".json");
    if (const auto text = read_text(file.string(), own)) {
        test.text = *text;
        const json::Parsed parsed = json::parse(*text, file.string(), own);
        if (!own.has_errors()) cases = read_case_keys(parsed.root, std::move(test), own);
    }
    diagnostics.append(own);
    if (own.has_errors()) return {};
    return cases;
}

TestFile read_test_file(const fs::path& path) {
    TestFile file;
    file.path = path;
    file.cases = read_test_cases(path, file.problems);
    return file;
}

std::string container_text(const json::Value& container) {
    const std::string_view text = container.source();
    const size_t begin = container.offset();
    return std::string(text.substr(begin, end_of_container(text, begin) - begin));
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
    const size_t brace = end_of_container(text, test.object.offset()) - 1;
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
            diagnostics.error(RuleId::test_case, path + ": there is no test",
                              "a file NAME.test.json, or a folder with such files in or below it");
        std::ranges::sort(found);
        tests.insert(tests.end(), found.begin(), found.end());
    }
    return tests;
}

}  // namespace wrinkle::cli
