#include "emit/reflection.h"

#include <cmath>

#include "base/text.h"
#include "emit/language.h"
#include "emit/target.h"
#include "ir/op.h"

namespace wrinkle {
namespace {

using Fields = std::vector<std::pair<std::string_view, std::string>>;

std::string object(const Fields& fields) {
    std::string text = "{";
    for (const auto& [name, value] : fields)
        text += (text.size() > 1 ? ", " : "") + json_quoted(name) + ": " + value;
    return text + "}";
}

// A list with one entry per line.
template <class T, class Write>
std::string list(const std::vector<T>& entries, const Write& write) {
    if (entries.empty()) return "[]";
    std::string text = "[";
    for (size_t i = 0; i < entries.size(); ++i) {
        text += i ? ",\n    " : "\n    ";
        text += write(entries[i]);
    }
    return text + "\n  ]";
}

constexpr std::string_view result_forms[] = {"struct", "value", "parameters"};  // by ResultForm

std::string quoted_type(Type type) {
    return json_quoted(info(type).name);
}

std::string number(double value) {
    return std::isfinite(value) ? shortest(value) : "null";
}

std::string value_text(const UniformInfo& uniform) {
    const int lanes = info(uniform.type).lanes;
    if (lanes == 1) return number(uniform.value[0]);
    std::string text = "[";
    for (int i = 0; i < lanes && i < 4; ++i)
        text += (i ? ", " : "") + number(uniform.value[static_cast<size_t>(i)]);
    return text + "]";
}

// Adds set and binding; only the binding if the target numbers by kind, and no field if resources
// are found by name.
void add_binding(const Binding& binding, bool sets, Fields& fields) {
    if (binding.set < 0) return;
    if (sets) fields.emplace_back("set", std::to_string(binding.set));
    fields.emplace_back("binding", std::to_string(binding.binding));
}

void add_offset(int offset, Fields& fields) {
    if (offset >= 0) fields.emplace_back("offset", std::to_string(offset));
}

std::string uniform_text(const UniformInfo& u) {
    Fields fields = {
        {"name", json_quoted(u.name)}, {"type", quoted_type(u.type)},
        {"value", value_text(u)},      {"node", json_quoted(u.node)},
        {"port", json_quoted(u.port)}, {"graph_input", u.graph_input ? "true" : "false"}};
    add_offset(u.offset, fields);
    return object(fields);
}

// Formats to upload, by the type of the file's values. In the color space srgb, values of more than
// 8 bits are decoded first, because no such format is sRGB.
std::string upload_text(const TextureOptions& options, UvOrigin origin) {
    const bool srgb = options.decodes_texels();
    return object({{"color_space", srgb ? "\"srgb\"" : "\"linear\""},
                   {"u8", srgb ? "\"srgb8_alpha8\"" : "\"rgba8\""},
                   {"u16", "\"rgba16\""},
                   {"half", "\"rgba16f\""},
                   {"float", "\"rgba32f\""},
                   {"first_row", json_quoted(name_of(origin))},
                   {"mips", "true"}});
}

std::string sampler_text(const SamplerInfo& s, UvOrigin origin, bool sets) {
    std::string readers = "[";
    for (const SamplerInfo::Reader& reader : s.readers)
        readers += (readers.size() > 1 ? ", " : "") +
                   object({{"node", json_quoted(reader.node)}, {"port", json_quoted(reader.port)}});
    Fields fields = {{"name", json_quoted(s.name)},
                     {"file", json_quoted(s.written)},
                     {"encoding", json_quoted(name_of(s.options.encoding))},
                     {"wrap", json_quoted(name_of(s.options.wrap))},
                     {"filter", json_quoted(name_of(s.options.filter))},
                     {"upload", upload_text(s.options, origin)},
                     {"readers", readers + "]"}};
    add_binding(s.binding, sets, fields);
    if (s.sampler_binding >= 0)
        fields.emplace_back("sampler_binding", std::to_string(s.sampler_binding));
    return object(fields);
}

std::string member_text(const MemberInfo& m) {
    constexpr std::string_view variants[] = {"value", "dx", "dy"};
    return object({{"name", json_quoted(m.name)},
                   {"type", quoted_type(m.type)},
                   {"surface", json_quoted(m.normal_matrix ? m.name : info(m.input).name)},
                   {"variant", json_quoted(variants[static_cast<size_t>(m.variant)])},
                   {"relative", m.relative ? "true" : "false"}});
}

std::string output_json(const OutputInfo& o) {
    Fields fields = {{"output", json_quoted(o.output)},
                     {"member", json_quoted(o.member)},
                     {"type", quoted_type(o.type)}};
    if (o.location >= 0) {
        fields.emplace_back("location", std::to_string(o.location));
        fields.emplace_back("variable", json_quoted(o.variable));
    }
    return object(fields);
}

std::string attribute_text(const AttributeInfo& a) {
    Fields fields = {{"name", json_quoted(a.name)},
                     {"type", quoted_type(a.type)},
                     {"location", std::to_string(a.location)},
                     {"surface", json_quoted(info(a.input).name)}};
    if (!a.semantic.empty()) fields.emplace_back("semantic", json_quoted(a.semantic));
    return object(fields);
}

std::string frame_text(const FrameUniform& u) {
    Fields fields = {
        {"name", json_quoted(u.name)}, {"type", json_quoted(u.type)}, {"doc", json_quoted(u.doc)}};
    add_offset(u.offset, fields);
    return object(fields);
}

std::string block_text(const Block& block, bool sets) {
    Fields fields = {{"name", json_quoted(block.name)}, {"variable", json_quoted(block.variable)}};
    add_binding(block.binding, sets, fields);
    fields.emplace_back("size", std::to_string(block.size));
    return object(fields);
}

std::vector<Block> blocks_of(const Reflection& r) {
    std::vector<Block> blocks;
    for (const auto& block : {r.frame_block, r.parameter_block})
        if (block) blocks.push_back(*block);
    return blocks;
}

bool uses_sets(const Reflection& r) {
    const Target* target = find_target(r.target);
    return target && target->bindings != Bindings::by_kind;
}

struct LineRange {
    size_t first, last;
    uint32_t node;
};

std::vector<LineRange> ranges(const std::vector<uint32_t>& lines) {
    std::vector<LineRange> result;
    for (size_t i = 0; i < lines.size(); ++i) {
        if (lines[i] == no_node) continue;
        if (!result.empty() && result.back().last == i && result.back().node == lines[i])
            result.back().last = i + 1;
        else
            result.push_back({i + 1, i + 1, lines[i]});
    }
    return result;
}

}  // namespace

std::string result_type(const Reflection& r) {
    return result_type(r, glsl());
}

std::string result_type(const Reflection& r, const Language& language) {
    return r.result_name.empty() ? std::string(language.type(r.outputs[0].type)) : r.result_name;
}

std::string call_text(const Reflection& r, std::string_view surface) {
    return r.function + "(" + (r.struct_name.empty() ? "" : std::string(surface)) + ")";
}

std::string output_text(const Reflection& r, const OutputInfo& output, std::string_view result) {
    return std::string(result) + (r.result_name.empty() ? "" : "." + output.member);
}

std::string to_json(const Reflection& r) {
    const auto line_text = [&](const LineRange& range) {
        return object({{"first", std::to_string(range.first)},
                       {"last", std::to_string(range.last)},
                       {"node", json_quoted(r.node_paths[range.node])}});
    };
    const bool sets = uses_sets(r);
    std::string text = "{\n  \"version\": 2,\n  \"target\": " + json_quoted(r.target);
    const auto field = [&](std::string_view name, const std::string& value) {
        text += ",\n  " + json_quoted(name) + ": " + value;
    };
    field("name", json_quoted(r.name));
    field("function", json_quoted(r.function));
    field("struct", json_quoted(r.struct_name));
    field("result", json_quoted(r.result_name));
    field("result_form", json_quoted(result_forms[static_cast<size_t>(r.result_form)]));
    field("uv_origin", json_quoted(name_of(r.uv_origin)));
    field("normal_space", json_quoted(r.attributes.empty() ? name_of(r.normal_space) : "world"));
    field("uniform_control_flow", r.uniform_control_flow ? "true" : "false");
    field("outputs", list(r.outputs, output_json));
    field("members", list(r.members, member_text));
    field("uniforms", list(r.uniforms, uniform_text));
    field("samplers", list(r.samplers, [&](const auto& sampler) {
              return sampler_text(sampler, r.uv_origin, sets);
          }));
    if (const std::vector<Block> blocks = blocks_of(r); !blocks.empty())
        field("blocks", list(blocks, [&](const auto& b) { return block_text(b, sets); }));
    field("attributes", list(r.attributes, attribute_text));
    if (!r.attributes.empty())
        field("entry_points", object({{"vertex", json_quoted(r.vertex_entry)},
                                      {"fragment", json_quoted(r.fragment_entry)}}));
    field("varyings", list(r.varyings, json_quoted));
    field("frame_uniforms", list(r.frame_uniforms, frame_text));
    field("lines", list(ranges(r.lines), line_text));
    return text + "\n}\n";
}

}  // namespace wrinkle
