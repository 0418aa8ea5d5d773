// Costs, numbers at points, GLSL and images of two graphs, compared for `wrinkle diff`.
//
// Each graph is compiled, evaluated and drawn as `wrinkle test` does it, by the cases of the test
// file of the second graph, else of the first. Without such cases: at three points of planes, and
// on a sphere, shaded and as normals.
#pragma once

#include <filesystem>
#include <string>

#include "cli/graph_operand.h"
#include "report/results.h"

namespace wrinkle::cli {

struct DiffSettings {
    const Registry& registry;
    const CommonOptions& common;
    bool renders = false;          // numbers and images; otherwise only costs
    std::filesystem::path folder;  // of the report; "": no images and no GLSL check
};

// Returns one check per result, with Status::passed if it is the same in both graphs, changed or
// error. `environment` is the reason why a cost could not be counted or an image could not be drawn
// or written, one sentence, or "": such a result has no check.
report::Results compare_materials(const GraphOperand& before, const GraphOperand& after,
                                  const DiffSettings& settings, Diagnostics& diagnostics,
                                  std::string& environment);

}  // namespace wrinkle::cli
