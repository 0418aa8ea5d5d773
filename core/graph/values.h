// JSON values of document parts, made with what was not edited in its old spelling; for core/graph
// alone.
#pragma once

#include "graph/document.h"

namespace wrinkle {

// {"from": "NODE.PORT"} with the unknown keys of `old` if that is a link object.
json::Value link_value(const Link& link, const json::Value& old);
// An array of these numbers; those that `old` holds at the same place keep its spelling.
json::Value number_array(std::initializer_list<double> numbers, const json::Value& old);
// `value` where an equal number at the same place of `old`, or of its array, is spelled as there.
json::Value with_old_spelling(const json::Value& value, const json::Value& old);
// A frame ("title") or note ("text").
json::Value box_value(const Box& box, std::string_view text_key);

}  // namespace wrinkle
