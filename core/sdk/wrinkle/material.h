// Materials: records of channels, such as "color", "roughness" and the bump "normal".
//
//   Material rusty = m.with<Color>("color", rust).with<Float>("roughness", 0.9);
//   Float roughness = m.channel<Float>("roughness");
//
// Channels are those of docs/outputs.md and any others. A bump is a Gradient, so materials are
// layered as bumps are. A channel that a material does not have is the default of docs/outputs.md;
// of another name it is 0, of a bump flat.
#pragma once

#include "wrinkle/gradient.h"

namespace wrinkle::sdk {

template <class T>
struct PortTraits;

class Material {
public:
    static constexpr uint32_t type = WR_TYPE_material;
    wr_value id = WR_POISON;  // no channels
    Material() = default;
    explicit Material(Raw raw) : id(raw.id) {}

    template <class T>
    auto channel(const char* name) const {
        using Value = typename PortTraits<T>::Value;
        return Value(channel(name, PortTraits<T>::type));
    }
    template <class T>
    Material with(const char* name, typename PortTraits<T>::Value value) const {
        return with(name, PortTraits<T>::type, Raw{value.id});
    }

    // As above, with the type of the port as WR_PORT_*.
    Raw channel(const char* name, uint32_t port_type) const {
        if (!has_host()) return {};
        return {builder->channel(builder, id, name, port_type)};
    }
    Material with(const char* name, uint32_t port_type, Raw value) const {
        if (!has_host()) return {};
        return Material(Raw{builder->with_channel(builder, id, name, port_type, value.id)});
    }

    friend Material mix(Material a, Material b, Float t) {
        if (!has_host()) return {};
        return Material(Raw{builder->mix_materials(builder, a.id, b.id, t.id)});
    }

private:
    // The calls are younger than the first hosts of version 1.
    static bool has_host() {
        if (builder && builder->size < sizeof(wr_builder)) fail("it needs a newer program");
        return builder && builder->size >= sizeof(wr_builder);
    }
};

}  // namespace wrinkle::sdk
