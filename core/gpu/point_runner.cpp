#include "gpu/point_runner.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "emit/attributes.h"
#include "emit/emit.h"
#include "gpu/covering.h"
#include "gpu/draw_state.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "gpu/texture.h"

namespace wrinkle::gpu {
namespace {

// Points per row; attribute k of all points is stored in the rows from k * rows_of(job) on.
constexpr size_t row_length = 1024;

constexpr const char* point_vertex_text = R"(#version 330 core
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

size_t rows_of(const PointJob& job) {
    return (job.points + row_length - 1) / row_length;
}

bool refuse(Diagnostics& diagnostics, std::string why) {
    diagnostics.error(RuleId::opengl, std::move(why));
    return false;
}

const MipChain* find_image(const PointJob& job, const std::string& file) {
    for (const PointImage& image : job.images)
        if (image.file == file) return image.chain;
    return nullptr;
}

bool check(const PointJob& job, Diagnostics& diagnostics) {
    if (job.outputs < 1) return refuse(diagnostics, "a point job has at least one output");
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (rows_of(job) * job.attributes.size() > static_cast<size_t>(limit))
        return refuse(diagnostics, "a table of " + std::to_string(job.points) + " points and " +
                                       std::to_string(job.attributes.size()) +
                                       " attributes is too large for this driver");
    for (const PointAttribute& attribute : job.attributes) {
        if (attribute.components < 1 || attribute.components > 4)
            return refuse(diagnostics,
                          "attribute '" + attribute.name + "' needs 1 to 4 components");
        if (attribute.values.size() != job.points * static_cast<size_t>(attribute.components))
            return refuse(diagnostics, "attribute '" + attribute.name + "' has " +
                                           std::to_string(attribute.values.size()) +
                                           " values, which does not fit " +
                                           std::to_string(job.points) + " points");
    }
    for (const SamplerInfo& sampler : job.samplers)
        if (!find_image(job, sampler.file))
            return refuse(diagnostics, "no image is given for '" + sampler.file + "'");
    return true;
}

Texture upload_table(const PointJob& job) {
    const size_t block = rows_of(job) * row_length;
    const size_t blocks = std::max<size_t>(job.attributes.size(), 1);
    std::vector<float> texels(4 * block * blocks);
    for (size_t k = 0; k < job.attributes.size(); ++k) {
        const PointAttribute& attribute = job.attributes[k];
        const auto components = static_cast<size_t>(attribute.components);
        for (size_t i = 0; i < attribute.values.size(); ++i)
            texels[4 * (k * block + i / components) + i % components] = attribute.values[i];
    }
    const auto height = static_cast<int>(rows_of(job) * blocks);
    return Texture::of_floats(static_cast<int>(row_length), height, texels);
}

std::string local_of(const PointJob& job, size_t k) {
    constexpr std::array types{"float", "vec2", "vec3", "vec4"};
    constexpr std::array swizzles{".x", ".xy", ".xyz", ""};
    const PointAttribute& attribute = job.attributes[k];
    const auto last = static_cast<size_t>(attribute.components - 1);
    const std::string row = std::to_string(k * rows_of(job));
    return "    " + std::string(types[last]) + " " + attribute.name +
           " = texelFetch(WrPoint_table, ivec2(gl_FragCoord.xy) + ivec2(0, " + row + "), 0)" +
           swizzles[last] + ";\n";
}

// The outputs that one pass draws; drivers draw to at least eight targets.
constexpr int most_targets = 8;
struct Group {
    int first, count;
    bool has(int output) const { return output >= first && output < first + count; }
};

std::string fragment_text(const PointJob& job, Group group) {
    std::string text = "#version 330 core\nuniform sampler2D WrPoint_table;\n";
    for (int i = 0; i < job.outputs; ++i)
        text += (group.has(i) ? "out vec4 out" : "vec4 out") + std::to_string(i) + ";\n";
    text += "#line 1\n" + job.globals + "\n#line 100001\nvoid main() {\n";
    for (size_t k = 0; k < job.attributes.size(); ++k)
        text += local_of(job, k);
    return text + "#line 200001\n" + job.body + "\n}\n";
}

std::optional<Program> compile(const PointJob& job, Group group, Diagnostics& diagnostics) {
    std::vector<std::string> outputs;
    for (int i = 0; i < group.count; ++i)
        outputs.push_back("out" + std::to_string(group.first + i));
    std::string log;
    std::optional<Program> program =
        Program::link(point_vertex_text, fragment_text(job, group), outputs, log);
    if (!program)
        diagnostics.error(RuleId::shader_rejected, "the driver refuses the shader: " + log);
    return program;
}

void draw_all_pixels() {
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    draw_covering_triangle();
}

PointResults read_results(const PointJob& job, Group group, const Target& target) {
    PointResults results;
    for (int k = 0; k < group.count; ++k) {
        const std::vector<float> pixels = target.read(k);
        auto& points = results.emplace_back(job.points);
        for (size_t i = 0; i < job.points; ++i)
            std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, points[i].begin());
    }
    return results;
}

std::optional<PointResults> run_group(const PointJob& job, Group group, Diagnostics& diagnostics) {
    TargetOptions options{static_cast<int>(row_length), static_cast<int>(rows_of(job)),
                          PixelFormat::rgba32f};
    options.colors = group.count;
    const std::optional<Target> target = Target::make(options, diagnostics);
    if (!target) return std::nullopt;
    const std::optional<Program> program = compile(job, group, diagnostics);
    if (!program) return std::nullopt;
    const Texture table = upload_table(job);
    program->use();
    std::vector<Texture> textures;
    std::vector<Sampler> samplers;  // their destruction unbinds them
    for (const SamplerInfo& sampler : job.samplers) {
        textures.push_back(Texture::upload(*find_image(job, sampler.file)));
        samplers.emplace_back(sampler.options.wrap, sampler.options.filter);
        const auto unit = static_cast<int>(textures.size());
        textures.back().bind(unit);
        samplers.back().bind(unit);
        program->set(sampler.name.c_str(), unit);
    }
    table.bind(0);
    program->set("WrPoint_table", 0);
    for (const UniformInfo& uniform : job.uniforms)
        program->set(uniform);
    target->bind();
    draw_all_pixels();
    return read_results(job, group, *target);
}

}  // namespace

PointJob point_job_from(const Shader& shader) {
    const Reflection& reflection = shader.reflection;
    PointJob job;
    job.globals = shader.source;
    if (!reflection.struct_name.empty()) job.body = reflection.struct_name + " s;\n";
    for (const MemberInfo& member : reflection.members)
        job.body += "s." + member.name + " = " + member.name + ";\n";
    job.body += result_type(reflection) + " m = " + call_text(reflection, "s") + ";\n";
    for (size_t k = 0; k < reflection.outputs.size(); ++k) {
        const OutputInfo& output = reflection.outputs[k];
        constexpr std::array padding{", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
        job.body += "out" + std::to_string(k) + " = vec4(" + output_text(reflection, output, "m") +
                    padding[info(output.type).lanes - 1U] + ");\n";
    }
    job.outputs = static_cast<int>(reflection.outputs.size());
    job.samplers = reflection.samplers;
    job.uniforms = reflection.uniforms;
    return job;
}

std::optional<PointResults> run_points(const PointJob& job, Diagnostics& diagnostics) {
    if (!check(job, diagnostics)) return std::nullopt;
    if (job.points == 0) return PointResults(static_cast<size_t>(job.outputs));
    PointResults results;
    for (int first = 0; first < job.outputs; first += most_targets) {
        auto group =
            run_group(job, {first, std::min(most_targets, job.outputs - first)}, diagnostics);
        if (!group) return std::nullopt;
        std::ranges::move(*group, std::back_inserter(results));
    }
    return results;
}

}  // namespace wrinkle::gpu
