// Tests that the tree follows its rules, and that the rules detect violations.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "layout/rules.h"
#include "support/files.h"

namespace wrinkle::layout {
namespace {

namespace fs = std::filesystem;

std::vector<Source> sources_below(const std::string& top) {
    const fs::path root = WRINKLE_SOURCE_DIR;
    std::vector<Source> sources;
    if (!fs::is_directory(root / top)) return sources;
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
        const auto extension = entry.path().extension();
        if (extension != ".h" && extension != ".cpp" && extension != ".c") continue;
        sources.push_back(
            {entry.path().lexically_relative(root).generic_string(), test::bytes_of(entry.path())});
    }
    std::sort(sources.begin(), sources.end(),
              [](const Source& a, const Source& b) { return a.path < b.path; });
    return sources;
}

using Check = std::vector<std::string> (*)(const Source&);

class Tree : public testing::TestWithParam<std::string> {
protected:
    static void expect_none(Check check) {
        const auto sources = sources_below(GetParam());
        EXPECT_FALSE(sources.empty()) << "nothing to check below " << GetParam();
        for (const Source& source : sources)
            for (const std::string& violation : check(source))
                ADD_FAILURE() << violation;
    }
};

TEST_P(Tree, IncludesOnlyWhatItsFolderMay) {
    expect_none(include_violations);
}
TEST_P(Tree, LinesFit) {
    expect_none(column_violations);
}
TEST_P(Tree, FilesAndFunctionsAreShort) {
    expect_none(length_violations);
}
TEST_P(Tree, NothingIsLeftForLater) {
    expect_none(word_violations);
}
TEST_P(Tree, FilesOfTestsAreCalledSo) {
    expect_none(name_violations);
}

INSTANTIATE_TEST_SUITE_P(Folders, Tree,
                         testing::Values("core", "nodes", "plugins", "editor", "tests"),
                         [](const auto& row) { return row.param; });

size_t count_of(Check check, const std::string& path, const std::string& text) {
    return check({path, text}).size();
}

TEST(Rules, FolderOfAPath) {
    EXPECT_EQ(folder_of("core/ir/module.h"), "core/ir");
    EXPECT_EQ(folder_of("core/image/png/session.h"), "core/image");
    EXPECT_EQ(folder_of("editor/model/document/history.h"), "editor/model");
    EXPECT_EQ(folder_of("nodes/uv.cpp"), "nodes");
}

TEST(Rules, AnIncludeOfALaterFolderIsFound) {
    EXPECT_EQ(count_of(include_violations, "core/ir/a.cpp", "#include \"emit/emit.h\"\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "core/ir/a.cpp", "  # include <emit/emit.h>\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "core/base/a.h", "#include \"ir/module.h\"\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "core/cpu/a.h", "#include \"editor/view/state.h\"\n"),
              1u);
    EXPECT_EQ(count_of(include_violations, "nodes/a.cpp", "#include \"ir/module.h\"\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "plugins/a/a.cpp", "#include \"base/text.h\"\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "editor/view/a.cpp", "#include \"nodes/noise.h\"\n"),
              1u);
    EXPECT_EQ(count_of(include_violations, "core/new/a.cpp", ""), 1u);
}

TEST(Rules, TheEditorsModelKnowsNoWindow) {
    for (const char* include : {"<imgui.h>", "<epoxy/gl.h>", "\"gpu/context.h\"",
                                "\"editor/view/state.h\"", "\"editor/app/window.h\""})
        EXPECT_EQ(count_of(include_violations, "editor/model/document/a.h",
                           "#include " + std::string(include) + "\n"),
                  1u)
            << include;
    EXPECT_EQ(count_of(include_violations, "editor/model/code/a.h",
                       "#include \"editor/model/document/model.h\"\n"),
              0u);
    EXPECT_EQ(count_of(include_violations, "editor/view/canvas/a.h",
                       "#include \"editor/app/window.h\"\n"),
              1u);
}

TEST(Rules, ALibraryOutsideItsFolderIsFound) {
    EXPECT_EQ(count_of(include_violations, "core/graph/a.cpp", "#include <nlohmann/json.hpp>\n"),
              1u);
    EXPECT_EQ(count_of(include_violations, "core/mesh/a.cpp", "#include <OpenImageIO/u.h>\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "core/mesh/a.cpp", "#include <epoxy/gl.h>\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "core/cli/a.cpp", "#include <imgui.h>\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "core/ir/a.cpp", "#include <glm/vec3.hpp>\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "core/ir/a.cpp", "#include <zlib.h>\n"), 1u);
}

TEST(Rules, TheCppFaceIsForNodesAlone) {
    EXPECT_EQ(count_of(include_violations, "core/ir/a.h", "#include <wrinkle/plugin.h>\n"), 0u);
    EXPECT_EQ(count_of(include_violations, "core/ir/a.h", "#include <wrinkle/node.h>\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "core/mesh/a.h", "#include <wrinkle/plugin.h>\n"), 1u);
    EXPECT_EQ(count_of(include_violations, "nodes/a.cpp", "#include \"wrinkle/node.h\"\n"), 0u);
}

TEST(Rules, WhatTheTableAllowsPasses) {
    EXPECT_EQ(count_of(include_violations, "core/emit/a.cpp",
                       "#include \"emit/emit.h\"\n#include <vector>\n#include <unistd.h>\n"
                       "#include \"ir/module.h\"\n#include <sys/stat.h>\n#include \"near.h\"\n"),
              0u);
    EXPECT_EQ(count_of(include_violations, "editor/view/a.cpp",
                       "#include \"glm/a.h\"\n#include <imgui.h>\n#include \"cpu/x.h\"\n"),
              0u);
    EXPECT_EQ(count_of(include_violations, "core/base/a.h", "// #include \"ir/module.h\"\n"), 0u);
}

TEST(Rules, LongLinesAreFoundButInTables) {
    const std::string wide = "int a; " + std::string(94, '+') + "\n";
    EXPECT_EQ(count_of(column_violations, "core/ir/a.cpp", wide), 1u);
    EXPECT_EQ(count_of(column_violations, "core/ir/a.cpp", wide.substr(1)), 0u);
    EXPECT_EQ(count_of(column_violations, "core/ir/a.cpp",
                       "// clang-format off\n" + wide + "// clang-format on\n" + wide),
              1u);
    std::string accents = "a b";
    for (int i = 0; i < 97; ++i)
        accents += "é";
    EXPECT_EQ(count_of(column_violations, "core/ir/a.cpp", accents + "\n"), 0u);
    EXPECT_EQ(count_of(column_violations, "core/ir/a.cpp", accents + "é\n"), 1u);
}

std::string function_of(size_t lines) {
    std::string text = "namespace n {\nint f(int a,\n      int b) {\n";
    for (size_t i = 3; i < lines; ++i)
        text += i % 2 ? "    g();\n" : "\n";
    return text + "}\n}  // namespace n\n";
}

TEST(Rules, LongFunctionsAndFilesAreFound) {
    EXPECT_EQ(count_of(length_violations, "core/ir/a.cpp", function_of(max_function_lines)), 0u);
    EXPECT_EQ(count_of(length_violations, "core/ir/a.cpp", function_of(max_function_lines + 1)),
              1u);
    std::string file(max_file_lines, '\n');
    EXPECT_EQ(count_of(length_violations, "core/ir/a.cpp", file), 0u);
    EXPECT_EQ(count_of(length_violations, "core/ir/a.cpp", file + "\n"), 1u);
}

TEST(Rules, DataMayBeWide) {
    const std::string wide = "int a; " + std::string(100, '+') + "\n";
    const std::string open = std::string("auto s = R") + "\"x(\n", close = ")x\";\n";
    EXPECT_EQ(count_of(column_violations, "tests/ir/a.cpp", open + wide + close), 0u);
    EXPECT_EQ(count_of(column_violations, "tests/ir/a.cpp", open + ")\"\n" + wide + close), 0u);
    EXPECT_EQ(count_of(column_violations, "tests/ir/a.cpp", open + close + wide), 1u);
}

TEST(Rules, WhatAProgramWritesIsNoIncludeOfItsOwn) {
    const std::string text = "auto s = R\"(\n#include <wrinkle/node.h>\n)\";\n";
    EXPECT_EQ(count_of(include_violations, "core/cli/a.cpp", text), 0u);
    EXPECT_EQ(count_of(include_violations, "core/cli/a.cpp", text + "#include <imgui.h>\n"), 1u);
}

TEST(Rules, LabelsOfASwitchAreNotCounted) {
    std::string text = "int f(int a) {\n    switch (a) {\n";
    for (int i = 0; i < 30; ++i)
        text += "        case " + std::to_string(i) + ":\n            return 1;\n";
    EXPECT_EQ(count_of(length_violations, "core/ir/a.cpp", text + "    }\n}\n"), 0u);
    for (int i = 0; i < 10; ++i)
        text += "        g();\n";
    EXPECT_EQ(count_of(length_violations, "core/ir/a.cpp", text + "    }\n}\n"), 1u);
}

TEST(Rules, FilesOfTestsHaveOneFormOfName) {
    const std::string text = "TEST_F(A, B) {\n}\n";
    EXPECT_EQ(count_of(name_violations, "tests/ir/fold_test.cpp", text), 0u);
    EXPECT_EQ(count_of(name_violations, "tests/ir/test_fold.cpp", text), 1u);
    EXPECT_EQ(count_of(name_violations, "tests/ir/fold_test.cpp", "int a;\n"), 1u);
    EXPECT_EQ(count_of(name_violations, "tests/ir/support.cpp", "int a;\n"), 0u);
}

TEST(Rules, UnfinishedWorkIsFound) {
    const std::string word = std::string("TO") + "DO";
    EXPECT_EQ(count_of(word_violations, "core/ir/a.cpp", "int a;  // " + word + ": more\n"), 1u);
    EXPECT_EQ(count_of(word_violations, "core/ir/a.cpp", "int a;  // to do\n"), 0u);
    EXPECT_EQ(all_violations({"core/ir/a.cpp", "#include <imgui.h>\n// " + word + "\n"}).size(),
              2u);
}

}  // namespace
}  // namespace wrinkle::layout
