// JSON values of document parts; unedited numbers retain their old spelling. Private to core/graph.
#pragma once

#include "graph/document.h"

namespace wrinkle {

// Returns {"from": "NODE.PORT"} with the unknown keys of `old` if that is a link object.
json::Value link_value(const Link& link, const json::Value& old);
// Returns an array of these numbers; a number equal to that of `old` at its index retains its
// spelling.
json::Value number_array(std::initializer_list<double> numbers, const json::Value& old);
// Returns `value`; numbers equal to `old`, or to its element at the same index, retain its
// spelling.
json::Value with_old_spelling(const json::Value& value, const json::Value& old);
// Returns the JSON of a frame (text key "title") or note ("text").
json::Value box_value(const Box& box, std::string_view text_key);

}  // namespace wrinkle
