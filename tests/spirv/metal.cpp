#include "spirv/metal.h"

#include <algorithm>

namespace wrinkle::test {
namespace {

size_t count(const std::string& text, const std::string& words) {
    size_t found = 0;
    for (size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1))
        ++found;
    return found;
}

struct Check {
    const std::string& text;
    std::string errors;

    void once(const std::string& words) {
        if (const size_t found = count(text, words); found != 1)
            errors += "'" + words + "' stands there " + std::to_string(found) + " times\n";
    }
};

std::string at(const char* kind, int number) {
    return std::string(" [[") + kind + "(" + std::to_string(number) + ")]]";
}

std::string without_comments(const std::string& text) {
    std::string code;
    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        code += line.substr(0, line.find("//")) + "\n";
        at = end + 1;
    }
    return code;
}

}  // namespace

std::string bracket_errors(const std::string& text) {
    std::string open;
    for (const char c : without_comments(text)) {
        if (c == '(' || c == '[' || c == '{') open += c;
        if (c != ')' && c != ']' && c != '}') continue;
        const char wanted = c == ')' ? '(' : c == ']' ? '[' : '{';
        if (open.empty() || open.back() != wanted) return std::string("a loose ") + c + "\n";
        open.pop_back();
    }
    return open.empty() ? "" : "an open " + open + "\n";
}

namespace {

std::string vertex_errors(const Reflection& r, const std::string& text) {
    Check check{text, bracket_errors(text)};
    check.once("vertex WrinkleVaryings_" + r.name + " " + r.vertex_entry + "(");
    for (const AttributeInfo& attribute : r.attributes)
        check.once(" " + attribute.name + at("attribute", attribute.location));
    check.once("constant WrinkleFrame& wrinkle_frame" +
               at("buffer", r.frame_block->binding.binding));
    return check.errors;
}

std::string fragment_errors(const Reflection& r, const std::string& text) {
    Check check{text, bracket_errors(text)};
    check.once("fragment WrinkleTargets_" + r.name + " " + r.fragment_entry + "(");
    for (const OutputInfo& output : r.outputs)
        check.once(" " + output.variable + at("color", output.location));
    if (r.parameter_block)
        check.once("constant " + r.parameter_block->name + "& " + r.parameter_block->variable +
                   at("buffer", r.parameter_block->binding.binding));
    for (const SamplerInfo& sampler : r.samplers) {
        check.once(" " + sampler.name + at("texture", sampler.binding.binding));
        check.once(" " + sampler.name + "_sampler" + at("sampler", sampler.binding.binding));
    }
    return check.errors;
}

}  // namespace

std::string metal_errors(const Shader& shader) {
    if (!shader.source.empty()) return bracket_errors(shader.source);
    const std::string vertex = without_comments(shader.vertex);
    const std::string fragment = without_comments(shader.fragment);
    const std::string errors =
        vertex_errors(shader.reflection, vertex) + fragment_errors(shader.reflection, fragment);
    return errors.empty() ? "" : errors + shader.fragment;
}

}  // namespace wrinkle::test
