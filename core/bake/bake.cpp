#include "bake/bake.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>

#include "bake/dilate.h"
#include "bake/texel_points.h"
#include "cpu/planes.h"

namespace wrinkle {
namespace {

// What one thread works with, tile after tile.
struct TileScratch {
    Coverage coverage;
    PlaneScratch planes;
    std::vector<float> inputs, outputs;
};

size_t lanes_of_outputs(const Program& program) {
    size_t lanes = 0;
    for (const Program::Output& output : program.outputs)
        lanes += output.regs.size();
    return lanes;
}

class RowBaker {
public:
    RowBaker(const BakeInput& input, const UvRaster& raster, uint32_t first, uint32_t last)
        : input_(input),
          raster_(raster),
          layout_(raster.layout()),
          points_(*input.mesh, *input.program, layout_),
          first_(first),
          last_(last),
          low_((first - std::min(first, input.dilate)) / bake_tile * bake_tile),
          high_(std::min(last + input.dilate, layout_.height)),
          window_(layout_.width, std::min(3 * bake_tile + 2 * input.dilate, layout_.height),
                  lanes_of_outputs(*input.program)) {}

    bool run(const TakeRows& take, BakeFindings& findings) {
        tbb::task_group taking;
        bool wanted = true;
        uint32_t given = first_;
        for (uint32_t row = low_; row < high_; row += bake_tile) {
            const uint32_t end = std::min(row + bake_tile, high_);
            bake_band(row, end, findings);
            const uint32_t seen = end - std::min(end, input_.dilate);
            const uint32_t ready = end == high_ ? last_ : seen / bake_tile * bake_tile;
            if (ready <= given) continue;
            give_[1].resize(window_, ready - given);
            dilate(window_, given, ready, low_, end, input_.dilate, give_[1].values.data(),
                   give_[1].covered.data());
            taking.wait();
            if (!wanted) return false;
            std::swap(give_[0], give_[1]);
            const BakedRows rows = {given, ready - given, give_[0].values.data(),
                                    give_[0].covered.data()};
            taking.run([&wanted, &take, rows] { wanted = take(rows); });
            given = ready;
        }
        taking.wait();
        return wanted;
    }

private:
    struct Given {
        std::vector<float> values;
        std::vector<uint8_t> covered;

        void resize(const RowWindow& window, uint32_t rows) {
            values.resize(size_t{window.width} * rows * window.lanes);
            covered.resize(size_t{window.width} * rows);
        }
    };

    void bake_band(uint32_t row, uint32_t end, BakeFindings& findings) {
        const uint32_t bottom = layout_.height - end;
        const std::vector<uint32_t> candidates = raster_.in_rows(bottom, end - row);
        const uint32_t tiles = (layout_.width + bake_tile - 1) / bake_tile;
        std::vector<BakeFindings> found(tiles);
        tbb::parallel_for(uint32_t{0}, tiles, [&](uint32_t tile) {
            const uint32_t x = tile * bake_tile;
            const TexelRect rect = {x, bottom, std::min(bake_tile, layout_.width - x), end - row};
            bake_tile_at(rect, candidates, scratch_.local(), found[tile]);
        });
        for (const BakeFindings& each : found) {
            // Margins of a part of the picture are somebody else's to tell of.
            if (row >= first_ && row < last_) findings.add(each);
        }
    }

    void bake_tile_at(const TexelRect& rect, std::span<const uint32_t> candidates,
                      TileScratch& scratch, BakeFindings& found) {
        raster_.cover(rect, candidates, scratch.coverage);
        const size_t count = TexelPoints::count(scratch.coverage);
        evaluate(rect, count, scratch);
        place(rect, count, scratch, found);
        const Coverage& coverage = scratch.coverage;
        if (coverage.overlapped == 0) return;
        found.overlapped = coverage.overlapped;
        found.overlap_x = rect.x + coverage.overlap_texel % rect.width;
        found.overlap_y = rect.y + coverage.overlap_texel / rect.width;
        found.overlap_triangle = coverage.overlap_triangle;
    }

    void evaluate(const TexelRect& rect, size_t count, TileScratch& scratch) {
        const Program& program = *input_.program;
        scratch.inputs.resize(program.inputs.size() * count);
        scratch.outputs.resize(window_.lanes * count);
        points_.fill(scratch.coverage, rect, count, scratch.inputs.data());
        Planes planes;
        for (size_t i = 0; i < program.inputs.size(); ++i)
            planes.inputs.push_back(scratch.inputs.data() + i * count);
        for (size_t i = 0; i < window_.lanes; ++i)
            planes.outputs.push_back(scratch.outputs.data() + i * count);
        if (count > 0) evaluate_planes(program, input_.textures, planes, count, scratch.planes);
    }

    // From points in their order to texels in theirs.
    void place(const TexelRect& rect, size_t count, TileScratch& scratch, BakeFindings& found) {
        const float* outputs = scratch.outputs.data();
        size_t point = 0;
        for (uint32_t i = 0; i < scratch.coverage.owners.size(); ++i) {
            uint8_t& covered = window_.covered[texel_of(rect, i)];
            covered = scratch.coverage.owners[i] != Coverage::none;
            if (!covered) continue;
            float* to = window_.values.data() + texel_of(rect, i) * window_.lanes;
            for (size_t lane = 0; lane < window_.lanes; ++lane)
                to[lane] = outputs[lane * count + point];
            ++point;
            note(to, found);
        }
        for (const Coverage::EdgeTexel& edge : scratch.coverage.edges) {
            window_.covered[texel_of(rect, edge.texel)] = 1;
            float* to = window_.values.data() + texel_of(rect, edge.texel) * window_.lanes;
            mix(outputs + point + edge.first, count, edge.count, to);
            note(to, found);
        }
    }

    size_t texel_of(const TexelRect& rect, uint32_t i) const {
        return window_.texel(rect.x + i % rect.width,
                             layout_.height - 1 - (rect.y + i / rect.width));
    }

    void mix(const float* outputs, size_t stride, uint32_t samples, float* to) const {
        for (size_t lane = 0; lane < window_.lanes; ++lane) {
            double sum = 0;
            for (uint32_t i = 0; i < samples; ++i)
                sum += static_cast<double>(outputs[lane * stride + i]);
            to[lane] = static_cast<float>(sum / samples);
        }
        for (const uint32_t lane : input_.unit) {
            float* v = to + lane;
            const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            for (size_t i = 0; i < 3 && length > 0; ++i)
                v[i] /= length;
        }
    }

    void note(const float* texel, BakeFindings& found) const {
        ++found.covered;
        float sum = 0;  // what is not finite stays so in it
        for (size_t lane = 0; lane < window_.lanes; ++lane)
            sum += texel[lane] * 0.0F;
        if (!(sum == 0)) ++found.not_finite;
    }

    const BakeInput& input_;
    const UvRaster& raster_;
    const UvLayout layout_;
    TexelPoints points_;
    uint32_t first_, last_;  // wanted
    uint32_t low_, high_;    // worked on: with the margins that dilation looks into
    RowWindow window_;
    Given give_[2];  // the rows that are taken, and the next
    tbb::enumerable_thread_specific<TileScratch> scratch_;
};

}  // namespace

void BakeFindings::add(const BakeFindings& below) {
    covered += below.covered;
    not_finite += below.not_finite;
    if (overlapped == 0 && below.overlapped > 0) {
        overlap_x = below.overlap_x;
        overlap_y = below.overlap_y;
        overlap_triangle = below.overlap_triangle;
    }
    overlapped += below.overlapped;
}

bool bake_rows(const BakeInput& input, const UvRaster& raster, uint32_t first, uint32_t last,
               uint32_t threads, const TakeRows& take, BakeFindings& findings) {
    const auto cores = static_cast<uint32_t>(tbb::this_task_arena::max_concurrency());
    const uint32_t wanted = threads == 0 ? cores : threads;
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, wanted);
    tbb::task_arena arena(static_cast<int>(wanted));
    return arena.execute([&] { return RowBaker(input, raster, first, last).run(take, findings); });
}

}  // namespace wrinkle
