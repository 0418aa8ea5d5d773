#include "emit/body.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/text.h"

namespace wrinkle {
namespace {

constexpr size_t max_code = 100;

// Returns the parameter's name in the region; without one, a letter by index: a, b, c, ...
std::string parameter_name(const Region& region, size_t index) {
    if (index < region.param_names.size() && !region.param_names[index].empty())
        return region.param_names[index];
    return std::string(1, static_cast<char>('a' + index % 26));
}

std::string result_name(const Region& region, size_t index) {
    if (index < region.result_names.size()) return "out_" + region.result_names[index];
    return "result_" + std::to_string(index + 1);
}

// Returns true for a normal that is multiplied by the member normal_matrix.
bool is_by_matrix(const Reflection& reflection, const OutputInfo& output) {
    return output.port_type == WR_PORT_normal && !reflection.members.empty() &&
           reflection.members.back().normal_matrix;
}

// Returns "// weave gives height, normal" for a sub-graph; "" for a region without result names.
std::string comment_on(const Region& region) {
    std::string text;
    for (const std::string& name : region.result_names)
        append_item(text, name);
    return text.empty() ? "" : "// " + comment_text(region.name + " gives " + text);
}

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ')';
}

}  // namespace

void Body::material_function(const Reflection& reflection) {
    std::vector<Id> roots;
    for (const ModuleOutput& output : m_.outputs)
        roots.push_back(analysis_.strip_detach(output.value));
    const Scope scope = collect(analysis_, values_, roots, 0);
    decide(analysis_, values_, scope, roots);
    code(0, material_signature(reflection), no_node);
    const std::vector<Id> ids = schedule(analysis_, values_, scope, scope.order);
    locals_.reserve(ids.size());
    const Id first = without_views(roots[0]);
    const bool bare = reflection.result_form == ResultForm::value;
    const bool returns_expression = bare && is_folded(first);
    statements(ids, 1,
               returns_expression ? group_of(analysis_, values_, first)
               : ids.empty()      ? no_node
                                  : group_of(analysis_, values_, ids.back()));
    if (bare)
        result("return ", roots[0], is_by_matrix(reflection, reflection.outputs[0]));
    else
        material_results(reflection, roots);
    text_.line(0, "}");
}

std::string Body::declared(std::string_view pattern, Type type, std::string_view name,
                           std::string_view value) const {
    return filled(pattern, {{'t', language_.type(type)}, {'n', name}, {'v', value}});
}

std::string Body::material_signature(const Reflection& r) {
    std::string list;
    if (!r.struct_name.empty())
        append_item(list, filled(language_.parameter, {{'t', r.struct_name}, {'n', "s"}}));
    if (language_.arguments == Arguments::flat)
        for (const MemberInfo& member : r.members)
            append_item(list,
                        declared(language_.parameter, member.type, locals_.add({{}, member.name})));
    if (r.result_form == ResultForm::parameters)
        for (const OutputInfo& output : r.outputs)
            append_item(list, declared(language_.out_parameter, output.type,
                                       locals_.add({{}, output.member})));
    append_item(list, values_.symbols.material_parameters);
    if (r.result_form == ResultForm::parameters)
        return filled(language_.no_value, {{'n', r.function}, {'v', list}});
    return filled(language_.function,
                  {{'t', result_type(r, language_)}, {'n', r.function}, {'v', list}});
}

void Body::material_results(const Reflection& r, std::span<const Id> roots) {
    const bool structure = r.result_form == ResultForm::structure;
    if (structure) text_.line(1, filled(language_.unset, {{'t', r.result_name}, {'n', "m"}}));
    for (size_t k = 0; k < roots.size(); ++k)
        result((structure ? "m." : "") + r.outputs[k].member + " = ", roots[k],
               is_by_matrix(r, r.outputs[k]));
    if (structure) text_.line(1, "return m;");
}

// Returns the value of which `id` is a part: a component, a column.
Id Body::without_views(Id id) const {
    while (analysis_.role(id) == Role::view && m_[id].op != Op::result_)
        id = analysis_.operands(id)[0];
    return id;
}

// Appends normalize(normal_matrix * value) to the line.
void Body::write_by_matrix(Id root) {
    const bool structs = language_.arguments == Arguments::structs;
    const std::string_view matrix = structs ? "s.normal_matrix" : "normal_matrix";
    const std::string_view transform = language_.op(Op::transform_);
    line_.append(language_.op(Op::normalize_)).append("(");
    if (language_.is_pattern(Op::transform_))
        append_filled(line_, transform, {{'0', matrix}, {'1', text_of(context_, root)}});
    else
        line_.append(matrix).append(" ").append(transform).append(" ").append(
            text_of(context_, root, info(Op::transform_).precedence + 1));
    line_.append(")");
}

// Writes the line that assigns or returns a result.
void Body::result(std::string_view target, Id root, bool by_matrix) {
    const Id value = without_views(root);
    const uint32_t group =
        analysis_.role(value) == Role::leaf ? no_node : group_of(analysis_, values_, value);
    line_ = target;
    if (by_matrix)
        write_by_matrix(root);
    else
        write(context_, root, line_);
    line_.append(";");
    if (is_folded(value))
        commented_line(1, line_, group, true);
    else
        code(1, line_, node_of(group));
}

std::vector<std::string> Body::name_parameters(const Region& region) {
    std::vector<std::string> names;
    for (size_t k = 0; k < region.params.size(); ++k)
        names.push_back(locals_.unique(parameter_name(region, k)));
    if (context_.parameters.size() <= region.level) context_.parameters.resize(region.level + 1u);
    context_.parameters[region.level] = names;
    return names;
}

std::string Body::region_signature(uint32_t index, const std::vector<std::string>& parameters,
                                   const std::vector<std::string>& outs) const {
    const Region& region = m_.region(index);
    std::string list;
    for (size_t k = 0; k < parameters.size(); ++k)
        append_item(list, declared(language_.parameter, region.params[k], parameters[k]));
    for (size_t k = 0; k < outs.size(); ++k)
        append_item(list,
                    declared(language_.out_parameter, m_.type(region.results[k + 1]), outs[k]));
    append_item(list, values_.symbols.resource_parameters[index]);
    return declared(language_.function, m_.type(region.results[0]),
                    values_.symbols.functions[index], list);
}

void Body::region_function(uint32_t index) {
    const Region& region = m_.region(index);
    values_.anonymous = true;
    const std::vector<std::string> parameters = name_parameters(region);
    std::vector<std::string> outs;
    for (size_t k = 1; k < region.results.size(); ++k)
        outs.push_back(locals_.unique(result_name(region, k)));
    const std::vector<Id> roots = analysis_.strip_detach(region.results);
    const Scope scope = collect(analysis_, values_, roots, 0);
    decide(analysis_, values_, scope, roots);
    if (const std::string comment = comment_on(region); !comment.empty())
        text_.line(0, comment, no_node);
    code(0, region_signature(index, parameters, outs), no_node);
    statements(schedule(analysis_, values_, scope, scope.order), 1);
    for (size_t k = 1; k < roots.size(); ++k)
        code(1,
             filled(language_.out_use, {{'n', outs[k - 1]}}) + " = " + text_of(context_, roots[k]) +
                 ";",
             node_of(group_));
    code(1, "return " + text_of(context_, roots[0]) + ";", node_of(group_));
    values_.anonymous = false;
    text_.line(0, "}");
}

// Appends "// weave: Tangent normal map"; appends nothing if the group has no comment.
void Body::append_comment_of(std::string& line, uint32_t group) {
    commented_.resize(m_.nodes.size());
    if (group == surface_group) {
        const bool again = std::exchange(surface_commented_, true);
        line.append(again ? "// the surface point (continued)" : "// the surface point");
        return;
    }
    const NodeInstance& node = m_.nodes[group];
    if (group == 0 || node.path.empty()) return;
    line.append("// ");
    append_comment_text(line, node.path);
    if (node.title > 0) line.append(": ");
    append_comment_text(line, m_.titles[node.title]);
    if (commented_[group]) line.append(" (continued)");
    commented_[group] = true;
}

void Body::comment(int indent, uint32_t group) {
    if (std::exchange(group_, group) == group) return;
    std::string line;
    append_comment_of(line, group);
    if (!line.empty()) text_.line(indent, line, node_of(group));
}

// Writes a statement. The first line of a group has the group's comment at its end, or on the line
// above if it does not fit. A single line of the surface point has no comment unless the group
// continues. Appends the comment to `line`.
void Body::commented_line(int indent, std::string& line, uint32_t group, bool single) {
    if (group == group_) return code(indent, line, node_of(group));
    group_ = group;
    const size_t code_end = line.size();
    line.append("  ");
    const size_t begin = line.size();
    if (!single || group != surface_group || surface_commented_) append_comment_of(line, group);
    const bool none = line.size() == begin;
    if (!none && 4 * static_cast<size_t>(indent) + line.size() <= max_code)
        return text_.line(indent, line, node_of(group));
    const std::string_view whole = line;
    if (!none) text_.line(indent, whole.substr(begin), node_of(group));
    code(indent, whole.substr(0, code_end), node_of(group));
}

// Returns where to break a line that has `room`: after the comma or operator that binds least, the
// last of these; npos for nowhere.
static size_t break_of(std::string_view line, size_t room) {
    size_t best = std::string_view::npos;
    int depth = 0, least = 0;
    for (size_t i = 0; i < std::min(room, line.size()); ++i) {
        depth += (line[i] == '(') - (line[i] == ')');
        const bool open = line[i] == ' ' && (i == 0 || line[i - 1] == ',' || !is_word(line[i - 1]));
        const bool product = open && i > 0 && (line[i - 1] == '*' || line[i - 1] == '/');
        const int binding = 2 * depth + product;
        if (!open || i < room / 3 || (best != line.npos && binding > least)) continue;
        best = i;
        least = binding;
    }
    return best == line.npos ? line.rfind(' ', room - 1) : best;
}

void Body::code(int indent, std::string_view line, uint32_t node) {
    constexpr int deeper = 2;
    for (int level = indent;; level = indent + deeper) {
        const size_t room = max_code - std::min<size_t>(4 * static_cast<size_t>(level), 60);
        if (line.size() <= room) return text_.line(level, line, node);
        const size_t end = break_of(line, room);
        if (end == std::string_view::npos) return text_.line(level, line, node);
        text_.line(level, line.substr(0, end), node);
        line.remove_prefix(end + 1);
    }
}

void Body::statements(std::span<const Id> ids, int indent, uint32_t next) {
    std::vector<uint32_t> groups;
    groups.reserve(ids.size() + 1);
    for (const Id id : ids)
        groups.push_back(group_of(analysis_, values_, id));
    groups.push_back(next);
    for (size_t i = 0; i < ids.size(); ++i) {
        const bool single = groups[i + 1] != groups[i] && groups[i + 1] != no_node;
        const Op op = m_[ids[i]].op;
        if (op != Op::loop_ && op != Op::call_) {
            assign(ids[i], indent, groups[i], single);
            continue;
        }
        comment(indent, groups[i]);
        if (op == Op::loop_)
            loop(ids[i], indent);
        else
            call(ids[i], indent);
    }
}

std::string_view Body::name_value(Id id, const NameHint& wanted) {
    ValueState& state = values_.state[id];
    state.name = locals_.add(wanted);
    state.width = static_cast<uint32_t>(state.name.size());
    return state.name;
}

void Body::assign(Id id, int indent, uint32_t group, bool single) {
    const std::string_view name = name_value(id, name_hint(analysis_, values_, id));
    line_.clear();
    value_.clear();
    write_definition(context_, id, value_);
    append_filled(line_, language_.constant,
                  {{'t', language_.type(m_.type(id))}, {'n', name}, {'v', value_}});
    commented_line(indent, line_, group, single);
}

// A member of a loop has the name of its parameter, if it has one.
std::vector<std::string> Body::name_members(Id tuple) {
    std::string_view path;
    if (!values_.anonymous) path = m_.nodes[m_.origin[tuple]].path;
    const std::vector<std::string>& own = m_.region(m_[tuple].extra).param_names;
    const bool loop = m_[tuple].op == Op::loop_;
    std::vector<std::string> names;
    for (const Id member : analysis_.members(tuple)) {
        const size_t k = names.size();
        const NameHint unread{path, loop && k < own.size() ? std::string_view(own[k]) : "state"};
        const bool named = member != no_id && (!loop || own.empty());
        names.emplace_back(
            name_value(member, named ? name_hint(analysis_, values_, member) : unread));
    }
    return names;
}

// Writes a call with several results: it returns the first; the others are `out` arguments.
void Body::call(Id id, int indent) {
    const Region& region = m_.region(m_[id].extra);
    std::string list;
    for (const Id argument : analysis_.operands(id))
        append_item(list, text_of(context_, argument));
    const std::vector<std::string> names = name_members(id);
    for (size_t k = 1; k < names.size(); ++k) {
        code(indent, declared(language_.unset, m_.type(region.results[k]), names[k]),
             node_of(group_));
        append_item(list, filled(language_.out_argument, {{'n', names[k]}}));
    }
    const uint32_t function = m_[id].extra;
    append_item(list, values_.symbols.resource_arguments[function]);
    code(indent,
         declared(language_.constant, m_.type(region.results[0]), names[0],
                  values_.symbols.functions[function] + "(" + list + ")"),
         node_of(group_));
}

}  // namespace wrinkle
