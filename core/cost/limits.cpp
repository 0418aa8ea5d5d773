#include "cost/limits.h"

#include "emit/target.h"

namespace wrinkle {

Excess texture_unit_excess(const Reflection& reflection) {
    const size_t used = reflection.samplers.size();
    if (used <= guaranteed_texture_units) return {};
    std::string text = "it reads " + std::to_string(used) + " images, and a shader has " +
                       std::to_string(guaranteed_texture_units) + " texture units for certain: ";
    for (size_t i = 0; i < used; ++i) {
        const SamplerInfo& sampler = reflection.samplers[i];
        text += (i ? ", " : "") + sampler.written;
        if (!sampler.readers.empty()) text += " (" + sampler.readers[0].node + ")";
    }
    return {text, "put several masks into the channels of one image, or use fewer layers"};
}

Excess draw_buffer_excess(const Reflection& reflection) {
    const Target* target = find_target(reflection.target);
    std::string names;
    size_t drawn = 0;
    for (const OutputInfo& output : reflection.outputs) {
        if (output.location < 0) continue;
        names += (drawn++ ? ", " : "") + output.output;
    }
    if (!target || drawn <= target->draw_buffers) return {};
    return {"it has " + std::to_string(drawn) + " outputs, and a shader of " +
                std::string(target->label) + " draws to " + std::to_string(target->draw_buffers) +
                " buffers for certain: " + names,
            "draw some of them with another graph, or put several numbers into one output"};
}

}  // namespace wrinkle
