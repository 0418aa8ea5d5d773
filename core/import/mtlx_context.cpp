#include <algorithm>
#include <cmath>

#include "import/mtlx_importer.h"

namespace wrinkle::materialx {

NodeContext::NodeContext(Importer& importer, NodeKey key)
    : importer_(importer),
      key_(key),
      element_(importer.document()[key.element]),
      type_(type_named(element_.attribute("type"))) {}

Value NodeContext::zero(Type type) {
    return filled(type, 0);
}

Value NodeContext::filled(Type type, double number) {
    return literal_value(type, std::vector<double>(static_cast<size_t>(size_of(type)), number));
}

bool NodeContext::has(std::string_view input) const {
    return importer_.document().has_child(key_.element, input);
}

Value NodeContext::any(std::string_view name, Type type, const Value& otherwise) {
    return importer_.value(importer_.sources().input(key_, name), type, otherwise);
}

Value NodeContext::input(std::string_view name, Type type, const Value& otherwise, bool or_number) {
    Value value =
        importer_.value(importer_.sources().input(key_, name), type, otherwise, or_number);
    importer_.graph().begin(element_.name);
    if (value.bump || value.is_surface_normal) {
        fail("input '" + std::string(name) + "' reads the numbers of a normal",
             "normals that go to a normalmap, a mix or a surface shader");
        value = bad_value();
    }
    if (!value.is_bad) return value;
    failed_ = true;
    return filled(type, 0);
}

Number NodeContext::number(std::string_view name, double otherwise) {
    return graph().part(input(name, Type::float_, filled(Type::float_, otherwise)), 0);
}

Numbers NodeContext::pair(std::string_view name, double otherwise) {
    const Value value = input(name, Type::vector2, filled(Type::vector2, otherwise));
    return {graph().part(value, 0), graph().part(value, 1)};
}

double NodeContext::constant(std::string_view name, double otherwise) {
    const Value value = input(name, Type::integer, filled(Type::integer, otherwise));
    if (value.is_literal()) return value.literal(0);
    fail("input '" + std::string(name) + "' is connected", "a value");
    return otherwise;
}

std::string NodeContext::text(std::string_view name, std::string otherwise) {
    const Source source = importer_.sources().input(key_, name);
    if (source.kind == Source::Kind::absent) return otherwise;
    if (source.kind == Source::Kind::node || source.kind == Source::Kind::bad) {
        failed_ = true;
        return otherwise;
    }
    return std::string(importer_.document()[source.input].attribute("value"));
}

Value NodeContext::fail(std::string message, std::string expected) {
    failed_ = true;
    importer_.report(key_.element, Severity::error, RuleId::materialx_unsupported,
                     std::move(message), std::move(expected));
    return bad_value();
}

void NodeContext::lose(std::string message) {
    importer_.report(key_.element, Severity::warning, RuleId::materialx_unsupported,
                     std::move(message));
}

void NodeContext::approximate(std::string message) {
    importer_.report(key_.element, Severity::warning, RuleId::materialx_approximate,
                     std::move(message));
}

Handler handler_of(std::string_view category) {
    for (const auto rows : {math_handlers(), vector_handlers(), color_handlers(),
                            surface_handlers(), texture_handlers(), bump_handlers()}) {
        const auto row = std::ranges::find(rows, category, &HandlerRow::category);
        if (row != rows.end()) return row->handler;
    }
    return nullptr;
}

}  // namespace wrinkle::materialx
