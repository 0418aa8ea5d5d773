#include "property/material.h"

#include <gtest/gtest.h>

#include "ir/inspect.h"

namespace wrinkle::test {

Expanded::Expanded(const Material& material, const ExpandOptions& options)
    : module_(expand(material.module, options)) {
    for (const Problem& problem : module_.problems)
        ADD_FAILURE() << problem.message;
    EXPECT_EQ(verify(module_), "");
}

Lanes Expanded::lanes(size_t output, const Surroundings& around) const {
    return interpret(module_, module_.outputs.at(output).value, around);
}

}  // namespace wrinkle::test
