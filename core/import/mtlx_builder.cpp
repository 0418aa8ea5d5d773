#include "import/mtlx_builder.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "base/standard_outputs.h"
#include "base/text.h"

namespace wrinkle::materialx {
namespace {

constexpr std::array vector_ports = {"x", "y", "z", "w"};
constexpr std::array image_ports = {"red", "green", "blue", "alpha"};
constexpr size_t max_id_bytes = 100;  // leaves room for a number behind it

std::string with_size(const char* name, int size) {
    return std::string(name) + "_vec" + std::to_string(size);
}

// Returns std::nullopt for results that are not finite, and for operations that are not folded.
std::optional<double> folded(std::string_view type, const Numbers& numbers) {
    if (!std::ranges::all_of(numbers, &Number::is_literal)) return {};
    const double a = numbers[0].value, b = numbers.size() > 1 ? numbers[1].value : 0;
    std::optional<double> result;
    if (type == "add") result = a + b;
    if (type == "subtract") result = a - b;
    if (type == "multiply") result = a * b;
    if (type == "divide") result = b == 0 ? 0 : a / b;
    if (type == "negate") result = -a;
    constexpr double largest = std::numeric_limits<float>::max();
    return result && std::abs(*result) <= largest ? result : std::nullopt;
}

// Returns the number that the operation leaves unchanged, such as x of x + 0.
std::optional<Number> unchanged(std::string_view type, const Numbers& numbers) {
    if (numbers.size() != 2) return {};
    const auto is = [](const Number& number, double value) {
        return number.is_literal() && number.value == value;
    };
    const bool is_sum = type == "add", is_product = type == "multiply";
    if ((is_sum || type == "subtract") && is(numbers[1], 0)) return numbers[0];
    if ((is_product || type == "divide") && is(numbers[1], 1)) return numbers[0];
    if (is_sum && is(numbers[0], 0)) return numbers[1];
    if (is_product && is(numbers[0], 1)) return numbers[1];
    return {};
}

}  // namespace

Input wire_input(std::string port, const Link& link) {
    const std::pair<std::string, json::Value> from[] = {{"from", json::Value::string(link.text())}};
    return {std::move(port), Input::Kind::link, link, json::Value::object(from)};
}

Input literal_input(std::string port, json::Value value) {
    return {std::move(port), Input::Kind::literal, {}, std::move(value)};
}

std::string GraphBuilder::valid_id(std::string_view name) const {
    std::string id;
    for (const char c : name.substr(0, max_id_bytes))
        id += is_json_plain(c) && c != '.' && c != ' ' ? c : '_';
    if (id.starts_with('$')) id[0] = '_';
    return id.empty() || id == Link::surface || id == Link::input ? id + "_node" : id;
}

std::string GraphBuilder::free_name(const std::string& base) {
    if (ids_.insert(base).second) return base;
    size_t& next = next_suffix_.try_emplace(base, 2).first->second;
    while (!ids_.insert(base + std::to_string(next)).second)
        ++next;
    return base + std::to_string(next++);
}

Link GraphBuilder::add(const char* type, const char* output, std::vector<Input> inputs) {
    auto node = std::make_shared<Node>();
    node->id = free_name(name_);
    node->type = type;
    node->inputs = std::move(inputs);
    Link link{node->id, output};
    nodes_.push_back(std::move(node));
    return link;
}

Input GraphBuilder::input(std::string port, const Number& number) {
    if (number.link) return wire_input(std::move(port), *number.link);
    return literal_input(std::move(port), json::Value::number(number.value));
}

Input GraphBuilder::input(std::string port, const Value& value) {
    if (!value.is_literal()) return wire_input(std::move(port), wire(value));
    if (size_of(value.type) == 1) return input(std::move(port), *value.parts[0]);
    std::vector<json::Value> numbers;
    for (int i = 0; i < size_of(value.type); ++i)
        numbers.push_back(json::Value::number(value.literal(i)));
    return literal_input(std::move(port), json::Value::array(numbers));
}

void GraphBuilder::make(ImageRead& image) {
    if (image.is_made) return;
    const std::string outer = std::exchange(name_, image.id);
    std::vector<Input> inputs = {literal_input("image", image.image)};
    if (image.uv) inputs.push_back(wire_input("uv", *image.uv));
    image.id = add("image", "color", std::move(inputs)).node;
    image.is_made = true;
    name_ = outer;
}

Link GraphBuilder::wire(const Value& value) {
    if (value.whole) return *value.whole;
    const int size = size_of(value.type);
    if (size == 1) return *part(value, 0).link;
    if (value.image && size == 3) {
        make(*value.image);
        return {value.image->id, "color"};
    }
    std::vector<Input> inputs;
    for (int i = 0; i < size; ++i)
        inputs.push_back(input(vector_ports[static_cast<size_t>(i)], part(value, i)));
    const std::string type = with_size("combine", size);
    return add(type.c_str(), "vector", std::move(inputs));
}

Number GraphBuilder::part(const Value& value, int part) {
    const auto index = static_cast<size_t>(part);
    if (value.parts[index]) return *value.parts[index];
    if (value.image) {
        make(*value.image);
        return {0, Link{value.image->id, image_ports[index]}};
    }
    const Link& whole = *value.whole;
    std::string& node = separated_[whole.text()];
    if (node.empty()) {
        const std::string type = with_size("separate", size_of(value.type));
        node = add(type.c_str(), "x", {wire_input("vector", whole)}).node;
        wholes_[node + std::to_string(size_of(value.type))] = whole;
    }
    return {0, Link{node, vector_ports[index]}};
}

std::optional<Link> GraphBuilder::whole_of(const Numbers& parts) const {
    for (size_t i = 0; i < parts.size(); ++i) {
        const auto& link = parts[i].link;
        if (!link || link->node != parts[0].link->node || link->port != vector_ports[i]) return {};
    }
    const auto found = wholes_.find(parts[0].link->node + std::to_string(parts.size()));
    return found == wholes_.end() ? std::nullopt : std::optional(found->second);
}

Value GraphBuilder::from_parts(Type type, const Numbers& parts) {
    Value value;
    value.type = type;
    std::ranges::copy(parts, value.parts.begin());
    if (!value.is_literal() && parts.size() > 1) {
        Value made = value;
        made.whole = whole_of(parts);
        if (!made.whole) made.whole = wire(value);
        return made;
    }
    return value;
}

Number GraphBuilder::math(const char* type, const std::vector<const char*>& ports,
                          const Numbers& numbers) {
    if (const auto result = folded(type, numbers)) return {*result};
    if (const auto same = unchanged(type, numbers)) return *same;
    std::vector<Input> inputs;
    for (size_t i = 0; i < ports.size(); ++i)
        inputs.push_back(input(ports[i], numbers[i]));
    return {0, add(type, "result", std::move(inputs))};
}

Link GraphBuilder::expose(GraphInput input) {
    const std::string base = valid_id(input.name);
    input.name = base;
    for (size_t i = 2; !input_names_.insert(input.name).second; ++i)
        input.name = base + std::to_string(i);
    inputs_.push_back(std::move(input));
    return {std::string(Link::input), inputs_.back().name};
}

void GraphBuilder::output(std::string_view name, const Link& from) {
    outputs_[std::string(name)] = from;
}

// Ids of the nodes and exposed inputs (as "input.NAME") that the outputs read.
std::unordered_set<std::string> GraphBuilder::needed(const std::vector<NodePtr>& nodes,
                                                     const std::vector<Output>& outputs) {
    std::unordered_map<std::string_view, const Node*> by_id;
    for (const NodePtr& node : nodes)
        by_id.emplace(node->id, node.get());
    std::unordered_set<std::string> found;
    std::deque<const Node*> open;
    const auto follow = [&](const Link& link) {
        if (link.is_input()) found.insert(link.text());
        if (link.is_node() && found.insert(link.node).second) open.push_back(by_id.at(link.node));
    };
    for (const Output& output : outputs)
        follow(output.from.link);
    for (; !open.empty(); open.pop_front())
        for (const Input& input : open.front()->inputs)
            if (input.kind == Input::Kind::link) follow(input.link);
    return found;
}

wrinkle::Document GraphBuilder::finish(std::string_view name) {
    wrinkle::Document graph;
    graph.name = std::string(name);
    std::vector<Output> outputs;
    for (const StandardOutput& row : standard_output_table)
        if (const auto found = outputs_.find(std::string(row.name)); found != outputs_.end())
            outputs.push_back({found->first, wire_input(found->first, found->second)});
    const auto used = needed(nodes_, outputs);
    std::erase_if(nodes_, [&](const NodePtr& node) { return !used.contains(node->id); });
    std::erase_if(inputs_, [&](const GraphInput& input) {
        return !used.contains(std::string(Link::input) + "." + input.name);
    });
    graph.nodes = Table<NodePtr>(std::move(nodes_));
    graph.inputs = Table<GraphInput>(std::move(inputs_));
    graph.outputs = Table<Output>(std::move(outputs));
    graph.edited = true;
    return graph;
}

}  // namespace wrinkle::materialx
