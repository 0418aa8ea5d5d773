#include "gpu/program.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "emit/attributes.h"

namespace wrinkle::gpu {
namespace {

// Returns the log of a shader or program without the newlines and the null character at its end.
std::string log_of(GLuint id, PFNGLGETSHADERIVPROC get_parameter,
                   PFNGLGETSHADERINFOLOGPROC get_log) {
    GLint size = 0;
    get_parameter(id, GL_INFO_LOG_LENGTH, &size);
    std::string log(static_cast<size_t>(size), '\0');
    get_log(id, size, nullptr, log.data());
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0'))
        log.pop_back();
    return log;
}

uint32_t compile(GLenum stage, const std::string& text, std::string& log) {
    const GLuint shader = glCreateShader(stage);
    const char* source = text.data();
    const auto length = static_cast<GLint>(text.size());
    glShaderSource(shader, 1, &source, &length);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    log += (stage == GL_VERTEX_SHADER ? "vertex shader: " : "fragment shader: ") +
           log_of(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    return 0;
}

bool link_status(uint32_t program, std::string& log) {
    GLint ok = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (!ok) log += "link: " + log_of(program, glGetProgramiv, glGetProgramInfoLog);
    return ok;
}

}  // namespace

std::optional<Program> Program::link(const std::string& vertex, const std::string& fragment,
                                     std::span<const std::string> outputs, std::string& log) {
    log.clear();
    const uint32_t vertex_shader = compile(GL_VERTEX_SHADER, vertex, log);
    const uint32_t fragment_shader = compile(GL_FRAGMENT_SHADER, fragment, log);
    std::optional<Program> program;
    if (vertex_shader && fragment_shader) {
        program = Program();
        glAttachShader(program->id(), vertex_shader);
        glAttachShader(program->id(), fragment_shader);
        for (size_t i = 0; i < outputs.size(); ++i)
            glBindFragDataLocation(program->id(), static_cast<GLuint>(i), outputs[i].c_str());
        glLinkProgram(program->id());
        if (!link_status(program->id(), log)) program.reset();
    }
    glDeleteShader(vertex_shader);
    glDeleteShader(fragment_shader);
    return program;
}

void Program::use() const {
    glUseProgram(id());
}

// GL ignores location -1, the location of an unused name.
void Program::set(const char* name, int value) const {
    glUniform1i(glGetUniformLocation(id(), name), value);
}

void Program::set(const char* name, const glm::mat3& value) const {
    glUniformMatrix3fv(glGetUniformLocation(id(), name), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(glGetUniformLocation(id(), name), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const char* name, std::span<const float> value) const {
    const std::array setters{glUniform1fv, glUniform2fv, glUniform3fv, glUniform4fv};
    setters[value.size() - 1](glGetUniformLocation(id(), name), 1, value.data());
}

void Program::set(const UniformInfo& uniform) const {
    std::array<float, 4> value;
    std::copy(uniform.value.begin(), uniform.value.end(), value.begin());
    set(uniform.name.c_str(), std::span<const float>(value).first(info(uniform.type).lanes));
}

}  // namespace wrinkle::gpu
