// Translates a GLSL 4.50 Shader to the language of its target.
#include <charconv>

#include "base/dynamic_library.h"
#include "base/text.h"
#include "glsl/log.h"
#include "glsl/text.h"
#include "spirv/tools.h"

namespace wrinkle {
namespace {

// Node index of each GLSL line, the comment of each node, and the second GLSL line as the title.
struct Origin {
    std::string title;
    std::vector<uint32_t> nodes;
    std::vector<std::string> comments;  // by node; "" for none

    Origin(const std::string& glsl, std::vector<uint32_t> lines, size_t node_count);
};

Origin::Origin(const std::string& glsl, std::vector<uint32_t> lines, size_t node_count)
    : nodes(std::move(lines)), comments(node_count) {
    const std::vector<std::string_view> texts = split(glsl, '\n');
    if (texts.size() > 1) title = texts[1];
    for (size_t i = 0; i < nodes.size() && i < texts.size(); ++i) {
        const size_t comment = texts[i].find("// ");
        if (nodes[i] >= node_count || comment == std::string_view::npos) continue;
        if (comments[nodes[i]].empty()) comments[nodes[i]] = texts[i].substr(comment);
    }
}

// Returns the number of a directive "#line 12 ..."; 0 for any other line.
size_t directive(std::string_view line) {
    constexpr std::string_view mark = "#line ";
    if (!line.starts_with(mark)) return 0;
    size_t number = 0;
    std::from_chars(line.data() + mark.size(), line.data() + line.size(), number);
    return number;
}

// Removes the #line directives. Writes the title first, a comment where the code of a node begins,
// and the node of each line to the line table.
Text with_nodes(const std::string& translated, const Origin& origin) {
    Text text;
    text.line(0, origin.title);
    uint32_t node = no_node, shown = no_node;
    std::string_view rest = translated;
    while (!rest.empty()) {
        const size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (const size_t number = directive(line)) {
            node = number <= origin.nodes.size() ? origin.nodes[number - 1] : no_node;
            continue;
        }
        const bool inside = line.starts_with(' ');
        if (!inside) shown = no_node;
        if (line.empty() || line[0] == '}') node = no_node;
        const bool begins = inside && node != no_node && node != shown;
        if (begins && !origin.comments[node].empty()) text.line(1, origin.comments[node], node);
        if (inside && node != no_node) shown = node;
        text.line(0, line, inside ? node : no_node);
    }
    return text;
}

// Returns "TEXCOORD0" for "uv0", "POSITION" for "position".
std::string semantic_of(const std::string& attribute) {
    if (attribute.starts_with("uv")) return "TEXCOORD" + attribute.substr(2);
    std::string upper = attribute;
    for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return upper;
}

class Translator {
public:
    explicit Translator(Shader& shader)
        : shader_(shader), r_(shader.reflection), target_(*find_target(r_.target)) {}

    void run();

private:
    bool metal() const { return target_.name == "msl"; }
    bool stage(ShaderStage stage, std::string& text, std::vector<uint32_t> lines);
    bool to_binary(ShaderStage stage, std::string& text);
    bool to_text(ShaderStage stage, std::string& text, std::vector<uint32_t> lines);
    void set_names();
    bool refuse(const std::string& log);

    Shader& shader_;
    Reflection& r_;
    const Target& target_;
    std::vector<uint32_t> made_lines_;  // node of each line of the last translated stage
};

bool Translator::refuse(const std::string& log) {
    const std::string sentence = std::string(target_.label) + " cannot be made from the GLSL";
    shader_.problems.push_back(problem_of_log(sentence, log, r_));
    shader_.vertex.clear();
    shader_.fragment.clear();
    return false;
}

bool Translator::to_binary(ShaderStage stage, std::string& text) {
    std::string log;
    const auto words = compile_to_spirv(text, stage, Lines::forget, log);
    const auto smaller = words ? optimised(*words, Inlining::none, log) : std::nullopt;
    if (!smaller) return refuse(log);
    text = bytes_of(*smaller);
    made_lines_.clear();
    return true;
}

bool Translator::to_text(ShaderStage stage, std::string& text, std::vector<uint32_t> lines) {
    std::string log;
    const auto words = compile_to_spirv(text, stage, Lines::keep, log);
    if (!words) return refuse(log);
    std::vector<WrinkleSpirvName> names;
    for (const auto* block : {&r_.frame_block, &r_.parameter_block})
        if (*block) names.push_back({(*block)->name.c_str(), (*block)->variable.c_str()});
    std::vector<WrinkleSpirvSemantic> semantics;
    for (const AttributeInfo& attribute : r_.attributes)
        if (!attribute.semantic.empty())
            semantics.push_back(
                {static_cast<uint32_t>(attribute.location), attribute.semantic.c_str()});
    const bool vertex = stage == ShaderStage::vertex;
    const std::string& entry = vertex ? r_.vertex_entry : r_.fragment_entry;
    WrinkleSpirvJob job{};
    job.language = metal() ? WRINKLE_SPIRV_MSL : WRINKLE_SPIRV_HLSL;
    job.stage = vertex ? WRINKLE_SPIRV_VERTEX : WRINKLE_SPIRV_FRAGMENT;
    job.entry = entry.c_str();
    job.names = names.data();
    job.name_count = static_cast<uint32_t>(names.size());
    job.semantics = semantics.data();
    job.semantic_count = vertex ? static_cast<uint32_t>(semantics.size()) : 0;
    std::string translated;
    const WrinkleSpirvModule* module = spirv_module(log);
    if (!module->translate(view_of(*words), &job, sink_of(translated), sink_of(log)))
        return refuse(log);
    Text made = with_nodes(translated, Origin(text, std::move(lines), r_.node_paths.size()));
    text = std::move(made.text);
    made_lines_ = std::move(made.nodes);
    return true;
}

bool Translator::stage(ShaderStage stage, std::string& text, std::vector<uint32_t> lines) {
    return target_.bindings == Bindings::by_set ? to_binary(stage, text)
                                                : to_text(stage, text, std::move(lines));
}

void Translator::set_names() {
    if (metal()) {
        r_.vertex_entry = r_.name + "_vertex";
        r_.fragment_entry = r_.name + "_fragment";
    } else if (target_.bindings == Bindings::by_kind) {
        for (AttributeInfo& attribute : r_.attributes)
            attribute.semantic = semantic_of(attribute.name);
        for (UniformInfo& uniform : r_.uniforms)
            uniform.name = r_.parameter_block->variable + "_" + uniform.name;
        for (FrameUniform& uniform : r_.frame_uniforms)
            uniform.name = r_.frame_block->variable + "_" + uniform.name;
    }
}

void Translator::run() {
    set_names();
    if (!stage(ShaderStage::vertex, shader_.vertex, {})) return;
    if (stage(ShaderStage::fragment, shader_.fragment, r_.lines)) r_.lines = made_lines_;
}

}  // namespace

Shader write_shader(const Module& module, const EmitOptions& options) {
    Shader shader = emit(module, options);
    if (!is_translated(*options.target) || !shader.problems.empty()) return shader;
    std::string why;
    if (!have_spirv_tools(why)) {
        shader.problems.push_back({0, why, library_remedy});
        shader.vertex.clear();
        shader.fragment.clear();
        return shader;
    }
    Translator(shader).run();
    return shader;
}

}  // namespace wrinkle
