// Tests of sub-graphs in files of a temporary folder.
#include "graph/subgraph.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file.h"
#include "sample.h"
#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

class Subgraph : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder / "in" / "parts"); }

    // A graph with one node for each type, n0, n1, ...
    static std::string text_with(const std::vector<std::string>& types) {
        std::string nodes;
        for (size_t i = 0; i < types.size(); ++i)
            nodes += (i ? ",\n" : "") + ("\"n" + std::to_string(i)) + "\": {\"type\": \"" +
                     types[i] + "\"}";
        return graph_of(nodes);
    }
    void put(const std::string& name, const std::string& text) { temporary.put(name, text); }
    Project load(const std::string& name, ProjectOptions options = {}) {
        return load_project(folder / name, options, diagnostics);
    }
    // The report without the folder's path.
    std::string report() {
        std::string text = to_text(diagnostics);
        for (size_t at = text.find(folder.string()); at != text.npos;
             at = text.find(folder.string()))
            text.replace(at, folder.string().size(), "DIR");
        return text;
    }

    test::TemporaryFolder temporary;
    fs::path folder = temporary.path();
    Diagnostics diagnostics;
};

TEST_F(Subgraph, FilesAreReadOnceRelativeToTheirReader) {
    put("in/top.json", text_with({"graph:parts/a.json", "t", "graph:parts/../parts/a.json"}));
    put("in/parts/a.json", text_with({"graph:b.json"}));
    put("in/parts/b.json", text_with({"x", "y"}));
    const Project project = load("in/top.json");
    EXPECT_EQ(report(), "");
    ASSERT_EQ(project.files.size(), 3u);
    EXPECT_EQ(project.top().nodes.size(), 3u);
    EXPECT_EQ(project.subgraph(0, "n0"), &project.files[1]);
    EXPECT_EQ(project.subgraph(0, "n1"), nullptr);
    EXPECT_EQ(project.subgraph(0, "n2"), &project.files[1]);
    EXPECT_EQ(project.subgraph(0, "nobody"), nullptr);
    EXPECT_EQ(project.subgraph(1, "n0")->document.nodes.size(), 2u);
    EXPECT_EQ(project.files[2].document.file, (folder / "in/parts/b.json").string());
    EXPECT_EQ(project.root, folder / "in");
}

TEST_F(Subgraph, ProblemsAreThoseOfEachFile) {
    put("in/top.json", text_with({"graph:parts/a.json", "graph:none.json", "graph:"}));
    put("in/parts/a.json", "{\"wrinkle\": 1,");
    const Project project = load("in/top.json");
    EXPECT_EQ(report(),
              "DIR/in/parts/a.json:1:15: error: unexpected end of the file (expected a key in "
              "double quotes)\n"
              "DIR/in/top.json:3:1: error: node 'n1': sub-graph \"none.json\" cannot be read: No "
              "such file or directory (expected a graph file)\n"
              "DIR/in/top.json:4:1: error: node 'n2': sub-graph \"\" names no file (expected "
              "\"graph:FILE.json\")\n");
    EXPECT_EQ(project.subgraph(0, "n1"), nullptr);
}

TEST_F(Subgraph, NothingClimbsOutOfTheRoot) {
    put("outside.json", text_with({}));
    fs::create_symlink(folder / "outside.json", folder / "in/link.json");
    put("in/top.json", text_with({"graph:../outside.json", "graph:link.json",
                                  "graph:" + (folder / "outside.json").string()}));
    EXPECT_EQ(load("in/top.json").files.size(), 1u);
    EXPECT_EQ(diagnostics.error_count(), 3u);
    EXPECT_EQ(to_text(diagnostics.list()[0]).substr(folder.string().size()),
              "/in/top.json:2:1: error: node 'n0': sub-graph \"../outside.json\" is outside the "
              "root " +
                  (folder / "in").string() +
                  " (keep it below the root, or choose another with --root)");
    diagnostics = Diagnostics();
    EXPECT_EQ(load("in/top.json", {folder, {}}).files.size(), 2u);
    EXPECT_EQ(report(), "");
}

TEST_F(Subgraph, CyclesOfFiles) {
    put("in/top.json", text_with({"graph:a.json"}));
    put("in/a.json", text_with({"t", "graph:b.json", "graph:c.json"}));
    put("in/b.json", text_with({"graph:a.json", "graph:b.json"}));
    put("in/c.json", text_with({"t"}));
    const Project project = load("in/top.json");
    EXPECT_EQ(report(),
              "DIR/in/b.json:2:1: error: node 'n0': the sub-graph contains itself: DIR/in/a.json "
              "uses DIR/in/b.json uses DIR/in/a.json (remove one of these nodes)\n"
              "DIR/in/b.json:3:1: error: node 'n1': the sub-graph contains itself: DIR/in/b.json "
              "uses DIR/in/b.json (remove one of these nodes)\n");
    EXPECT_EQ(project.subgraph(2, "n0"), nullptr);
    EXPECT_NE(project.subgraph(1, "n2"), nullptr);
}

TEST_F(Subgraph, ALongChainOfFiles) {
    for (int i = 0; i < 300; ++i)
        put("in/f" + std::to_string(i) + ".json",
            text_with({"graph:f" + std::to_string(i + 1) + ".json"}));
    put("in/f300.json", text_with({"graph:f0.json"}));
    EXPECT_EQ(load("in/f0.json").files.size(), 301u);
    EXPECT_EQ(diagnostics.error_count(), 1u);
}

TEST_F(Subgraph, UsesOfAFileDoNotCount) {
    put("in/top.json", text_with({"graph:a.json", "t", "graph:a.json"}));
    put("in/a.json", text_with({"t", "graph:b.json"}));
    put("in/b.json", text_with({"t", "t"}));
    const Project project = load("in/top.json", {"", {7, 0}});
    EXPECT_EQ(report(), "");
    EXPECT_EQ(project.subgraph(0, "n0"), project.subgraph(0, "n2"));
    load("in/top.json", {"", {6, 0}});
    EXPECT_EQ(diagnostics.error_count(), 1u);
}

TEST_F(Subgraph, SixtyLevelsThatEachUseTheNextTwiceAreSixtyFiles) {
    for (int i = 0; i < 60; ++i) {
        const std::string next = "graph:f" + std::to_string(i + 1) + ".json";
        put("in/f" + std::to_string(i) + ".json", text_with({next, next}));
    }
    put("in/f60.json", text_with({"t"}));
    EXPECT_EQ(load("in/f0.json").files.size(), 61u);
    EXPECT_EQ(report(), "");
}

TEST_F(Subgraph, SpecialFilesAreNotOpened) {
    ASSERT_EQ(mkfifo((folder / "in/pipe").c_str(), 0600), 0);
    put("in/top.json", text_with({"graph:pipe", "graph:parts"}));
    load("in/top.json");
    EXPECT_EQ(report(),
              "DIR/in/top.json:2:1: error: node 'n0': sub-graph \"pipe\" is a pipe, not a file "
              "(expected a graph file)\n"
              "DIR/in/top.json:3:1: error: node 'n1': sub-graph \"parts\" is a folder, not a file "
              "(expected a graph file)\n");
}

TEST_F(Subgraph, ATopDocumentInMemory) {
    put("in/a.json", text_with({"t"}));
    Diagnostics quiet;
    Document top = read_document(text_with({"graph:a.json"}), "<stdin>", quiet);
    const Project project = load_project(std::move(top), folder / "in", {}, diagnostics);
    EXPECT_EQ(report(), "");
    ASSERT_EQ(project.files.size(), 2u);
    EXPECT_EQ(project.files[1].document.file, "a.json");
    EXPECT_EQ(project.root, folder / "in");
    EXPECT_EQ(*resolve_file(project, 0, "x/y.png"), folder / "in/x/y.png");
    EXPECT_FALSE(resolve_file(project, 0, "../y.png").has_value());
    EXPECT_FALSE(resolve_file(project, 0, std::string_view("a\0b", 3)).has_value());
}

TEST_F(Subgraph, ATopDocumentWithoutANameHasItsFolderAsRoot) {
    put("in/a.json", text_with({"t"}));
    Diagnostics quiet;
    for (const fs::path& given : {folder / "in", folder / "in" / ""}) {
        Document top = read_document(text_with({"graph:a.json"}), "", quiet);
        const Project project = load_project(std::move(top), given, {}, diagnostics);
        EXPECT_EQ(report(), "");
        EXPECT_EQ(project.files.size(), 2u);
        EXPECT_EQ(project.root, folder / "in");
        EXPECT_EQ(*resolve_file(project, 0, "x/y.png"), folder / "in/x/y.png");
        EXPECT_FALSE(resolve_file(project, 0, "../y.png").has_value());
    }
}

TEST_F(Subgraph, AMissingTopFile) {
    const Project project = load("in/absent.json");
    EXPECT_EQ(report(), "DIR/in/absent.json: error: cannot be read: No such file or directory\n");
    EXPECT_TRUE(project.top().nodes.empty());
}

TEST_F(Subgraph, TheNodeLimitIsOfAllFiles) {
    put("in/top.json", text_with({"graph:a.json", "t", "t"}));
    put("in/a.json", text_with({"t", "t"}));
    load("in/top.json", {"", {5, 0}});
    EXPECT_EQ(report(), "");
    load("in/top.json", {"", {4, 0}});
    EXPECT_EQ(report(),
              "DIR/in/a.json:3:1: error: the graph has more nodes than are allowed (the limit is "
              "4)\n");
}

}  // namespace
}  // namespace wrinkle
