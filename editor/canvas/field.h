// A literal at a port as the hand changes it: read, spelled for people, dragged, written back.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::editor {

// How many numbers the port shows: 1 to 4 for numbers, 1 for a count, 0 for anything else.
int lanes_of_field(const Port& port);

// The numbers that hold at the port now: the literal's or the default's. Of a choice, a count or a
// flag the first one.
std::array<double, 4> numbers_at(const Node& node, const Port& port);

// A number with its unit, "0.015 m", in the shortest text that reads back as the value. Where
// `fits` refuses that, ".015"; and where it refuses that too, the number rounded to as many
// decimals as fit, or to none.
using Fits = std::function<bool(const std::string& text)>;
std::string shown_number(double value, const Port& port, const Fits& fits);
// "0.6", "4", "uv0", "fbm", "bricks.png"
std::string shown_value(const Node& node, const Port& port, const Fits& fits);

// Lane `lane` set to `value`, clamped to the hard range; the default is not written.
Document with_number(const Document& document, std::string_view node, const Port& port, int lane,
                     double value);
Document with_choice(const Document& document, std::string_view node, const Port& port,
                     uint32_t choice);
Document with_flag(const Document& document, std::string_view node, const Port& port, bool value);
Document with_file(const Document& document, std::string_view node, const Port& port,
                   std::string_view file);
// An image's "encoding" or "wrap" by its name; what holds without it is not written.
Document with_image_word(const Document& document, std::string_view node, const Port& port,
                         std::string_view key, std::string_view word);

// `start` after a drag of `pixels` along a field `width` pixels wide.
double dragged(double start, double pixels, double width, const Port& port, bool fine, bool coarse);

}  // namespace wrinkle::editor
