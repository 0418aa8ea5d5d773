#include "registry/listing.h"

#include <cmath>
#include <deque>
#include <limits>

#include "base/text.h"
#include "json/parse.h"
#include "json/write.h"
#include "registry/reference.h"
#include "wrinkle/plugin.h"

namespace wrinkle {
namespace {

using json::Kind;
using json::Value;

constexpr double listing_form = 1;  // increased if older programs must not read it

std::string node_json(const NodeType& type) {
    std::string text = head_json(type);
    const auto rename_json = [](const Rename& rename) {
        return "{\"version\": " + std::to_string(rename.version) +
               ", \"old\": " + json_quoted(rename.old_name) +
               ", \"new\": " + json_quoted(rename.new_name) + "}";
    };
    if (!type.renames.empty())
        text += ", \"renames\": [" + joined(type.renames, ", ", rename_json) + "]";
    return text + ", \"ports\": [" + joined(type.ports, ", ", port_json) + "]}";
}

// Converts JSON to the C structs of a plugin, which are valid during the lifetime of this object.
class Descriptors {
public:
    const wr_plugin* plugin(const Value& root) {
        plugin_ = {};
        plugin_.size = sizeof plugin_;
        plugin_.abi = number(root, "abi");
        plugin_.id = text(root, "id");
        plugin_.version = text(root, "version");
        const Value nodes = root.find("nodes");
        if (!nodes.is(Kind::array)) wrong(root, "has no list of nodes");
        list(nodes, &Descriptors::node, node_lists_, plugin_.nodes, plugin_.node_count);
        return &plugin_;
    }

    const std::string& problem() const { return problem_; }
    const Value& problem_value() const { return problem_value_; }

private:
    void wrong(const Value& at, std::string message) {
        if (!problem_.empty()) return;
        problem_ = std::move(message);
        problem_value_ = at;
    }

    // Returns null if absent; another kind is an error.
    const char* text(const Value& object, std::string_view key) {
        const Value value = object.find(key);
        if (value.is(Kind::null)) return nullptr;
        if (!value.is(Kind::string)) {
            wrong(value, "\"" + std::string(key) + "\" is not a string");
            return nullptr;
        }
        return texts_.emplace_back(value.as_string()).c_str();
    }

    uint32_t number(const Value& object, std::string_view key) {
        const Value value = object.find(key);
        const double x = value.is(Kind::number) ? value.as_number() : -1;
        if (x >= 0 && x < 4294967296.0 && x == std::floor(x)) return static_cast<uint32_t>(x);
        wrong(value.is(Kind::null) ? object : value,
              "\"" + std::string(key) + "\" is not a whole number");
        return 0;
    }

    template <class T>
    void list(const Value& from, T (Descriptors::*read)(const Value&),
              std::deque<std::vector<T>>& lists, const T*& items, uint32_t& count) {
        std::vector<T>& list = lists.emplace_back();
        for (const json::Member& each : from.children())
            list.push_back((this->*read)(each.value));
        items = list.data();
        count = static_cast<uint32_t>(list.size());
    }

    const wr_node* node(const Value& object) {
        wr_node& node = nodes_.emplace_back();
        node.size = sizeof node;
        node.version = number(object, "version");
        node.id = text(object, "id");
        node.title = text(object, "title");
        node.doc = text(object, "doc");
        node.family = text(object, "family");
        node.build = [](const wr_builder*) {};
        list(object.find("ports"), &Descriptors::port, port_lists_, node.ports, node.port_count);
        list(object.find("renames"), &Descriptors::rename, rename_lists_, node.renames,
             node.rename_count);
        return &node;
    }

    const wr_rename* rename(const Value& object) {
        wr_rename& rename = renames_.emplace_back();
        rename.size = sizeof rename;
        rename.version = number(object, "version");
        rename.old_name = text(object, "old");
        rename.new_name = text(object, "new");
        return &rename;
    }

    const wr_port* port(const Value& object) {
        wr_port& port = ports_.emplace_back();
        port.size = sizeof port;
        port.kind = kind_number(text(object, "kind"));
        port.name = text(object, "name");
        port.doc = text(object, "doc");
        port.unit = text(object, "unit");
        port.encoding = text(object, "encoding");
        if (const char* type = text(object, "type"))
            if (const auto named = port_type_named(type)) port.type = static_cast<uint32_t>(*named);
        range(object.find("slider"), port.soft_min, port.soft_max);
        range(object.find("range"), port.hard_min, port.hard_max);
        list(object.find("choices"), &Descriptors::choice, choice_lists_, port.choices,
             port.choice_count);
        if (const char* domain = text(object, "domain")) port.default_surface = surface(domain);
        default_value(object.find("default"), port);
        if (object.has("absent")) port.default_kind = WR_DEFAULT_ABSENT;
        return &port;
    }

    const char* choice(const Value& value) {
        if (value.is(Kind::string)) return texts_.emplace_back(value.as_string()).c_str();
        wrong(value, "a choice is not a string");
        return "";
    }

    static uint32_t kind_number(const char* word) {
        for (uint32_t kind = WR_KIND_INPUT; word && kind <= WR_KIND_FIELD; ++kind)
            if (kind_word(static_cast<Port::Kind>(kind)) == word) return kind;
        return 0;
    }

    static uint32_t surface(std::string_view link) {
        constexpr std::string_view prefix = "surface.";
        if (link.starts_with(prefix)) link.remove_prefix(prefix.size());
        const auto all = surface_properties();
        for (uint32_t i = 0; i < all.size(); ++i)
            if (all[i].name == link) return i;
        return ~0u;  // refused by read_descriptors()
    }

    // [min, max]; null is an infinite end.
    void range(const Value& value, double& least, double& most) {
        if (value.is(Kind::null)) return;
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (value.size() != 2) return wrong(value, "a range is not a pair");
        const Value first = value.at(0), last = value.at(1);
        least = first.is(Kind::number) ? first.as_number() : -infinity;
        most = last.is(Kind::number) ? last.as_number() : infinity;
    }

    void default_value(const Value& value, wr_port& port) {
        if (value.is(Kind::null)) return;
        port.default_kind = WR_DEFAULT_CONSTANT;
        if (value.is(Kind::number)) {
            port.default_value[0] = value.as_number();
        } else if (value.is(Kind::boolean)) {
            port.default_value[0] = value.as_boolean() ? 1 : 0;
        } else if (value.is(Kind::string)) {
            port.default_value[0] = -1;
            for (uint32_t i = 0; i < port.choice_count; ++i)
                if (value.as_string() == port.choices[i]) port.default_value[0] = i;
        } else if (value.is(Kind::array) && value.size() <= 4) {
            size_t lane = 0;
            for (const json::Member& each : value.children())
                if (each.value.is(Kind::number))
                    port.default_value[lane++] = each.value.as_number();
                else
                    wrong(each.value, "a default is not a number");
        } else if (const char* link = value.is(Kind::object) ? text(value, "from") : nullptr) {
            port.default_kind = WR_DEFAULT_SURFACE;
            port.default_surface = surface(link);
        } else {
            wrong(value, "a default is of no known form");
        }
    }

    std::string problem_;
    Value problem_value_;
    wr_plugin plugin_{};
    std::deque<std::string> texts_;
    std::deque<wr_node> nodes_;
    std::deque<wr_port> ports_;
    std::deque<wr_rename> renames_;
    std::deque<std::vector<const wr_node*>> node_lists_;
    std::deque<std::vector<const wr_port*>> port_lists_;
    std::deque<std::vector<const wr_rename*>> rename_lists_;
    std::deque<std::vector<const char*>> choice_lists_;
};

}  // namespace

std::string to_json(const PluginListing& listing) {
    const std::string text =
        "{\"wrinkle_plugin\": " + shortest(listing_form) + ", \"abi\": " + std::to_string(WR_ABI) +
        ", \"sha256\": " + json_quoted(listing.sha256) + ", \"id\": " + json_quoted(listing.id) +
        ", \"version\": " + json_quoted(listing.version) + ", \"nodes\": [" +
        joined(listing.types, ", ", node_json) + "]}";
    Diagnostics none;
    return json::pretty(json::parse(text, "", none).root) + "\n";
}

std::optional<PluginListing> read_listing(std::string text, const std::string& name,
                                          const std::string& origin, Diagnostics& diagnostics) {
    const auto refuse = [&](const Value& at, std::string message, std::string expected = {}) {
        diagnostics.add({.rule = RuleId::plugin,
                         .where = at.location(),
                         .message = std::move(message),
                         .expected = std::move(expected)});
        return std::nullopt;
    };
    Diagnostics problems;
    const json::Parsed parsed = json::parse(std::move(text), name, problems);
    diagnostics.append(problems);
    if (!parsed.complete || problems.has_errors()) return std::nullopt;
    const Value form = parsed.root.find("wrinkle_plugin");
    if (!form.is(Kind::number) || form.as_number() != listing_form)
        return refuse(parsed.root, "this is not a description of a plugin that this program knows",
                      "\"wrinkle_plugin\": " + shortest(listing_form));
    Descriptors descriptors;
    const wr_plugin* plugin = descriptors.plugin(parsed.root);
    if (!descriptors.problem().empty())
        return refuse(descriptors.problem_value(), descriptors.problem());
    const Value hash = parsed.root.find("sha256");
    if (!hash.is(Kind::string)) return refuse(parsed.root, "\"sha256\" is missing");
    PluginListing listing;
    listing.sha256 = hash.as_string();
    if (!read_descriptors(plugin, name, listing.types, diagnostics)) return std::nullopt;
    listing.id = plugin->id;
    listing.version = plugin->version;
    for (NodeType& type : listing.types) {
        type.origin = origin;
        type.build = nullptr;
    }
    return listing;
}

}  // namespace wrinkle
