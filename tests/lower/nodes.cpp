#include <wrinkle/node.h>
#include <limits>
#include <vector>

namespace {

using namespace wrinkle::sdk;

Node number_node = node("number", "Number", "A number.")
                       .in<Float>("value", 0.5, "It", limits(0, 1))
                       .out<Float>("value", "The same")
                       .body([](Float value) { return value; });
Node pass_height = node("pass_height", "Pass height", "Passes a height.")
                       .in<Height>("height", 0, "It")
                       .out<Height>("height", "The same")
                       .body([](Float height) { return height; });
Node bump = node("bump", "Bump", "Differentiates.")
                .in<Height>("height", 0, "It")
                .out<Gradient>("gradient", "Its gradient")
                .body([](Float height) { return gradient_from_height(height); });
Node scale = node("scale", "Scale", "Scales.")
                 .in<Gradient>("gradient", "It")
                 .in<Float>("amount", 1, "How much")
                 .out<Gradient>("gradient", "Scaled")
                 .body([](Gradient gradient, Float amount) { return gradient * amount; });
Node sum = node("sum", "Sum", "Adds.")
               .in<Gradient>("a", "One")
               .in<Gradient>("b", "Other")
               .out<Gradient>("gradient", "Both")
               .body([](Gradient a, Gradient b) { return a + b; });
Node resolve_node = node("resolve", "Resolve", "Resolves.")
                        .in<Gradient>("gradient", "It")
                        .out<Normal>("normal", "Its normal")
                        .body([](Gradient gradient) { return resolve(gradient); });
Node layer = node("layer", "Layer", "A bump on a base.")
                 .in<Height>("height", 0, "It")
                 .in<Normal>("base", surface::normal, "What it stands on")
                 .out<Gradient>("gradient", "The bump")
                 .body([](Float height, vec3) { return gradient_from_height(height); });
Node times = node("times", "Times", "A normal of another length.")
                 .in<Normal>("normal", surface::normal, "It")
                 .count("amount", 1, 1, 8, "Its length")
                 .out<Normal>("normal", "The longer one")
                 .body([](vec3 normal, int amount) { return normal * amount; });
Node image_node = node("texture", "Texture", "Reads an image.")
                      .in<Image>("image", "It", encoding("srgb"))
                      .in<vec2>("uv", surface::uv0, "Where")
                      .out<Color>("color", "Color")
                      .out<Float>("alpha", "Alpha")
                      .body([](Image image, vec2 uv) {
                          const vec4 t = image.sample(uv);
                          return std::tuple{t.xyz(), t.w()};
                      });
Node normal_map =
    node("normal_map", "Normal map", "Reads a normal map.")
        .in<Image>("image", "It", encoding("normal_gl"))
        .in<vec2>("uv", surface::uv0, "Where")
        .out<Derivative>("derivative", "Slopes")
        .body([](Image image, vec2 uv) {
            return normal_derivative(image.sample(uv).xyz(), 1, frame(uv, Scale::unit));
        });
Node vector_node = node("vector", "Vector", "Passes vectors.")
                       .in<vec2>("scale", {1, 1}, "One", limits(0, 8))
                       .in<vec3>("offset", {0, 0, 0}, "Two")
                       .in<Color>("tint", {1, 1, 1}, "Three")
                       .out<vec2>("scale", "One")
                       .out<vec3>("offset", "Two")
                       .out<Color>("tint", "Three")
                       .body([](vec2 a, vec3 b, vec3 c) {
                           return std::tuple{a, b, c};
                       });
Node options = node("options", "Options", "Shows its options.")
                   .choice("mode", {"first", "second", "third"}, "One of three", 1)
                   .count("octaves", 4, 1, 8, "How many")
                   .flag("tile", false, "Whether")
                   .out<Float>("value", "All in one number")
                   .body([](int mode, int octaves, bool tile) {
                       return Float(mode * 100 + octaves * 10 + (tile ? 1 : 0));
                   });
Node field_at =
    node("field_at", "Field", "Reads a field beside the point.")
        .field<Float>("shape", surface::uv0, "It")
        .out<Float>("value", "Its value")
        .body([](Field<Float> shape) { return shape(vec2(surface::uv0) + vec2(3, 5)); });
Node march = node("march", "March", "Walks along a field.")
                 .field<Float>("shape", surface::uv0, "It")
                 .out<Float>("value", "Where it ended")
                 .body([](Field<Float> shape) {
                     const auto [t] = loop(8, std::tuple{Float(0)}, [&](Float t) {
                         const Float h = shape(vec2(surface::uv0) + vec2(t, t));
                         return std::tuple{h > t, t + 0.125};
                     });
                     return t;
                 });
Node width = node("width", "Width", "How wide a pixel is.")
                 .out<Float>("value", "Its width, by place")
                 .body([] { return vec2(surface::uv0).x() * ddx<vec2>(surface::uv0).x(); });
Node many =
    node("many", "Many", "Changes everything that it passes.")
        .in<Float>("value", 1, "A number")
        .in<Height>("height", 2, "A height")
        .in<Gradient>("gradient", "A gradient")
        .out<Float>("value", "Another number")
        .out<Height>("height", "Another height")
        .out<Normal>("normal", "A normal")
        .out<Gradient>("gradient", "Another gradient")
        .out<vec2>("pair", "Two numbers")
        .body([](Float value, Float height, Gradient gradient) {
            return std::tuple{value + 1, height + 1, resolve(gradient), gradient * 2, vec2(7, 8)};
        });
Node old_name = node("old_name", "Old name", "Had another port name once.")
                    .version(2)
                    .renamed(2, "length", "size")
                    .in<Float>("size", 1, "It")
                    .out<Float>("value", "The same")
                    .body([](Float size) { return size; });

Node wrong_frame = node("wrong_frame", "Wrong frame", "A frame and a scale that do not fit.")
                       .out<Gradient>("gradient", "A bump")
                       .body([] {
                           const vec2 uv = surface::uv0;
                           return Gradient(Derivative(
                               uv, frame(uv, FrameMethod::exact, Scale::unit, vec3(0, 0, 1))));
                       });

// Faulty nodes, in plain C.
wr_port c_port(uint32_t kind, uint32_t type, const char* name) {
    wr_port p{};
    p.size = sizeof p;
    p.kind = kind;
    p.type = type;
    p.name = name;
    p.doc = "A port";
    p.default_kind = WR_DEFAULT_CONSTANT;
    return p;
}
const wr_port c_in = c_port(WR_KIND_INPUT, WR_PORT_float, "value");
const wr_port c_out = c_port(WR_KIND_OUTPUT, WR_PORT_float, "value");
const wr_port* const c_ports[] = {&c_in, &c_out};

wr_node c_node(const char* id, void (*build)(const wr_builder*)) {
    return {sizeof(wr_node), 1, id, "C", "In C.", "test", c_ports, 2, nullptr, 0, build};
}

wr_value emit(const wr_builder* b, uint32_t op, std::initializer_list<wr_value> args,
              uint32_t extra = 0, uint32_t type = 0) {
    return b->emit(b, op, type, args.begin(), static_cast<uint32_t>(args.size()), extra);
}

const wr_node c_nodes[] = {
    c_node("forgets", [](const wr_builder*) {}),
    c_node("twice",
           [](const wr_builder* b) {
               b->output(b, 1, b->input(b, 0));
               b->output(b, 1, b->input(b, 0));
           }),
    c_node("wrong_type",
           [](const wr_builder* b) { b->output(b, 1, b->surface(b, WR_SURFACE_uv0)); }),
    c_node("bad_operands",
           [](const wr_builder* b) {
               b->output(b, 1, emit(b, WR_OP_dot, {b->input(b, 0), b->input(b, 0)}));
           }),
    c_node("guess_nowhere",
           [](const wr_builder* b) {
               const wr_value uv = b->surface(b, WR_SURFACE_uv0);
               emit(b, WR_OP_frame, {uv}, WR_FRAME(WR_FRAME_guess, WR_SCALE_unit));
               b->output(b, 1, b->input(b, 0));
           }),
    c_node("vertex_somewhere",
           [](const wr_builder* b) {
               const wr_value uv = b->surface(b, WR_SURFACE_uv0);
               const wr_value direction = b->surface(b, WR_SURFACE_position);
               emit(b, WR_OP_frame, {uv, direction}, WR_FRAME(WR_FRAME_vertex, WR_SCALE_unit));
               b->output(b, 1, b->input(b, 0));
           }),
    c_node("complains",
           [](const wr_builder* b) {
               b->error(b, "the moon is not full");
               b->output(b, 1, WR_POISON);
           }),
    c_node("open_region",
           [](const wr_builder* b) {
               const uint32_t type = WR_TYPE_float;
               wr_value param = 0;
               b->begin_region(b, WR_REGION_LOOP, "x", &type, 1, &param);
               b->output(b, 1, b->input(b, 0));
           }),
    c_node("leaks_region",
           [](const wr_builder* b) {
               const uint32_t type = WR_TYPE_float;
               wr_value param = 0;
               b->begin_region(b, WR_REGION_FUNCTION, "x", &type, 1, &param);
               b->end_region(b, &param, 1, 0);
               b->output(b, 1, emit(b, WR_OP_add, {param, b->input(b, 0)}));
           }),
    c_node("lies",
           [](const wr_builder* b) {
               const double infinity[4] = {std::numeric_limits<double>::infinity(), 0, 0, 0};
               emit(b, 9999, {});
               emit(b, WR_OP_literal, {});
               emit(b, WR_OP_add, {b->input(b, 0)});
               emit(b, WR_OP_add, {b->input(b, 0), 4000000000u});
               emit(b, WR_OP_column, {b->input(b, 0)}, 3);
               b->literal(b, WR_TYPE_float, infinity);
               b->literal(b, WR_TYPE_gradient, infinity);
               b->input(b, 77);
               b->input(b, 1);
               b->image(b, 0);
               b->option(b, 0);
               b->field(b, 0, b->surface(b, WR_SURFACE_uv0));
               b->surface(b, 10);
               b->sample(b, WR_OP_add, 1, nullptr, 0);
               b->sample(b, WR_OP_image_size, 5, nullptr, 0);
               b->end_region(b, nullptr, 0, 0);
               wr_value result = 1;
               b->apply(b, 3, nullptr, 0, &result, 1);
               b->begin_region(b, 7, nullptr, nullptr, 1000000, nullptr);
               b->end_region(b, nullptr, 0, 0);
               b->output(b, 0, 0);
               b->output(b, 99, 0);
               b->output(b, 1, result);
           }),
};

}  // namespace

const wr_plugin* test_plugin() {
    static Node* const nodes[] = {
        &number_node, &pass_height, &bump,       &scale,      &sum,         &resolve_node,
        &layer,       &times,       &image_node, &normal_map, &vector_node, &options,
        &field_at,    &march,       &width,      &many,       &old_name,    &wrong_frame};
    static std::vector<const wr_node*> list;
    for (Node* each : nodes)
        list.push_back(each->descriptor());
    for (const wr_node& each : c_nodes)
        list.push_back(&each);
    static const wr_plugin plugin = {sizeof plugin, WR_ABI,      "test",
                                     "1",           list.data(), static_cast<uint32_t>(list.size()),
                                     nullptr};
    return &plugin;
}
