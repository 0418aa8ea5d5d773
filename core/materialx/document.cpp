#include "materialx/document.h"

#include <algorithm>

namespace wrinkle::materialx {

std::string_view Element::attribute(std::string_view wanted) const {
    const auto found = std::ranges::find(attributes, wanted, &Attribute::name);
    return found == attributes.end() ? std::string_view() : found->value;
}

bool Element::has(std::string_view wanted) const {
    return std::ranges::find(attributes, wanted, &Attribute::name) != attributes.end();
}

Document::Document() {
    elements_.emplace_back();
    elements_.back().category = "materialx";
}

uint32_t Document::add(uint32_t parent, std::string category, std::string name) {
    const auto index = static_cast<uint32_t>(elements_.size());
    elements_[parent].children.push_back(index);
    Element& element = elements_.emplace_back();
    element.category = std::move(category);
    element.name = std::move(name);
    element.parent = parent;
    if (!element.name.empty()) by_name_.emplace(Key(parent, element.name), index);
    return index;
}

void Document::set(uint32_t element, std::string attribute, std::string value) {
    for (Attribute& each : elements_[element].attributes)
        if (each.name == attribute) {
            each.value = std::move(value);
            return;
        }
    elements_[element].attributes.push_back({std::move(attribute), std::move(value)});
}

void Document::locate(uint32_t element, uint32_t line, uint32_t column) {
    elements_[element].line = line;
    elements_[element].column = column;
}

uint32_t Document::child(uint32_t parent, std::string_view name) const {
    const auto found = by_name_.find(Key(parent, std::string(name)));
    return found == by_name_.end() ? no_element : found->second;
}

bool Document::has_child(uint32_t parent, std::string_view name) const {
    return child(parent, name) != no_element;
}

Location Document::location(uint32_t element) const {
    return {file, elements_[element].line, elements_[element].column};
}

}  // namespace wrinkle::materialx
