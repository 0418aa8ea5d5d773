#include "export/mtlx_flatten.h"

#include <algorithm>

#include "export/mtlx_ops.h"

namespace wrinkle {
namespace {

constexpr uint8_t red = 1, all_colors = 7;

std::string numbered(const char* name, int number) {
    return name + std::to_string(number);
}

std::vector<double> repeated(std::vector<double> numbers, int size) {
    if (numbers.size() == 1) numbers.resize(static_cast<size_t>(size), numbers[0]);
    return numbers;
}

}  // namespace

MtlxFlattener::MtlxFlattener(const Module& module, MtlxNodes& nodes,
                             std::function<std::string(const Parameter&)> interface_of,
                             std::function<std::string(uint32_t)> file_of)
    : module_(module),
      nodes_(nodes),
      interface_of_(std::move(interface_of)),
      file_of_(std::move(file_of)),
      support_(module),
      components_(module.size()),
      names_(module.size()) {
    find_components();
}

void MtlxFlattener::find_components() {
    for (Id id = 1; id < module_.size(); ++id)
        for (const Id operand : module_.operands(id)) {
            if (module_[operand].op != Op::sample_) continue;
            const uint32_t extra = module_[id].extra;
            uint8_t& read = components_[operand];
            if (module_[id].op != Op::swizzle_) read = 15;
            for (int i = 0; module_[id].op == Op::swizzle_ && i < swizzle_count(extra); ++i)
                read = static_cast<uint8_t>(read | 1 << swizzle_component(extra, i));
        }
}

// A node is named by that of the graph.
std::string MtlxFlattener::title(Id id, const char* category) const {
    const uint32_t origin = module_.origin[id];
    return origin == 0 ? category : module_.nodes[origin].path + "_" + category;
}

std::string MtlxFlattener::add(Id id, const char* category) {
    return nodes_.add(category, title(id, category), mtlx_type(size_of(id)));
}

// A float becomes each component of a vector.
void MtlxFlattener::operand(const std::string& node, const char* input, Id value, int size) {
    const auto numbers = repeated(mtlx_constant(module_, value), size);
    if (!numbers.empty()) return nodes_.write(node, input, mtlx_type(size), numbers);
    const std::string source = this->node(value);
    nodes_.connect(node, input, mtlx_type(size),
                   size_of(value) == size ? source : nodes_.filled(source, size));
}

std::string MtlxFlattener::node(Id value) {
    if (names_[value].empty()) emit_needed(value);
    return names_[value];
}

// Operands have smaller ids, so the order of ids is that of the nodes.
void MtlxFlattener::emit_needed(Id value) {
    std::vector<bool> needed(value + size_t{1});
    needed[value] = true;
    const auto is_written = [&](Id id) {
        return needed[id] && names_[id].empty() && (id == value || !module_.is_constant(id));
    };
    for (Id id = value; id > 0; --id)
        if (is_written(id))
            for (const Id operand : module_.operands(id))
                needed[operand] = needed[operand] || !reads_uv0(id);
    for (Id id = 1; id <= value; ++id)
        if (is_written(id)) names_[id] = emit(id);
}

std::string MtlxFlattener::emit(Id id) {
    const Inst& inst = module_[id];
    if (const auto numbers = mtlx_constant(module_, id); !numbers.empty()) {
        const std::string node = add(id, "constant");
        nodes_.write(node, "value", mtlx_type(size_of(id)), numbers);
        return node;
    }
    switch (inst.op) {
        case Op::parameter_:
            return interface_of_(module_.parameters[inst.extra]);
        case Op::input_:
            return emit_input(id);
        case Op::construct_:
            return emit_construct(id);
        case Op::swizzle_:
            return emit_swizzle(id);
        case Op::sample_:
            return emit_sample(id);
        case Op::step_:
            return emit_step(id);
        case Op::mul_:
            return emit_product(id);
        case Op::select_:
        case Op::to_float_:
            return emit_select(id);
        default:
            break;
    }
    if (module_.type(id) == Type::derivative_ || module_.type(id) == Type::gradient_)
        return emit_slopes(id);
    return mtlx_call(inst.op) ? emit_call(id) : "";  // else part of the node that reads it
}

std::string MtlxFlattener::emit_call(Id id) {
    const Inst& inst = module_[id];
    const MtlxCall& call = *mtlx_call(inst.op);
    const auto operands = module_.operands(id);
    int size = 1;
    for (const Id operand : operands)
        size = std::max(size, size_of(operand));
    const std::string node = add(id, call.category);
    if (inst.op == Op::neg_) nodes_.write(node, "in1", mtlx_type(size), repeated({0}, size));
    for (size_t i = 0; i < call.inputs.size(); ++i) {
        const bool is_mask = inst.op == Op::mix_ && i == 2;
        operand(node, call.inputs[i], operands[i], is_mask ? size_of(operands[i]) : size);
    }
    if (inst.op == Op::inversesqrt_)
        nodes_.write(node, "in2", mtlx_type(size), repeated({-0.5}, size));
    return node;
}

// The second factor of a vector may be a float.
std::string MtlxFlattener::emit_product(Id id) {
    const Inst& inst = module_[id];
    const bool is_swapped = size_of(inst.arg[0]) < size_of(inst.arg[1]);
    const Id first = inst.arg[is_swapped ? 1 : 0], second = inst.arg[is_swapped ? 0 : 1];
    const std::string node = add(id, "multiply");
    operand(node, "in1", first, size_of(id));
    operand(node, "in2", second, size_of(second));
    return node;
}

std::string MtlxFlattener::emit_comparison(Id id, Id condition) {
    const Inst& inst = module_[condition];
    const MtlxComparison& comparison = *mtlx_comparison(inst.op);
    const std::string node = add(id, comparison.category);
    operand(node, "value1", inst.arg[comparison.swaps_operands ? 1 : 0], 1);
    operand(node, "value2", inst.arg[comparison.swaps_operands ? 0 : 1], 1);
    return node;
}

std::string MtlxFlattener::emit_step(Id id) {
    const std::string node = add(id, "ifgreatereq");
    operand(node, "value1", module_[id].arg[1], 1);
    operand(node, "value2", module_[id].arg[0], 1);
    nodes_.write(node, "in1", "float", {1});
    nodes_.write(node, "in2", "float", {0});
    return node;
}

std::string MtlxFlattener::emit_select(Id id) {
    const Inst& inst = module_[id];
    const std::string node = emit_comparison(id, inst.arg[0]);
    const bool is_swapped = mtlx_comparison(module_[inst.arg[0]].op)->swaps_results;
    const char *yes = is_swapped ? "in2" : "in1", *no = is_swapped ? "in1" : "in2";
    if (inst.op == Op::to_float_) {
        nodes_.write(node, yes, "float", {1});
        nodes_.write(node, no, "float", {0});
    } else {
        operand(node, yes, inst.arg[1], size_of(id));
        operand(node, no, inst.arg[2], size_of(id));
    }
    return node;
}

std::string MtlxFlattener::emit_construct(Id id) {
    const auto operands = module_.operands(id);
    const int size = size_of(id);
    const std::string category = numbered("combine", size);
    const std::string node = add(id, category.c_str());
    int component = 0;
    for (const Id operand : operands) {
        const auto numbers = mtlx_constant(module_, operand);
        for (int i = 0; i < size_of(operand); ++i) {
            const std::string input = numbered("in", ++component);
            if (!numbers.empty())
                nodes_.write(node, input, "float", {numbers[static_cast<size_t>(i)]});
            else
                nodes_.connect(node, input, "float",
                               nodes_.component(this->node(operand), size_of(operand), i));
        }
    }
    return node;
}

std::string MtlxFlattener::emit_swizzle(Id id) {
    const Inst& inst = module_[id];
    const Id from = inst.arg[0];
    const std::string source = node(from);
    int size = size_of(from);
    if (module_[from].op == Op::sample_ && components_[from] <= all_colors) size = 3;
    if (module_[from].op == Op::sample_ && components_[from] == red) size = 1;
    bool is_same = size == size_of(id);
    for (int i = 0; i < size_of(id); ++i)
        is_same = is_same && swizzle_component(inst.extra, i) == i;
    if (is_same) return source;
    if (size == 1) return nodes_.filled(source, size_of(id));
    if (size_of(id) == 1) return nodes_.component(source, size, swizzle_component(inst.extra, 0));
    const std::string category = numbered("combine", size_of(id));
    const std::string node = add(id, category.c_str());
    for (int i = 0; i < size_of(id); ++i)
        nodes_.connect(node, numbered("in", i + 1), "float",
                       nodes_.component(source, size, swizzle_component(inst.extra, i)));
    return node;
}

// The default of an image's texcoord.
bool MtlxFlattener::reads_uv0(Id sample) const {
    if (module_[sample].op != Op::sample_) return false;
    const Inst& uv = module_[module_[sample].arg[0]];
    return uv.op == Op::input_ && input_of(uv.extra) == SurfaceInput::uv0_;
}

// Colors are read as such, so that their color space applies.
std::string MtlxFlattener::emit_sample(Id id) {
    const Inst& inst = module_[id];
    const TextureOptions& options = module_.resources[inst.extra].options;
    const bool is_color = options.encoding == Encoding::srgb;
    const int size = components_[id] > all_colors ? 4 : components_[id] == red && !is_color ? 1 : 3;
    const std::string color = "color" + std::to_string(size);
    const std::string image =
        nodes_.add("image", title(id, "image"), is_color ? color : mtlx_type(size));
    nodes_.write_file(image, file_of_(inst.extra), is_color);
    if (!reads_uv0(id)) nodes_.connect(image, "texcoord", "vector2", node(inst.arg[0]));
    write_sampler(image, options);
    if (!is_color) return image;
    const std::string vector = nodes_.add("convert", image + "_vector", mtlx_type(size));
    nodes_.connect(vector, "in", color, image);
    if (size == 3) add_color(vector, image);
    return vector;
}

void MtlxFlattener::write_sampler(const std::string& image, const TextureOptions& options) {
    if (options.wrap != Wrap::repeat) {
        const char* mode = options.wrap == Wrap::clamp ? "clamp" : "mirror";
        nodes_.write_text(image, "uaddressmode", "string", mode);
        nodes_.write_text(image, "vaddressmode", "string", mode);
    }
    if (options.filter == Filter::nearest)
        nodes_.write_text(image, "filtertype", "string", "closest");
}

std::string MtlxFlattener::emit_input(Id id) {
    const MtlxSurface surface = mtlx_surface(module_[id].extra);
    const std::string node = nodes_.add(surface.category, surface.category, surface.type);
    if (surface.index >= 0)
        nodes_.write_text(node, "index", "integer", std::to_string(surface.index));
    else
        nodes_.write_text(node, "space", "string", "object");
    return node;
}

std::string MtlxFlattener::color(Id value) {
    const std::string source = node(value);
    if (const auto found = colors_.find(source); found != colors_.end()) return found->second;
    const std::string made = nodes_.add("convert", source + "_color", "color3");
    nodes_.connect(made, "in", mtlx_type(size_of(value)), source);
    add_color(source, made);
    return made;
}

}  // namespace wrinkle
