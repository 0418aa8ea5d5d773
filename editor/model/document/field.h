// A literal at a port as edited on the canvas: read, formatted, dragged, written back.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::editor {

// Number of components that the port shows: 1 to 4 for numbers, 1 for a count, else 0.
int lanes_of_field(const Port& port);

// Returns the current numbers of the port: of its literal, else of its default. A choice, a count
// or a flag uses only the first.
std::array<double, 4> numbers_at(const Node& node, const Port& port);

// Returns the literal of a value with that many components.
json::Value literal_of(const std::array<double, 4>& numbers, int lanes);

// Formats a number with its unit, "0.015 m", as the shortest text that reads back as the value. If
// `fits` rejects it, drops the leading zero (".015"); if `fits` rejects that too, rounds to the
// most decimals (7 to 0) that fit.
using Fits = std::function<bool(const std::string& text)>;
std::string shown_number(double value, const Port& port, const Fits& fits);
// "0.6", "4", "uv0", "fbm", "bricks.png"
std::string shown_value(const Node& node, const Port& port, const Fits& fits);

// Sets lane `lane` to `value`, clamped to the hard range; a default value is not stored.
Document with_number(const Document& document, std::string_view node, const Port& port, int lane,
                     double value);
Document with_choice(const Document& document, std::string_view node, const Port& port,
                     uint32_t choice);
Document with_flag(const Document& document, std::string_view node, const Port& port, bool value);
// Returns the literal of an image with another file.
json::Value with_file(const json::Value& image, std::string_view file);
Document with_file(const Document& document, std::string_view node, const Port& port,
                   std::string_view file);
// Sets an image's "encoding" or "wrap" (`key`) by its name; a default value is not stored.
Document with_image_word(const Document& document, std::string_view node, const Port& port,
                         std::string_view key, std::string_view word);

// Returns `start` after a drag of `pixels` along a field `width` pixels wide.
double dragged(double start, double pixels, double width, const Port& port, bool fine, bool coarse);

}  // namespace wrinkle::editor
