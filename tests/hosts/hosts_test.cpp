// Tests of source in its hosts: in a browser (WebGL 2 and WebGPU) every sample compiles in both
// forms, and there and in Godot 3 it draws the same image as OpenGL, within 2 of 255.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "gpu/texture.h"
#include "graph/subgraph.h"
#include "hosts/browser.h"
#include "hosts/godot.h"
#include "hosts/pass.h"
#include "lower/material.h"
#include "support/files.h"
#include "support/linked_nodes.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {
namespace fs = std::filesystem;

const Target& es = *find_target("essl300");
const Target& gpu_target = *find_target("wgsl");

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
    const auto target = gpu::Target::make({.width = pass_size, .height = pass_size}, diagnostics);
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

// Fragment shaders of more outputs do not link in Chromium's WebGL 2.
constexpr size_t most_draw_buffers = 8;

std::vector<BrowserJob> jobs_of(const std::vector<fs::path>& graphs) {
    std::vector<BrowserJob> jobs;
    for (const fs::path& graph : graphs) {
        const Shader pair = shader_of(graph, es, Form::shader);
        if (pair.reflection.outputs.size() <= most_draw_buffers)
            jobs.push_back({name_for(graph) + ":pair", pair.vertex, pair.fragment, false, {}});
        const Shader functions = shader_of(graph, es, Form::function);
        jobs.push_back({name_for(graph), pass_vertex(es),
                        pass_fragment(functions, shown_output(functions)), true,
                        functions.reflection.samplers});
        const Shader gpu_pair = shader_of(graph, gpu_target, Form::shader);
        jobs.push_back({name_for(graph) + ":webgpu:pair",
                        gpu_pair.vertex,
                        gpu_pair.fragment,
                        false,
                        {},
                        true});
        const Shader module = shader_of(graph, gpu_target, Form::function);
        jobs.push_back({name_for(graph) + ":webgpu", "", pass_module(module, shown_output(module)),
                        true, module.reflection.samplers, true,
                        module.reflection.parameter_block
                            ? module.reflection.parameter_block->binding.binding
                            : -1});
    }
    return jobs;
}

// Edges of cells and steps may fall on the other side of a pixel's centre: one in a thousand.
constexpr int max_off = pass_size * pass_size / 1000;

TEST(Browser, DrawsEverySampleAsOpenGlDoes) {
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
        const Shader shader = shader_of(graph, targets().front(), Form::function);
        const std::vector<uint8_t> wanted = drawn(shader, shown_output(shader));
        std::vector<std::string> pairs{name + ":webgpu:pair"};
        if (shader.reflection.outputs.size() <= most_draw_buffers) pairs.push_back(name + ":pair");
        for (const std::string& pair : pairs) {
            ASSERT_TRUE(results.count(pair)) << pair;
            EXPECT_EQ(results.at(pair).log, "") << pair;
        }
        for (const std::string& drawn_by : {name, name + ":webgpu"}) {
            ASSERT_TRUE(results.count(drawn_by));
            EXPECT_EQ(results.at(drawn_by).log, "");
            ASSERT_EQ(results.at(drawn_by).pixels.size(), wanted.size());
            EXPECT_LE(far_off(results.at(drawn_by).pixels, wanted), max_off) << drawn_by;
        }
    }
}

TEST(Godot, DrawsEverySampleAsOpenGlDoes) {
    Diagnostics diagnostics;
    auto context = gpu::Context::offscreen(diagnostics);
    ASSERT_TRUE(context && context->make_current()) << to_text(diagnostics);
    const TemporaryFolder folder;
    std::vector<GodotJob> jobs;
    for (const fs::path& graph : sample_graphs()) {
        const Shader shader = shader_of(graph, *find_target("godot3"), Form::function);
        jobs.push_back({name_for(graph), pass_canvas(shader, shown_output(shader)),
                        shader.reflection.samplers});
    }
    jobs.push_back({"seeded", jobs[0].shader + "?", {}});
    std::string log;
    const auto results = run_in_godot(jobs, folder.path(), log);
    const size_t seeded = log.find("drawing seeded");
    EXPECT_EQ(log.substr(0, seeded).find("SHADER ERROR"), log.npos) << log;
    EXPECT_NE(log.find("SHADER ERROR"), log.npos) << log;
    for (const fs::path& graph : sample_graphs()) {
        const Shader shader = shader_of(graph, targets().front(), Form::function);
        const std::vector<uint8_t> wanted = drawn(shader, shown_output(shader));
        const std::vector<uint8_t>& pixels = results.at(name_for(graph));
        ASSERT_EQ(pixels.size(), wanted.size()) << log;
        EXPECT_LE(far_off(pixels, wanted), max_off) << graph;
    }
}

// The comparison detects differences, and the browser reports invalid source.
TEST(Browser, NoticesOtherPicturesAndBadTexts) {
    const TemporaryFolder folder;
    const fs::path graph = WRINKLE_SOURCE_DIR "/graphs/base_and_detail.json";
    std::vector<BrowserJob> jobs = jobs_of({graph});
    jobs[0].name = "bad";
    jobs[0].fragment += "?";
    jobs[2].name = "bad:webgpu";
    jobs[2].fragment += "?";
    std::string why;
    const auto results = run_in_browser(jobs, folder.path(), why);
    ASSERT_EQ(why, "");
    EXPECT_NE(results.at("bad").log, "");
    EXPECT_NE(results.at("bad:webgpu").log, "");
    std::vector<uint8_t> pixels = results.at(name_for(graph)).pixels;
    ASSERT_EQ(pixels.size(), static_cast<size_t>(pass_size) * pass_size * 4);
    EXPECT_GT(far_off(pixels, std::vector<uint8_t>(pixels.size(), 255)), max_off);
    EXPECT_EQ(far_off(pixels, pixels), 0);
}

}  // namespace
}  // namespace wrinkle::test
