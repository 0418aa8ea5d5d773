// Checks of the calls that a node's build() makes: data from plugins is not trusted. Each invalid
// call is recorded as a problem of the node. Internal to core/lower.
#pragma once

#include <span>
#include <string>

#include "ir/module.h"
#include "registry/registry.h"

namespace wrinkle {

inline bool is_number(uint32_t type) {
    return type >= WR_TYPE_float && type <= WR_TYPE_bool;
}

inline bool exists(uint32_t op) {
    return op < tables::op_count && !info(static_cast<Op>(op)).name.empty();
}
inline bool host_only(Op op) {
    return info(op).rule == Rule::leaf || op == Op::loop_ || op == Op::call_ || op == Op::result_ ||
           reads_image(op);
}
inline bool takes(Op op, uint32_t count) {
    const int arity = info(op).arity;
    return arity < 0 ? count >= 1 && count <= 4 : count == static_cast<uint32_t>(arity);
}

class CallChecks {
public:
    CallChecks(Module& module, const NodeType& type) : module_(module), type_(type) {}

    // Records an invalid call as a problem, once per message. Returns poison.
    Id refuse(const std::string& message,
              std::string expected = "report it to the author of the node") {
        const std::vector<Problem>& problems = module_.problems;
        for (size_t i = problems.size(); i > 0 && problems[i - 1].node == module_.current_node; --i)
            if (problems[i - 1].message == message) return poison;
        module_.problem(message, std::move(expected));
        return poison;
    }

    const Port* port(uint32_t index, const char* call) {
        if (index < type_.ports.size()) return &type_.ports[index];
        refuse(std::string(call) + " asks for port " + std::to_string(index) +
               ", which does not exist");
        return nullptr;
    }

    // Returns false if a value is poison, does not exist or is out of scope.
    bool usable(std::span<const wr_value> values) {
        bool all = true;
        for (const wr_value value : values) {
            if (value >= module_.size())
                refuse("uses a value that does not exist");
            else if (value != poison && module_[value].level > module_.depth())
                refuse("uses a value of a loop or a function outside of it");
            else if (value != poison)
                continue;
            all = false;
        }
        return all;
    }
    [[gnu::cold]] Id refuse_kind(const Port& port, const char* kind) {
        return refuse("reads port '" + port.name + "' as " + kind + ", which it is not");
    }
    [[gnu::cold]] Id refuse_op(uint32_t number, uint32_t count) {
        const auto o = static_cast<Op>(number);
        if (!exists(number))
            return refuse("uses op " + std::to_string(number) + ", which does not exist",
                          "a newer program may be needed");
        if (host_only(o))
            return refuse("emits the op " + quoted(o) + ", which only the host makes");
        return refuse_count(o, count);
    }
    [[gnu::cold]] Id refuse_count(Op o, uint32_t count) {
        return refuse("gives the op " + quoted(o) + " " + std::to_string(count) + " operands");
    }
    static std::string quoted(Op o) { return "'" + std::string(info(o).name) + "'"; }

protected:
    Module& module_;
    const NodeType& type_;
};

}  // namespace wrinkle
