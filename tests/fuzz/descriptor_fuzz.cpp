// Fuzz target: an accepted plugin has complete pages; a rejected one gives errors of one line each
// and adds no node.
//
// The bytes choose how a plugin describes itself: mostly valid, with some null pointers, absurd
// counts, wrong numbers, strange names and structs of other sizes. Memory beyond a struct's size or
// a list's end is not allocated, so that a sanitizer detects reads of it.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "fuzz/fuzz.h"
#include "json/parse.h"
#include "registry/listing.h"
#include "registry/reference.h"
#include "wrinkle/plugin.h"

namespace wrinkle::fuzz {
namespace {

void build(const wr_builder*) {}

// After the last byte the choices are zero, which are all valid.
class Choices {
public:
    explicit Choices(std::string_view bytes) : bytes_(bytes) {}

    uint32_t below(uint32_t limit) { return next() % limit; }
    bool wrong() { return next() >= 250; }

private:
    uint32_t next() {
        if (bytes_.empty()) return 0;
        const auto byte = static_cast<unsigned char>(bytes_.front());
        bytes_.remove_prefix(1);
        return byte;
    }

    std::string_view bytes_;
};

class Plugin {
public:
    explicit Plugin(std::string_view bytes) : choose_(bytes) {}

    const wr_plugin* describe() {
        wr_plugin plugin{};
        plugin.abi = choose_.wrong() ? choose_.below(4) : WR_ABI;
        plugin.id = text("plugin");
        plugin.version = text("1.0");
        std::vector<const wr_node*> nodes;
        for (uint32_t i = 1 + choose_.below(3); i > 0; --i)
            nodes.push_back(node());
        plugin.nodes = list(nodes, plugin.node_count, 10'001);
        return placed(plugin);
    }

private:
    const char* kept(std::string value) {
        strings_.push_back(std::make_unique<std::string>(std::move(value)));
        return strings_.back()->c_str();
    }

    const char* text(const char* right) {
        static const std::string megabyte(1 << 20, 'b');
        if (!choose_.wrong()) return right;
        switch (choose_.below(8)) {
            case 0:
                return nullptr;
            case 1:
                return "";
            case 2:
                return kept(std::string(65, 'a'));
            case 3:
                return megabyte.c_str();
            case 4:
                return "\xC3";
            case 5:
                return "two\nlines";
            case 6:
                return "\x1B[31m\"quoted\"\\";
            default:
                return "Upper case";
        }
    }

    const char* name() {
        static constexpr const char* names[] = {"a", "b", "c", "d", "e", "f", "g", "reroute"};
        return text(names[choose_.below(std::size(names))]);
    }

    double number(double right) {
        if (!choose_.wrong()) return right;
        constexpr double infinity = std::numeric_limits<double>::infinity();
        constexpr double numbers[] = {NAN, infinity, -infinity, 1e308, -1, 0.5, 1e9, 1e-320};
        return numbers[choose_.below(std::size(numbers))];
    }

    uint32_t word(uint32_t right) {
        constexpr uint32_t words[] = {~0u, 0x80000000u, 99, 11, 10, 7, 3, 0};
        return choose_.wrong() ? words[choose_.below(std::size(words))] : right;
    }

    // Returns a list with its count, null, or a list with an impossible count.
    template <class T>
    T* list(const std::vector<T>& values, uint32_t& count, uint32_t absurd) {
        count = static_cast<uint32_t>(values.size());
        if (choose_.wrong()) return nullptr;
        if (choose_.wrong()) count = choose_.below(2) ? ~0u : absurd;
        auto& place = blocks_.emplace_back(new std::byte[values.size() * sizeof(T)]);
        const auto out = reinterpret_cast<T*>(place.get());
        std::copy(values.begin(), values.end(), out);
        return out;
    }

    // Returns a struct with its size, a larger (later) one, a smaller (earlier) one, an impossible
    // size, or null.
    template <class T>
    const T* placed(T value) {
        value.size = sizeof(T);
        if (choose_.wrong()) {
            constexpr uint32_t sizes[] = {0, 1, 4, sizeof(T) - 1, sizeof(T) + 8, 4096, ~0u};
            const uint32_t choice = choose_.below(1 + std::size(sizes));
            if (choice == std::size(sizes)) return nullptr;
            value.size = sizes[choice];
        }
        const size_t there = std::clamp<size_t>(value.size, sizeof value.size, 4096);
        auto& place = blocks_.emplace_back(new std::byte[there]);
        std::memset(place.get(), 0xA5, there);
        std::memcpy(place.get(), &value, std::min(there, sizeof(T)));
        return reinterpret_cast<const T*>(place.get());
    }

    const wr_port* port(bool output) {
        wr_port port{};
        port.kind = word(output ? WR_KIND_OUTPUT : WR_KIND_INPUT + choose_.below(6));
        port.type = word(1 + choose_.below(10));
        port.name = name();
        port.doc = text("A port");
        port.unit = choose_.below(2) ? text("m") : nullptr;
        port.default_kind = word(choose_.below(3));
        port.default_surface = word(choose_.below(10));
        for (double& value : port.default_value)
            value = number(0);
        port.soft_max = number(1);
        port.soft_min = number(0);
        port.hard_max = number(choose_.below(2));
        port.hard_min = number(0);
        const std::vector<const char*> choices = {text("soft"), text("hard"), text("both")};
        port.choices = list(choices, port.choice_count, 257);
        port.encoding = choose_.below(2) ? text("srgb") : nullptr;
        return placed(port);
    }

    const wr_node* node() {
        wr_node node{};
        node.version = word(2);
        node.id = name();
        node.title = text("A node");
        node.doc = text("What it does.");
        node.family = text("family");
        std::vector<const wr_port*> ports = {port(true)};
        for (uint32_t i = choose_.below(4); i > 0; --i)
            ports.push_back(port(false));
        node.ports = list(ports, node.port_count, 257);
        std::vector<const wr_rename*> renames;
        if (choose_.below(4) == 1)
            renames.push_back(placed(wr_rename{0, word(2), text("old"), name()}));
        node.renames = list(renames, node.rename_count, 257);
        node.build = choose_.wrong() ? nullptr : build;
        return placed(node);
    }

    Choices choose_;
    std::vector<std::unique_ptr<std::byte[]>> blocks_;
    std::vector<std::unique_ptr<std::string>> strings_;
};

std::string wrong_with(const Diagnostics& diagnostics) {
    if (!diagnostics.has_errors()) return "refused without a word";
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        const std::string said = to_text(diagnostic);
        if (diagnostic.where.file != "fuzz.so") return "an error without the plugin: " + said;
        if (said.find('\n') != said.npos) return "an error of several lines: " + said;
        if (said.size() > 1000) return "an error of " + std::to_string(said.size()) + " bytes";
    }
    return "";
}

std::string wrong_with(const Registry& registry) {
    for (const std::string& text : {list_json(registry), graph_schema(registry)}) {
        Diagnostics problems;
        json::parse(text, "page.json", problems);
        if (problems.has_errors()) return "pages are no JSON: " + to_text(problems) + text;
    }
    return list_text(registry).empty() || list_markdown(registry).empty() ? "an empty page" : "";
}

// A listing reads back as written; a damaged one is rejected or is another valid listing.
std::string wrong_with_listing(const Registry& registry, std::string_view bytes) {
    PluginListing listing{"fuzz", "1", "0", {}};
    listing.types.assign(registry.list().begin(), registry.list().end());
    std::string text = to_json(listing);
    Diagnostics problems;
    const auto same = read_listing(text, "fuzz.so.json", "fuzz.so", problems);
    if (!same) return "its listing is refused: " + to_text(problems) + text;
    if (to_json(*same) != text) return "its listing reads back as " + to_json(*same) + text;
    for (size_t i = 0; i < bytes.size(); i += 5)
        text[(i * 31 + static_cast<unsigned char>(bytes[i])) % text.size()] = bytes[i];
    Diagnostics spoilt;
    const auto other = read_listing(text, "fuzz.so.json", "fuzz.so", spoilt);
    if (!other && !spoilt.has_errors()) return "a spoilt listing is refused without a word";
    return other && other->types.size() > 10'000 ? "too many nodes" : "";
}

}  // namespace

std::string descriptor(std::string_view bytes) {
    Plugin plugin(bytes);
    Registry registry;
    Diagnostics diagnostics;
    const bool taken = registry.add_plugin(plugin.describe(), "fuzz.so", diagnostics);
    if (!taken) return registry.list().empty() ? wrong_with(diagnostics) : "half a plugin";
    if (diagnostics.has_errors()) return "taken with " + to_text(diagnostics);
    const std::string wrong = wrong_with(registry);
    return wrong.empty() ? wrong_with_listing(registry, bytes) : wrong;
}

}  // namespace wrinkle::fuzz
