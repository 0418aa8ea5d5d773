// The state of one lowering: the module under construction and the values at ports of flat nodes.
// For core/lower alone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/back_faces.h"
#include "graph/named_files.h"
#include "lower/conversion.h"
#include "lower/dropped.h"
#include "lower/flat.h"
#include "lower/literal.h"

namespace wrinkle {

Type value_type(PortType type);  // poison of an image

// An image as a graph names it; no longer than the project lives.
struct BoundImage {
    ImageLiteral literal;
    uint32_t file = 0;  // that names it
};

// What an input of a function's body is.
struct BoundInput {
    Id value = poison;  // of an image unused
    std::optional<BoundImage> image;
};

class Lowering {
public:
    // `dropped`: numbers are literals, and this looks on; null: they are parameters.
    Lowering(Module& module, const FlatGraph& graph, const Project& project, NamedFiles& files,
             Dropped* dropped = nullptr);
    // Of a function's body: its inputs are these, in the order of the file's.
    Lowering(Module& module, const FlatGraph& graph, const Project& project, NamedFiles& files,
             std::span<const BoundInput> inputs);

    Module& module() { return module_; }
    const FlatGraph& graph() const { return graph_; }

    // The value at an input: of its wire, literal or default, converted and clamped. Of an image a
    // handle for image(). What the node reads must have been built.
    Id input(uint32_t node, uint32_t port);
    // A choice's index, a count's value, 0 or 1.
    int32_t option(uint32_t node, uint32_t port) const;
    void set_output(uint32_t node, uint32_t port, Id value) { slot(node, port) = value; }
    bool has_output(uint32_t node, uint32_t port) { return slot(node, port) != unset; }
    Id output(uint32_t node, uint32_t port);

    Id surface(uint32_t property);
    Id zero(PortType type);  // of a normal the surface's; of an image none
    Id convert(Id value, Conversion conversion, uint32_t node);

    // The base of gradients that the node makes itself: what its input `base` says, else the
    // surface.
    Id own_base(uint32_t node);

    struct Image {
        uint32_t named = 0;  // in named_images_
        std::optional<Encoding> encoding;
        uint32_t resource = 0;
        bool ready = false;
    };
    // A handle with the encoding settled and a resource behind it; 0 when there is no image.
    Id image(uint32_t node, uint32_t port);
    const Image* ready_image(Id handle) const;
    std::optional<BoundImage> bound_image(Id handle) const;

    Dropped* dropped() { return dropped_; }

private:
    static constexpr Id unset = ~0u;
    Id& slot(uint32_t node, uint32_t port) { return slots_[graph_.nodes[node].first_wire + port]; }
    Id compute(uint32_t node, uint32_t port);
    Id from_wire(const Wire& wire);
    Id number(uint32_t node, const Port& port, std::array<double, 4> value);
    Id default_of(uint32_t node, const Port& port);
    Id graph_input(uint32_t index, PortType type);
    Id clamped(Id value, const Port& port);
    Id base_of(uint32_t node);
    Id add_image(const ImageLiteral& literal, uint32_t file);

    Module& module_;
    const FlatGraph& graph_;
    const Project& project_;
    const BackFaces back_faces_;
    NamedFiles& files_;
    Dropped* dropped_ = nullptr;
    Id surface_normal_ = poison;
    std::vector<Id> slots_;         // by wire: an input's or an output's value
    std::vector<Id> graph_inputs_;  // of the graph
    std::vector<Image> images_;     // handle - 1
    std::vector<BoundImage> named_images_;
};

// Runs the node's build() and takes its outputs; what it did wrong is a problem of the module.
void build_node(Lowering& lowering, uint32_t node);

}  // namespace wrinkle
