#include "graphs.h"

namespace wrinkle::test {

uint32_t node(Module& module, const std::string& path, const std::string& title) {
    for (uint32_t i = 0; i < module.nodes.size(); ++i)
        if (module.nodes[i].path == path) return module.current_node = i;
    module.nodes.push_back({path, module.titles.add(title)});
    return module.current_node = static_cast<uint32_t>(module.nodes.size() - 1);
}

Id image(Module& module, const std::string& port, const std::string& file, Id uv,
         Encoding encoding) {
    Resource resource;
    resource.file = "/graphs/" + file;
    resource.name = file;
    resource.options.encoding = encoding;
    resource.readers = {{module.current_node, port}};
    return module.add(Op::sample_, {uv}, module.add_resource(resource));
}

Id parameter(Module& module, const std::string& port, double value, Type type) {
    Parameter parameter;
    parameter.node = module.current_node;
    parameter.port = port;
    parameter.type = type;
    parameter.value.fill(value);
    return module.parameter(module.add_parameter(parameter));
}

void name(Module& module, const std::string& port, Id value) {
    module.named.push_back({value, module.current_node, port, true});
}

void output(Module& module, const std::string& name, Id value, uint32_t port_type) {
    ModuleOutput output;
    output.name = name;
    output.value = value;
    output.port_type = port_type;
    module.outputs.push_back(output);
}

namespace {

Id normal_map(Module& m, const std::string& file, Id uv) {
    const Value texel{&m, image(m, "image", file, uv, Encoding::normal_gl)};
    const Value normal =
        texel.xyz() * 2 - Value{&m, m.constant(Type::vec3_, std::array{1.0, 1.0, 1.0})};
    const Id frame = m.add(Op::frame_, {uv}, WR_FRAME(WR_FRAME_auto, WR_SCALE_unit));
    const Id derivative = m.add(Op::normal_derivative_, {normal.id, m.number(1), frame});
    const Id gradient = m.add(Op::gradient_from_derivative_, {derivative}, poison);
    name(m, "gradient", gradient);
    return gradient;
}

Id detail(Module& m, SurfaceInput uv_set) {
    node(m, "tile", "Tile");
    const Value uv = Value{&m, m.input(uv_set)} * 8;
    name(m, "uv", uv.id);
    node(m, "weave", "Tangent normal map");
    return normal_map(m, "weave.png", uv.id);
}

Id base(Module& m) {
    node(m, "base", "Tangent normal map");
    return normal_map(m, "base.png", m.input(SurfaceInput::uv0_));
}

}  // namespace

Module base_and_detail(SurfaceInput detail_uv, bool detail_first) {
    Module m;
    m.nodes[0].title = m.titles.add("Woven strap over a baked shape");
    node(m, "base", "Tangent normal map");
    node(m, "tile", "Tile");
    node(m, "weave", "Tangent normal map");
    Id below = poison, above = poison;
    if (detail_first) {
        above = detail(m, detail_uv);
        below = base(m);
    } else {
        below = base(m);
        above = detail(m, detail_uv);
    }
    node(m, "softer", "Scale");
    const Id softer = m.add(Op::gradient_scale_, {above, parameter(m, "amount", 0.6)});
    node(m, "sum", "Add");
    const Id sum = m.add(Op::gradient_add_, {below, softer});
    const uint32_t resolver = node(m, "normal", "Resolve");
    const Id normal = m.add(Op::resolve_, {sum}, resolver);
    name(m, "normal", normal);
    output(m, "normal", normal, WR_PORT_normal);
    return m;
}

}  // namespace wrinkle::test
