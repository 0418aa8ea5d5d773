// Graphs of the tests of differences and merges.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "graph/read.h"

namespace wrinkle::difference {

// Reads a graph of these sections, such as "\"nodes\": {...}". Links to missing nodes are allowed.
inline Document graph_with(const std::string& sections) {
    Diagnostics ignored;
    Document document = read_document("{\"wrinkle\": 1, " + sections + "}\n", "g.json", ignored);
    EXPECT_EQ(document.lost, "") << sections;
    return document;
}

// A graph of these nodes: R"("a": {"type": "t"})".
inline Document nodes(const std::string& members) {
    return graph_with("\"nodes\": {" + members + "}");
}

}  // namespace wrinkle::difference
