// Times one fragment shader in OpenGL. forms.py starts it once for each form of a material and each
// round, because a driver caches compiled programs.
//
//   wrinkle_form_bench FRAGMENT SIZE FRAMES     prints ms: link, first draw, median frame
//
// The fragment shader reads `position`, `normal`, `tangent` and `uv0` of a square and writes
// `color`. Set MESA_SHADER_CACHE_DISABLE=1.
#include <epoxy/gl.h>
#include <stdio.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "base/file.h"
#include "bench/texels/clock.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/target.h"

namespace {

using namespace wrinkle;

constexpr const char* vertex_text = R"(#version 330 core
out vec3 position, normal;
out vec4 tangent;
out vec2 uv0;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
    position = vec3(corner * 2.0 - 1.0, 0.2 * corner.x);
    normal = vec3(-0.1, 0.0, 1.0);
    tangent = vec4(1.0, 0.0, 0.1, 1.0);
    uv0 = corner;
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
)";

double milliseconds(auto work) {
    const double start = bench::seconds(CLOCK_MONOTONIC);
    work();
    return 1e3 * (bench::seconds(CLOCK_MONOTONIC) - start);
}

void draw() {
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
}

int time_shader(const std::string& fragment, int size, int frames) {
    Diagnostics diagnostics;
    auto context = gpu::Context::offscreen(diagnostics);
    if (context) context->make_current();
    const auto target =
        context ? gpu::Target::make({.width = size, .height = size}, diagnostics) : std::nullopt;
    std::string log = to_text(diagnostics);
    const std::string outputs[] = {"color"};
    std::optional<gpu::Program> program;
    const double link = milliseconds([&] {
        if (target) program = gpu::Program::link(vertex_text, fragment, outputs, log);
    });
    if (!program) return std::fprintf(stderr, "%s\n", log.c_str()), 1;
    program->use();
    target->bind();
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    const double first = milliseconds(draw);
    std::vector<double> times;
    for (int k = 0; k < frames; ++k)
        times.push_back(milliseconds(draw));
    std::sort(times.begin(), times.end());
    std::printf("%.3f %.3f %.3f\n", link, first, times[times.size() / 2]);
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    std::string why = "usage: wrinkle_form_bench FRAGMENT SIZE FRAMES";
    const auto fragment = count == 4 ? read_file(arguments[1], why) : std::nullopt;
    if (!fragment) return std::fprintf(stderr, "%s\n", why.c_str()), 2;
    return time_shader(*fragment, std::max(1, std::atoi(arguments[2])),
                       std::max(1, std::atoi(arguments[3])));
}
