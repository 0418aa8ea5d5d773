// Fuzz target: calls that a plugin's process returns are lowered like those of a linked node: a
// graph with them compiles, or has an error at the node.
#include "fuzz/calls_fuzz.h"

#include <algorithm>
#include <cstdlib>

#include "fuzz/compiled.h"
#include "fuzz/fuzz.h"
#include "graph/read.h"
#include "registry/recording.h"
#include "wrinkle/node.h"

namespace wrinkle::fuzz {
namespace {
using namespace sdk;

enum class Shape { round, flat };
struct Inputs {
    Float amount;
    vec2 uv;
    Gradient bump;
    Image image;
    Field<Float> height;
    Shape shape;
    int times;
    bool raised;
};

// Has every kind of port and records every call of a builder.
sdk::Node played =
    node("played", "Played", "A node whose calls are bytes.")
        .family("fuzz")
        .in<Float>("amount", 0.5, "A number")
        .in<vec2>("uv", surface::uv0, "A place")
        .in<Gradient>("bump", "A bump")
        .in<Image>("image", "A picture")
        .field<Height>("height", surface::uv0, "A field")
        .choice("shape", {"round", "flat"}, "An option")
        .count("times", 3, 1, 8, "A number of turns")
        .flag("raised", true, "A flag")
        .out<Float>("value", "A number")
        .out<vec3>("color", "A vector")
        .out<Gradient>("gradient", "A bump")
        .body([](Inputs in) {
            const auto [turns] =
                loop(static_cast<uint32_t>(in.times), std::tuple{Float(0)}, [&](Float sum) {
                    return std::tuple{sum < 10, sum + in.amount};
                });
            const auto twice = function("twice", [](Float x) { return x * 2; });
            const Float height = in.height(in.uv * twice(turns)) + in.image.sample(in.uv).x();
            const Gradient made =
                gradient_from_height(named("height", height + ddx(in.amount))) + in.bump;
            const vec3 color = in.shape == Shape::flat ? surface::position : resolve(made);
            if (in.raised) return std::tuple{height, color, made};
            const Gradient other = Derivative(in.uv, frame(in.uv, Scale::unit));
            return std::tuple{unit_float(hash(Int(height))), color, other + made};
        });

std::string_view bytes_at_work;

void play_bytes(const wr_builder* builder) {
    if (!replay(bytes_at_work, builder)) builder->error(builder, "the recording is damaged");
}

Registry with_played_node() {
    wr_node node = *played.descriptor();
    node.build = play_bytes;
    const wr_node* const list[] = {&node};
    const wr_plugin plugin{sizeof(wr_plugin), WR_ABI, "fuzz", "1", list, 1, nullptr};
    Registry registry = with_built_in_nodes();
    Diagnostics ignored;
    registry.add_plugin(&plugin, "fuzz.so", ignored);
    return registry;
}

constexpr const char* graph_of_it = R"({
  "wrinkle": 1,
  "nodes": {
    "place": { "type": "separate_vec2", "in": { "vector": { "from": "surface.uv0" } } },
    "played": {
      "type": "played",
      "in": { "image": "textures/weave_normal.png", "height": { "from": "place.x" } }
    },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "played.gradient" } } }
  },
  "outputs": {
    "value": { "from": "played.value" },
    "color": { "from": "played.color" },
    "normal": { "from": "normal.normal" }
  }
}
)";

}  // namespace

std::vector<std::string> right_calls() {
    const wr_node& node = *played.descriptor();
    std::vector<std::string> all;
    for (const int32_t shape : {0, 1})
        for (const int32_t raised : {0, 1}) {
            std::vector<int32_t> options(node.port_count, 3);
            options[5] = shape;
            options[7] = raised;
            Recorder recorder(options, [] { std::abort(); });
            node.build(recorder.builder());
            all.push_back(recorder.calls());
        }
    return all;
}

std::string calls(std::string_view bytes) {
    static const Registry registry = with_played_node();
    static const std::vector<std::string> right = right_calls();
    Diagnostics diagnostics;
    const Document document = read_document(graph_of_it, "fuzz.json", diagnostics);
    bytes_at_work = bytes;
    const bool is_right = std::find(right.begin(), right.end(), bytes) != right.end();
    return wrong_with_compiled(document, registry, is_right);
}

}  // namespace wrinkle::fuzz
