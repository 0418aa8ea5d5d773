#include "lower/record.h"

#include <algorithm>

#include "base/standard_outputs.h"
#include "lower/lowering.h"

namespace wrinkle {
namespace {

const Channel* find(const Record& record, std::string_view name) {
    const auto found = std::ranges::find(record, name, &Channel::name);
    return found == record.end() ? nullptr : &*found;
}

bool is_tangent(std::string_view name) {
    return name == "tangent" || name == "coat_tangent";
}

// Order of channels: the rows of the table, then other names.
bool precedes(const Channel& one, const Channel& other) {
    const StandardOutput* a = find_standard_output(one.name);
    const StandardOutput* b = find_standard_output(other.name);
    if (a && b) return a < b;
    return a || (!b && one.name < other.name);
}

Id default_of(Module& module, const StandardOutput& output, PortType type) {
    if (type == PortType::gradient_) return module.add(Op::gradient_zero_, {});
    if (is_tangent(output.name)) return module.swizzle(module.input(SurfaceInput::tangent_), "xyz");
    const auto lanes = static_cast<size_t>(lanes_of(type));
    return module.constant(value_type(type), std::span(output.value).first(lanes));
}

}  // namespace

std::optional<PortType> channel_type(std::string_view name) {
    const StandardOutput* output = find_standard_output(name);
    return output ? port_type_named(channel_type(*output)) : std::nullopt;
}

Id Records::add(Record record) {
    records_.push_back(std::move(record));
    return module_.material(static_cast<uint32_t>(records_.size() - 1));
}

const Record& Records::of(Id material) const {
    static const Record nothing;
    return material == poison ? nothing : records_[module_[material].extra];
}

std::string Records::problem(Id material, std::string_view name, PortType type) const {
    const auto fault = [&](const std::string& what) {
        return "channel '" + std::string(name) + "' " + what;
    };
    if (!is_name(name)) return fault("has no lower_snake_case name");
    if (lanes_of(type) == 0 && type != PortType::gradient_)
        return fault("cannot be a " + std::string(name_of(type)));
    const Channel* own = find(of(material), output_name(name));
    const PortType wanted = own ? own->type : channel_type(name).value_or(type);
    if (wanted == type) return "";
    return fault("is " + std::string(name_of(wanted)) + ", not " + std::string(name_of(type)));
}

Id Records::channel(Id material, std::string_view name, PortType type) const {
    const Record& record = of(material);
    if (const Channel* own = find(record, output_name(name))) return own->value;
    if (output_name(name) == "emission_luminance" && find(record, "emission"))
        return module_.number(nits_of_unit_emission);
    if (const StandardOutput* output = find_standard_output(name))
        return default_of(module_, *output, type);
    return type == PortType::gradient_ ? module_.add(Op::gradient_zero_, {})
                                       : module_.zero(value_type(type));
}

Id Records::with(Id material, Channel channel) {
    Record record = of(material);
    channel.name = output_name(channel.name);
    const auto at = std::ranges::lower_bound(record, channel, precedes);
    if (at != record.end() && at->name == channel.name)
        *at = std::move(channel);
    else
        record.insert(at, std::move(channel));
    return add(std::move(record));
}

Id Records::mixed(Id one, Id other, Id t) {
    Record both;
    std::ranges::set_union(of(one), of(other), std::back_inserter(both), precedes);
    const bool luminance = !find(of(one), "emission") != !find(of(other), "emission");
    Id material = add({});
    if (luminance) both.push_back({"emission_luminance", PortType::float_, poison});
    for (const Channel& each : both) {
        const Id a = channel(one, each.name, each.type), b = channel(other, each.name, each.type);
        Id value =
            module_.add(each.type == PortType::gradient_ ? Op::gradient_mix_ : Op::mix_, {a, b, t});
        if (is_tangent(each.name)) value = module_.add(Op::normalize_, {value});
        if (each.type != PortType::gradient_) module_.name(value, module_.current_node, each.name);
        material = with(material, {each.name, each.type, value});
    }
    return material;
}

}  // namespace wrinkle
