#include "registry/reference.h"

#include <algorithm>

#include "base/text.h"

namespace wrinkle {
namespace {

// Returns the families in order of first appearance.
std::vector<std::string> families(const Registry& registry) {
    std::vector<std::string> names;
    for (const NodeType& type : registry.list())
        if (std::ranges::find(names, type.family) == names.end()) names.push_back(type.family);
    return names;
}

template <class Write>
std::string by_family(const Registry& registry, Write write) {
    std::string text;
    for (const std::string& family : families(registry)) {
        text += write(family, nullptr);
        for (const NodeType& type : registry.list())
            if (type.family == family) text += write(family, &type);
    }
    return text;
}

std::string rows_text(const NodeType& type, bool outputs) {
    std::string text;
    for (const Port& port : type.ports) {
        if ((port.kind == Port::Kind::output) != outputs) continue;
        text += "    " + padded(port.name, 16) + " " + padded(kind_text(port), 12) + " " + port.doc;
        const std::string details = details_text(port);
        text += details.empty() ? "\n" : " (" + details + ")\n";
    }
    return text;
}

// Escapes bars and line ends, which would end a table cell.
std::string cell(const std::string& text) {
    std::string safe;
    for (const char c : text)
        safe += c == '|' ? std::string("\\|") : c == '\n' ? " " : std::string(1, c);
    return safe;
}

std::string rows_markdown(const NodeType& type, bool outputs) {
    std::string text;
    for (const Port& port : type.ports)
        if ((port.kind == Port::Kind::output) == outputs)
            text += "| `" + port.name + "` | " + cell(kind_text(port)) + " | " + cell(port.doc) +
                    " | " + cell(details_text(port)) + " |\n";
    return text;
}

}  // namespace

std::string padded(std::string text, size_t width) {
    if (text.size() < width) text.append(width - text.size(), ' ');
    return text;
}

std::string list_text(const Registry& registry) {
    return by_family(registry, [](const std::string& family, const NodeType* type) {
        if (!type) return family + "\n";
        return "    " + padded(type->id, 24) + " " + type->doc + "\n";
    });
}

std::string page_text(const NodeType& type) {
    std::string text = type.id + ": " + type.title + " (" + type.family + ", version " +
                       std::to_string(type.version) + ", " + type.origin + ")\n" + type.doc + "\n";
    const std::string inputs = rows_text(type, false);
    if (!inputs.empty()) text += "\n  in\n" + inputs;
    return text + "\n  out\n" + rows_text(type, true);
}

std::string head_json(const NodeType& type) {
    return "{\"id\": " + json_quoted(type.id) + ", \"title\": " + json_quoted(type.title) +
           ", \"doc\": " + json_quoted(type.doc) + ", \"family\": " + json_quoted(type.family) +
           ", \"version\": " + std::to_string(type.version);
}

std::string page_json(const NodeType& type) {
    const auto line = [](const Port& port) { return "\n  " + port_json(port); };
    return head_json(type) + ", \"origin\": " + json_quoted(type.origin) + ", \"ports\": [" +
           joined(type.ports, ",", line) + "]}\n";
}

std::string list_json(const Registry& registry) {
    const auto line = [](const NodeType& type) {
        std::string page = "\n" + page_json(type);
        page.pop_back();  // the end of the line
        return page;
    };
    return "{\"version\": 1, \"nodes\": [" + joined(registry.list(), ",", line) + "\n]}\n";
}

std::string page_markdown(const NodeType& type) {
    std::string text = "### " + type.title + " (`" + type.id + "`)\n\n" + type.doc + "\n\n";
    text += "| port | type | | |\n|---|---|---|---|\n" + rows_markdown(type, false);
    return text + "| **out** | | | |\n" + rows_markdown(type, true) + "\n";
}

std::string list_markdown(const Registry& registry) {
    return "# Nodes\n\n" + by_family(registry, [](const std::string& family, const NodeType* type) {
               return type ? page_markdown(*type) : "## " + family + "\n\n";
           });
}

}  // namespace wrinkle
