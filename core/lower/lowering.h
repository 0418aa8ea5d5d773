// Lowers the inputs of flat nodes to IR values on demand, each once (memoised per port), for one
// graph or function body. Internal to core/lower.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/back_faces.h"
#include "graph/named_files.h"
#include "lower/conversion.h"
#include "lower/field.h"
#include "lower/flat.h"
#include "lower/literal.h"
#include "lower/record.h"

namespace wrinkle {

Type value_type(PortType type);  // poison for an image

// An image named by a graph; valid as long as the project.
struct BoundImage {
    ImageLiteral literal;
    uint32_t file = 0;  // the file that names it
};

// The value or image at an input of a function's body.
struct BoundInput {
    Id value = poison;  // unused for an image
    std::optional<BoundImage> image;
};

class Lowering {
public:
    // `inputs`: values for the inputs of a function's body, by index of the graph input; null for
    // the top graph. Only references are stored: all other arguments must outlive the object.
    Lowering(Module& module, const FlatGraph& graph, const Project& project, NamedFiles& files,
             SrgbDecoder srgb, const std::vector<BoundInput>* inputs);

    Module& module() { return module_; }
    const FlatGraph& graph() const { return graph_; }
    FieldReads& fields() { return fields_; }
    Records& records() { return records_; }

    // Returns the value at an input, from its wire, literal or default, converted and clamped;
    // poison if it has none. For an image, returns a handle that is not ready: call image().
    // Precondition: the nodes that it reads have been built.
    Id input(uint32_t node, uint32_t port);
    // Returns a choice's index, a count's value, 0 or 1 for a flag.
    int32_t option(uint32_t node, uint32_t port) const;
    void set_output(uint32_t node, uint32_t port, Id value) { slot(node, port) = value; }
    bool has_output(uint32_t node, uint32_t port) { return slot(node, port) != unset; }
    // Returns the value of an output; for a pass-through node, that of its input. Returns poison if
    // the node has not been built.
    Id output(uint32_t node, uint32_t port);

    Id surface(uint32_t property);
    Id zero(PortType type);  // for a normal the surface's; for an image poison
    Id convert(Id value, Conversion conversion, uint32_t node);

    // Returns the base of the gradients that the node's build() creates, from its input `base`; 0
    // for the surface.
    Id own_base(uint32_t node);

    struct Image {
        BoundImage named;
        uint32_t resource = 0;
        bool ready = false;  // `resource` is set and the encoding has a value
    };
    // Adds the image at an input to the module's resources. Returns a new, ready handle; 0 without
    // an image or if its file cannot be resolved.
    Id image(uint32_t node, uint32_t port);
    // Returns null if the handle is invalid or not ready.
    const Image* ready_image(Id handle) const;
    // Returns the image with the handle's encoding; std::nullopt if the handle is invalid.
    std::optional<BoundImage> bound_image(Id handle) const;

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
    Id add_image(const BoundImage& named);

    Module& module_;
    const FlatGraph& graph_;
    const Project& project_;
    const BackFaces back_faces_;
    NamedFiles& files_;
    const SrgbDecoder srgb_;
    FieldReads fields_;
    Records records_;
    Id surface_normal_ = poison;
    std::vector<Id> slots_;         // by wire: value of an input or output
    std::vector<Id> graph_inputs_;  // by input of the graph
    std::vector<Image> images_;     // by handle - 1, ready or not
};

// Runs the node's build() and stores its outputs; its errors are problems of the module.
void build_node(Lowering& lowering, uint32_t node);

}  // namespace wrinkle
