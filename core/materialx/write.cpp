#include <pugixml.hpp>
#include <sstream>

#include "materialx/document.h"

namespace wrinkle::materialx {

std::string write_document(const Document& document) {
    pugi::xml_document xml;
    pugi::xml_node declaration = xml.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    std::vector<pugi::xml_node> written;
    for (const Element& element : document.elements()) {
        pugi::xml_node parent = xml;
        if (element.parent != no_element) parent = written[element.parent];
        pugi::xml_node node = parent.append_child(element.category.c_str());
        if (!element.name.empty()) node.append_attribute("name") = element.name.c_str();
        for (const Attribute& attribute : element.attributes)
            node.append_attribute(attribute.name.c_str()) = attribute.value.c_str();
        written.push_back(node);
    }
    std::ostringstream text;
    xml.save(text, "  ", pugi::format_indent, pugi::encoding_utf8);
    return text.str();
}

}  // namespace wrinkle::materialx
