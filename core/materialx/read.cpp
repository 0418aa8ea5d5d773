#include <algorithm>
#include <pugixml.hpp>

#include "base/limits.h"
#include "base/text.h"
#include "materialx/document.h"

namespace wrinkle::materialx {
namespace {

// Attributes of an element that are read; more are an error, so that one element stays small.
constexpr size_t max_attributes = 256;

class Reader {
public:
    Reader(const std::string& text, const std::string& file, Diagnostics& diagnostics)
        : text_(text), diagnostics_(diagnostics) {
        document_.file = file;
        line_starts_.push_back(0);
        for (size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
            line_starts_.push_back(at + 1);
    }

    std::optional<Document> read() {
        if (!check_sizes() || !parse()) return {};
        const pugi::xml_node root = xml_.document_element();
        if (std::string_view(root.name()) != "materialx") {
            fail(root.offset_debug(), "the root element is <" + std::string(root.name()) + ">",
                 "a MaterialX document, with the root element <materialx>");
            return {};
        }
        return copy(root) ? std::optional(std::move(document_)) : std::nullopt;
    }

private:
    bool check_sizes() {
        const uint64_t most = limit_of(Limit::materialx_bytes);
        if (text_.size() > most)
            return over_limit(Limit::materialx_bytes, "has " + std::to_string(text_.size()) +
                                                          " bytes, more than " +
                                                          std::to_string(most));
        const auto tags = static_cast<uint64_t>(std::ranges::count(text_, '<'));
        if (tags / 2 > limit_of(Limit::graph_nodes))
            return over_limit(Limit::graph_nodes, "has more elements than " +
                                                      std::to_string(limit_of(Limit::graph_nodes)));
        return true;
    }

    bool over_limit(Limit limit, std::string message) {
        diagnostics_.add(file_problem(Severity::error, RuleId::over_limit, document_.file,
                                      std::move(message),
                                      std::string(row_of(limit).variable) + " sets another limit"));
        return false;
    }

    // Document types are parsed as one node and never expanded.
    bool parse() {
        if (!is_utf8(text_)) return fail(0, "the text is not UTF-8", "an XML document in UTF-8");
        const unsigned options = pugi::parse_default | pugi::parse_doctype;
        const pugi::xml_parse_result result =
            xml_.load_buffer(text_.data(), text_.size(), options, pugi::encoding_utf8);
        if (!result)
            return fail(result.offset, "the text is not XML: " + lower_case(result.description()),
                        "a well-formed XML document");
        for (const pugi::xml_node node : xml_.children())
            if (node.type() == pugi::node_doctype)
                return fail(node.offset_debug(), "document type declarations are not read",
                            "a document without <!DOCTYPE>");
        return true;
    }

    static std::string lower_case(std::string text) {
        if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] += 'a' - 'A';
        return text;
    }

    // In file order with an explicit stack.
    bool copy(pugi::xml_node root) {
        struct Open {
            pugi::xml_node next;
            uint32_t element;
        };
        if (!copy_attributes(root, 0)) return false;
        std::vector<Open> stack = {{root.first_child(), 0}};
        while (!stack.empty()) {
            Open& top = stack.back();
            const pugi::xml_node node = top.next;
            if (!node) {
                stack.pop_back();
                continue;
            }
            top.next = node.next_sibling();
            if (node.type() != pugi::node_element) continue;
            if (stack.size() >= static_cast<size_t>(max_depth))
                return fail(node.offset_debug(), "elements are nested more than 64 deep", "");
            const std::optional<uint32_t> element = add(node, top.element);
            if (!element) return false;
            stack.push_back({node.first_child(), *element});
        }
        return true;
    }

    std::optional<uint32_t> add(pugi::xml_node node, uint32_t parent) {
        const std::string category = node.name();
        if (category.ends_with(":include")) {
            fail(node.offset_debug(),
                 "includes '" + std::string(node.attribute("href").value()) +
                     "': other documents are not read",
                 "one document with all elements, as MaterialX writes without includes");
            return {};
        }
        const std::string name = node.attribute("name").value();
        if (!name.empty() && document_.has_child(parent, name)) {
            fail(node.offset_debug(), "'" + name + "' is the name of two elements",
                 "different names of all elements of one parent");
            return {};
        }
        const uint32_t element = document_.add(parent, category, name);
        if (!copy_attributes(node, element)) return {};
        return element;
    }

    bool copy_attributes(pugi::xml_node node, uint32_t element) {
        const Location at = location(node.offset_debug() - 1);
        document_.locate(element, at.line, at.column);
        size_t count = 0;
        for (const pugi::xml_attribute attribute : node.attributes()) {
            if (++count > max_attributes)
                return fail(node.offset_debug(), "an element has more than 256 attributes", "");
            if (std::string_view(attribute.name()) != "name")
                document_.set(element, attribute.name(), attribute.value());
        }
        return true;
    }

    bool fail(ptrdiff_t offset, std::string message, std::string expected) {
        diagnostics_.add({RuleId::materialx_syntax, Severity::error, location(offset), "", "",
                          std::move(message), std::move(expected)});
        return false;
    }

    Location location(ptrdiff_t offset) const {
        const size_t at =
            std::min(static_cast<size_t>(std::max<ptrdiff_t>(offset, 0)), text_.size());
        const auto line = std::ranges::upper_bound(line_starts_, at) - 1;
        return {document_.file, static_cast<uint32_t>(line - line_starts_.begin()) + 1,
                static_cast<uint32_t>(at - *line) + 1};
    }

    const std::string& text_;
    Diagnostics& diagnostics_;
    Document document_;
    pugi::xml_document xml_;
    std::vector<size_t> line_starts_;
};

}  // namespace

std::optional<Document> read_document(const std::string& text, const std::string& file,
                                      Diagnostics& diagnostics) {
    return Reader(text, file, diagnostics).read();
}

}  // namespace wrinkle::materialx
