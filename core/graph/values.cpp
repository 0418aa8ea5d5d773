#include "graph/values.h"

namespace wrinkle {
namespace {
using json::Kind;
using json::Value;
using Members = std::vector<std::pair<std::string, Value>>;
}  // namespace

Value link_value(const Link& link, const Value& old) {
    Members members{{"from", Value::string(link.text())}};
    if (old.has("from"))
        for (const auto& [key, value] : old.children())
            if (key != "from") members.emplace_back(key, value);
    return Value::object(members);
}

Value number_array(std::initializer_list<double> numbers, const Value& old) {
    std::vector<Value> items;
    for (const double number : numbers) {
        const size_t i = items.size();
        const bool had = old.is(Kind::array) && i < old.size() && old.at(i).is(Kind::number);
        const bool keep = had && old.at(i).as_number() == number;
        items.push_back(keep ? old.at(i) : Value::number(number));
    }
    return Value::array(items);
}

Value with_old_spelling(const Value& value, const Value& old) {
    if (value.is(Kind::number) && value == old) return old;
    if (!value.is(Kind::array) || !old.is(Kind::array)) return value;
    std::vector<Value> items;
    for (const json::Member& item : value.children()) {
        const size_t i = items.size();
        const bool keep = item.value.is(Kind::number) && i < old.size() && old.at(i) == item.value;
        items.push_back(keep ? old.at(i) : item.value);
    }
    return Value::array(items);
}

Value box_value(const Box& box, std::string_view text_key) {
    Members members;
    bool rect_kept_as_extra = false;
    for (const Extra& extra : box.unknown)
        rect_kept_as_extra |= extra.key == "rect";
    if (!box.text.empty()) members.emplace_back(text_key, Value::string(box.text));
    if (!rect_kept_as_extra)
        members.emplace_back("rect",
                             number_array({box.rect.x, box.rect.y, box.rect.width, box.rect.height},
                                          box.source.find("rect")));
    for (const Extra& extra : box.unknown)
        members.emplace_back(extra.key, extra.value);
    return Value::object(members);
}

}  // namespace wrinkle
