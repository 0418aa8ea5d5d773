// Names of values in generated source.
#include <set>

#include "ir/module_cloner.h"

namespace wrinkle {

void Module::name(Id value, uint32_t node, std::string_view name) {
    constexpr std::string_view mark = " // ";
    std::string_view comment;
    if (const size_t end = name.find(mark); end != name.npos) {
        comment = name.substr(end + mark.size());
        name = name.substr(0, end);
    }
    const Named* known = name_of(value);
    if (!known || (known->comment.empty() && !comment.empty() && is_constant(value)))
        named.push_back(
            {value, node, std::string(name), false, false, false, std::string(comment)});
    else if (known->node != node && known->name == name && !known->output && !known->unshared)
        share_name(names_[value] - 1);
}

// A value that several nodes name alike belongs to the surface point if it is computed from one
// surface input only: "uv0_width".
void Module::share_name(uint32_t index) {
    Named& shared = named[index];
    std::set<SurfaceInput> inputs;
    bool only_inputs = shared.node != 0;
    walk({&shared.value, 1}, [&](Id id, std::vector<Id>& open) {
        if (inst_[id].op == Op::input_) inputs.insert(input_of(inst_[id].extra));
        const auto parts = operands(id);
        only_inputs = only_inputs && (inst_[id].op == Op::input_ || !parts.empty());
        open.insert(open.end(), parts.begin(), parts.end());
    });
    shared.unshared = !only_inputs || inputs.size() != 1;
    if (shared.unshared) return;
    shared.node = 0;
    shared.name = std::string(info(*inputs.begin()).name) + "_" + shared.name;
}

void Module::name_slope(Id value, Id derivative, std::string_view suffix) {
    const Named* known = name_of(value);
    if (!known) return;
    const bool main = known->output || known->name == "value";
    // A vector has the name of its value: "uv_dx".
    const bool vector = !suffix.empty() && info(type(derivative)).lanes > 1;
    const std::string stem = vector ? known->name : main ? "slope" : known->name + "_slope";
    if (!name_of(derivative))
        named.push_back({derivative, known->node, stem + std::string(suffix), false, true});
}

const Named* Module::name_of(Id value) {
    for (; indexed_names_ < named.size(); ++indexed_names_) {
        const Id other = named[indexed_names_].value;
        if (other >= names_.size()) names_.resize(size_t{2} * size());
        if (names_[other] == 0) names_[other] = static_cast<uint32_t>(indexed_names_ + 1);
    }
    return value < names_.size() && names_[value] > 0 ? &named[names_[value] - 1] : nullptr;
}

}  // namespace wrinkle
