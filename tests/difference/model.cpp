#include "difference/random_edits.h"
#include "json/parse.h"
#include "json/write.h"

namespace wrinkle::test {
namespace {

std::string in_quotes(const std::string& text) {
    return "\"" + text + "\"";
}

std::string keys_text(const ModelKeys& keys) {
    if (keys.contains("")) return keys.at("");
    std::string members, ports;
    for (const auto& [key, value] : keys) {
        const bool is_port = key.starts_with("in.");
        std::string& list = is_port ? ports : members;
        list +=
            (list.empty() ? "" : ", ") + in_quotes(is_port ? key.substr(3) : key) + ": " + value;
    }
    if (!ports.empty()) members += (members.empty() ? "" : ", ") + ("\"in\": {" + ports + "}");
    return "{" + members + "}";
}

}  // namespace

std::string model_text(const Model& model) {
    std::string text = "{\"wrinkle\": 1";
    for (const auto& [section, entries] : model) {
        text += ", " + in_quotes(section == "positions" ? "layout" : section) + ": {";
        bool is_first = true;
        for (const auto& [id, keys] : entries) {
            text += (is_first ? "\n" : ",\n") + in_quotes(id) + ": " + keys_text(keys);
            is_first = false;
        }
        text += "}";
    }
    return text + "}\n";
}

Model model_of(const std::string& text) {
    Model model;
    Diagnostics none;
    for (const auto& [section, entries] : json::parse(text, "", none).root.children()) {
        const std::string name(section == "layout" ? "positions" : section);
        for (const auto& [id, value] : entries.children()) {
            ModelKeys& keys = model[name][std::string(id)];
            if (name == "outputs" || name == "positions") {
                keys[""] = json::one_line(value);
                continue;
            }
            for (const auto& [key, member] : value.children()) {
                if (name != "nodes" || key != "in") {
                    keys[std::string(key)] = json::one_line(member);
                    continue;
                }
                for (const auto& [port, input] : member.children())
                    keys["in." + std::string(port)] = json::one_line(input);
            }
        }
    }
    return model;
}

}  // namespace wrinkle::test
