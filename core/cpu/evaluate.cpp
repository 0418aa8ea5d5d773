#include "cpu/evaluate.h"

#include <algorithm>
#include <set>

#include "cpu/tile.h"
#include "ir/op.h"

namespace wrinkle {
namespace {

static_assert(PointSet::inputs == surface_input_count);

template <class T>
void load(const PointSet& points, const Program::Input& input, size_t first, size_t count, T* out) {
    const std::vector<double>& values = points.at(input.input, input.variant);
    const size_t lanes = info(info(input.input).type).lanes;
    for (size_t k = 0; k < count; ++k)
        out[k] = static_cast<T>(values[(first + k) * lanes + input.lane]);
}

template <class T>
void store(Tile<T>& tile, const Program::Output& output, size_t first, size_t count,
           std::vector<double>& values) {
    const size_t lanes = output.regs.size();
    for (size_t i = 0; i < lanes; ++i)
        for (size_t k = 0; k < count; ++k)
            values[(first + k) * lanes + i] = tile.value(output, output.regs[i], k);
}

}  // namespace

std::vector<InputNeed> needed_inputs(const Program& program) {
    std::set<std::pair<SurfaceInput, Variant>> needs;
    for (const Program::Input& input : program.inputs)
        needs.insert({input.input, input.variant});
    std::vector<InputNeed> list;
    for (const auto& [input, variant] : needs)
        list.push_back({input, variant});
    return list;
}

Results make_results(const Program& program, size_t points) {
    Results results;
    for (const Program::Output& output : program.outputs)
        results.values.emplace_back(output.regs.size() * points);
    return results;
}

template <class T>
void evaluate(const Program& program, const PointSet& points, std::span<const Texture> textures,
              size_t first, size_t count, Results& results, InstructionSet set) {
    TileMemory<T> memory;
    Tile<T> tile(program, textures, set, memory);
    for (const size_t end = first + count; first < end; first += tile_points) {
        const size_t n = std::min(tile_points, end - first);
        for (const Program::Input& input : program.inputs)
            load(points, input, first, n, tile.floats(input.reg));
        tile.run(n);
        for (size_t i = 0; i < program.outputs.size(); ++i)
            store(tile, program.outputs[i], first, n, results.values[i]);
    }
}

template void evaluate<float>(const Program&, const PointSet&, std::span<const Texture>, size_t,
                              size_t, Results&, InstructionSet);
template void evaluate<double>(const Program&, const PointSet&, std::span<const Texture>, size_t,
                               size_t, Results&, InstructionSet);

}  // namespace wrinkle
