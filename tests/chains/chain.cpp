#include "chains/chain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lower/conversion.h"
#include "nodes/all.h"

namespace wrinkle::test {
namespace {

// Rank of the work needed by a link: 3 for a field, 2 with a conversion, 1 without. 0 if the input
// does not take this type. The input "base" is excluded, as it takes only resolved normals.
int work(const Port& input, PortType from) {
    if (!input.is_value() || input.type == PortType::image_) return 0;
    const Conversion how = conversion(from, input.type);
    if (how == Conversion::illegal || input.name == "base") return 0;
    if (input.kind == Port::Kind::field) return 3;
    return how == Conversion::same || how == Conversion::rename ? 1 : 2;
}

// Source for an input of this type; the nodes are those of `seeds`.
std::string source(PortType type) {
    switch (type) {
        case PortType::vec2_:
            return "surface.uv0";
        case PortType::vec3_:
        case PortType::color_:
            return "surface.position";
        case PortType::vec4_:
            return "surface.color0";
        case PortType::derivative_:
            return "slopes.derivative";
        case PortType::gradient_:
            return "bump.gradient";
        case PortType::normal_:
            return "shaded.normal";
        default:
            return "wave.height";
    }
}

constexpr const char* seeds = R"("wave": {"type": "waves"},
"slopes": {"type": "derivative_map", "in": {"image": "a.exr"}},
"bump": {"type": "gradient_from_height", "in": {"height": {"from": "wave.height"}}},
"shaded": {"type": "resolve", "in": {"gradient": {"from": "bump.gradient"}}})";

std::string wire(const std::string& port, const std::string& from) {
    return "\"" + port + "\": {\"from\": \"" + from + "\"}";
}

// `from`: the node read by the linked inputs; "" for the first node, which reads sources.
std::string node(const std::string& id, const Link& link, const std::string& from) {
    std::string in;
    const auto put = [&](const std::string& text) { in += (in.empty() ? "" : ", ") + text; };
    for (const Port& port : link.to->ports) {
        const bool linked =
            std::find(link.inputs.begin(), link.inputs.end(), port.name) != link.inputs.end();
        if (port.kind == Port::Kind::output) continue;
        if (linked && port.is_value())
            put(wire(port.name, from.empty() ? source(port.type) : from));
        else if (port.type == PortType::image_ && port.is_value())
            put("\"" + port.name + "\": \"a.exr\"");
        else if (port.is_required())
            put(wire(port.name, source(port.type)));
    }
    return ",\n\"" + id + "\": {\"type\": \"" + link.to->id + "\", \"in\": {" + in + "}}";
}

}  // namespace

const Registry& registry() {
    static const Registry all = [] {
        Registry made;
        Diagnostics diagnostics;
        EXPECT_TRUE(made.add_plugin(built_in_nodes(), Registry::built_in, diagnostics));
        return made;
    }();
    return all;
}

Link link(const NodeType& from, const NodeType& to, Wiring wiring) {
    Link best{&from, &to, "", {}};
    int most = 0;
    for (const Port& output : from.ports) {
        if (output.kind != Port::Kind::output) continue;
        std::vector<std::string> inputs;
        int sum = 0;
        for (const Port& input : to.ports) {
            const int one = work(input, output.type);
            if (one == 0) continue;
            if (wiring == Wiring::all_inputs || one > sum) {
                if (wiring == Wiring::one_input) inputs.clear();
                inputs.push_back(input.name);
                sum = wiring == Wiring::all_inputs ? sum + one : one;
            }
        }
        if (sum <= most) continue;
        most = sum;
        best.output = output.name;
        best.inputs = inputs;
    }
    return best;
}

std::string chain(const Link& there, const Link& back, int length) {
    std::string text = std::string("{\"wrinkle\": 1, \"nodes\": {") + seeds, from;
    for (int i = 0; i < length; ++i) {
        const Link& into = i % 2 == 0 ? back : there;
        const Link& out_of = i % 2 == 0 ? there : back;
        const std::string id = "n" + std::to_string(i);
        text += node(id, into, from);
        from = id + "." + out_of.output;
    }
    return text + "},\n\"outputs\": {" + wire("result", from) + "}}";
}

}  // namespace wrinkle::test
