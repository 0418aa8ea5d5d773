// Builds the values of the nodes of a MaterialX document, each once, inputs before the nodes that
// read them.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "import/mtlx_builder.h"
#include "import/mtlx_sources.h"
#include "import/mtlx_value.h"
#include "materialx/document.h"

namespace wrinkle::materialx {

// Transfer function of stored colors: linear = stored ^ gamma; 0 is the curve of sRGB.
struct ColorSpace {
    double gamma = 1;
    bool is_linear() const { return gamma == 1; }
    bool is_srgb() const { return gamma == 0; }
};

class Importer {
public:
    // `source` is the folder of the document, `target` that of the graph.
    Importer(const Document& document, std::filesystem::path source, std::filesystem::path target,
             Diagnostics& diagnostics);

    GraphBuilder& graph() { return graph_; }
    Sources& sources() { return sources_; }
    const Document& document() const { return document_; }
    const std::vector<std::string>& images() const { return images_; }

    // Builds the nodes that the source needs, then returns its value; `otherwise` if it is absent.
    // A value of another size than `type`'s is reported, but a single number if `or_number`.
    Value value(const Source& source, Type type, const Value& otherwise, bool or_number = false);

    // Returns the color space of an element or of its nearest parent that has one; for
    // an unknown one std::nullopt, which is reported.
    std::optional<ColorSpace> color_space(uint32_t element);

    // Returns the path for the graph of the file that a `filename` names; "" after an error.
    std::string image_path(uint32_t input);

    void report(uint32_t element, Severity severity, RuleId rule, std::string message,
                std::string expected = {});
    bool is_built(uint32_t element) const { return values_.contains({0, element}); }

private:
    struct Entry {
        bool is_done = false;
        Value value;
    };

    void build(NodeKey wanted);
    std::vector<NodeKey> needs(NodeKey key);
    Value build_node(NodeKey key);
    Value constant(uint32_t input, Type type);
    Value exposed(uint32_t input, Type type);
    Value node_value(const Source& source);
    bool within_limits(NodeKey key);

    const Document& document_;
    std::filesystem::path source_, target_;
    Diagnostics& diagnostics_;
    Sources sources_;
    GraphBuilder graph_;
    std::map<NodeKey, Entry> values_;
    std::map<uint32_t, Value> exposed_;  // by element of the interface
    std::vector<std::string> images_;
    bool is_over_limit_ = false;
};

// One node that is being built.
class NodeContext {
public:
    NodeContext(Importer& importer, NodeKey key);

    const Element& element() const { return element_; }
    std::string_view category() const { return element_.category; }
    Type type() const { return type_; }
    int size() const { return size_of(type_); }
    GraphBuilder& graph() { return importer_.graph(); }
    Importer& importer() { return importer_; }
    NodeKey key() const { return key_; }

    bool has(std::string_view input) const;
    // Numbers of an input; a value of `type`, or one number if `or_number`.
    Value input(std::string_view name, Type type, const Value& otherwise, bool or_number = false);
    Value input(std::string_view name, Type type) { return input(name, type, zero(type)); }
    Number number(std::string_view name, double otherwise);
    Numbers pair(std::string_view name, double otherwise);
    // A number that is known: a wire is an error.
    double constant(std::string_view name, double otherwise);
    std::string text(std::string_view name, std::string otherwise);
    // As input(), for values that may be normals.
    Value any(std::string_view name, Type type, const Value& otherwise);

    static Value zero(Type type);
    static Value filled(Type type, double number);

    bool failed() const { return failed_; }
    Value fail(std::string message, std::string expected = {});
    void lose(std::string message);         // a warning: left out
    void approximate(std::string message);  // a warning: replaced

private:
    Importer& importer_;
    NodeKey key_;
    const Element& element_;
    Type type_;
    bool failed_ = false;
};

// A normal between two, both bumps or the surface's own.
Value mix_normals(NodeContext& context, const Value& bg, const Value& fg, const Value& mask);

using Handler = Value (*)(NodeContext&);
struct HandlerRow {
    std::string_view category;
    Handler handler;
};

std::span<const HandlerRow> math_handlers();
std::span<const HandlerRow> vector_handlers();
std::span<const HandlerRow> color_handlers();
std::span<const HandlerRow> surface_handlers();
std::span<const HandlerRow> texture_handlers();
std::span<const HandlerRow> bump_handlers();
Handler handler_of(std::string_view category);  // null for an unknown one

}  // namespace wrinkle::materialx
