// Planar float buffers for tests: the inputs of a scene, and storage for the outputs.
#pragma once

#include <vector>

#include "cpu/planes.h"
#include "ir/op.h"

namespace wrinkle::test {

struct Columns {
    std::vector<std::vector<float>> inputs, outputs;

    Columns(const Program& program, const PointSet& points) {
        for (const Program::Input& input : program.inputs) {
            const size_t lanes = info(info(input.input).type).lanes;
            std::vector<float>& column = inputs.emplace_back(points.count);
            for (size_t k = 0; k < points.count; ++k)
                column[k] = static_cast<float>(
                    points.at(input.input, input.variant)[k * lanes + input.lane]);
        }
        for (const Program::Output& output : program.outputs)
            outputs.resize(outputs.size() + output.regs.size(), std::vector<float>(points.count));
    }

    Planes from(size_t first) {
        Planes planes;
        for (const std::vector<float>& column : inputs)
            planes.inputs.push_back(column.data() + first);
        for (std::vector<float>& column : outputs)
            planes.outputs.push_back(column.data() + first);
        return planes;
    }
};

}  // namespace wrinkle::test
