#include "lower/lowering.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ir/surface.h"

namespace wrinkle {

Type value_type(PortType type) {
#define X(name, number, value) Type::value##_,
    static constexpr std::array types = {WR_PORT_TYPES(X)};
#undef X
    return types[static_cast<size_t>(type) - 1];
}

Lowering::Lowering(Module& module, const FlatGraph& graph, const Project& project,
                   NamedFiles& files, SrgbDecoder srgb, const std::vector<BoundInput>* inputs)
    : module_(module),
      graph_(graph),
      project_(project),
      back_faces_(project.top().back_face_rule()),
      files_(files),
      srgb_(srgb),
      fields_(module),
      records_(module),
      slots_(graph.wires.size(), unset),
      graph_inputs_(inputs ? inputs->size() : project.top().inputs.size(), unset) {
    for (size_t i = 0; inputs && i < inputs->size(); ++i) {
        const BoundInput& input = (*inputs)[i];
        graph_inputs_[i] = input.image ? add_image(*input.image) : input.value;
    }
}

Id Lowering::input(uint32_t node, uint32_t port) {
    if (slot(node, port) == unset) {
        const uint32_t before = std::exchange(module_.current_node, graph_.nodes[node].instance);
        const Id value = compute(node, port);
        module_.current_node = before;
        slot(node, port) = value;
    }
    return slot(node, port);
}

Id Lowering::output(uint32_t node, uint32_t port) {
    const FlatNode& flat = graph_.nodes[node];
    if (flat.is_passthrough()) return input(node, 0);
    return slot(node, port) == unset ? poison : slot(node, port);
}

int32_t Lowering::option(uint32_t node, uint32_t port) const {
    const FlatNode& flat = graph_.nodes[node];
    const Port& described = flat.type->ports[port];
    const Wire& wire = graph_.wire(flat, port);
    std::optional<int32_t> value;
    if (wire.kind == Wire::Kind::literal) value = literal_option(*wire.literal, described);
    return value.value_or(static_cast<int32_t>(described.default_value[0]));
}

Id Lowering::compute(uint32_t node, uint32_t port) {
    const FlatNode& flat = graph_.nodes[node];
    const Port& described = graph_.port(flat, port);
    const Wire& wire = graph_.wire(flat, port);
    if (wire.kind == Wire::Kind::none) return default_of(node, described);
    if (wire.kind == Wire::Kind::literal) {
        if (described.type == PortType::image_)
            return add_image({literal_image(*wire.literal), wire.from});
        std::array<double, 4> value{};
        literal_numbers(*wire.literal, described.type, value);
        return number(node, described, value);
    }
    const Id value = convert(from_wire(wire), conversion(wire.type, described.type), node);
    return clamped(value, described);
}

Id Lowering::from_wire(const Wire& wire) {
    if (wire.kind == Wire::Kind::surface) return surface(wire.from);
    if (wire.kind == Wire::Kind::graph_input) return graph_input(wire.from, wire.type);
    return output(wire.from, wire.output);
}

Id Lowering::number(uint32_t node, const Port& port, std::array<double, 4> value) {
    const auto lanes = static_cast<size_t>(lanes_of(port.type));
    if (port.has_hard_range())
        for (size_t i = 0; i < lanes; ++i)
            value[i] = std::clamp(value[i], port.hard_min, port.hard_max);
    Parameter parameter;
    parameter.node = graph_.nodes[node].instance;
    parameter.port = port.name;
    parameter.type = value_type(port.type);
    parameter.value = value;
    return module_.parameter(module_.add_parameter(std::move(parameter)));
}

Id Lowering::default_of(uint32_t node, const Port& port) {
    if (port.default_kind == Port::Default::surface) return surface(port.default_surface);
    if (port.default_kind == Port::Default::absent) return poison;
    if (port.default_kind == Port::Default::constant) return number(node, port, port.default_value);
    return zero(port.type);
}

Id Lowering::graph_input(uint32_t index, PortType type) {
    Id& value = graph_inputs_[index];
    if (value != unset) return value;
    const GraphInput& input = project_.top().inputs[index];
    std::array<double, 4> numbers{};
    const bool given = literal_numbers(input.default_value, type, numbers);
    if (type == PortType::image_) return value = add_image({literal_image(input.default_value), 0});
    if (lanes_of(type) == 0 || (type == PortType::normal_ && !given)) return value = zero(type);
    Parameter parameter;
    parameter.port = input.name;
    parameter.type = value_type(type);
    parameter.graph_input = true;
    Port port;
    port.type = type;
    if (const auto limits = range_of(input.limits)) {
        port.hard_min = limits->least;
        port.hard_max = limits->most;
        for (double& number : numbers)
            number = std::clamp(number, limits->least, limits->most);
    }
    parameter.value = numbers;
    const Id uniform = module_.parameter(module_.add_parameter(std::move(parameter)));
    return value = clamped(uniform, port);
}

Id Lowering::clamped(Id value, const Port& port) {
    const bool clamps = port.has_hard_range() && port.clamps_wires && lanes_of(port.type) > 0;
    if (!clamps || value == poison) return value;
    if (std::isfinite(port.hard_min))
        value = module_.add(Op::max_, {value, module_.number(port.hard_min)});
    if (std::isfinite(port.hard_max))
        value = module_.add(Op::min_, {value, module_.number(port.hard_max)});
    return value;
}

Id Lowering::surface(uint32_t property) {
    if (property == WR_SURFACE_normal) {
        if (surface_normal_ == poison) surface_normal_ = surface_normal(module_, back_faces_);
        return surface_normal_;
    }
    return module_.input(static_cast<SurfaceInput>(property));
}

Id Lowering::zero(PortType type) {
    switch (type) {
        case PortType::image_:
            return poison;
        case PortType::material_:
            return records_.add({});
        case PortType::normal_:
            return surface(WR_SURFACE_normal);
        case PortType::gradient_:
            return module_.add(Op::gradient_zero_, {});
        case PortType::derivative_: {
            const Id uv = module_.input(SurfaceInput::uv0_);
            const Id frame =
                module_.add(Op::frame_, {uv}, WR_FRAME(WR_FRAME_auto, WR_SCALE_surface));
            return module_.add(Op::derivative_, {module_.zero(Type::vec2_), frame});
        }
        default:
            return module_.zero(value_type(type));
    }
}

Id Lowering::base_of(uint32_t node) {
    const uint32_t definer = graph_.nodes[node].base_node;
    return definer == FlatNode::none ? poison : own_base(definer);
}

Id Lowering::own_base(uint32_t node) {
    const FlatNode& flat = graph_.nodes[node];
    if (!has_own_base(graph_, flat)) return poison;
    const Id normal = input(node, flat.type->find_input("base"));
    if (normal == surface(WR_SURFACE_normal)) return poison;
    const uint32_t before = std::exchange(module_.current_node, flat.instance);
    const Id base = module_.add(Op::base_, {normal});
    module_.current_node = before;
    return base;
}

Id Lowering::convert(Id value, Conversion conversion, uint32_t node) {
    const auto resolved = [&](Id gradient) {
        return module_.add(Op::resolve_, {gradient}, graph_.nodes[node].instance);
    };
    switch (conversion) {
        case Conversion::illegal:
            return poison;
        case Conversion::same:
        case Conversion::rename:
            return value;
        case Conversion::gray:
            return module_.add(Op::construct_, {value, value, value}, 0, Type::vec3_);
        case Conversion::differentiate:
            return module_.add(Op::gradient_from_height_, {value}, base_of(node));
        case Conversion::apply_frame:
            return module_.add(Op::gradient_from_derivative_, {value}, base_of(node));
        case Conversion::take_normal:
            return module_.add(Op::gradient_from_normal_, {value}, base_of(node));
        case Conversion::resolve:
            return resolved(value);
        case Conversion::differentiate_and_resolve:
            return resolved(module_.add(Op::gradient_from_height_, {value}, poison));
        case Conversion::apply_frame_and_resolve:
            return resolved(module_.add(Op::gradient_from_derivative_, {value}, poison));
    }
    return poison;
}

Id Lowering::add_image(const BoundImage& named) {
    images_.push_back({named, 0, false});
    return static_cast<Id>(images_.size());
}

Id Lowering::image(uint32_t node, uint32_t port) {
    const Id handle = input(node, port);
    if (handle == poison) return poison;
    Image image = images_[handle - 1];
    ImageLiteral& literal = image.named.literal;
    const FlatNode& flat = graph_.nodes[node];
    const Port& described = flat.type->ports[port];
    const auto& path = files_.find(image.named.file, literal.file).path;
    if (!path) return poison;
    literal.encoding = literal.encoding.value_or(described.encoding);
    image.resource = module_.add_resource({path->native(),
                                           std::string(literal.file),
                                           {*literal.encoding, literal.wrap, literal.filter, srgb_},
                                           {{flat.instance, described.name}}});
    image.ready = true;
    images_.push_back(image);
    return static_cast<Id>(images_.size());
}

std::optional<BoundImage> Lowering::bound_image(Id handle) const {
    if (handle == poison || handle > images_.size()) return {};
    return images_[handle - 1].named;
}

const Lowering::Image* Lowering::ready_image(Id handle) const {
    if (handle == poison || handle > images_.size() || !images_[handle - 1].ready) return nullptr;
    return &images_[handle - 1];
}

}  // namespace wrinkle
