// The graphs of core/certify around every node, for tests: with the built-in nodes and those of the
// example plugins, one folder of images for the test program, and a test failure for every error.
#pragma once

#include "certify/subject.h"

namespace wrinkle::test {

using certify::Inputs;
using certify::Subject;
using certify::test_image;

// The built-in nodes and those of the example plugins.
const Registry& all_nodes();

// A folder with files of the names that graphs use.
std::string image_folder();

// Source is validated by glslang. `gpu`: a context is current.
certify::CertifyContext bench(bool gpu = false);

Subject compile_harness(const NodeType& type, Inputs inputs, unsigned seed);

}  // namespace wrinkle::test
