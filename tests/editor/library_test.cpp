// Tests of the library, and of the images of graphs in the search and on the start page.
#include "editor/model/document/library.h"

#include <fstream>

#include "editor/model/document/files.h"
#include "editor/view/commands/commands.h"
#include "editor/view/preview/graph_images.h"
#include "graph/read.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

// A bump of an image and a sub-graph, as rock.json; another project has it in its library.
class Libraries : public Headless {
protected:
    void SetUp() override {
        const std::string image = texture("rivets_normal.png");
        folder.write("half.json", R"({"wrinkle": 1,
            "inputs": {"g": {"type": "gradient"}}, "nodes": {"s": {"type": "gradient_scale",
            "in": {"gradient": {"from": "input.g"}, "amount": 0.5}}},
            "outputs": {"g": {"from": "s.gradient"}}})");
        rock = folder.write("rock.json", R"({"wrinkle": 1, "nodes": {
            "map": {"type": "tangent_normal_map", "in": {"image": ")" +
                                             image + R"("}},
            "half": {"type": "graph:half.json", "in": {"g": {"from": "map.gradient"}}}},
            "outputs": {"normal": {"from": "half.g"}}, "layout": {"map": [0, 0]}})");
        open_file(state, rock);
        frame();
        play("assert errors 0");
    }
    fs::path entry() const { return home.path() / "library/rock"; }
    void add() {
        ASSERT_TRUE(run_command(state, "add-to-library")) << state.status;
        frame();
    }
    void open_other_project() {
        open_file(state, other.write("other.json", small_graph));
        frame();
    }
    void add_from_library() {
        play("click canvas+-100,200\nkey Space\ntype rock\nclick palette:library:rock");
    }
    size_t files_in(const fs::path& path) const {
        size_t count = 0;
        for (const auto& each : fs::recursive_directory_iterator(path))
            count += each.is_regular_file();
        return count;
    }

    TemporaryFolder other;
    fs::path rock;
};

TEST_F(Libraries, HaveTheGraphWithItsFiles) {
    add();
    EXPECT_EQ(state.status, "Added rock to the library: " + entry().string());
    EXPECT_EQ(files_in(home.path() / "library"), 3U);
    EXPECT_EQ(state.path, rock) << "another graph is open";
    play("assert clean");
    fs::rename(folder.path() / "half.json", folder.path() / "gone.json");
    open_file(state, entry() / "rock.json");
    frame();
    play("assert errors 0\nassert nodes 2");
    ASSERT_EQ(library_entries(state.keeping.folders).size(), 1U);
    EXPECT_EQ(library_entries(state.keeping.folders)[0].name, "rock");
}

TEST_F(Libraries, AreSearchedAndCopiedIntoTheProject) {
    add();
    open_other_project();
    add_from_library();
    play("assert nodes 5\nassert node rock\nassert errors 0");
    EXPECT_EQ(state.document().find("rock")->type, "graph:rock/rock.json");
    EXPECT_EQ(files_in(other.path() / "rock"), 3U);
    add_from_library();
    play("assert nodes 6\nassert errors 0");
    EXPECT_EQ(state.document().find("rock2")->type, "graph:rock/rock.json");
    EXPECT_FALSE(fs::exists(other.path() / "rock2")) << "equal files were copied again";
}

TEST_F(Libraries, NeverReplaceFilesOfTheProject) {
    add();
    open_other_project();
    other.write("rock.json", "{}");
    fs::create_directory(other.path() / "rock");
    other.write("rock/rock.json", "mine");
    add_from_library();
    EXPECT_EQ(text_of(other.path() / "rock/rock.json"), "mine");
    EXPECT_EQ(files_in(other.path() / "rock"), 1U) << "copies of a refused entry are left";
    EXPECT_EQ(state.document().find("rock")->type, "graph:rock2/rock.json");
    play("assert errors 0");
}

TEST_F(Libraries, AskBeforeTheyReplaceAnEntry) {
    add();
    const std::string before = text_of(entry() / "rock.json");
    state.commit("Remove", parsed(small_graph));
    frame();
    add();
    EXPECT_EQ(state.question.kind, Question::Kind::library);
    play("click answer:cancel");
    EXPECT_EQ(text_of(entry() / "rock.json"), before);
    add();
    play("click answer:library\nassert status Added rock to the library");
    EXPECT_NE(text_of(entry() / "rock.json"), before);
    EXPECT_EQ(files_in(home.path() / "library"), 1U) << "files of the former graph are left";
}

TEST_F(Libraries, NeedAFileAndAFolder) {
    EXPECT_EQ(why_not_in_library(state), "");
    new_file(state);
    EXPECT_EQ(why_not_in_library(state), "The graph has no nodes.");
    state.commit("Add", parsed(small_graph));
    EXPECT_NE(why_not_in_library(state).find("Save the graph first"), std::string::npos);
    state.keeping.folders = {};
    EXPECT_EQ(why_not_in_library(state), "There is no folder for a library.");
}

TEST_F(Libraries, SayWhyNothingWasAdded) {
    std::ofstream(home.path() / "library") << "a file";
    add();
    EXPECT_EQ(state.status.rfind("rock was not added to the library: ", 0), 0U) << state.status;
    EXPECT_EQ(text_of(home.path() / "library"), "a file");
}

TEST_F(Libraries, AreOnTheStartPage) {
    add();
    new_file(state);
    state.keeping.settings.recent.clear();
    state.start = {};
    frame();
    play("click library:rock\nassert nodes 2\nassert errors 0");
    EXPECT_EQ(state.path, entry() / "rock.json");
}

std::vector<uint8_t> image_of(const TemporaryFolder& folder, const std::string& outputs) {
    const fs::path file = folder.write("g.json", R"({"wrinkle": 1, "nodes": {
        "red": {"type": "color", "in": {"color": [1, 0, 0]}},
        "grey": {"type": "material", "in": {"color": [0.5, 0.5, 0.5]}},
        "half": {"type": "add", "in": {"a": 0.25}}}, "outputs": {)" +
                                                     outputs + "}}");
    return draw_graph_image({"g", 0, GraphFile{file, {}, &built_in_registry()}}).texels;
}

TEST(GraphImages, ShowTheColorOrTheMaterialOrTheFirstOutput) {
    const TemporaryFolder folder;
    const std::string red = R"("color": {"from": "red.color"})";
    const std::string grey = R"("material": {"from": "grey.material"})";
    const std::string broken = R"("normal": {"from": "none.normal"})";
    const auto both = image_of(folder, grey + "," + red);
    ASSERT_EQ(both.size(), size_t{4} * GraphImage::side * GraphImage::side);
    EXPECT_EQ(std::vector<uint8_t>(both.begin(), both.begin() + 4),
              (std::vector<uint8_t>{255, 0, 0, 255}));
    EXPECT_EQ(image_of(folder, grey)[0], 188);  // 0.5 as sRGB
    EXPECT_FALSE(image_of(folder, R"("height": {"from": "half.result"})").empty());
    EXPECT_EQ(image_of(folder, broken + "," + grey)[0], 188);
    EXPECT_TRUE(image_of(folder, broken).empty());
    const GraphFile none{folder.path() / "none.json", {}, &built_in_registry()};
    EXPECT_TRUE(draw_graph_image({"none", 0, none}).texels.empty());
}

TEST(GraphImages, HaveTheInputsOfAPreset) {
    GraphPreset graph;
    graph.document = parsed(R"({"wrinkle": 1,
        "inputs": {"tint": {"type": "color", "default": [1, 0, 0]}},
        "presets": {"Blue": {"tint": [0, 0, 1]}},
        "nodes": {"c": {"type": "color", "in": {"color": {"from": "input.tint"}}}},
        "outputs": {"color": {"from": "c.color"}}})");
    graph.model = make_model(graph.document, ".", built_in_registry());
    EXPECT_EQ(draw_graph_image({"a", 0, graph}).texels[0], 255);
    graph.preset = "Blue";
    const auto blue = draw_graph_image({"b", 0, graph}).texels;
    EXPECT_EQ(blue[0], 0);
    EXPECT_EQ(blue[2], 255);
}

}  // namespace
}  // namespace wrinkle::editor
