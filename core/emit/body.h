// Emits the statements of one function: temporaries grouped by node, loops, results.
#pragma once

#include <string>
#include <string_view>

#include "emit/expression.h"
#include "emit/names.h"
#include "emit/reflection.h"
#include "emit/text.h"

namespace wrinkle {

class Body {
public:
    Body(const EmitAnalysis& analysis, Values& values, const NameSet& globals, const Target& target,
         Text& text)
        : analysis_(analysis),
          m_(analysis.module()),
          values_(values),
          locals_(&globals),
          language_(target.language()),
          context_{analysis, values, target, language_, {}},
          text_(text) {}

    // Append a complete function. The material's returns all outputs, declared in the reflection; a
    // region's returns its first result and has `out` parameters for the others.
    void material_function(const Reflection& reflection);
    void region_function(uint32_t region);

private:
    std::string type_name(Type type) const { return std::string(language_.type(type)); }
    bool is_folded(Id id) const {
        return analysis_.role(id) == Role::value && !values_.state[id].statement;
    }
    Id without_views(Id id) const;
    void result(std::string_view target, Id root, bool by_matrix);
    void write_by_matrix(Id root);
    std::vector<std::string> name_parameters(const Region& region);
    std::string declared(std::string_view pattern, Type type, std::string_view name,
                         std::string_view value = {}) const;
    std::string material_signature(const Reflection& reflection);
    void material_results(const Reflection& reflection, std::span<const Id> roots);
    std::string region_signature(uint32_t region, const std::vector<std::string>& parameters,
                                 const std::vector<std::string>& outs) const;

    // A group is a node or the surface point (group_of() in emit/scope.h). `single`: the group ends
    // with this line.
    void append_comment_of(std::string& line, uint32_t group);
    void comment(int indent, uint32_t group);
    void commented_line(int indent, std::string& line, uint32_t group, bool single);
    uint32_t node_of(uint32_t group) const {
        return group == surface_group || group == 0 ? no_node : group;
    }
    void code(int indent, std::string_view line, uint32_t node);
    // `next`: group of the line after these statements; no_node: unknown.
    void statements(std::span<const Id> ids, int indent, uint32_t next = no_node);
    std::string_view name_value(Id id, const NameHint& wanted);
    void assign(Id id, int indent, uint32_t group, bool single);
    void call(Id id, int indent);
    void loop(Id id, int indent);
    std::vector<std::string> name_members(Id tuple);
    Id limit_of(const Region& region, uint32_t counter) const;
    void loop_body(Id id, const std::vector<std::string>& state, bool limited, int indent);
    void write_loop_condition(Id condition, int indent, uint32_t node);
    void next_state(Id loop, std::span<const Id> next, const std::vector<std::string>& state,
                    int indent);
    std::vector<uint32_t> state_read(Id value, uint8_t level);
    std::string assignment(const std::string& name, Id next, uint8_t level, uint32_t member);

    const EmitAnalysis& analysis_;
    const Module& m_;
    Values& values_;
    NameSet locals_;
    const Language& language_;
    ExpressionContext context_;
    Text& text_;
    std::string line_, value_;     // buffers for the current line and its expression
    uint32_t group_ = no_node;     // group of the last comment
    std::vector<bool> commented_;  // by node
    bool surface_commented_ = false;
};

}  // namespace wrinkle
