#include "bench/texels/ours.h"

#include "base/diagnostics.h"
#include "compile/shader.h"
#include "cpu/aligned.h"
#include "cpu/planes.h"
#include "graph/subgraph.h"
#include "nodes/all.h"

namespace wrinkle::bench {
namespace {

Compiled compiled(const Project& project, const Registry& registry, bool given,
                  Diagnostics& diagnostics) {
    MaterialOptions options;
    options.given_differentials = given;
    return compile_material(project, registry, options, diagnostics);
}

Affine difference(const Affine& value, Variant variant) {
    return {variant == Variant::dx ? value.across : value.up, 0, 0};
}

Affine surface_value(const Program::Input& input) {
    const Affine one{1, 0, 0};
    Affine value = one;
    if (input.input == SurfaceInput::normal_) value = frame().normal[input.lane];
    if (input.input == SurfaceInput::tangent_)
        value = input.lane < 3 ? frame().tangent[input.lane] : Affine{tangent_w, 0, 0};
    if (input.input == SurfaceInput::uv0_) value = frame().uv[input.lane];
    return input.variant == Variant::value ? value : difference(value, input.variant);
}

constexpr uint32_t chunk = 256;

// The planes of a chunk, with a stride of `chunk` floats plus one cache line. Constant planes are
// filled once.
struct Chunk {
    explicit Chunk(const Program& program) : memory((program.inputs.size() + 3) * (chunk + 16)) {
        size_t at = 0;
        const auto next = [&] { return &memory[at++ * (chunk + 16)]; };
        for (const Program::Input& input : program.inputs) {
            const Affine value = surface_value(input);
            planes.inputs.push_back(next());
            if (value.across != 0 || value.up != 0)
                varying.push_back({value, &memory[(at - 1) * (chunk + 16)]});
            else
                std::fill_n(&memory[(at - 1) * (chunk + 16)], chunk, value.at);
        }
        for (size_t i = 0; i < 3; ++i)
            planes.outputs.push_back(next());
    }

    AlignedVector<float> memory;
    Planes planes;
    std::vector<Plane> varying;
    PlaneScratch scratch;
};

}  // namespace

Material make_material() {
    Material made;
    Diagnostics diagnostics;
    Registry registry;
    registry.add_plugin(built_in_nodes(), Registry::built_in, diagnostics);
    Document top = read_document(graph_text(), "texels.json", diagnostics);
    const Project project =
        load_project(std::move(top), WRINKLE_SOURCE_DIR "/graphs", {}, diagnostics);
    const Module given = compiled(project, registry, true, diagnostics).module;
    made.program = compile_program(given, made.error);
    made.shader = emit(compiled(project, registry, false, diagnostics).module, {});
    if (diagnostics.has_errors()) made.error = to_text(diagnostics);
    for (const Resource& resource : given.resources)
        made.textures.emplace_back(
            resource.name == "textures/rivets_normal.png" ? textures().base : textures().detail,
            resource.options);
    return made;
}

void evaluate_rows(const Material& material, InstructionSet set, const Kernel& ends, uint32_t first,
                   uint32_t last, uint32_t* out) {
    thread_local Chunk work(material.program);
    for (uint32_t y = first; y < last; ++y)
        for (uint32_t x = 0; x < side; x += chunk) {
            ends.fill(work.varying.data(), work.varying.size(), x, y, chunk);
            evaluate_planes(material.program, material.textures, work.planes, chunk, work.scratch,
                            set);
            ends.pack(work.planes.outputs.data(), chunk, out + size_t{y} * side + x);
        }
}

}  // namespace wrinkle::bench
