// Tests of files dropped on the window: the pixels and the drop position select the nodes made.
#include <fstream>

#include "base/text.h"
#include "editor/model/document/field.h"
#include "editor/model/document/files.h"
#include "editor/view/drop/image_kind.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

const char* const empty_graph = "{\n  \"wrinkle\": 1\n}\n";

TEST(ImageKinds, AreToldByThePixels) {
    const fs::path textures = fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures";
    const std::pair<const char*, const char*> wanted[] = {
        {"rivets_normal.png", "tangent_normal_map"}, {"weave_normal.png", "tangent_normal_map"},
        {"bricks_height.png", "height_map"},         {"weave_height.png", "height_map"},
        {"pebbles_height.png", "height_map"},        {"pebbles_slopes.png", "derivative_map"},
        {"ball_object.png", "object_normal_map"},    {"ball_cube.png", "cube_normal_map"},
    };
    for (const auto& [file, type] : wanted) {
        const Examined examined = examine_file(textures / file);
        ASSERT_EQ(examined.problem, "") << file;
        const ImageKind kind = kind_of(examined, file);
        EXPECT_EQ(kind.node_type, type) << file << ": " << kind.why;
        EXPECT_FALSE(kind.encoding) << file;
    }
}

Examined painted(uint32_t channels, float (*value)(uint32_t x, uint32_t channel)) {
    Image image = make_image(64, 4, channels);
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            for (uint32_t c = 0; c < channels; ++c)
                image.texel(x, y)[c] = value(x, c);
    Examined examined;
    examined.info.width = image.width;
    examined.info.height = image.height;
    examined.verdict = maps::examine(image, Wrap::repeat);
    return examined;
}

TEST(ImageKinds, OfPicturesThatOnlyLookAlike) {
    const auto photo = [](uint32_t x, uint32_t c) {
        return static_cast<float>((x * (c + 3)) % 64) / 64;
    };
    const auto grey = [](uint32_t x, uint32_t) { return static_cast<float>(x) / 64; };
    const auto flat = [](uint32_t, uint32_t c) { return c == 2 ? 1.0F : 0.5F; };
    EXPECT_EQ(kind_of(painted(3, photo), "rust.png").node_type, "image");
    EXPECT_EQ(kind_of(painted(3, photo), "rust_Normal.png").node_type, "tangent_normal_map");
    EXPECT_EQ(kind_of(painted(3, grey), "normal.png").node_type, "height_map");
    EXPECT_EQ(kind_of(painted(1, grey), "a.png").node_type, "height_map");
    EXPECT_EQ(kind_of(painted(2, photo), "a.png").node_type, "derivative_map");
    EXPECT_EQ(kind_of(painted(4, flat), "a.png").node_type, "tangent_normal_map");
}

TEST(ImageKinds, OfNoPictureIsAProblem) {
    const TemporaryFolder folder;
    const std::string problem = examine_file(folder.write("notes.png", "no picture")).problem;
    EXPECT_NE(problem.find("notes.png"), std::string::npos) << problem;
    EXPECT_NE(examine_file(folder.path() / "missing.png").problem, "");
}

class Layering : public Headless {
protected:
    Layering() {
        texture("rivets_normal.png");
        texture("weave_normal.png");
        open(empty_graph);
    }
    // Compares the generated source of the saved graph with the golden file; all ways must give the
    // same source. The dragged value is replaced, as it depends on the fonts, which determine the
    // width of a field.
    void expect_layers() {
        play("assert errors 0\nkey Ctrl+S\nassert clean");
        const Node* weave = state.document().find("weave_normal");
        ASSERT_TRUE(weave);
        const NodeType* type = built_in_registry().find(weave->type);
        const double amount = numbers_at(*weave, type->ports[type->find_input("strength")])[0];
        EXPECT_NE(amount, 1);
        std::string text = program_output("compile " + file.string());
        const std::string digits = shortest(static_cast<float>(amount));
        ASSERT_NE(text.find(digits), std::string::npos) << digits << "\n" << text;
        text.replace(text.find(digits), digits.size(), "AMOUNT");
        expect_golden("dropped.glsl", text);
    }
};

TEST_F(Layering, TakesThreeActionsByDropping) {
    play(R"(
        drop textures/rivets_normal.png canvas
        assert wire rivets_normal.gradient resolve.gradient
        assert wire resolve.normal normal
        drop textures/weave_normal.png wire:resolve.gradient
        assert wire gradient_add.gradient resolve.gradient
        assert wire rivets_normal.gradient gradient_add.a
        assert wire weave_normal.gradient gradient_add.b
        drag field:weave_normal.strength field:weave_normal.strength+12,0
        assert actions 3)");
    expect_layers();
}

TEST_F(Layering, TakesSevenActionsByTheMouse) {
    play(R"(
        click menu:Node
        click menu:add-picture
        click choice:textures/rivets_normal.png
        click menu:Node
        click menu:add-picture
        click choice:textures/weave_normal.png
        drag field:weave_normal.strength field:weave_normal.strength+12,0
        assert actions 7)");
    expect_layers();
}

TEST_F(Layering, TakesSevenActionsByTheKeyboard) {
    for (const char* name :
         {"ball_cube.png", "ball_object.png", "bricks_height.png", "patches_mask.png",
          "pebbles_height.png", "pebbles_slopes.png", "weave_height.png"})
        texture(name);  // enough choices to filter by typing
    play(R"(
        key I
        type rivets
        key Enter
        key I
        type weave_n
        key Enter
        key Enter
        key Tab
        type 0.6
        key Enter
        assert value weave_normal.strength 0.6
        assert actions 7)");
    expect_layers();
}

TEST_F(Layering, APictureIsLaidOverTheSelectedWire) {
    play(R"(
        drop textures/rivets_normal.png canvas
        click wire:$output.normal
        key I
        click choice:textures/weave_normal.png
        assert wire weave_normal.gradient gradient_add.b
        assert wire gradient_add.gradient resolve.gradient)");
}

TEST_F(Layering, ACardIsLaidOverTheWireThatItIsDroppedOn) {
    play(R"(
        drop textures/rivets_normal.png canvas+0,-150
        drop textures/weave_normal.png canvas+0,200
        assert status drop its card on a wire
        drag node:weave_normal wire:resolve.gradient
        assert wire rivets_normal.gradient gradient_add.a
        assert wire weave_normal.gradient gradient_add.b
        assert wire gradient_add.gradient resolve.gradient
        assert errors 0)");
    EXPECT_EQ(state.document().find("weave_normal")->find("base"), nullptr);
    for (const Card& card : state.layout.cards)
        for (const Card& other : state.layout.cards)
            EXPECT_TRUE(card.id == other.id || !card.extent().touches(other.extent()))
                << card.id << " covers " << other.id;
    play("key Ctrl+Z\nassert no-node gradient_add");
}

TEST_F(Layering, ANewBumpIsLaidOverTheSelectedWire) {
    play(R"(
        drop textures/rivets_normal.png canvas
        click wire:resolve.gradient
        key Space
        type gradient noise
        key Enter
        assert wire rivets_normal.gradient gradient_add.a
        assert wire gradient_noise.height gradient_add.b
        assert wire gradient_add.gradient resolve.gradient
        assert errors 0)");
}

TEST_F(Headless, ADropIsOneStep) {
    texture("rivets_normal.png");
    texture("weave_height.png");
    open(empty_graph);
    play(R"(
        drop textures/rivets_normal.png textures/weave_height.png canvas
        assert nodes 4
        assert wire weave_height.height gradient_add.b
        assert errors 0
        key Ctrl+Z
        assert nodes 0
        assert clean)");
}

TEST_F(Headless, AFreeInputOfAnAdditionIsUsed) {
    texture("weave_normal.png");
    open(R"({ "wrinkle": 1, "nodes": {
        "noise": { "type": "gradient_noise" },
        "sum": { "type": "gradient_add", "in": { "a": { "from": "noise.height" } } },
        "normal": { "type": "resolve", "in": { "gradient": { "from": "sum.gradient" } } } },
        "outputs": { "normal": { "from": "normal.normal" } } })");
    play(R"(
        drop textures/weave_normal.png wire:sum.a
        assert nodes 4
        assert wire weave_normal.gradient sum.b
        drop textures/weave_normal.png wire:$output.normal
        assert nodes 6
        assert wire gradient_add.gradient normal.gradient
        assert errors 0)");
}

TEST_F(Headless, ANormalMapIsNotConnectedToASumOfHeights) {
    texture("weave_normal.png");
    open(R"({ "wrinkle": 1, "nodes": {
        "noise": { "type": "gradient_noise" },
        "sum": { "type": "height_add", "in": { "a": { "from": "noise.height" } } } },
        "outputs": { "height": { "from": "sum.height" } } })");
    play(R"(
        drop textures/weave_normal.png wire:sum.a
        assert wire noise.height sum.a
        assert no-wire weave_normal.gradient sum.b)");
    for (const Wire& wire : state.layout.wires)
        EXPECT_NE(wire.conversion, Conversion::illegal) << wire.port;
}

TEST_F(Headless, APictureOnANodeReplacesItsPicture) {
    texture("rivets_normal.png");
    texture("weave_normal.png");
    open(empty_graph);
    play(R"(
        drop textures/rivets_normal.png canvas
        drop textures/weave_normal.png field:rivets_normal.image
        assert nodes 2
        assert value rivets_normal.image "textures/weave_normal.png"
        drop textures/rivets_normal.png node:rivets_normal
        assert value rivets_normal.image "textures/rivets_normal.png")");
}

TEST_F(Headless, APictureFromElsewhereIsCopiedWhenAsked) {
    const fs::path from = fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures/rivets_normal.png";
    texture("weave_normal.png");
    open(empty_graph);
    play("drop " + from.string() + " canvas\nassert nodes 0\nclick copy:no\nassert nodes 0");
    EXPECT_FALSE(fs::exists(folder.path() / "textures/rivets_normal.png"));
    play("drop " + from.string() + " canvas\nclick copy:yes\nassert nodes 2\nassert errors 0");
    EXPECT_TRUE(fs::exists(folder.path() / "textures/rivets_normal.png"));
    play(R"(assert value rivets_normal.image "textures/rivets_normal.png")");
}

// Two images in another folder, to be dropped.
struct Elsewhere {
    Elsewhere() {
        for (const char* name : {"rivets_normal.png", "weave_normal.png"})
            fs::copy_file(fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures" / name,
                          folder.path() / name);
    }
    std::string path(const char* name) const { return (folder.path() / name).string(); }
    TemporaryFolder folder;
};

TEST_F(Headless, AnUnsavedGraphReadsImagesOfItsFolder) {
    texture("rivets_normal.png");
    texture("weave_normal.png");
    new_file(state, folder.path());
    play(R"(
        drop textures/rivets_normal.png textures/weave_normal.png canvas
        assert nodes 4
        assert wire weave_normal.gradient gradient_add.b
        assert errors 0
        assert value weave_normal.image "textures/weave_normal.png")");
}

TEST_F(Headless, AnUnsavedGraphGetsTheFolderOfImagesThatItRefersTo) {
    const Elsewhere other;
    new_file(state, folder.path());
    play("drop " + other.path("rivets_normal.png") + " canvas\nclick copy:refer\nassert errors 0");
    EXPECT_EQ(state.folder(), fs::canonical(other.folder.path()));
    EXPECT_TRUE(fs::is_empty(folder.path()));
    play(R"(
        assert nodes 2
        assert value rivets_normal.image "rivets_normal.png"
        drop weave_normal.png canvas
        assert nodes 3
        assert errors 0)");
}

TEST_F(Headless, ReferringIsNotOfferedToAGraphThatNamesOtherFilesOrHasAFile) {
    const Elsewhere other;
    texture("pebbles_height.png");
    new_file(state, folder.path());
    play("drop textures/pebbles_height.png canvas\ndrop " + other.path("rivets_normal.png") +
         " canvas\nassert target copy:yes\nassert no-target copy:refer\nclick copy:no");
    open(empty_graph);
    play("drop " + other.path("rivets_normal.png") +
         " canvas\nassert target copy:yes\nassert no-target copy:refer\nclick copy:no");
}

TEST_F(Headless, AGraphWithARelativePathHasAnAbsoluteFolder) {
    state.path = "graph.json";
    EXPECT_EQ(state.folder(), fs::current_path());
    state.path = "./graph.json";
    EXPECT_EQ(state.folder(), fs::current_path());
    state.path.clear();
    EXPECT_EQ(state.folder(), fs::current_path());
}

TEST_F(Headless, AGraphThatIsALinkReadsImagesOfTheFolderThatItLeadsTo) {
    const Elsewhere other;
    other.folder.write("graph.json", empty_graph);
    fs::create_symlink(other.folder.path() / "graph.json", folder.path() / "link.json");
    open_file(state, folder.path() / "link.json");
    play("drop " + other.path("rivets_normal.png") + " canvas\nassert nodes 2\nassert errors 0");
}

TEST_F(Headless, WhatIsNoPictureIsRefused) {
    folder.write("notes.txt", "no picture");
    open(empty_graph);
    play("drop notes.txt canvas\nassert nodes 0\nassert status notes.txt\nassert clean");
    play("drop missing.png canvas\nassert nodes 0\nassert status missing.png");
}

TEST_F(Headless, AMeshIsLeftForThePreviewAndAGraphIsOpened) {
    folder.write("ball.obj", "v 0 0 0\n");
    folder.write("other.json", small_graph);
    open(empty_graph);
    play("drop ball.obj preview");
    EXPECT_EQ(fs::path(state.view.preview_view.mesh).filename(), "ball.obj");
    folder.write("sky.hdr", "none");
    play("drop sky.hdr preview");
    EXPECT_EQ(fs::path(state.view.preview_view.environment).filename(), "sky.hdr");
    play("drop other.json canvas\nassert nodes 4");
    EXPECT_EQ(state.path.filename(), "other.json");
}

TEST_F(Headless, AGraphDroppedOnAGraphOfItsFolderIsANodeOrOpened) {
    folder.write("other.json", small_graph);
    open(small_graph);
    play("click node:number\ndrop other.json canvas\nkey Delete\nassert nodes 4");
    play("key Escape\nassert nodes 4\nassert clean");
    play("drop other.json canvas\nkey Enter\nassert nodes 5\nassert errors 0");
    ASSERT_TRUE(state.document().find("other"));
    EXPECT_EQ(state.document().find("other")->type, "graph:other.json");
    play("key Ctrl+Z\ndrop other.json canvas\nclick graph:node\nassert nodes 5\nkey Ctrl+Z");
    play("drop other.json canvas\nclick graph:open\nassert nodes 4");
    EXPECT_EQ(state.path.filename(), "other.json");
}

TEST_F(Headless, AGraphFromElsewhereIsOpened) {
    const TemporaryFolder elsewhere;
    elsewhere.write("other.json", small_graph);
    open(small_graph);
    play("drop " + (elsewhere.path() / "other.json").string() + " canvas");
    EXPECT_EQ(state.path.filename(), "other.json");
}

}  // namespace
}  // namespace wrinkle::editor
