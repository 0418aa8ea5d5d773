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
#include "cpu/aligned.h"
#include "cpu/planes.h"

namespace wrinkle {
namespace {

// Scratch memory of one thread, reused for each tile.
struct TileScratch {
    Coverage coverage;
    PlaneScratch planes;
    TriangleCache cache;
    size_t stride = 0;  // floats per plane, for the largest point count so far
    AlignedVector<float> inputs, outputs;
};

size_t lanes_of_outputs(const Program& program) {
    size_t lanes = 0;
    for (const Program::Output& output : program.outputs)
        lanes += output.regs.size();
    return lanes;
}

// Capacity of the row window: one row of tiles, the rows of tiles before it that wait for it, and
// the margin above them that dilation reads.
uint32_t buffered_rows(uint32_t dilate) {
    return bake_tile + (dilate + bake_tile - 1) / bake_tile * bake_tile + dilate;
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
          window_(layout_.width, std::min(buffered_rows(input.dilate), layout_.height),
                  lanes_of_outputs(*input.program)) {}

    bool run(const RowSink& take) {
        tbb::task_group sink;
        bool wanted = true;
        uint32_t given = first_;
        for (uint32_t row = low_; row < high_; row += bake_tile) {
            const uint32_t end = std::min(row + bake_tile, high_);
            bake_band(row, end);
            const uint32_t seen = end - std::min(end, input_.dilate);
            const uint32_t ready = end == high_ ? last_ : seen / bake_tile * bake_tile;
            if (ready <= given) continue;
            output_[1].resize(window_, ready - given);
            dilate(window_, given, ready, low_, end, input_.dilate, output_[1].values.data(),
                   output_[1].covered.data());
            sink.wait();
            if (!wanted) return false;
            std::swap(output_[0], output_[1]);
            const BakedRows rows = {given, ready - given, output_[0].values.data(),
                                    output_[0].covered.data(), found_in(given, ready)};
            sink.run([&wanted, &take, rows] { wanted = take(rows); });
            given = ready;
        }
        sink.wait();
        return wanted;
    }

private:
    struct Output {
        std::vector<float> values;
        std::vector<uint8_t> covered;

        void resize(const RowWindow& window, uint32_t rows) {
            values.resize(size_t{window.width} * rows * window.lanes);
            covered.resize(size_t{window.width} * rows);
        }
    };

    BakeStatistics found_in(uint32_t first, uint32_t last) const {
        BakeStatistics sum;
        for (uint32_t row = first; row < last; row += bake_tile)
            sum.add(found_[(row - low_) / bake_tile]);
        return sum;
    }

    void bake_band(uint32_t row, uint32_t end) {
        const uint32_t bottom = layout_.height - end;
        const std::vector<RowCandidate> candidates = raster_.in_rows(bottom, end - row);
        const uint32_t tiles = (layout_.width + bake_tile - 1) / bake_tile;
        std::vector<BakeStatistics> found(tiles);
        tbb::parallel_for(uint32_t{0}, tiles, [&](uint32_t tile) {
            const uint32_t x = tile * bake_tile;
            const TexelRect rect = {x, bottom, std::min(bake_tile, layout_.width - x), end - row};
            bake_tile_at(rect, candidates, scratch_.local(), found[tile]);
        });
        BakeStatistics& sum = found_.emplace_back();
        for (const BakeStatistics& each : found)
            sum.add(each);
    }

    void bake_tile_at(const TexelRect& rect, std::span<const RowCandidate> candidates,
                      TileScratch& scratch, BakeStatistics& found) {
        raster_.cover(rect, candidates, scratch.coverage);
        const size_t count = TexelPoints::count(scratch.coverage);
        evaluate(rect, count, scratch);
        scatter(rect, scratch, found);
        const Coverage& coverage = scratch.coverage;
        if (coverage.overlapped == 0) return;
        found.overlapped = coverage.overlapped;
        found.overlap_uv = layout_.uv(rect.x + coverage.overlap_texel % rect.width + 0.5,
                                      rect.y + coverage.overlap_texel / rect.width + 0.5);
        found.overlap_triangle = coverage.overlap_triangle;
    }

    void evaluate(const TexelRect& rect, size_t count, TileScratch& scratch) {
        const Program& program = *input_.program;
        // Planes begin at cache lines, an odd number of lines apart.
        const size_t stride = (count + interpolate_padding + 31) / 32 * 32 + 16;
        if (stride > scratch.stride) {
            scratch.stride = stride;
            scratch.inputs.resize(program.inputs.size() * stride);
            scratch.outputs.resize(window_.lanes * stride);
            points_.fill_constants(stride, scratch.inputs.data());
        }
        points_.fill(scratch.coverage, rect, scratch.stride, scratch.inputs.data(), scratch.cache);
        Planes planes;
        for (size_t i = 0; i < program.inputs.size(); ++i)
            planes.inputs.push_back(scratch.inputs.data() + i * scratch.stride);
        for (size_t i = 0; i < window_.lanes; ++i)
            planes.outputs.push_back(scratch.outputs.data() + i * scratch.stride);
        if (count > 0) evaluate_planes(program, input_.textures, planes, count, scratch.planes);
    }

    // Scatters the results from point order to texel order.
    void scatter(const TexelRect& rect, TileScratch& scratch, BakeStatistics& found) {
        size_t point = 0;
        for (uint32_t y = 0; y < rect.height; ++y)
            point = scatter_row(rect, y, point, scratch);
        count_points(scratch, point, found);
        std::vector<float> texel(window_.lanes);
        for (const Coverage::EdgeTexel& edge : scratch.coverage.edges) {
            average_samples(scratch, point + edge.first, edge.count, texel);
            const uint32_t x = rect.x + edge.texel % rect.width;
            const uint32_t row = row_of(rect, edge.texel / rect.width);
            window_.covered[window_.covered_at(row) + x] = 1;
            for (size_t lane = 0; lane < window_.lanes; ++lane)
                window_.values[window_.lane_at(row, lane) + x] = texel[lane];
            ++found.covered;
            found.not_finite +=
                !std::ranges::all_of(texel, [](float value) { return std::isfinite(value); });
        }
    }

    // Writes one row of results, which begin at `point`; returns the index of the next point.
    size_t scatter_row(const TexelRect& rect, uint32_t y, size_t point,
                       const TileScratch& scratch) {
        const uint32_t row = row_of(rect, y);
        const uint32_t* owners = scratch.coverage.owners.data() + size_t{y} * rect.width;
        uint8_t* covered = window_.covered.data() + window_.covered_at(row) + rect.x;
        for (uint32_t x = 0; x < rect.width; ++x)
            covered[x] = owners[x] != Coverage::none;
        const uint8_t* const row_end = covered + rect.width;
        for (const uint8_t* run = std::find<const uint8_t*>(covered, row_end, 1); run != row_end;) {
            const uint8_t* const end = std::find(run, row_end, 0);
            const auto count = static_cast<size_t>(end - run);
            for (size_t lane = 0; lane < window_.lanes; ++lane)
                std::copy_n(
                    scratch.outputs.data() + lane * scratch.stride + point, count,
                    window_.values.data() + window_.lane_at(row, lane) + rect.x + (run - covered));
            point += count;
            run = std::find(end, row_end, 1);
        }
        return point;
    }

    // Returns the row index from the top of the image.
    uint32_t row_of(const TexelRect& rect, uint32_t y) const {
        return layout_.height - 1 - (rect.y + y);
    }

    void average_samples(const TileScratch& scratch, size_t first, uint32_t samples,
                         std::vector<float>& to) const {
        for (size_t lane = 0; lane < window_.lanes; ++lane) {
            double sum = 0;
            for (uint32_t i = 0; i < samples; ++i)
                sum += static_cast<double>(scratch.outputs[lane * scratch.stride + first + i]);
            to[lane] = static_cast<float>(sum / samples);
        }
        for (const uint32_t lane : input_.unit) {
            float* v = to.data() + lane;
            const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            for (size_t i = 0; i < 3 && length > 0; ++i)
                v[i] /= length;
        }
    }

    void count_points(const TileScratch& scratch, size_t count, BakeStatistics& found) const {
        std::vector<uint32_t> not_finite(count);  // by point: 1 if any lane is not finite
        for (size_t lane = 0; lane < window_.lanes; ++lane)
            for (size_t point = 0; point < count; ++point)
                not_finite[point] |= !std::isfinite(scratch.outputs[lane * scratch.stride + point]);
        found.covered += count;
        found.not_finite += static_cast<uint64_t>(std::ranges::count(not_finite, 1U));
    }

    const BakeInput& input_;
    const UvRaster& raster_;
    const UvLayout layout_;
    TexelPoints points_;
    uint32_t first_, last_;  // requested rows
    uint32_t low_, high_;    // computed rows: with the margins that dilation reads
    RowWindow window_;
    Output output_[2];                   // the rows passed to `take`, and the next ones
    std::vector<BakeStatistics> found_;  // per row of tiles, from low_
    tbb::enumerable_thread_specific<TileScratch> scratch_;
};

}  // namespace

void BakeStatistics::add(const BakeStatistics& below) {
    covered += below.covered;
    not_finite += below.not_finite;
    if (overlapped == 0 && below.overlapped > 0) {
        overlap_uv = below.overlap_uv;
        overlap_triangle = below.overlap_triangle;
    }
    overlapped += below.overlapped;
}

bool bake_rows(const BakeInput& input, const UvRaster& raster, uint32_t first, uint32_t last,
               uint32_t threads, const RowSink& take) {
    const auto cores = static_cast<uint32_t>(tbb::this_task_arena::max_concurrency());
    const uint32_t wanted = threads == 0 ? cores : threads;
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, wanted);
    tbb::task_arena arena(static_cast<int>(wanted));
    return arena.execute([&] { return RowBaker(input, raster, first, last).run(take); });
}

}  // namespace wrinkle
