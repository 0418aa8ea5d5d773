// Tests of WebGL 2 source in a browser: every sample compiles and links in both forms, and draws
// the same image as OpenGL, within 2 of 255.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "gpu/texture.h"
#include "graph/subgraph.h"
#include "lower/material.h"
#include "support/files.h"
#include "support/linked_nodes.h"
#include "support/samples.h"
#include "webgl/browser.h"
#include "webgl/pass.h"

namespace wrinkle::test {
namespace {
namespace fs = std::filesystem;

const Target& es = *find_target("essl300");

std::string name_for(const fs::path& graph) {
    return material_name(fs::relative(graph, WRINKLE_SOURCE_DIR "/graphs").replace_extension());
}

Shader shader_of(const fs::path& graph, const Target& target, Form form) {
    Diagnostics diagnostics;
    MaterialOptions material;
    material.given_differentials = form == Form::function;
    const Compiled compiled = compile_material(load_project(graph, {}, diagnostics), linked_nodes(),
                                               material, diagnostics);
    EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
    EmitOptions options;
    options.target = &target;
    options.form = form;
    options.differentials = form == Form::function ? Differentials::given : Differentials::screen;
    options.name = "sample";
    return emit(compiled.module, options);
}

// The image drawn by OpenGL, as bytes.
std::vector<uint8_t> drawn(const Shader& shader, size_t output) {
    Diagnostics diagnostics;
    std::string log;
    const std::array<std::string, 1> outputs{"result"};
    const auto program = gpu::Program::link(pass_vertex(targets().front()),
                                            pass_fragment(shader, output), outputs, log);
    EXPECT_TRUE(program) << log;
    const auto picture = gpu::Texture::upload(pass_picture());
    const auto target =
        gpu::Target::make({.width = pass_size, .height = pass_size, .depth = false}, diagnostics);
    EXPECT_TRUE(target);
    if (!program || !target) return {};
    program->use();
    std::vector<gpu::Sampler> samplers;
    for (const SamplerInfo& sampler : shader.reflection.samplers) {
        const auto unit = static_cast<int>(samplers.size());
        samplers.emplace_back(sampler.options.wrap, sampler.options.filter);
        picture.bind(unit);
        samplers.back().bind(unit);
        program->set(sampler.name.c_str(), unit);
    }
    GLuint empty = 0;
    glGenVertexArrays(1, &empty);
    glBindVertexArray(empty);
    target->bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDeleteVertexArrays(1, &empty);
    std::vector<uint8_t> bytes;
    for (const float value : target->read())
        bytes.push_back(static_cast<uint8_t>(std::lround(value * 255)));
    return bytes;
}

// Number of pixels that differ by more than 2 in some channel.
int far_off(const std::vector<uint8_t>& one, const std::vector<uint8_t>& other) {
    int count = 0;
    for (size_t pixel = 0; pixel + 3 < one.size(); pixel += 4) {
        bool off = false;
        for (size_t i = pixel; i < pixel + 4; ++i)
            off = off || std::abs(one[i] - other[i]) > 2;
        count += off;
    }
    return count;
}

size_t shown_output(const Shader& shader) {
    const auto& outputs = shader.reflection.outputs;
    for (size_t i = 0; i < outputs.size(); ++i)
        if (outputs[i].output == "normal") return i;
    return 0;
}

std::vector<BrowserJob> jobs_of(const std::vector<fs::path>& graphs) {
    std::vector<BrowserJob> jobs;
    for (const fs::path& graph : graphs) {
        const Shader pair = shader_of(graph, es, Form::shader);
        jobs.push_back({name_for(graph) + ":pair", pair.vertex, pair.fragment, false, {}});
        const Shader functions = shader_of(graph, es, Form::function);
        jobs.push_back({name_for(graph), pass_vertex(es),
                        pass_fragment(functions, shown_output(functions)), true,
                        functions.reflection.samplers});
    }
    return jobs;
}

// Edges of cells and steps may fall on the other side of a pixel's centre: one in a thousand.
constexpr int max_off = pass_size * pass_size / 1000;

TEST(WebGl2, DrawsEverySampleAsOpenGlDoes) {
    Diagnostics diagnostics;
    auto context = gpu::Context::offscreen(diagnostics);
    ASSERT_TRUE(context && context->make_current()) << to_text(diagnostics);
    const TemporaryFolder folder;
    const std::vector<fs::path> graphs = sample_graphs();
    std::string why;
    const auto results = run_in_browser(jobs_of(graphs), folder.path(), why);
    ASSERT_EQ(why, "");
    for (const fs::path& graph : graphs) {
        SCOPED_TRACE(graph.string());
        const std::string name = name_for(graph);
        ASSERT_TRUE(results.count(name) && results.count(name + ":pair"));
        EXPECT_EQ(results.at(name + ":pair").log, "");
        EXPECT_EQ(results.at(name).log, "");
        const Shader shader = shader_of(graph, targets().front(), Form::function);
        const std::vector<uint8_t> wanted = drawn(shader, shown_output(shader));
        ASSERT_EQ(results.at(name).pixels.size(), wanted.size());
        EXPECT_LE(far_off(results.at(name).pixels, wanted), max_off);
    }
}

// The comparison detects differences, and the browser reports invalid source.
TEST(WebGl2, NoticesOtherPicturesAndBadTexts) {
    const TemporaryFolder folder;
    const fs::path graph = WRINKLE_SOURCE_DIR "/graphs/base_and_detail.json";
    std::vector<BrowserJob> jobs = jobs_of({graph});
    jobs[0].name = "bad";
    jobs[0].fragment += "?";
    std::string why;
    const auto results = run_in_browser(jobs, folder.path(), why);
    ASSERT_EQ(why, "");
    EXPECT_NE(results.at("bad").log, "");
    std::vector<uint8_t> pixels = results.at(name_for(graph)).pixels;
    ASSERT_EQ(pixels.size(), static_cast<size_t>(pass_size) * pass_size * 4);
    EXPECT_GT(far_off(pixels, std::vector<uint8_t>(pixels.size(), 255)), max_off);
    EXPECT_EQ(far_off(pixels, pixels), 0);
}

}  // namespace
}  // namespace wrinkle::test
