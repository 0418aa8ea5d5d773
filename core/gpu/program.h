// A linked vertex and fragment shader, and its uniforms by name.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <string>

#include "emit/reflection.h"
#include "gpu/gl_handle.h"

namespace wrinkle::gpu {

class Program {
public:
    // Returns std::nullopt if the driver rejects a shader; `log` then holds the stage and the
    // driver's log. `outputs` are the fragment shader's variables for color attachments 0, 1, …
    static std::optional<Program> link(const std::string& vertex, const std::string& fragment,
                                       std::span<const std::string> outputs, std::string& log);

    void use() const;

    // Precondition: the program is in use. A name that the program does not use is ignored.
    void set(const char* name, float value) const { set(name, std::span<const float>(&value, 1)); }
    void set(const char* name, int value) const;
    template <glm::length_t n>
    void set(const char* name, const glm::vec<n, float>& value) const {
        set(name, std::span<const float>(&value.x, n));
    }
    void set(const char* name, const glm::mat3& value) const;
    void set(const char* name, const glm::mat4& value) const;
    void set(const char* name, std::span<const float> value) const;  // 1 to 4 components
    void set(const UniformInfo& uniform) const;

    uint32_t id() const { return handle_.id(); }

private:
    Program() = default;
    ProgramHandle handle_ = ProgramHandle::make();
};

}  // namespace wrinkle::gpu
