// Inputs of the renderer and the point runner from a generated shader.
#include "glsl/emit.h"
#include "gpu/material.h"
#include "gpu/point_runner.h"

#include "ir/op.h"

namespace wrinkle::gpu {
namespace {

std::string glsl_name(Type type) {
    return std::string(info(type).name);
}

Member member_from(const MemberInfo& member) {
    const std::string property =
        member.relative ? "position_relative" : std::string(info(member.input).name);
    return {member.name, glsl_name(member.type), property};
}

MaterialUniform uniform_from(const UniformInfo& uniform) {
    MaterialUniform result{uniform.name, {}};
    for (size_t i = 0; i < info(uniform.type).lanes; ++i)
        result.value.push_back(static_cast<float>(uniform.value[i]));
    return result;
}

std::vector<MaterialSampler> samplers_from(const Reflection& reflection) {
    std::vector<MaterialSampler> result;
    for (const SamplerInfo& sampler : reflection.samplers)
        result.push_back({sampler.name, sampler.file, sampler.options});
    return result;
}

std::vector<MaterialUniform> uniforms_from(const Reflection& reflection) {
    std::vector<MaterialUniform> result;
    for (const UniformInfo& uniform : reflection.uniforms)
        result.push_back(uniform_from(uniform));
    return result;
}

std::string widened(const std::string& value, int lanes) {
    switch (lanes) {
        case 1:
            return "vec4(" + value + ", 0.0, 0.0, 0.0)";
        case 2:
            return "vec4(" + value + ", 0.0, 0.0)";
        case 3:
            return "vec4(" + value + ", 0.0)";
        default:
            return value;
    }
}

}  // namespace

Material material_from(const Shader& shader) {
    const Reflection& reflection = shader.reflection;
    Material material;
    material.text = shader.source;
    for (const uint32_t node : reflection.lines)
        material.nodes.push_back(node == no_node ? "" : reflection.node_paths[node]);
    material.struct_name = reflection.struct_name;
    for (const MemberInfo& member : reflection.members)
        material.members.push_back(member_from(member));
    for (const FunctionInfo& function : reflection.functions)
        material.outputs.push_back({function.output, function.function, glsl_name(function.type)});
    material.samplers = samplers_from(reflection);
    material.uniforms = uniforms_from(reflection);
    return material;
}

PointJob point_job_from(const Shader& shader) {
    const Reflection& reflection = shader.reflection;
    const bool has_struct = !reflection.struct_name.empty();
    PointJob job;
    job.globals = shader.source;
    if (has_struct) job.body = reflection.struct_name + " s;\n";
    for (const MemberInfo& member : reflection.members)
        job.body += "s." + member.name + " = " + member.name + ";\n";
    for (size_t k = 0; k < reflection.functions.size(); ++k) {
        const FunctionInfo& function = reflection.functions[k];
        const std::string call = function.function + (has_struct ? "(s)" : "()");
        job.body +=
            "out" + std::to_string(k) + " = " + widened(call, info(function.type).lanes) + ";\n";
    }
    job.outputs = static_cast<int>(reflection.functions.size());
    job.samplers = samplers_from(reflection);
    job.uniforms = uniforms_from(reflection);
    return job;
}

}  // namespace wrinkle::gpu
