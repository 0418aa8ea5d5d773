// The elements of a MaterialX document, as written: nothing is resolved or checked against node
// definitions. Format: MaterialX Specification 1.39, "MaterialX XML".
//
// Element 0 is the root <materialx>. A parent comes before its children, and all are in file
// order. Names are unique among siblings: read_document() rejects a duplicate; add() does not
// check, and child() returns the first.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::materialx {

inline constexpr uint32_t no_element = ~uint32_t{0};
inline constexpr int max_depth = 64;  // elements in each other

struct Attribute {
    std::string name, value;
};

struct Element {
    std::string category;               // the tag: "image", "input", "nodegraph"
    std::string name;                   // "" if it has none
    std::vector<Attribute> attributes;  // all but the name, in file order
    std::vector<uint32_t> children;
    uint32_t parent = no_element;
    uint32_t line = 0, column = 0;  // from 1; 0 for an element that was not read

    // Returns the value of an attribute, "" if the element does not have it.
    std::string_view attribute(std::string_view name) const;
    bool has(std::string_view name) const;
};

class Document {
public:
    Document();  // a root without attributes

    std::string file;  // as given to read_document; "" for a new document

    const std::vector<Element>& elements() const { return elements_; }
    const Element& operator[](uint32_t element) const { return elements_[element]; }

    // Appends a child; returns its index.
    uint32_t add(uint32_t parent, std::string category, std::string name);
    void set(uint32_t element, std::string attribute, std::string value);
    void locate(uint32_t element, uint32_t line, uint32_t column);

    // Returns the child of this name, no_element if none has it. O(log n).
    uint32_t child(uint32_t parent, std::string_view name) const;
    bool has_child(uint32_t parent, std::string_view name) const;

    Location location(uint32_t element) const;

private:
    using Key = std::pair<uint32_t, std::string>;

    std::vector<Element> elements_;
    std::map<Key, uint32_t> by_name_;
};

// Reads a text. Document types, and with them entities, and XInclude are errors, as are texts
// beyond Limit::materialx_bytes, more elements than Limit::graph_nodes, and elements nested deeper
// than max_depth. Returns std::nullopt after an error.
std::optional<Document> read_document(const std::string& text, const std::string& file,
                                      Diagnostics& diagnostics);

// Returns XML of version 1.0, UTF-8, two spaces a level, with a newline at the end.
std::string write_document(const Document& document);

}  // namespace wrinkle::materialx
