// Tests of the preview's thread and its requests. Skipped only if GL is not available.
#include <cmath>
#include <numbers>

#include "graph/edit.h"
#include "graph/read.h"
#include "lower/material.h"
#include "with_preview.h"

namespace wrinkle::editor {
namespace {

// Two smooth bumps over uv0 of the plane, steep enough for large errors of blended normals.
const char* const two_bumps = R"({
  "wrinkle": 1,
  "nodes": {
    "uv": { "type": "separate_vec2", "in": { "vector": { "from": "surface.uv0" } } },
    "u": { "type": "multiply", "in": { "a": { "from": "uv.x" }, "b": 9 } },
    "v": { "type": "multiply", "in": { "a": { "from": "uv.y" }, "b": 7 } },
    "su": { "type": "sine", "in": { "angle": { "from": "u.result" } } },
    "sv": { "type": "sine", "in": { "angle": { "from": "v.result" } } },
    "across": { "type": "multiply", "in": { "a": { "from": "su.result" }, "b": 0.3 } },
    "along": { "type": "multiply", "in": { "a": { "from": "sv.result" }, "b": 0.3 } },
    "sum": {
      "type": "gradient_add",
      "in": { "a": { "from": "across.result" }, "b": { "from": "along.result" } }
    },
    "softer": { "type": "gradient_scale", "in": { "gradient": { "from": "sum.gradient" }, "amount": 0.9 } },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "softer.gradient" } } }
  },
  "outputs": { "normal": { "from": "normal.normal" } }
}
)";

TEST_F(WithPreview, APictureIsDrawnOnTheOtherThread) {
    begin(two_bumps);
    const PreviewImage& picture = see();
    ASSERT_NE(picture.texture, 0U) << to_text(picture.problems);
    EXPECT_FALSE(picture.refused);
    EXPECT_TRUE(is_settled(state));
    const auto pixels = pixels_of(picture.texture);
    const size_t middle = 4 * (side / 2 * side + side / 2);
    EXPECT_EQ(pixels[middle + 3], 255) << "the plane is opaque";
    EXPECT_EQ(pixels[3], 255) << "and so is the studio";
    EXPECT_GT(pixels[middle], 2 * pixels[0]) << "which is darker";
}

TEST_F(WithPreview, AGraphWithoutOutputsShowsTheSelectedNode) {
    begin(R"({ "wrinkle": 1, "nodes": { "noise": { "type": "gradient_noise" },
                                        "file": { "type": "image" } } })");
    EXPECT_EQ(see().texture, 0U);
    state.view.selected = {"noise"};
    EXPECT_NE(see().texture, 0U);
    EXPECT_EQ(state.follow.drawn.request.node, "noise");
    EXPECT_TRUE(state.view.preview_request.node.empty());
    edit(set_output(state.document(), "height", {"noise", "height"}));
    see();
    EXPECT_EQ(state.follow.drawn.request.node, "");
}

TEST_F(WithPreview, TheNewestOfManyJobsIsShownAndHeldTexturesStay) {
    begin(two_bumps);
    const PreviewImage first = see();
    const auto before = pixels_of(first.texture);
    for (int i = 1; i <= 60; ++i) {
        state.view.preview_view.yaw = 0.02F * static_cast<float>(i);
        preview_->show(state.view.preview_view, "", {}, side, side);
    }
    preview_->wait_idle();
    EXPECT_EQ(pixels_of(first.texture), before) << "it is still being looked at";
    EXPECT_EQ(preview_->newest().version, preview_->asked());
    EXPECT_NE(pixels_of(preview_->shown().texture), before);
}

TEST_F(WithPreview, DragsMovesAndRenamesBuildNoProgram) {
    begin(two_bumps);
    const uint64_t programs = see().programs;
    const auto before = pixels_of(preview_->shown().texture);
    edit(move_node(state.document(), "sum", 5, 6));
    edit(rename_node(state.document(), "softer", "weaker"));
    see();
    EXPECT_EQ(preview_->shown().programs, programs);
    EXPECT_EQ(pixels_of(preview_->shown().texture), before);
    state.gesture.kind = Gesture::Kind::value;
    edit(set_value(state.document(), "weaker", "amount", json::Value::number(0.1)));
    EXPECT_NE(pixels_of(see().texture), before);
    EXPECT_EQ(preview_->shown().programs, programs);
    state.gesture.kind = Gesture::Kind::none;
    see();
    EXPECT_EQ(preview_->shown().programs, programs);
}

TEST_F(WithPreview, TheLastGoodPictureStaysWhenTheGraphBreaks) {
    begin(two_bumps);
    const auto before = pixels_of(see().texture);
    edit(set_type(state.document(), "sum", "no_such_type", 1));
    EXPECT_EQ(pixels_of(see().texture), before);
    EXPECT_TRUE(state.preview_stale);
    state.history.undo();
    see();
    EXPECT_FALSE(state.preview_stale);
}

TEST_F(WithPreview, ANewGraphIsTheBareMeshAndNothingOfTheFormerOne) {
    new_file(state);
    const auto bare = pixels_of(see().texture);
    begin(two_bumps);
    EXPECT_NE(pixels_of(see().texture), bare);
    preview_->show({}, "", {}, side, side + 1);  // in progress when the other graph is opened
    new_file(state);
    EXPECT_EQ(preview_->shown().texture, 0U);
    EXPECT_EQ(pixels_of(see().texture), bare);
    EXPECT_TRUE(state.built.problems.list().empty()) << to_text(state.built.problems);
    begin(two_bumps);
    EXPECT_NE(see().texture, 0U);
    EXPECT_FALSE(state.preview_stale);
}

TEST_F(WithPreview, AGraphThatDoesNotCompileShowsNothingOfTheOneBefore) {
    begin(two_bumps);
    ASSERT_NE(see().texture, 0U);
    begin(R"({ "wrinkle": 1, "nodes": { "normal": { "type": "no_such_node" } },
               "outputs": { "normal": { "from": "normal.normal" } } })");
    EXPECT_EQ(see().texture, 0U);
    EXPECT_TRUE(state.preview_stale);
}

TEST_F(WithPreview, AShaderThatTheDriverRefusesIsAProblemOfItsNode) {
    begin(two_bumps);
    const auto before = pixels_of(see().texture);
    Shader broken = *state.built.uniform;
    // First line of the generated source that belongs to `sum`.
    size_t line = 0, at = 0;
    const Reflection& reflection = broken.reflection;
    for (size_t i = 0; i < reflection.lines.size() && line == 0; ++i)
        if (reflection.lines[i] != no_node && reflection.node_paths[reflection.lines[i]] == "sum")
            line = i + 1;
    ASSERT_GT(line, 0U);
    for (size_t i = 1; i < line; ++i)
        at = broken.source.find('\n', at) + 1;
    broken.source.insert(at, "nonsense nonsense; ");
    preview_->set_material(std::make_shared<const Shader>(broken), {});
    EXPECT_EQ(pixels_of(see().texture), before);
    EXPECT_TRUE(state.preview_stale);
    ASSERT_FALSE(state.preview_problems.list().empty());
    EXPECT_EQ(state.preview_problems.list()[0].node, "sum") << to_text(state.preview_problems);
    EXPECT_NE(state.preview_problems.list()[0].message.find("(sum)"), std::string::npos);
}

TEST_F(WithPreview, AMeshThatIsNoneLeavesTheFormerOne) {
    begin(two_bumps);
    const auto before = pixels_of(see().texture);
    state.view.preview_view.mesh = folder.write("junk.obj", "f 1 2 3\n").string();
    EXPECT_EQ(pixels_of(see().texture), before);
    EXPECT_TRUE(state.preview_problems.has_errors());
    EXPECT_FALSE(state.preview_stale);
    state.view.preview_view.environment = (folder.path() / "none.hdr").string();
    see();
    see();
    EXPECT_GE(state.preview_problems.error_count(), 2U);
}

TEST_F(WithPreview, TwiceTheObjectHasHalfTheSlopes) {
    begin(two_bumps);
    state.view.preview_view.view = gpu::View::difference;
    const auto once = pixels_of(see().texture);
    state.view.preview_view.scale = 4;
    const auto twice = pixels_of(see().texture);
    double before = 0, after = 0;  // red, which increases at the start of the heat map
    for (size_t i = 0; i < once.size(); i += 4)
        before += once[i], after += twice[i];
    EXPECT_LT(after, 0.8 * before);
}

// Returns the inputs that the program reads, at these uv coordinates of the plane.
PointSet plane_points(const Program& program, const std::vector<glm::dvec2>& places) {
    PointSet points;
    points.count = places.size();
    constexpr double step = 1e-3;
    for (const InputNeed need : needed_inputs(program)) {
        const bool value = need.variant == Variant::value;
        const glm::dvec2 d(need.variant == Variant::dx ? step : 0,
                           need.variant == Variant::dy ? step : 0);
        std::vector<double>& list = points.at(need.input, need.variant);
        for (const glm::dvec2 uv : places) {
            std::vector<double> numbers{value ? 1.0 : 0.0};  // facing
            const glm::dvec2 p = value ? 2.0 * uv - 1.0 : 2.0 * d;
            if (need.input == SurfaceInput::position_) numbers = {p.x, p.y, 0};
            if (need.input == SurfaceInput::uv0_)
                numbers = value ? std::vector<double>{uv.x, uv.y} : std::vector<double>{d.x, d.y};
            if (need.input == SurfaceInput::normal_) numbers = {0, 0, value ? 1.0 : 0.0};
            if (need.input == SurfaceInput::tangent_)
                numbers = {value ? 1.0 : 0.0, 0, 0, value ? 1.0 : 0.0};
            list.insert(list.end(), numbers.begin(), numbers.end());
        }
    }
    return points;
}

glm::dvec3 vector_at(const std::vector<double>& values, size_t i) {
    return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

// Returns the angles between the two normals at these uv coordinates of the plane, computed on the
// CPU, in degrees.
std::vector<double> cpu_angles(const State& state, const std::vector<glm::dvec2>& places) {
    const Requested requested =
        requested_document(state.document(), state.model, wanted_request(state));
    EXPECT_EQ(requested.why_not, "");
    MaterialOptions options;
    options.given_differentials = true;
    options.lower.outputs = {"normal", against_output};
    Diagnostics problems;
    const Compiled compiled = compile_material(project_with(state.model, requested.document),
                                               *state.registry, options, problems);
    EXPECT_TRUE(compiled.ok) << to_text(problems);
    std::string why;
    const Program program = compile_program(compiled.module, why);
    Results results = make_results(program, places.size());
    evaluate<double>(program, plane_points(program, places), {}, 0, places.size(), results);
    std::vector<double> angles;
    for (size_t i = 0; i < places.size(); ++i) {
        const double cosine =
            glm::dot(vector_at(results.values[0], i), vector_at(results.values[1], i));
        angles.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
    }
    return angles;
}

TEST_F(WithPreview, TheDegreesOfAComparisonAreThoseOfTheCpu) {
    begin(two_bumps);
    for (const char* blend : {"udn", "whiteout", "rnm", "linear"}) {
        compare(Against::blend, blend);
        const PreviewImage& picture = see();
        ASSERT_NE(picture.other, 0U) << blend << state.built.why_not_shown;
        const std::vector<float>& degrees = *picture.angles.degrees;
        // The plane is viewed from the front and fills a square of the image.
        int low = side, high = 0;
        for (int i = 0; i < side; ++i)
            if (degrees[static_cast<size_t>(side / 2 * side + i)] >= 0)
                low = std::min(low, i), high = std::max(high, i);
        std::vector<glm::dvec2> places;
        std::vector<float> seen;
        const double size = high - low + 1;
        for (int y = low + 4; y < high - 4; y += 3)
            for (int x = low + 4; x < high - 4; x += 3) {
                places.push_back({(x - low + 0.5) / size, (y - low + 0.5) / size});
                seen.push_back(degrees[static_cast<size_t>(y * side + x)]);
            }
        ASSERT_GT(places.size(), 1000U);
        const std::vector<double> expected = cpu_angles(state, places);
        double sum = 0, mean = 0, largest = 0;
        for (size_t i = 0; i < places.size(); ++i) {
            EXPECT_NEAR(seen[i], expected[i], 1.2) << blend;
            sum += std::fabs(static_cast<double>(seen[i]) - expected[i]);
            mean += expected[i] / static_cast<double>(places.size());
            largest = std::max(largest, expected[i]);
        }
        EXPECT_LT(sum / static_cast<double>(places.size()), 0.25) << blend;
        EXPECT_NEAR(static_cast<double>(picture.angles.mean), mean, 0.25) << blend;
        EXPECT_NEAR(static_cast<double>(picture.angles.max), largest, 1.2) << blend;
        EXPECT_GT(picture.angles.max, 10) << blend << " is far off, and is seen to be";
    }
}

TEST_F(WithPreview, TheRightBlendOfTwoMapsDiffersFromTheSumByNothing) {
    begin(two_bumps);
    compare(Against::blend, "partial_derivative");
    EXPECT_LT(see().angles.max, 0.1F);
    EXPECT_EQ(state.built.replaced, 1U);
    EXPECT_EQ(preview_->shown().angles.end, 3) << "the least of the scales";
}

TEST_F(WithPreview, AValueAfterTheSumMovesBothSides) {
    begin(two_bumps);
    compare(Against::blend, "partial_derivative");
    const uint64_t programs = see().programs;
    state.gesture.kind = Gesture::Kind::value;
    edit(set_value(state.document(), "softer", "amount", json::Value::number(0.3)));
    EXPECT_LT(see().angles.max, 0.1F);
    EXPECT_EQ(preview_->shown().programs, programs);
    state.gesture.kind = Gesture::Kind::none;
}

TEST_F(WithPreview, AComparisonWithAnotherNodeOrOutput) {
    begin(two_bumps);
    compare(Against::node, "normal");
    EXPECT_LT(see().angles.max, 0.01F);
    compare(Against::node, "across");
    EXPECT_GT(see().angles.max, 10);
    edit(set_output(state.document(), "other", {"normal", "normal"}));
    compare(Against::output, "other");
    EXPECT_LT(see().angles.max, 0.01F);
    compare(Against::output, "missing");
    see();
    EXPECT_NE(state.built.why_not_shown, "");
    EXPECT_EQ(preview_->shown().other, 0U);
    EXPECT_NE(preview_->shown().texture, 0U);
}

TEST_F(WithPreview, ANodeIsPreviewedWithoutTouchingTheDocument) {
    begin(two_bumps);
    const auto before = pixels_of(see().texture);
    state.view.selected = {"across"};
    const Document document = state.document();
    state.view.preview_request.node = "across";
    EXPECT_NE(pixels_of(see().texture), before);
    EXPECT_TRUE(same_document(document, state.document()));
    state.view.preview_view.view = gpu::View::height;
    see();
    EXPECT_FALSE(state.preview_problems.has_errors()) << to_text(state.preview_problems);
    edit(remove_node(state.document(), "across"));
    see();
    EXPECT_EQ(state.follow.drawn.request.node, "") << "a node that is gone is not previewed";
}

TEST(Request, SaysWhenThereIsNoSumToReplace) {
    Diagnostics problems;
    const Document document = read_document(small_graph, "graph.json", problems);
    const Model model = make_model(document, ".", built_in_registry());
    const Requested requested =
        requested_document(document, model, {"", Against::blend, "udn", false});
    EXPECT_EQ(requested.replaced, 0U);
    EXPECT_NE(requested.why_not.find("no sum"), std::string::npos);
}

TEST(Request, EveryNodeOfTheRegistryCanBePreviewedOrSaysWhyNot) {
    for (const NodeType& type : built_in_registry().list()) {
        bool has_output = false;
        for (const Port& port : type.ports)
            has_output |= port.kind == Port::Kind::output && port.type != PortType::vec2_ &&
                          port.type != PortType::vec4_;
        EXPECT_EQ(shown_port(&type) != nullptr, has_output) << type.id;
    }
}

TEST(Worker, DoesTheNewestJobAndEndsWithOneWaiting) {
    std::atomic<int> done = 0, woken = 0;
    std::atomic<bool> finished = false;
    {
        Worker<int, int> worker([&](int&& job) { return ++done, job; }, [&] { ++woken; },
                                [&] { finished = true; });
        for (int i = 1; i <= 1000; ++i)
            worker.post(i);
        worker.wait_idle();
        EXPECT_EQ(worker.take(), 1000);
        EXPECT_FALSE(worker.take());
        EXPECT_TRUE(worker.idle());
        worker.post(1);
    }
    EXPECT_TRUE(finished);
    EXPECT_LE(done, 1001);
    EXPECT_GE(woken, 1);
}

}  // namespace
}  // namespace wrinkle::editor
