// The builder that a body records into, without passing it around, and the errors of a body.
//
// While a node's build() runs, the thunk (node.h) sets `builder` for this thread and this shared
// object; it is not passed over the C interface. At other times every operation returns poison.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "wrinkle/plugin.h"

namespace wrinkle::sdk {

[[gnu::visibility("hidden")]] inline thread_local const wr_builder* builder = nullptr;

// The id of a recorded value in the C interface. Float, vec3 and the other value types are
// constructed from it.
struct Raw {
    wr_value id = WR_POISON;
};

inline Raw emit(uint32_t op, std::initializer_list<wr_value> args, uint32_t extra = 0,
                uint32_t type = WR_TYPE_poison) {
    if (!builder) return {};
    return {
        builder->emit(builder, op, type, args.begin(), static_cast<uint32_t>(args.size()), extra)};
}

inline Raw literal(uint32_t type, double value) {
    if (!builder) return {};
    return {builder->literal(builder, type, &value)};
}

// Reports a problem on the node: "the width must not be 0". The body continues; its outputs are not
// used.
inline void fail(const char* message) {
    if (builder) builder->error(builder, message);
}

// Makes `inner` the builder until the end of the scope.
class UseBuilder {
public:
    explicit UseBuilder(const wr_builder* inner) : outer_(builder) { builder = inner; }
    ~UseBuilder() { builder = outer_; }
    UseBuilder(const UseBuilder&) = delete;
    UseBuilder& operator=(const UseBuilder&) = delete;

private:
    const wr_builder* outer_;
};

}  // namespace wrinkle::sdk
