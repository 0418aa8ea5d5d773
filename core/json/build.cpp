// Construction of values: a built value is parsed from its text, linear in its length.
#include <cassert>
#include <cmath>

#include "base/text.h"
#include "json/parse.h"
#include "json/tree.h"
#include "json/write.h"

namespace wrinkle::json {
namespace {

Value built(std::string text) {
    Diagnostics none;
    constexpr uint32_t unlimited = ~0u;
    auto tree = std::make_shared<Tree>(*parse(std::move(text), "", none, unlimited).root.tree());
    tree->is_parsed = false;
    return {std::move(tree), 0};
}

}  // namespace

Value Value::boolean(bool value) {
    return built(value ? "true" : "false");
}

Value Value::number(double value) {
    assert(std::isfinite(value));
    return built(shortest(value));
}

Value Value::single(float value) {
    assert(std::isfinite(value));
    return built(shortest(value));
}

Value Value::string(std::string_view text) {
    return built(json_quoted(text));
}

Value Value::array(std::span<const Value> items) {
    return built("[" + joined(items, ", ", one_line) + "]");
}

Value Value::object(std::span<const std::pair<std::string, Value>> members) {
    const auto text = [](const auto& member) {
        return json_quoted(member.first) + ": " + one_line(member.second);
    };
    return built("{" + joined(members, ", ", text) + "}");
}

}  // namespace wrinkle::json
