// A correct node, followed by one that ends the program while it is built.
#include <cstdlib>

#include "wrinkle/node.h"

using namespace wrinkle::sdk;

static Node steady = node("steady", "Steady", "Half of what comes in.")
                         .family("test")
                         .in<Float>("value", 1, "A number")
                         .out<Float>("half", "Half of it")
                         .body([](Float value) { return value * 0.5; });

static Node ending = node("ending", "Ending", "Never comes back.")
                         .family("test")
                         .in<Float>("value", 1, "A number")
                         .out<Float>("half", "Half of it")
                         .body([](Float) -> Float { std::abort(); });

WRINKLE_PLUGIN("ending", "1.0", steady, ending)
