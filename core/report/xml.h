// Text in XML 1.0 (W3C, Extensible Markup Language, fifth edition, 2.2 and 2.4).
#pragma once

#include <string>
#include <string_view>

namespace wrinkle::report {

// Returns the text without ANSI escape sequences (ECMA-48), with U+FFFD for each character that XML
// does not allow and each byte that is not UTF-8.
std::string xml_characters(std::string_view text);

// Escapes a text for an attribute in double quotes: tabs and line ends as character references,
// since a reader takes a plain one for a space.
std::string xml_attribute(std::string_view text);

// Escapes a text between tags.
std::string xml_text(std::string_view text);

}  // namespace wrinkle::report
