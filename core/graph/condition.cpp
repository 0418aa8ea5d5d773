#include "graph/condition.h"

namespace wrinkle {

std::optional<Condition> parse_condition(std::string_view text) {
    constexpr std::string_view prefix = "input.";
    const bool negated = text.starts_with('!');
    if (negated) text.remove_prefix(1);
    if (!text.starts_with(prefix) || text.size() == prefix.size()) return {};
    text.remove_prefix(prefix.size());
    for (const std::string_view op : {"==", "!=", "<=", ">=", "<", ">"}) {
        const size_t at = text.find(" " + std::string(op) + " ");
        if (at == text.npos) continue;
        const std::string_view value = text.substr(at + op.size() + 2);
        if (negated || at == 0 || value.empty()) return {};
        return Condition{std::string(text.substr(0, at)), std::string(op), std::string(value)};
    }
    return Condition{std::string(text), negated ? "==" : "!=", {}};
}

}  // namespace wrinkle
