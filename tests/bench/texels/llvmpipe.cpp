#include "bench/texels/llvmpipe.h"

#include <epoxy/gl.h>

#include <cstring>

#include "bench/texels/clock.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/target.h"

namespace wrinkle::bench {
namespace {

std::string number(float value) {
    return std::to_string(static_cast<double>(value));
}

// GLSL expression of a value at the corners of a triangle of twice the target's area.
std::string corner_value(const Affine& value) {
    return number(value.at) + " + " + number(value.across * side) + " * at.x + " +
           number(value.up * side) + " * at.y";
}

std::string vector_of(const Affine* values, int count) {
    std::string text = "vec" + std::to_string(count) + "(";
    for (int k = 0; k < count; ++k)
        text += (k ? ", " : "") + corner_value(values[k]);
    return text + ")";
}

std::string vertex_text() {
    const std::string half = number(0.5F / side);
    return "#version 330 core\nout vec3 normal, tangent;\nout vec2 uv;\nvoid main() {\n"
           "vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0, at = corner - " +
           half + ";\nnormal = " + vector_of(frame().normal, 3) +
           ";\ntangent = " + vector_of(frame().tangent, 3) + ";\nuv = " + vector_of(frame().uv, 2) +
           ";\ngl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);\n}\n";
}

std::string fragment_text(const Shader& shader) {
    return "#version 330 core\nin vec3 normal, tangent;\nin vec2 uv;\nout vec4 color;\n" +
           shader.source +
           "void main() {\nWrinkleSurface_material s;\ns.normal = normal;\n"
           "s.tangent = vec4(tangent, 1.0);\ns.uv0 = uv;\ns.facing = 1.0;\n"
           "color = vec4(wrinkle_material(s).normal * 0.5 + 0.5, 1.0);\n}\n";
}

void bind_texture(const std::vector<uint32_t>& texels, GLenum unit) {
    GLuint id = 0;
    glGenTextures(1, &id);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, id);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void draw_once() {
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
}

}  // namespace

Rate draw(const Shader& shader, int rounds, int threads, Packed& texels, std::string& why) {
    Diagnostics diagnostics;
    auto context = gpu::Context::offscreen(diagnostics);
    if (context) context->make_current();
    const gpu::TargetOptions options{side, side, gpu::PixelFormat::rgba8};
    const auto target = context ? gpu::Target::make(options, diagnostics) : std::nullopt;
    why = to_text(diagnostics);
    if (!target) return {};
    const std::string outputs[] = {"color"};
    const auto program = gpu::Program::link(vertex_text(), fragment_text(shader), outputs, why);
    if (!program) return {};
    bind_texture(textures().rgba_base, 0);
    bind_texture(textures().rgba_detail, 1);
    program->use();
    program->set("base_image", 0);
    program->set("detail_image", 1);
    target->bind();
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    draw_once();
    const Rate rate = measure(rounds, threads, draw_once);
    texels.resize(texel_count);
    glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    return rate;
}

}  // namespace wrinkle::bench
