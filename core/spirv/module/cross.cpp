#include <spirv_cross/spirv_cross_c.h>

#include <cstring>
#include <span>
#include <vector>

#include "spirv/module/parts.h"

namespace wrinkle::spirv {
namespace {

// One translation. Each step returns false on failure; good() then logs the context's last error.
class Translation {
public:
    Translation(const WrinkleSpirvJob& job, WrinkleSpirvSink log) : job_(job), log_(log) {
        if (spvc_context_create(&context_) != SPVC_SUCCESS) context_ = nullptr;
    }
    ~Translation() {
        if (context_) spvc_context_destroy(context_);
    }
    Translation(const Translation&) = delete;
    Translation& operator=(const Translation&) = delete;

    bool run(WrinkleSpirvWords in, WrinkleSpirvSink text);

private:
    bool good(spvc_result result) {
        if (result == SPVC_SUCCESS) return true;
        write(log_, spvc_context_get_last_error_string(context_));
        return false;
    }
    bool metal() const { return job_.language == WRINKLE_SPIRV_MSL; }
    SpvExecutionModel model() const {
        return job_.stage == WRINKLE_SPIRV_VERTEX ? SpvExecutionModelVertex
                                                  : SpvExecutionModelFragment;
    }
    bool begin(WrinkleSpirvWords in);
    bool set_options();
    bool name_and_bind();
    bool bind_metal(const spvc_reflected_resource& resource);

    const WrinkleSpirvJob& job_;
    WrinkleSpirvSink log_;
    spvc_context context_ = nullptr;
    spvc_compiler compiler_ = nullptr;
};

bool Translation::begin(WrinkleSpirvWords in) {
    spvc_parsed_ir ir = nullptr;
    const spvc_backend backend = metal() ? SPVC_BACKEND_MSL : SPVC_BACKEND_HLSL;
    return good(spvc_context_parse_spirv(context_, in.data, in.count, &ir)) &&
           good(spvc_context_create_compiler(context_, backend, ir,
                                             SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler_));
}

bool Translation::set_options() {
    spvc_compiler_options options = nullptr;
    if (!good(spvc_compiler_create_compiler_options(compiler_, &options))) return false;
    const auto [key, value] =
        metal() ? std::pair(SPVC_COMPILER_OPTION_MSL_VERSION, SPVC_MAKE_MSL_VERSION(2, 0, 0))
                : std::pair(SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, 50);
    return good(spvc_compiler_options_set_uint(options, key, static_cast<unsigned>(value))) &&
           good(spvc_compiler_options_set_bool(options, SPVC_COMPILER_OPTION_EMIT_LINE_DIRECTIVES,
                                               SPVC_TRUE)) &&
           good(spvc_compiler_install_compiler_options(compiler_, options));
}

bool Translation::bind_metal(const spvc_reflected_resource& resource) {
    spvc_msl_resource_binding binding;
    spvc_msl_resource_binding_init(&binding);
    const auto decoration = [&](SpvDecoration which) {
        return spvc_compiler_get_decoration(compiler_, resource.id, which);
    };
    binding.stage = model();
    binding.desc_set = decoration(SpvDecorationDescriptorSet);
    binding.binding = decoration(SpvDecorationBinding);
    binding.msl_buffer = binding.msl_texture = binding.msl_sampler = binding.binding;
    return good(spvc_compiler_msl_add_resource_binding(compiler_, &binding));
}

bool Translation::name_and_bind() {
    spvc_resources all = nullptr;
    if (!good(spvc_compiler_create_shader_resources(compiler_, &all))) return false;
    for (const spvc_resource_type type :
         {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, SPVC_RESOURCE_TYPE_SAMPLED_IMAGE}) {
        const spvc_reflected_resource* list = nullptr;
        size_t count = 0;
        if (!good(spvc_resources_get_resource_list_for_type(all, type, &list, &count)))
            return false;
        for (const spvc_reflected_resource& resource : std::span(list, count)) {
            for (const WrinkleSpirvName& name : std::span(job_.names, job_.name_count))
                if (std::strcmp(name.block, resource.name) == 0)
                    spvc_compiler_set_name(compiler_, resource.id, name.variable);
            if (metal() && !bind_metal(resource)) return false;
        }
    }
    return true;
}

bool Translation::run(WrinkleSpirvWords in, WrinkleSpirvSink text) {
    if (!context_ || !begin(in) || !set_options() || !name_and_bind()) return false;
    if (!good(spvc_compiler_rename_entry_point(compiler_, "main", job_.entry, model())))
        return false;
    std::vector<spvc_hlsl_vertex_attribute_remap> remaps;
    for (const WrinkleSpirvSemantic& each : std::span(job_.semantics, job_.semantic_count))
        remaps.push_back({each.location, each.semantic});
    if (!metal() && !remaps.empty() &&
        !good(
            spvc_compiler_hlsl_add_vertex_attribute_remap(compiler_, remaps.data(), remaps.size())))
        return false;
    const char* source = nullptr;
    if (!good(spvc_compiler_compile(compiler_, &source))) return false;
    write(text, source);
    return true;
}

}  // namespace

int32_t translate(WrinkleSpirvWords in, const WrinkleSpirvJob* job, WrinkleSpirvSink text,
                  WrinkleSpirvSink log) {
    return Translation(*job, log).run(in, text) ? 1 : 0;
}

}  // namespace wrinkle::spirv
