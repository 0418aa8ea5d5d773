// Tests of image lint: the nodes that dropped images become, remarks and their fixes; the interface
// does not wait for it.
#include "editor/model/images/images.h"
#include "editor/view/lifecycle.h"

#include <unistd.h>

#include <atomic>
#include <cmath>

#include "editor/model/document/files.h"
#include "editor/model/document/used_files.h"
#include "editor/model/images/facts.h"
#include "editor/model/images/remarks.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;
using Names = std::vector<std::string>;

const char* const bare_graph = "{ \"wrinkle\": 1 }\n";

class Pictures : public Headless {
protected:
    // Saves a modified copy of an image of graphs/textures: `change` is called for each texel, and
    // `keep` is the fraction of the width that is retained.
    template <class Change>
    fs::path changed(const std::string& from, const std::string& to, Change change,
                     double keep = 1) const {
        Diagnostics problems;
        const auto whole =
            load_image(fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures" / from, problems);
        EXPECT_TRUE(whole) << from;
        const auto width = static_cast<uint32_t>(whole->width * keep);
        Image image = make_image(width, whole->height, whole->channels, PixelType::u8);
        for (uint32_t y = 0; y < image.height; ++y)
            for (uint32_t x = 0; x < width; ++x) {
                std::copy_n(whole->texel(x, y), image.channels, image.texel(x, y));
                change(image.texel(x, y));
            }
        fs::create_directories(folder.path() / "textures");
        const fs::path file = folder.path() / "textures" / to;
        EXPECT_TRUE(save_image(image, file, {}, problems));
        return file;
    }
    fs::path turned_green(const std::string& to) const {
        return changed("rivets_normal.png", to, [](float* t) { t[1] = 1 - t[1]; });
    }
    // Opens the graph source -> normal. `source` reads the image and has the input `more`, which
    // only some types have.
    void open_reading(const std::string& type, const std::string& image,
                      const std::string& output = "gradient",
                      const std::string& more = "\"strength\": 0.5") {
        open(R"({ "wrinkle": 1, "nodes": { "source": { "type": ")" + type +
             R"(", "in": { "image": )" + image + ", " + more +
             R"( } }, "normal": { "type": "resolve", "in": { "gradient": { "from": "source.)" +
             output + R"(" } } } }, "outputs": { "normal": { "from": "normal.normal" } } })");
        play("wait");
    }
    Names remarked() const {
        Names names;
        for (const ImageWarning& remark : state.images.remarks)
            names.push_back(remark.about + ": " + remark.remedy.label);
        return names;
    }
};

TEST_F(Pictures, GreenThatPointsDownIsReadSoFromTheStart) {
    turned_green("down.png");
    open(bare_graph);
    play(R"(
        drop textures/down.png canvas
        assert nodes 2
        assert value down.image { "file": "textures/down.png", "encoding": "normal_dx" }
        assert status green down: curl −
        assert errors 0
        key Ctrl+Z
        assert nodes 0
        assert clean)");
    play("drop textures/down.png canvas\nwait");
    EXPECT_EQ(remarked(), Names{});
    const Examined* found = examined_at(state, *state.document().find("down"), "image");
    ASSERT_TRUE(found);
    bool offset = false;
    for (const Fact& fact : facts_of(*found))
        offset |= fact.name == "Offset" && fact.value.find("green") != fact.value.npos;
    EXPECT_TRUE(offset) << "it has 8 bits";
}

TEST_F(Pictures, TheOtherGreenIsRemarkedAndMendedByOneClick) {
    turned_green("down.png");
    open_reading("tangent_normal_map", "\"textures/down.png\"");
    ASSERT_EQ(remarked(), Names{"green: Read as dx"});
    const Diagnostic& problem = state.images.remarks[0].problem;
    EXPECT_EQ(problem.node, "source");
    EXPECT_EQ(problem.message,
              "the image looks like green points down (dx), but the node reads green as up (gl). "
              "Bumps may look like dents");
    play(R"(
        assert errors 0
        assert target problem:1
        click fix:1
        assert value source.image { "file": "textures/down.png", "encoding": "normal_dx" }
        assert no-target problem:1
        key Ctrl+Z
        assert clean
        assert target problem:1
        click dismiss:1
        assert no-target problem:1
        assert clean)");
}

TEST_F(Pictures, WhatIsDismissedIsSoInTheNextSessionToo) {
    const auto next_session = [&] {
        const std::string graph = text_of(file);
        std::string trouble = write_settings(state.keeping.folders, state.keeping.settings);
        EXPECT_EQ(trouble, "");
        state.images = {};
        state.keeping.settings = {};
        use_settings(state, read_settings(state.keeping.folders, trouble));
        EXPECT_EQ(trouble, "");
        open(graph);
        play("wait");
    };
    turned_green("down.png");
    open_reading("tangent_normal_map", "\"textures/down.png\"");
    next_session();
    ASSERT_EQ(remarked(), Names{"green: Read as dx"});
    play("click dismiss:1\nassert clean");
    next_session();
    EXPECT_EQ(remarked(), Names{});
    changed("rivets_normal.png", "down.png", [](float* t) {
        t[1] = 1 - t[1];
        t[2] = 0.9F * t[2];
    });
    next_session();
    const Names of_the_new_one = remarked();
    EXPECT_TRUE(std::find(of_the_new_one.begin(), of_the_new_one.end(), "green: Read as dx") !=
                of_the_new_one.end());
    for (size_t i = 0; i < 2 * Settings::max_dismissed; ++i)
        dismiss_remark(state, state.images.remarks[0]);
    EXPECT_EQ(state.keeping.settings.dismissed.size(), Settings::max_dismissed);
}

TEST_F(Pictures, AnEncodingThatSaysSoNeedlesslyGoesWithItsMend) {
    texture("rivets_normal.png");
    open_reading("tangent_normal_map",
                 R"({ "file": "textures/rivets_normal.png", "encoding": "normal_dx" })");
    ASSERT_EQ(remarked(), Names{"green: Read as gl"});
    play("click fix:1\nassert value source.image \"textures/rivets_normal.png\"");
    EXPECT_EQ(remarked(), Names{});
}

TEST_F(Pictures, AHeightReadAsNormalsGetsItsNode) {
    texture("bricks_height.png");
    open_reading("tangent_normal_map", "\"textures/bricks_height.png\"");
    ASSERT_EQ(remarked(), Names{"type: Read as heights"});
    play(R"(
        click fix:1
        assert errors 0
        assert wire source.gradient normal.gradient
        assert value source.image "textures/bricks_height.png"
        assert no-target problem:1)");
    const Node* node = state.document().find("source");
    ASSERT_TRUE(node);
    EXPECT_EQ(node->type, "height_map");
    EXPECT_FALSE(node->find("strength")) << "a height map has none";
    play("key Ctrl+Z\nassert clean");
    EXPECT_EQ(state.document().find("source")->type, "tangent_normal_map");
}

TEST_F(Pictures, NormalsReadAsHeightsTakeTheirWiresAndGreenAlong) {
    turned_green("down.png");
    open_reading("height_map", "\"textures/down.png\"", "height", "\"amplitude\": 0.1");
    ASSERT_EQ(remarked(), Names{"type: Read as normals"});
    play(R"(
        click fix:1
        assert errors 0
        assert wire source.gradient normal.gradient
        assert value source.image { "file": "textures/down.png", "encoding": "normal_dx" })");
    EXPECT_EQ(state.document().find("source")->type, "tangent_normal_map");
    EXPECT_EQ(remarked(), Names{});
}

TEST_F(Pictures, NoRemedyPartsAWire) {
    texture("weave_normal.png");
    open(R"({ "wrinkle": 1, "nodes": {
        "source": { "type": "height_map", "in": { "image": "textures/weave_normal.png" } },
        "sum": { "type": "height_add", "in": { "a": { "from": "source.height" } } } },
      "outputs": { "height": { "from": "sum.height" } } })");
    play("wait");
    EXPECT_EQ(remarked(), Names{"type: "}) << "a sum of heights takes no bump";
    play("assert target dismiss:1\nassert no-target fix:1");
}

TEST_F(Pictures, DefectsAreRemarkedWithWhatHelps) {
    changed(
        "pebbles_height.png", "cut.png", [](float*) {}, 0.77);
    open_reading("height_map", "\"textures/cut.png\"", "gradient", "\"amplitude\": 0.1");
    ASSERT_EQ(remarked(), Names{"seam: Clamp"});
    play(R"(
        click fix:1
        assert value source.image { "file": "textures/cut.png", "wrap": "clamp" }
        assert no-target problem:1)");
    changed("weave_normal.png", "z.png", [](float* t) { t[2] = 2 * t[2] - 1; });
    open_reading("tangent_normal_map", "\"textures/z.png\"");
    EXPECT_EQ(remarked(), Names{"unsigned_z: Make z"});
    play("click fix:1\nassert no-target problem:1");
    changed("weave_normal.png", "leans.png", [](float* t) { t[0] += 0.03F; });
    open_reading("tangent_normal_map", "\"textures/leans.png\"");
    const Names leans = remarked();
    EXPECT_TRUE(std::find(leans.begin(), leans.end(), "tilt: ") != leans.end());
    changed("weave_height.png", "stairs.png", [](float* t) { t[0] = std::round(t[0] * 16) / 255; });
    open_reading("height_map", "\"textures/stairs.png\"", "gradient", "\"amplitude\": 0.1");
    EXPECT_EQ(remarked(), Names{"banding: "});
}

TEST_F(Pictures, TheSamplesAreAsTheirNodesReadThem) {
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(WRINKLE_SOURCE_DIR) / "graphs")) {
        if (entry.path().extension() != ".json") continue;
        open_file(state, entry.path());
        play("wait");
        EXPECT_EQ(remarked(), Names{}) << entry.path();
    }
}

TEST_F(Pictures, AFileThatIsReplacedIsLookedAtAgain) {
    const fs::path file = texture("rivets_normal.png");
    open_reading("tangent_normal_map", "\"textures/rivets_normal.png\"");
    EXPECT_EQ(remarked(), Names{});
    fs::rename(turned_green("other.png"), file);
    state.used.checked_at = 0;
    play("wait");
    EXPECT_EQ(remarked(), Names{"green: Read as dx"});
}

TEST_F(Pictures, TheNodesPageShowsTheNumbersAndMends) {
    turned_green("down.png");
    open_reading("tangent_normal_map", "\"textures/down.png\"");
    play(R"(
        click node:source
        key F1
        assert target help:tangent_normal_map
        assert target image:dismiss:1
        click image:fix:1
        assert value source.image { "file": "textures/down.png", "encoding": "normal_dx" }
        assert target help:tangent_normal_map
        assert no-target image:fix:1)");
}

TEST(ImageFacts, SayKindSizeAndTheNumbersOfLint) {
    const Examined found =
        examine_file(fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures/rivets_normal.png");
    ASSERT_EQ(found.problem, "");
    const std::string lint = program_output(
        "lint " + (fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures/rivets_normal.png").string());
    const size_t at = lint.find("curl_correlation ");
    ASSERT_NE(at, std::string::npos);
    const double curl = std::strtod(lint.c_str() + at + 17, nullptr);
    char words[16];
    ASSERT_GT(curl, 0);
    std::snprintf(words, sizeof words, "+%.2f", curl);
    EXPECT_EQ(summary_of(found), "tangent-space normal map, green up: curl " + std::string(words));
    std::map<std::string, std::string> facts;
    for (const Fact& fact : facts_of(found))
        facts[fact.name] = fact.value;
    EXPECT_EQ(facts["Kind"], "Tangent-space normal map, green up");
    EXPECT_EQ(facts["Size"].find(std::to_string(found.info.width) + " \u00D7 "), 0U)
        << facts["Size"];
    EXPECT_NE(facts["Size"].find("3 channels, 16 bits"), std::string::npos) << facts["Size"];
    EXPECT_EQ(facts["Curl"].find(words), 0U) << facts["Curl"];
    for (const char* name : {"Mean normal", "Blue", "Levels", "Border"})
        EXPECT_NE(facts[name], "") << name;
}

// Examines no image until `go` is set.
class Waiting : public Pictures {
protected:
    Waiting() {
        texture("rivets_normal.png");
        texture("weave_height.png");
        state.images.examiner = &examiner;
        open(bare_graph);
    }
    ~Waiting() override {
        go = true;
        state.images.examiner = nullptr;
    }
    void drop(const Names& files) {
        const auto canvas = state.targets.find("canvas");
        ASSERT_TRUE(canvas);
        Names paths;
        for (const std::string& file : files)
            paths.push_back((folder.path() / file).string());
        queue.drop(canvas->middle_x(), canvas->middle_y(), paths);
        frame();
    }
    void frames_until_placed() {
        for (int i = 0; i < 3000 && !state.dropped.waiting.empty(); ++i) {
            frame();
            usleep(1000);
        }
    }
    std::atomic<bool> go = false;
    ImageExaminer examiner{[this](fs::path&& file) {
                               while (!go)
                                   usleep(1000);
                               return ImageAnswer{file, examine_file(file)};
                           },
                           {}};
};

TEST_F(Waiting, ADropIsPlacedWhenItIsKnownWhatItIs) {
    drop({"textures/rivets_normal.png", "textures/weave_height.png"});
    for (int i = 0; i < 5; ++i)
        frame();
    EXPECT_EQ(state.document().nodes.size(), 0U);
    EXPECT_EQ(state.status, "Looking at rivets_normal.png.");
    go = true;
    frames_until_placed();
    EXPECT_EQ(state.document().nodes.size(), 4U);
    play("assert wire weave_height.height gradient_add.b\nkey Ctrl+Z\nassert nodes 0");
}

TEST_F(Waiting, AnotherGraphTakesNoneOfIt) {
    drop({"textures/rivets_normal.png"});
    EXPECT_FALSE(state.dropped.waiting.empty());
    open(small_graph);
    go = true;
    for (int i = 0; i < 200; ++i) {
        frame();
        usleep(1000);
    }
    play("assert nodes 4\nassert clean");
}

}  // namespace
}  // namespace wrinkle::editor
