#include "export/baked_material.h"

#include <algorithm>
#include <cstring>

#include "bake/mesh_check.h"
#include "bake/texture_set.h"
#include "base/standard_outputs.h"
#include "compile/shader.h"
#include "cpu/texture_store.h"
#include "mesh/uv_survey.h"

namespace wrinkle {
namespace {

const StandardOutput& row_of(std::string_view name) {
    return *std::ranges::find(standard_output_table, name, &StandardOutput::name);
}

// The maps of the graph's standard outputs, as floats.
std::vector<MapRequest> requests_for(const Module& module) {
    std::vector<MapRequest> requests;
    for (const StandardOutput& row : standard_output_table) {
        const auto is_row = [&](const ModuleOutput& output) { return output.name == row.name; };
        if (row.type == "vec3" || std::ranges::none_of(module.outputs, is_row)) continue;
        requests.emplace_back();
        requests.back().name = row.name;
        requests.back().integers = false;
    }
    return requests;
}

// Stores rows that come from the top of the image into one that begins at its bottom.
class BakedRowsSink {
public:
    BakedRowsSink(BakedMaterial& material, const BakePlan& plan) : material_(material) {
        for (const BakedMap& map : plan.maps) {
            BakedOutput output;
            output.name = map.name;
            output.channels = static_cast<uint32_t>(map.channels.size());
            output.texels.resize(size_t{material.width} * material.height * output.channels);
            material.outputs.push_back(std::move(output));
        }
        next_.resize(plan.maps.size());
    }

    bool take(size_t map, std::span<const std::byte> bytes) {
        BakedOutput& output = material_.outputs[map];
        const size_t row = size_t{material_.width} * output.channels;
        for (; !bytes.empty(); bytes = bytes.subspan(row * sizeof(float))) {
            const size_t from_bottom = material_.height - 1 - next_[map]++;
            std::memcpy(output.texels.data() + from_bottom * row, bytes.data(),
                        row * sizeof(float));
        }
        return true;
    }

private:
    BakedMaterial& material_;
    std::vector<uint32_t> next_;  // row from the top, by map
};

void decode_normal(BakedOutput& output) {
    for (float& value : output.texels)
        value = 2 * value - 1;
}

void find_constant(BakedOutput& output) {
    const size_t channels = output.channels;
    const std::vector<float>& texels = output.texels;
    output.constant = true;
    for (size_t i = channels; i < texels.size() && output.constant; ++i)
        output.constant = texels[i] == texels[i - channels];
    for (size_t i = 0; i < 3; ++i)
        output.value[i] = texels[std::min(i, channels - 1)];
}

void complete(BakedOutput& output) {
    if (row_of(output.name).type == "normal") decode_normal(output);
    find_constant(output);
}

struct BakeOfMaterial {
    const ExportRequest& request;
    Diagnostics& diagnostics;
    TextureStore textures;
    std::vector<std::string> graph_outputs;

    std::optional<BakePlan> plan() {
        MaterialOptions options{.given_differentials = true, .runs_calls = "bake"};
        options.vertex_tangents = !request.mesh.tangents.empty();
        const Compiled compiled =
            compile_or_check(request.project, request.registry, options, diagnostics);
        if (!compiled.ok) return {};
        read_textures(textures, compiled, request.project, diagnostics);
        for (const ModuleOutput& output : compiled.module.outputs)
            graph_outputs.push_back(output.name);
        MapOptions maps;
        maps.vertex_tangents = options.vertex_tangents;
        maps.width = maps.height = request.size;
        auto plan = plan_maps(compiled.module, requests_for(compiled.module), maps, diagnostics);
        return diagnostics.has_errors() ? std::nullopt : std::move(plan);
    }

    bool mesh_can_be_baked(const UvSurvey& uvs, const BakePlan& plan) {
        return check_uvs(uvs, false, request.mesh_name, diagnostics) &&
               check_inputs(request.mesh, {&plan, 1}, request.mesh_name, diagnostics);
    }

    std::optional<BakedMaterial> run() {
        if (!has_uv_layout(request.mesh, request.mesh_name, diagnostics)) return {};
        const auto maps = plan();
        if (!maps) return {};
        const UvSurvey uvs = survey_uvs(request.mesh);
        if (!mesh_can_be_baked(uvs, *maps)) return {};
        BakedMaterial material;
        material.width = material.height = request.size;
        BakedRowsSink sink(material, *maps);
        const std::vector<Texture> sampled = textures.textures_of(maps->resources);
        TextureSetInput input;
        input.mesh = &request.mesh;
        input.plan = &*maps;
        input.textures = sampled;
        input.types.assign(maps->maps.size(), PixelType::float32);
        input.layout = {request.size, request.size, uvs.square, 4};
        BakeReport found;
        bake_texture_set(input, 0, request.size,
                         {[&](size_t map, auto rows) { return sink.take(map, rows); },
                          [](uint32_t, uint64_t) { return true; }},
                         found);
        found.append_warnings(request.graph, request.mesh_name, maps->maps, diagnostics);
        std::ranges::for_each(material.outputs, complete);
        material.graph_outputs = std::move(graph_outputs);
        return material;
    }
};

}  // namespace

const BakedOutput* BakedMaterial::find(std::string_view name) const {
    const auto found = std::ranges::find(outputs, name, &BakedOutput::name);
    return found == outputs.end() ? nullptr : &*found;
}

std::array<float, 3> BakedMaterial::at(std::string_view name, size_t texel) const {
    std::array<float, 3> values{};
    const BakedOutput* output = find(name);
    if (!output) {
        const StandardOutput& row = row_of(name);
        for (size_t i = 0; i < 3; ++i)
            values[i] = static_cast<float>(row.value[row.type == "color" ? i : 0]);
        return row.type == "normal" ? std::array<float, 3>{0, 0, 1} : values;
    }
    for (size_t i = 0; i < 3; ++i)
        values[i] =
            output->texels[texel * output->channels + std::min<size_t>(i, output->channels - 1)];
    return values;
}

bool BakedMaterial::all_constant(std::initializer_list<std::string_view> names) const {
    return std::ranges::all_of(names, [&](std::string_view name) {
        const BakedOutput* output = find(name);
        return !output || output->constant;
    });
}

std::optional<BakedMaterial> bake_outputs(const ExportRequest& request, Diagnostics& diagnostics) {
    return BakeOfMaterial{request, diagnostics, {}, {}}.run();
}

Image composed(const BakedMaterial& material, uint32_t channels,
               const std::function<std::array<float, 4>(size_t texel)>& texel) {
    Image image = make_image(material.width, material.height, channels);
    for (size_t i = 0; i < size_t{material.width} * material.height; ++i) {
        const std::array<float, 4> values = texel(i);
        std::copy_n(values.begin(), channels, image.data.begin() + i * channels);
    }
    return image;
}

}  // namespace wrinkle
