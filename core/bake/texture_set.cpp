#include "bake/texture_set.h"

#include "base/diagnostics.h"
#include "base/text.h"

namespace wrinkle {
void BakeReport::append_warnings(const std::string& graph, const std::string& mesh,
                                 std::span<const BakedMap> maps, Diagnostics& warnings) const {
    const auto warn = [&](RuleId rule, const std::string& file, std::string message,
                          std::string expected) {
        warnings.add(
            file_problem(Severity::warning, rule, file, std::move(message), std::move(expected)));
    };
    if (overlapped > 0)
        warn(RuleId::mesh_uvs, mesh,
             std::to_string(overlapped) + " texels are covered by more than one triangle; at uv " +
                 shortest(static_cast<float>(overlap_uv.x)) + "," +
                 shortest(static_cast<float>(overlap_uv.y)) + " triangle " +
                 std::to_string(overlap_triangle) + " is hidden by one before it",
             "a uv layout without overlaps");
    if (not_finite > 0)
        warn(RuleId::not_finite, graph,
             std::to_string(not_finite) + " texels hold a number that is not finite",
             "integer files hold 0 there");
    for (size_t map = 0; map < clamped.size(); ++map) {
        const Clamped& lost = clamped[map];
        if (lost.numbers == 0) continue;
        warn(RuleId::precision_loss, graph,
             "the map '" + maps[map].name + "' holds " + std::to_string(lost.numbers) +
                 " numbers that integers do not, from " + shortest(lost.least) + " to " +
                 shortest(lost.greatest),
             "the type half or float, or another scale");
    }
}

bool bake_texture_set(const TextureSetInput& input, uint32_t first, uint32_t last,
                      const BakeSinks& take, BakeReport& report) {
    const BakePlan& plan = *input.plan;
    const UvRaster raster(*input.mesh, input.layout);
    report.clamped.resize(plan.maps.size());
    BakeInput rows;
    rows.mesh = input.mesh;
    rows.program = &plan.program;
    rows.textures = input.textures;
    rows.unit = plan.unit;
    rows.dilate = input.dilate;
    const auto keep = [&](const BakedRows& baked) {
        report.add(baked.found);
        for (size_t map = 0; map < plan.maps.size(); ++map)
            if (!take.rows(map, stored_rows(plan.maps[map], input.types[map], baked,
                                            input.layout.width, plan.lanes, report.clamped[map])))
                return false;
        return take.band(baked.first + baked.count, uint64_t{baked.count} * input.layout.width);
    };
    return bake_rows(rows, raster, first, last, input.threads, keep);
}

}  // namespace wrinkle
