#include "import/relief.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "image/load.h"

namespace wrinkle::textures {
namespace {

constexpr uint32_t max_cells = 512;  // in a row
constexpr double min_correlation = 0.5;

// Means over squares of texels, row by row from the top of the image.
class Cells {
public:
    Cells() = default;
    explicit Cells(const ImageInfo& info)
        : side((std::max(info.width, info.height) + max_cells - 1) / max_cells),
          columns(info.width / side),
          rows(info.height / side),
          sums_(size_t{columns} * rows) {}

    void add(uint32_t y, const std::vector<float>& values) {
        if (y / side >= rows) return;
        double* sums = sums_.data() + size_t{y / side} * columns;
        for (uint32_t x = 0; x < columns * side; ++x)
            sums[x / side] += values[x];
    }
    double mean(uint32_t x, uint32_t y) const {
        return sums_[size_t{y} * columns + x] / (static_cast<double>(side) * side);
    }

    uint32_t side = 1, columns = 0, rows = 0;  // texels of a square; squares

private:
    std::vector<double> sums_;
};

struct Slopes {
    Cells u, v;
};

std::optional<Cells> read_heights(const std::filesystem::path& file, Diagnostics& diagnostics,
                                  const std::function<bool()>& stopped) {
    std::optional<Cells> cells;
    std::vector<float> values;
    uint32_t y = 0;
    const auto take = [&](const ImageInfo& info, const float* row) {
        if (stopped && stopped()) return false;
        if (!cells) cells.emplace(info);
        values.resize(info.width);
        for (uint32_t x = 0; x < info.width; ++x)
            values[x] = row[size_t{x} * info.channels];
        cells->add(y++, values);
        return true;
    };
    return read_image_rows(file, take, diagnostics) ? cells : std::nullopt;
}

std::optional<Slopes> read_slopes(const std::filesystem::path& file, maps::Green green,
                                  Diagnostics& diagnostics, const std::function<bool()>& stopped) {
    std::optional<Slopes> slopes;
    std::vector<float> du, dv;
    uint32_t y = 0;
    const float sign = green == maps::Green::gl ? 1.0F : -1.0F;
    const auto take = [&](const ImageInfo& info, const float* row) {
        if (stopped && stopped()) return false;
        if (!slopes) slopes.emplace(Slopes{Cells(info), Cells(info)});
        du.resize(info.width);
        dv.resize(info.width);
        maps::slopes_of_normals(row, info.channels, info.channels - (info.has_alpha ? 1 : 0), sign,
                                info.width, du.data(), dv.data());
        slopes->u.add(y, du);
        slopes->v.add(y++, dv);
        return true;
    };
    return read_image_rows(file, take, diagnostics) ? slopes : std::nullopt;
}

// The difference of the means of two squares, with one between, is a weighted mean of the slopes
// of all three: about 1, 2, 1.
double blurred(double before, double here, double after) {
    return (before + 2 * here + after) / 4;
}

}  // namespace

std::optional<double> fitted_relief(const std::filesystem::path& height,
                                    const std::filesystem::path& normal, maps::Green green,
                                    Diagnostics& diagnostics,
                                    const std::function<bool()>& stopped) {
    const auto h = read_heights(height, diagnostics, stopped);
    const auto s = h ? read_slopes(normal, green, diagnostics, stopped) : std::nullopt;
    if (!s || h->side != s->u.side || h->columns != s->u.columns || h->rows != s->u.rows) return {};
    double both = 0, heights = 0, normals = 0;
    const auto add = [&](double of_height, double of_normal) {
        both += of_height * of_normal;
        heights += of_height * of_height;
        normals += of_normal * of_normal;
    };
    for (uint32_t y = 1; y + 1 < h->rows; ++y)
        for (uint32_t x = 1; x + 1 < h->columns; ++x) {
            const double texels = 2.0 * h->side;
            add((h->mean(x + 1, y) - h->mean(x - 1, y)) / texels,
                blurred(s->u.mean(x - 1, y), s->u.mean(x, y), s->u.mean(x + 1, y)));
            add((h->mean(x, y - 1) - h->mean(x, y + 1)) / texels,  // v runs up
                blurred(s->v.mean(x, y - 1), s->v.mean(x, y), s->v.mean(x, y + 1)));
        }
    const double correlation = both / std::sqrt(heights * normals);
    if (!(correlation >= min_correlation)) return {};  // NaN of flat maps too
    const double texels = both / heights;
    return std::isfinite(texels) && texels > 0 ? std::optional(texels) : std::nullopt;
}

}  // namespace wrinkle::textures
