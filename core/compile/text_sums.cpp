#include "compile/text_sums.h"

#include "base/sha256.h"
#include "base/text.h"
#include "glsl/reflection.h"

namespace wrinkle {

std::string reflection_json(const Shader& shader) {
    std::string sums;
    const auto add = [&](const char* name, const std::string& text) {
        if (text.empty()) return;
        sums += (sums.empty() ? "" : ", ") + json_quoted(name) + ": " + json_quoted(sha256(text));
    };
    add("function", shader.source);
    add("vertex", shader.vertex);
    add("fragment", shader.fragment);
    std::string text = to_json(shader.reflection);
    text.resize(text.rfind("\n}"));
    return text + ",\n  \"sha256\": {" + sums + "}\n}\n";
}

}  // namespace wrinkle
