// Declaring a node: its ports, then its formula. Include this one header.
//
//   static Node gradient_scale =
//       node("gradient_scale", "Scale", "Makes a bump stronger or weaker.")
//           .in<Gradient>("gradient", "The bump to scale")
//           .in<Float>("amount", 1, "1 leaves it unchanged, negative inverts it", slider(-2, 2))
//           .out<Gradient>("gradient", "The scaled bump")
//           .body([](Gradient g, Float amount) { return g * amount; });
//
//   WRINKLE_PLUGIN("my_plugin", "1.0", gradient_scale)  // once, in a plugin
//
// in      a value: of a wire, a literal, or its default; without one it is required (gradients:
//         flat)
// choice  one of several names, known while building: an int, or an enum class in the order of the
//         names
// count   an integer, known while building, within its limits
// flag    a bool, known while building
// field   an expression to be read at other places: height(uv + d); `domain` is the property it is
//         a function of
// body    captureless: a node has no state. Its parameters are the ports but outputs, in their
//         order, or one struct with these members. It returns the output, or a std::tuple of them.
//         fail("...") or an exception reports a problem on the node.
//
// A node is one static object of at most 64 ports; declaring it runs no code at start-up.
#pragma once

#include "wrinkle/body.h"
#include "wrinkle/hash.h"
#include "wrinkle/region.h"

namespace wrinkle::sdk {

inline constexpr uint32_t max_ports = 64;
inline constexpr uint32_t max_renames = 4;
inline constexpr uint32_t max_choices = 32;  // the names of all choices of a node together

struct Description {
    wr_node node{};
    wr_port ports[max_ports]{};
    wr_rename renames[max_renames]{};
    const char* choices[max_choices]{};  // in the order of the ports
    uint32_t choice_count = 0;
};

// The finished declaration. Stays where it is: its descriptor points into it.
class Node {
public:
    constexpr Node(const Description& description, void (*build)(const wr_builder*))
        : description_(description) {
        description_.node.build = build;
    }
    Node(const Node&) = delete;
    Node& operator=(const Node&) = delete;

    // For lists of nodes; not to be called by two threads at once.
    const wr_node* descriptor() {
        const char* const* names = description_.choices;
        for (uint32_t i = 0; i < description_.node.port_count; ++i) {
            wr_port& port = description_.ports[i];
            if (port.choice_count > 0) port.choices = names;
            names += port.choice_count;
            ports_[i] = &port;
        }
        for (uint32_t i = 0; i < description_.node.rename_count; ++i)
            renames_[i] = &description_.renames[i];
        description_.node.ports = ports_;
        description_.node.renames = renames_;
        return &description_.node;
    }

private:
    Description description_;
    const wr_port* ports_[max_ports]{};
    const wr_rename* renames_[max_renames]{};
};

// A declaration under way. Inputs: everything that the body receives.
template <class Inputs, class Outputs>
class Declaration {
    static constexpr uint32_t next = Inputs::count + Outputs::count;
    template <class Port>
    using WithInput = Declaration<typename Inputs::template With<Port>, Outputs>;
    template <class Port>
    using WithOutput = Declaration<Inputs, typename Outputs::template With<Port>>;
    template <class T>
    using Value = typename PortTraits<T>::Value;
    template <class T>
    using Input = WithInput<detail::InputPort<Value<T>, next>>;

public:
    constexpr explicit Declaration(const Description& d) : d_(d) {}

    // An input without a default: required, or flat for a gradient or a derivative.
    template <class T, size_t N, PortOption... Options>
    constexpr auto in(const char* name, const char (&doc)[N], Options... options) const {
        return with<Input<T>>(port<T>(WR_KIND_INPUT, name, doc), Default(), options...);
    }
    template <class T, PortOption... Options>
    constexpr auto in(const char* name, Default value, const char* doc, Options... options) const {
        return with<Input<T>>(port<T>(WR_KIND_INPUT, name, doc), value, options...);
    }

    template <class T, PortOption... Options>
    constexpr auto out(const char* name, const char* doc, Options... options) const {
        return with<WithOutput<detail::OutputPort<Value<T>, next>>>(
            port<T>(WR_KIND_OUTPUT, name, doc), Default(), options...);
    }

    template <size_t N>
    constexpr auto choice(const char* name, const char* const (&names)[N], const char* doc,
                          int value = 0) const {
        wr_port port = make_port(WR_KIND_CHOICE, 0, name, doc);
        port.choice_count = N;
        auto copy = *this;
        if (d_.choice_count + N > max_choices) throw "a node has at most 32 names of choices";
        for (const char* each : names)
            copy.d_.choices[copy.d_.choice_count++] = each;
        return copy.template with<WithInput<detail::ChoicePort<next>>>(port, Default(value));
    }

    constexpr auto count(const char* name, int value, int low, int high, const char* doc) const {
        return with<WithInput<detail::CountPort<next>>>(make_port(WR_KIND_COUNT, 0, name, doc),
                                                        Default(value), limits(low, high));
    }

    constexpr auto flag(const char* name, bool value, const char* doc) const {
        return with<WithInput<detail::FlagPort<next>>>(make_port(WR_KIND_FLAG, 0, name, doc),
                                                       Default(value ? 1 : 0));
    }

    template <class T, class Domain, PortOption... Options>
    constexpr auto field(const char* name, surface::Property<Domain> domain, const char* doc,
                         Options... options) const {
        wr_port p = port<T>(WR_KIND_FIELD, name, doc);
        p.default_surface = domain.input;
        const Default flat = p.type == WR_PORT_derivative ? Default() : Default(0);
        return with<WithInput<detail::FieldPort<Value<T>, Domain, next>>>(p, flat, options...);
    }

    constexpr auto family(const char* name) const {
        auto copy = *this;
        copy.d_.node.family = name;
        return copy;
    }
    constexpr auto version(uint32_t number) const {
        auto copy = *this;
        copy.d_.node.version = number;
        return copy;
    }
    // Since `version`, the port `old_name` is called `new_name`.
    constexpr auto renamed(uint32_t version, const char* old_name, const char* new_name) const {
        if (d_.node.rename_count == max_renames) throw "a node has at most 4 renamed ports";
        auto copy = *this;
        copy.d_.renames[copy.d_.node.rename_count++] = {sizeof(wr_rename), version, old_name,
                                                        new_name};
        return copy;
    }

    template <class F>
    constexpr Node body(F) const {
        detail::check_body<F, Inputs, Outputs>();
        if constexpr (detail::callable<F>(Inputs{}))
            return Node(d_, detail::build<F, Inputs, Outputs>);
        else
            return Node(d_, nullptr);
    }

private:
    template <class T>
    static constexpr wr_port port(uint32_t kind, const char* name, const char* doc) {
        return make_port(kind, PortTraits<T>::type, name, doc);
    }

    template <class Result, class... Options>
    constexpr Result with(wr_port port, const Default& value, Options... options) const {
        static_assert(next < max_ports, "a node has at most 64 ports");
        set_default(port, value);
        (options.apply(port), ...);
        Description description = d_;
        description.ports[next] = port;
        description.node.port_count = next + 1;
        return Result(description);
    }

    Description d_;
    template <class, class>
    friend class Declaration;
};

// `id` is lower_snake_case, the "type" of a node in a graph; `doc` is one or two sentences.
constexpr auto node(const char* id, const char* title, const char* doc) {
    Description d;
    d.node.size = sizeof(wr_node);
    d.node.version = 1;
    d.node.id = id;
    d.node.title = title;
    d.node.doc = doc;
    d.node.family = "other";
    return Declaration<detail::Ports<>, detail::Ports<>>(d);
}

// Result of wrinkle_plugin(): the nodes in the order they are listed.
template <size_t N>
class Plugin {
public:
    template <class... Nodes>
    Plugin(const char* id, const char* version, Nodes&... nodes)
        : nodes_{nodes.descriptor()...}, plugin_{sizeof(wr_plugin), WR_ABI, id, version, nodes_, N,
                                                 no_extension} {}
    const wr_plugin* descriptor() const { return &plugin_; }

private:
    static const void* no_extension(const char*) { return nullptr; }
    const wr_node* nodes_[N];
    wr_plugin plugin_;
};
template <class... Nodes>
Plugin(const char*, const char*, Nodes&...) -> Plugin<sizeof...(Nodes)>;

}  // namespace wrinkle::sdk

// The one exported symbol of a plugin.
#define WRINKLE_PLUGIN(id, version, ...)                                      \
    extern "C" const wr_plugin* wrinkle_plugin(void) {                        \
        static const ::wrinkle::sdk::Plugin plugin(id, version, __VA_ARGS__); \
        return plugin.descriptor();                                           \
    }
