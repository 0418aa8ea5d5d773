#include "glsl/reflection.h"

#include <cmath>

#include "base/text.h"

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

std::string uniform_text(const UniformInfo& u) {
    return object({{"name", json_quoted(u.name)},
                   {"type", quoted_type(u.type)},
                   {"value", value_text(u)},
                   {"node", json_quoted(u.node)},
                   {"port", json_quoted(u.port)},
                   {"graph_input", u.graph_input ? "true" : "false"}});
}

std::string sampler_text(const SamplerInfo& s) {
    std::string readers = "[";
    for (const SamplerInfo::Reader& reader : s.readers)
        readers += (readers.size() > 1 ? ", " : "") +
                   object({{"node", json_quoted(reader.node)}, {"port", json_quoted(reader.port)}});
    return object({{"name", json_quoted(s.name)},
                   {"file", json_quoted(s.written)},
                   {"encoding", json_quoted(name_of(s.options.encoding))},
                   {"wrap", json_quoted(name_of(s.options.wrap))},
                   {"filter", json_quoted(name_of(s.options.filter))},
                   {"readers", readers + "]"}});
}

std::string member_text(const MemberInfo& m) {
    constexpr std::string_view variants[] = {"value", "dx", "dy"};
    return object({{"name", json_quoted(m.name)},
                   {"type", quoted_type(m.type)},
                   {"surface", json_quoted(info(m.input).name)},
                   {"variant", json_quoted(variants[static_cast<size_t>(m.variant)])},
                   {"relative", m.relative ? "true" : "false"}});
}

std::string function_text(const FunctionInfo& f) {
    Fields fields = {{"output", json_quoted(f.output)},
                     {"function", json_quoted(f.function)},
                     {"type", quoted_type(f.type)}};
    if (f.location >= 0) {
        fields.emplace_back("location", std::to_string(f.location));
        fields.emplace_back("variable", json_quoted(f.variable));
    }
    return object(fields);
}

std::string attribute_text(const AttributeInfo& a) {
    return object({{"name", json_quoted(a.name)},
                   {"type", quoted_type(a.type)},
                   {"location", std::to_string(a.location)},
                   {"surface", json_quoted(info(a.input).name)}});
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

std::string to_json(const Reflection& r) {
    const auto line_text = [&](const LineRange& range) {
        return object({{"first", std::to_string(range.first)},
                       {"last", std::to_string(range.last)},
                       {"node", json_quoted(r.node_paths[range.node])}});
    };
    const auto frame_text = [](const FrameUniform& u) {
        return object({{"name", json_quoted(u.name)},
                       {"type", json_quoted(u.type)},
                       {"doc", json_quoted(u.doc)}});
    };
    std::string text = "{\n  \"version\": 1,\n  \"name\": " + json_quoted(r.name);
    const auto field = [&](std::string_view name, const std::string& value) {
        text += ",\n  " + json_quoted(name) + ": " + value;
    };
    field("struct", json_quoted(r.struct_name));
    field("uniform_control_flow", r.uniform_control_flow ? "true" : "false");
    field("functions", list(r.functions, function_text));
    field("members", list(r.members, member_text));
    field("uniforms", list(r.uniforms, uniform_text));
    field("samplers", list(r.samplers, sampler_text));
    field("attributes", list(r.attributes, attribute_text));
    field("varyings", list(r.varyings, json_quoted));
    field("frame_uniforms", list(r.frame_uniforms, frame_text));
    field("lines", list(ranges(r.lines), line_text));
    return text + "\n}\n";
}

}  // namespace wrinkle
