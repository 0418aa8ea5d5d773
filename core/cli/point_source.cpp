#include "cli/point_source.h"

#include <cmath>
#include <memory>

#include "base/diagnostics.h"
#include "base/text.h"
#include "cli/arguments.h"
#include "cli/meshes.h"
#include "ir/op.h"
#include "mesh/sample.h"
#include "mesh/uv_grid.h"

namespace wrinkle::cli {
namespace {

constexpr InputNeed first_uv = {SurfaceInput::uv0_, Variant::value};

bool is_facing(const InputNeed& need) {
    return need.input == SurfaceInput::facing_;
}

std::string lacks(const std::string& who, const InputNeed& need) {
    return who + " lacks '" + name_of(need) + "'";
}

std::optional<glm::dvec2> parse_uv(const std::string& text) {
    double uv[2];
    if (!parse_numbers<double>(text, ',', uv)) return {};
    if (!std::isfinite(uv[0]) || !std::isfinite(uv[1])) return {};
    return glm::dvec2(uv[0], uv[1]);
}

PointSource source_of(std::shared_ptr<const PointTable> table) {
    PointSource source;
    source.count = table->count();
    source.report = [table](size_t point, Severity severity, std::string message,
                            std::string expected, Diagnostics& diagnostics) {
        message = "point " + std::to_string(point) + ": " + message;
        diagnostics.add({severity, table->where(point), "", "", message, std::move(expected)});
    };
    source.check = [table](const Needs& needs, Diagnostics& diagnostics) {
        bool fine = true;
        for (const InputNeed& need : needs) {
            if (is_facing(need) || table->gives(need)) continue;
            const std::string column = column_name(name_of(need), 0, lanes_of(need));
            diagnostics.add(file_problem(Severity::error, table->where(0).file,
                                         lacks("the table", need),
                                         "the graph needs it: " + column));
            fine = false;
        }
        return fine;
    };
    source.fill = [table](const Needs& needs, size_t first, PointSet& set, Diagnostics&) {
        for (const InputNeed& need : needs) {
            const size_t lanes = lanes_of(need);
            std::vector<double>& values = set.at(need.input, need.variant);
            values.assign(set.count * lanes, 1);  // default of `facing`
            if (!table->gives(need)) continue;
            for (size_t i = 0; i < values.size(); ++i)
                values[i] = table->at(need, i % lanes, first + i / lanes);
        }
        return true;
    };
    return source;
}

// Components of a surface value, zero-padded.
using Attribute = std::array<double, 4>;

template <typename Vector>
Attribute lanes_from(const Vector& vector) {
    Attribute lanes{};
    for (int i = 0; i < Vector::length(); ++i)
        lanes[static_cast<size_t>(i)] = vector[i];
    return lanes;
}

size_t uv_set_of(SurfaceInput input) {
    return static_cast<size_t>(input) - static_cast<size_t>(SurfaceInput::uv0_);
}

Attribute value_of(const SurfacePoint& point, const InputNeed& need) {
    const SurfaceAttributes& from = need.variant == Variant::dx   ? point.dx
                                    : need.variant == Variant::dy ? point.dy
                                                                  : point.value;
    switch (need.input) {
        case SurfaceInput::position_:
            return lanes_from(from.position);
        case SurfaceInput::normal_:
            return lanes_from(from.normal);
        case SurfaceInput::tangent_:
            return lanes_from(from.tangent);
        case SurfaceInput::color0_:
            return lanes_from(from.color);
        case SurfaceInput::facing_:
            return {1};
        default:
            return lanes_from(from.uv.at(uv_set_of(need.input)));
    }
}

bool has_attribute(const Mesh& mesh, const InputNeed& need) {
    switch (need.input) {
        case SurfaceInput::position_:
        case SurfaceInput::facing_:
            return true;
        case SurfaceInput::normal_:
            return !mesh.normals.empty();
        case SurfaceInput::tangent_:
            return !mesh.tangents.empty();
        case SurfaceInput::color0_:
            return !mesh.colors.empty();
        case SurfaceInput::view_:
            return false;
        default:
            return mesh.has_uv(uv_set_of(need.input));
    }
}

// Samples the surface of a mesh at the uvs of another source.
struct MeshPoints {
    MeshPoints(Mesh opened, const PointOptions& options, PointSource from)
        : mesh(std::move(opened)),
          grid(mesh),
          name(options.mesh),
          size(options.size),
          uv_source(std::move(from)) {}

    bool fill(const Needs& needs, size_t first, PointSet& set, Diagnostics& diagnostics) const {
        PointSet uvs;
        uvs.count = set.count;
        if (!uv_source.fill({first_uv}, first, uvs, diagnostics)) return false;
        for (const InputNeed& need : needs)
            set.at(need.input, need.variant).resize(set.count * lanes_of(need));
        const std::vector<double>& uv = uvs.at(SurfaceInput::uv0_);
        bool fine = true;
        for (size_t k = 0; k < set.count; ++k) {
            const glm::dvec2 place(uv[2 * k], uv[2 * k + 1]);
            const auto point = sample_mesh(mesh, grid.near(place), place, size);
            if (point) {
                put(*point, needs, k, set);
                continue;
            }
            uv_source.report(first + k, Severity::error,
                             "no triangle of the mesh " + name + " covers the uv (" +
                                 shortest(uv[2 * k]) + ", " + shortest(uv[2 * k + 1]) + ")",
                             "a place inside its uv layout", diagnostics);
            fine = false;
        }
        return fine;
    }

    static void put(const SurfacePoint& point, const Needs& needs, size_t k, PointSet& set) {
        for (const InputNeed& need : needs) {
            const size_t lanes = lanes_of(need);
            const Attribute values = value_of(point, need);
            std::copy_n(values.begin(), lanes,
                        set.at(need.input, need.variant).begin() + static_cast<long>(k * lanes));
        }
    }

    Mesh mesh;
    UvGrid grid;
    std::string name;
    uint32_t size;
    PointSource uv_source;
};

PointSource source_on(std::shared_ptr<const MeshPoints> on) {
    PointSource source = on->uv_source;
    source.check = [on](const Needs& needs, Diagnostics& diagnostics) {
        bool fine = on->uv_source.check({first_uv}, diagnostics);
        for (const InputNeed& need : needs) {
            if (has_attribute(on->mesh, need)) continue;
            diagnostics.error(lacks(on->name, need), "the graph needs it");
            fine = false;
        }
        return fine;
    };
    source.fill = [on](const Needs& needs, size_t first, PointSet& set, Diagnostics& diagnostics) {
        return on->fill(needs, first, set, diagnostics);
    };
    return source;
}

// Source of one point with only uv0.
PointSource source_of_uv(glm::dvec2 uv) {
    PointSource source;
    source.count = 1;
    source.check = [](const auto&, Diagnostics&) { return true; };
    source.fill = [uv](const auto&, size_t, PointSet& set, Diagnostics&) {
        set.at(SurfaceInput::uv0_) = {uv.x, uv.y};
        return true;
    };
    source.report = [](size_t, Severity severity, std::string message, std::string expected,
                       Diagnostics& diagnostics) {
        diagnostics.add(file_problem(severity, "--uv", std::move(message), std::move(expected)));
    };
    return source;
}

// Returns the table format of the file of --at; std::nullopt if it is not a table.
std::optional<TableForm> table_form(const std::string& at) {
    if (at.ends_with(".csv")) return TableForm::csv;
    if (at.ends_with(".npy")) return TableForm::npy;
    return {};
}

PointSource open_at(const std::string& at, Diagnostics& diagnostics) {
    const auto form = table_form(at);
    if (!form) return source_of(points_of_option(at, diagnostics));
    const std::string file = at.starts_with('@') ? at.substr(1) : at;
    auto bytes = read_text(file, diagnostics);
    if (!bytes) return {};
    auto table = PointTable::read(*form, std::move(*bytes), file, diagnostics);
    if (!table) return {};
    return source_of(std::make_shared<const PointTable>(std::move(*table)));
}

}  // namespace

PointSource source_of(std::vector<Point> list) {
    const auto points = std::make_shared<const std::vector<Point>>(std::move(list));
    PointSource source;
    source.count = points->size();
    source.check = [points](const Needs& needs, Diagnostics& diagnostics) {
        bool fine = true;
        for (const Point& point : *points)
            for (const InputNeed& need : needs) {
                if (point[need].given) continue;
                report_at(point.source, lacks(point.name, need), "the graph needs it", diagnostics);
                fine = false;
            }
        return fine;
    };
    source.fill = [points](const Needs& needs, size_t first, PointSet& set, Diagnostics&) {
        for (const InputNeed& need : needs) {
            std::vector<double>& values = set.at(need.input, need.variant);
            values.clear();
            for (size_t k = 0; k < set.count; ++k) {
                const auto& lanes = (*points)[first + k][need].lanes;
                values.insert(values.end(), lanes.begin(),
                              lanes.begin() + static_cast<long>(lanes_of(need)));
            }
        }
        return true;
    };
    source.report = [points](size_t index, Severity severity, std::string message,
                             std::string expected, Diagnostics& diagnostics) {
        if (diagnostics.dropped() > 0) return diagnostics.add({});
        const Point& point = (*points)[index];
        Diagnostic problem =
            diagnose(point.source, "", point.name + ": " + message, std::move(expected));
        problem.severity = severity;
        diagnostics.add(std::move(problem));
    };
    return source;
}

bool is_uv(const std::string& text) {
    return parse_uv(text).has_value();
}

PointSource open_points(const PointOptions& options, const CommonOptions& common,
                        Diagnostics& diagnostics) {
    if (options.mesh.empty()) return open_at(options.at, diagnostics);
    std::optional<Mesh> mesh = open_mesh(options.mesh, common, diagnostics);
    if (mesh && !mesh->has_uv(0)) {
        diagnostics.error("the mesh " + options.mesh + " has no uvs (set 0)",
                          "a mesh with a uv layout");
        return {};
    }
    PointSource uv_source =
        options.at.empty() ? source_of_uv(*parse_uv(options.uv)) : open_at(options.at, diagnostics);
    if (!mesh || diagnostics.has_errors()) return {};
    return source_on(
        std::make_shared<const MeshPoints>(std::move(*mesh), options, std::move(uv_source)));
}

}  // namespace wrinkle::cli
